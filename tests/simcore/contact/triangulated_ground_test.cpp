#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "tests/support/one_wheel.h"
#include "tests/support/patches.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::contact;
using namespace testsupport;
using std::numbers::pi;
using terrain::Terrain;
using terrain::TriangleMesh;

namespace {

constexpr double kRadius = 0.08;
constexpr double kWidth = 0.05;
const OneWheel kWheel{kRadius, kWidth};

Eigen::Quaterniond turned(double yaw, double roll = 0.0) {
    return Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(roll, Vec3::UnitX());
}

double deepest(const std::vector<Contact>& contacts) {
    double depth = -1.0;
    for (const Contact& contact : contacts) {
        depth = std::max(depth, contact.depth);
    }
    return depth;
}

}  // namespace

class TriangleSizeTest : public testing::TestWithParam<double> {};

// Inner edges of even ground do not exist for a wheel: one contact a slice, its normal the plane's,
// wherever the wheel stands; above all where a slice runs along edges and through vertices.
TEST_P(TriangleSizeTest, EvenGroundHasNoInnerEdges) {
    const double cell = GetParam();
    const double half = std::max(0.15, 4.0 * cell);
    for (const double jitter : {0.0, 0.2}) {
        for (const double slope : {0.0, 0.35}) {
            // Even ground that rises ahead and to the left.
            const double ahead = slope;
            const double left = 0.5 * slope;
            const Terrain ground = patch(
                cell, half, half, [&](double x, double y) { return ahead * x + left * y; }, jitter);
            const Vec3 normal = Vec3(-ahead, -left, 1.0).normalized();
            Random random(3);
            for (int i = 0; i < 400; ++i) {
                // Every other time on the lattice of the vertices.
                const bool lattice = i % 2 == 0;
                const double reach = 0.5 * half;
                double x = random.uniform(-reach, reach);
                double y = random.uniform(-0.5 * reach, 0.5 * reach);
                if (lattice) {
                    x = std::round(x / cell) * cell;
                    y = std::round(y / cell) * cell + 0.45 * kWidth;
                }
                const double yaw = lattice ? 0.0 : random.uniform(-0.8, 0.8);
                const Eigen::Quaterniond rotation = turned(yaw);
                // The lowest point of a slice: the disc is nearest to the plane by its radius
                // times the cosine between disc and plane normal.
                const Vec3 axis = rotation * Vec3::UnitY();
                const double cosine = std::sqrt(1.0 - std::pow(axis.dot(normal), 2));
                const double depth = 0.0005;
                const Vec3 center = Vec3(x, y, ahead * x + left * y) +
                                    normal * (kRadius * cosine +
                                              0.45 * kWidth * std::abs(axis.dot(normal)) - depth);
                const auto contacts = kWheel.contactsAt(ground, center, rotation);
                ASSERT_NEAR(deepest(contacts), depth, 1e-9) << "at " << x << ", " << y;
                ASSERT_LE(contacts.size(), 2u) << "at " << x << ", " << y;
                for (const Contact& contact : contacts) {
                    ASSERT_LT((contact.normal - normal).norm(), 1e-7)
                        << "at " << x << ", " << y << ": " << contact.normal.transpose();
                }
                if (slope == 0.0) {
                    ASSERT_EQ(contacts.size(), 2u);
                }
            }
        }
    }
}

// Rolling over a smooth hill on a slope: the depth never jumps by more than the wheel moves, and
// the normal is that of the hill but for the creases between its triangles.
TEST_P(TriangleSizeTest, SmoothGroundIsRolledOverSmoothly) {
    const double cell = GetParam();
    constexpr double kBend = 1.2;  // radius of the hill [m]
    const double cross = std::tan(0.3);
    const Height hill = [&](double x, double y) {
        return std::sqrt(kBend * kBend - x * x - 0.5 * y * y) - kBend + cross * y;
    };
    const Terrain ground = patch(cell, 0.3, 0.1, hill, 0.2);
    // Triangles of this size turn by cell / radius from one to the next; shorn ones by more.
    const double crease = 4.0 * cell / kBend;
    double last = -1.0;
    const double step = 0.001;  // 0.5 m/s at 2 ms
    for (double x = -0.15; x < 0.15; x += step) {
        const double y = 0.0123;
        const Vec3 normal = Vec3(x / kBend, 0.5 * y / kBend - cross, 1.0).normalized();
        const Vec3 center = Vec3(x, y, hill(x, y)) + kRadius * 0.99 * normal;
        const auto contacts = kWheel.contactsAt(ground, center, turned(0.2));
        ASSERT_FALSE(contacts.empty()) << x;
        for (const Contact& contact : contacts) {
            ASSERT_GT(contact.normal.dot(normal), std::cos(crease + 0.03)) << "x = " << x;
        }
        const double depth = deepest(contacts);
        if (last > -1.0) {
            ASSERT_LT(std::abs(depth - last), step) << "x = " << x;
        }
        last = depth;
    }
}

INSTANTIATE_TEST_SUITE_P(Cells, TriangleSizeTest, testing::Values(0.001, 0.005, 0.02, 0.05),
                         [](const auto& test) {
                             return std::to_string(std::lround(1e3 * test.param)) + "mm";
                         });

// A floor with bumps of a tenth of a millimetre gives many contacts; the wall stays among them.
TEST(TriangulatedGroundTest, BumpyFloorDoesNotCrowdOutAWall) {
    Random random(5);
    const double wall = 0.05;
    const Terrain ground = patch(0.001, 0.15, 0.04, [&](double x, double) {
        return x > wall - 0.0004 ? 0.2 : random.uniform(-1e-4, 1e-4);
    });
    for (double deep = 1e-5; deep < 1e-3; deep *= 1.5) {
        // The face leans by one cell over 0.2 m.
        const Vec3 normal = Vec3(-0.2, 0.0, 0.001).normalized();
        const Vec3 onFace(wall - 0.001 + 0.001 * kRadius / 0.2, 0.0, kRadius);
        const Vec3 center = onFace + (kRadius - deep) * normal;
        const auto contacts = kWheel.contactsAt(ground, {center.x(), 0.0, kRadius - 0.0005});
        int walls = 0;
        for (const Contact& contact : contacts) {
            walls += contact.normal.x() < -0.9 ? 1 : 0;
        }
        EXPECT_GE(walls, 2) << "depth " << deep;
        EXPECT_LE(contacts.size(), 2 * kMostPerSlice);
    }
}

// A ridge along the rolling direction, narrower than the wheel, between its two outer slices.
TEST(TriangulatedGroundTest, RidgeBetweenTheSlicesCarriesTheWheel) {
    const double high = 0.02;
    const Terrain ground =
        patch(0.005, 0.2, 0.1, [&](double, double y) { return std::abs(y) < 0.0105 ? high : 0.0; });
    const auto contacts = kWheel.contactsAt(ground, {0.0, 0.0, high + kRadius - 0.0004});
    ASSERT_FALSE(contacts.empty());
    for (const Contact& contact : contacts) {
        EXPECT_GE(contact.slice, 2) << "the outer slices are beside the ridge";
        EXPECT_NEAR(contact.depth, 0.0004, 1e-9);
        EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-9);
    }
}

// A disc that meets an edge askew: the normal is square to the edge and to the disc's rim.
TEST(TriangulatedGroundTest, EdgeMetAskew) {
    const Terrain step = made(spec(project::TerrainKind::Step, 0.05, 1.0));
    for (const double yaw : {-0.6, -0.2, 0.2, 0.6}) {
        const Vec3 center(1.0 - 0.04, 0.0, 0.05 + 0.066);
        int edges = 0;
        for (const Contact& contact : kWheel.contactsAt(step, center, turned(yaw))) {
            const Vec3 axis = turned(yaw) * Vec3::UnitY();
            const double side = contact.slice == 0 ? -1.0 : 1.0;
            const Vec3 arm = contact.point - (center + side * 0.45 * kWidth * axis);
            const Vec3 rim = axis.cross(arm);
            EXPECT_NEAR(contact.normal.y(), 0.0, 1e-9);
            EXPECT_NEAR(contact.normal.dot(rim.normalized()), 0.0, 1e-9);
            EXPECT_NEAR(contact.point.x(), 1.0, 1e-9);
            ++edges;
        }
        EXPECT_GE(edges, 1) << yaw;
    }
}

// The rim of a hole or of the whole ground carries a wheel as an edge does.
TEST(TriangulatedGroundTest, RimOfAHoleIsAnEdge) {
    TriangleMesh mesh;
    for (const double x : {-1.0, -0.02, 0.02, 1.0}) {
        mesh.vertices.emplace_back(x, -1.0, 0.0);
        mesh.vertices.emplace_back(x, 1.0, 0.0);
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 6, 5}, {5, 6, 7}};
    const Terrain ground = Terrain::fromMesh(mesh);
    const double depth = 0.0003;
    const double z = std::sqrt(std::pow(kRadius - depth, 2) - 0.02 * 0.02);
    const auto contacts = kWheel.contactsAt(ground, {0.0, 0.0, z});
    ASSERT_EQ(contacts.size(), 4u);
    for (const Contact& contact : contacts) {
        EXPECT_NEAR(contact.depth, depth, 1e-9);
        EXPECT_NEAR(std::abs(contact.normal.x()), 0.02 / (kRadius - depth), 1e-9);
    }
}

// A thin plate that stands across the way: from 0.01 to 0.5 m/s the wheel meets its face, and the
// depth grows by no more than the wheel moves.
TEST(TriangulatedGroundTest, ThinPlateIsNotTunnelledThrough) {
    // A plate of 1 mm, as high as two wheels, on the floor.
    const Terrain plate = Terrain::extruded(
        {{-1.0, 0.0}, {0.0, 0.0}, {0.0, 0.2}, {0.001, 0.3}, {0.001, 0.0}, {1.0, 0.0}}, -1.0, 1.0);
    for (const double speed : {0.01, 0.1, 0.5}) {
        const double step = 0.002 * speed;
        double last = 0.0;
        for (double x = -kRadius - 0.002; x < -kRadius + 0.01; x += step) {
            double wall = 0.0;
            for (const Contact& contact : kWheel.contactsAt(plate, {x, 0.0, kRadius - 0.0005})) {
                if (std::abs(contact.normal.z()) < 0.1) {
                    EXPECT_LT(contact.normal.x(), -0.99) << "pushed through the plate";
                    wall = std::max(wall, contact.depth);
                }
            }
            ASSERT_NEAR(wall, std::max(0.0, x + kRadius), 1e-9);
            ASSERT_LE(wall - last, step + 1e-9);
            last = wall;
        }
    }
}

TEST(TriangulatedGroundTest, BuriedWheelIsPushedOutTheNearestWay) {
    const Terrain step = made(spec(project::TerrainKind::Step, 0.3, 2.0));
    // Inside the block, 30 mm behind its face and 60 mm below its top.
    const auto contacts = kWheel.contactsAt(step, {1.03, 0.0, 0.24});
    ASSERT_EQ(contacts.size(), 2u);
    for (const Contact& contact : contacts) {
        EXPECT_LT((contact.normal - Vec3(-1.0, 0.0, 0.0)).norm(), 1e-9);
        EXPECT_NEAR(contact.depth, kRadius + 0.03, 1e-9);
    }
}

// A wheel that slid sideways into a block, one disc inside, is not thrown onto it.
TEST(TriangulatedGroundTest, DiscInsideABlockBesideIsNotLifted) {
    const Terrain ground =
        patch(0.005, 0.2, 0.1, [&](double, double y) { return y > 0.0125 ? 0.1 : 0.0; });
    const Vec3 center(0.0, 0.0, kRadius - 0.0004);
    for (const Contact& contact : kWheel.contactsAt(ground, center)) {
        EXPECT_LT(contact.depth, 0.01);
    }
}

TEST(TriangulatedGroundTest, BadMeshesAreTheCallersMistake) {
    TriangleMesh mesh;
    EXPECT_THROW((void)Terrain::fromMesh(mesh), std::invalid_argument);
    mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.triangles = {{0, 1, 3}};
    EXPECT_THROW((void)Terrain::fromMesh(mesh), std::invalid_argument);
    mesh.triangles = {{0, 1, 1}};
    EXPECT_THROW((void)Terrain::fromMesh(mesh), std::invalid_argument);
    mesh.triangles = {{0, 1, 2}};
    mesh.vertices[0].z() = std::nan("");
    EXPECT_THROW((void)Terrain::fromMesh(mesh), std::invalid_argument);
}
