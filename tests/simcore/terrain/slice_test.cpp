#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::terrain;
using namespace testsupport;
using project::TerrainKind;

namespace {

using Segment = std::array<double, 4>;

/// The section by going through every triangle of the mesh: clips its edges at the plane.
std::vector<Segment> bruteForce(const Terrain& terrain, const SlicePlane& plane, double radius) {
    const Vec3 w = plane.u.cross(plane.v);
    std::vector<Segment> segments;
    for (const auto& t : terrain.mesh().triangles) {
        std::vector<Eigen::Vector2d> ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 a = terrain.mesh().vertices[static_cast<std::size_t>(t[k])] - plane.origin;
            const Vec3 b =
                terrain.mesh().vertices[static_cast<std::size_t>(t[(k + 1) % 3])] - plane.origin;
            const double da = w.dot(a);
            const double db = w.dot(b);
            if ((da < 0.0) != (db < 0.0)) {
                const Vec3 p = a + (b - a) * (da / (da - db));
                ends.emplace_back(plane.u.dot(p), plane.v.dot(p));
            }
        }
        if (ends.size() != 2) {
            continue;
        }
        // Kept when it reaches into the disc.
        const Eigen::Vector2d along = ends[1] - ends[0];
        const double s = along.squaredNorm() > 0.0
                             ? std::clamp(-ends[0].dot(along) / along.squaredNorm(), 0.0, 1.0)
                             : 0.0;
        if ((ends[0] + s * along).norm() > radius) {
            continue;
        }
        segments.push_back({ends[0].x(), ends[0].y(), ends[1].x(), ends[1].y()});
    }
    return segments;
}

std::vector<Segment> withinDisc(const std::vector<SliceSegment>& slice, double radius) {
    std::vector<Segment> segments;
    for (const SliceSegment& piece : slice) {
        const Eigen::Vector2d along = piece.b - piece.a;
        const double s = along.squaredNorm() > 0.0
                             ? std::clamp(-piece.a.dot(along) / along.squaredNorm(), 0.0, 1.0)
                             : 0.0;
        if ((piece.a + s * along).norm() > radius) {
            continue;
        }
        segments.push_back({piece.a.x(), piece.a.y(), piece.b.x(), piece.b.y()});
    }
    return segments;
}

/// The same piece, in either direction.
bool same(const Segment& a, const Segment& b) {
    const auto distance = [](const Segment& p, const Segment& q) {
        double largest = 0.0;
        for (std::size_t n = 0; n < 4; ++n) {
            largest = std::max(largest, std::abs(p[n] - q[n]));
        }
        return largest;
    };
    return std::min(distance(a, b), distance(a, {b[2], b[3], b[0], b[1]})) < 1e-9;
}

/// A wheel plane, tilted by up to 25 degrees to each side and turned by up to 40.
SlicePlane randomPlane(const Terrain& terrain, Random& random, double radius) {
    const double yaw = random.uniform(-0.7, 0.7);
    const double roll = random.uniform(-0.45, 0.45);
    const double pitch = random.uniform(-1.0, 1.0);
    const Eigen::Quaterniond turn = Eigen::AngleAxisd(yaw, Vec3::UnitZ()) *
                                    Eigen::AngleAxisd(roll, Vec3::UnitX()) *
                                    Eigen::AngleAxisd(pitch, Vec3::UnitY());
    const double x = random.uniform(-1.0, 4.5);
    const double y = random.uniform(-1.0, 1.0);
    return {{x, y, terrain.heightAt(x, y) + radius * random.uniform(0.2, 1.0)},
            turn * Vec3::UnitX(),
            turn * Vec3::UnitZ()};
}

Vec3 randomDirection(Random& random) {
    return Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0))
        .normalized();
}

}  // namespace

class SliceTest : public testing::TestWithParam<project::Terrain> {};

TEST_P(SliceTest, AgreesWithEveryTriangleOfTheMesh) {
    const Terrain terrain = made(GetParam());
    const bool large = terrain.mesh().triangles.size() > 10000;
    Random random(5);
    std::vector<SliceSegment> slice;
    std::size_t total = 0;
    for (int i = 0; i < (large ? 60 : 500); ++i) {
        const double radius = random.uniform(0.05, 0.3);
        const SlicePlane plane = randomPlane(terrain, random, radius);
        terrain.slice(plane, radius, slice);
        const std::vector<Segment> found = withinDisc(slice, radius);
        const std::vector<Segment> wanted = bruteForce(terrain, plane, radius);
        total += wanted.size();
        ASSERT_EQ(found.size(), wanted.size()) << "plane " << i;
        for (const Segment& segment : wanted) {
            ASSERT_TRUE(std::any_of(found.begin(), found.end(),
                                    [&](const Segment& f) { return same(f, segment); }))
                << "plane " << i << " misses (" << segment[0] << ", " << segment[1] << ") to ("
                << segment[2] << ", " << segment[3] << ")";
        }
        for (const SliceSegment& piece : slice) {
            // The free side is left, the normal is a unit vector and points to it.
            const Eigen::Vector2d along = piece.b - piece.a;
            const double left =
                -along.y() * piece.normal.dot(plane.u) + along.x() * piece.normal.dot(plane.v);
            ASSERT_GE(left, 0.0);
            ASSERT_NEAR(piece.normal.norm(), 1.0, 1e-12);
            ASSERT_GE(piece.normal.z(), -1e-12) << "ground that hangs over";
        }
    }
    EXPECT_GT(total, 100u) << "the planes miss the ground";
}

// Discs of a wheel: beside each other, forward level, in or just above the ground. Cells that stay
// below them are not looked at, and must not be missed; nor what comes near as the wheel moves.
TEST_P(SliceTest, DiscsOfAWheelAgreeWithEveryTriangleToo) {
    const Terrain terrain = made(GetParam());
    const bool large = terrain.mesh().triangles.size() > 10000;
    Random random(8);
    const std::array<double, 4> offsets{-0.0225, -0.0075, 0.0075, 0.0225};
    GroundPatch near;
    std::array<std::vector<SliceSegment>, 4> slices;
    std::size_t total = 0;
    for (int i = 0; i < (large ? 40 : 300); ++i) {
        const double radius = random.uniform(0.05, 0.2);
        SlicePlane plane = randomPlane(terrain, random, radius);
        const Vec3 axis = plane.v.cross(plane.u);
        plane.u = axis.cross(Vec3::UnitZ()).normalized();
        plane.v = plane.u.cross(axis);
        plane.origin.z() += radius * random.uniform(0.0, 0.6);
        const double slack = i % 3 == 0 ? 0.0 : random.uniform(0.0, 0.01);
        const double reach = radius + offsets.back();
        const double way = i % 2 == 0 ? slack : random.uniform(0.0, slack);
        const double turn = random.uniform(0.0, 0.5) * way / reach;
        SlicePlane before = plane;
        before.origin += (way - turn * reach) * randomDirection(random);
        const Eigen::AngleAxisd turned(turn, randomDirection(random));
        const Vec3 axisBefore = turned * axis;
        before.u = axisBefore.cross(Vec3::UnitZ()).normalized();
        before.v = before.u.cross(axisBefore);
        terrain.findNear(before, offsets, radius, slack, near);
        near.see(plane);
        for (std::size_t k = 0; k < offsets.size(); ++k) {
            near.slice(k, offsets[k], radius, way, slices[k]);
        }
        for (std::size_t k = 0; k < offsets.size(); ++k) {
            SlicePlane disc = plane;
            disc.origin += offsets[k] * axis;
            const std::vector<Segment> found = withinDisc(slices[k], radius);
            const std::vector<Segment> wanted = bruteForce(terrain, disc, radius);
            total += wanted.size();
            ASSERT_EQ(found.size(), wanted.size()) << "plane " << i << ", disc " << k;
            for (const Segment& segment : wanted) {
                ASSERT_TRUE(std::any_of(found.begin(), found.end(),
                                        [&](const Segment& f) { return same(f, segment); }))
                    << "plane " << i << ", disc " << k;
            }
        }
    }
    EXPECT_GT(total, 100u) << "the planes miss the ground";
}

INSTANTIATE_TEST_SUITE_P(Terrains, SliceTest,
                         testing::Values(spec(TerrainKind::Flat),
                                         spec(TerrainKind::Step, 0.15, 0.8),
                                         spec(TerrainKind::Stairs, 0.1, 0.2, 0.0, 6),
                                         spec(TerrainKind::Sinus, 0.1, 0.4, 0.0, 4),
                                         spec(TerrainKind::Circle, 0.0, 0.5, 0.15, 3),
                                         spec(TerrainKind::RandomProfile, 0.1, 3.0, 0.0, 8, 3),
                                         spec(TerrainKind::Particles, 0.0, 3.0, 0.11, 150, 3)),
                         [](const auto& test) {
                             std::string name = nameOf(test.param.kind);
                             std::erase(name, '-');
                             return name;
                         });

// The polyline of a profile is a corner chain: a slice along x must show it exactly.
TEST(SliceExtrudedTest, AlignedSliceIsThePolyline) {
    const Terrain terrain = made(spec(TerrainKind::Stairs, 0.1, 0.2, 0.0, 3));
    const SlicePlane plane{{1.3, 0.123, 0.2}, Vec3::UnitX(), Vec3::UnitZ()};
    std::vector<SliceSegment> slice;
    terrain.slice(plane, 0.5, slice);
    for (const SliceSegment& piece : slice) {
        for (const Eigen::Vector2d& end : {piece.a, piece.b}) {
            // Each end lies on the profile: on an edge of it.
            double nearest = 1.0;
            const Eigen::Vector2d p(end.x() + 1.3, end.y() + 0.2);
            for (std::size_t i = 0; i + 1 < terrain.profile().size(); ++i) {
                const Eigen::Vector2d a = terrain.profile()[i];
                const Eigen::Vector2d along = terrain.profile()[i + 1] - a;
                const double s = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (a + s * along - p).norm());
            }
            EXPECT_LT(nearest, 1e-12);
        }
    }
    EXPECT_GE(slice.size(), 7u);
}

// Nothing touches the mesh beyond its edges; a slice there must not fail.
TEST(SliceEdgeTest, OutsideTheMeshThereIsNothing) {
    const Terrain terrain = made(spec(TerrainKind::Particles, 0.0, 3.0, 0.11, 50, 3));
    std::vector<SliceSegment> slice;
    terrain.slice({{100.0, 0.0, 0.1}, Vec3::UnitX(), Vec3::UnitZ()}, 0.2, slice);
    EXPECT_TRUE(withinDisc(slice, 0.2).empty());
    terrain.slice({{0.0, -30.0, 0.1}, Vec3::UnitX(), Vec3::UnitZ()}, 0.2, slice);
    EXPECT_TRUE(withinDisc(slice, 0.2).empty());
}

TEST(TerrainTest, MeshIsCounterClockwiseAndMirrorsItsDiagonals) {
    const Terrain terrain = Terrain::grid(-1.0, -1.0, 0.1, 21, 21, std::vector<double>(441, 0.0));
    const auto& mesh = terrain.mesh();
    ASSERT_EQ(mesh.triangles.size(), 800u);
    double area = 0.0;
    std::vector<Segment> edges;
    for (const auto& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
        const Vec3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
        const Vec3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
        const Vec3 normal = (b - a).cross(c - a);
        EXPECT_GT(normal.z(), 0.0);
        area += 0.5 * normal.norm();
        for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
            const bool diagonal = std::abs(p.x() - q.x()) > 0.05 && std::abs(p.y() - q.y()) > 0.05;
            if (diagonal && p.x() < q.x()) {
                edges.push_back({std::round(p.x() * 10), std::round(p.y() * 10),
                                 std::round(q.x() * 10), std::round(q.y() * 10)});
            }
        }
    }
    EXPECT_NEAR(area, 4.0, 1e-9);
    EXPECT_EQ(edges.size(), 400u);
    for (const Segment& e : edges) {
        const Segment mirrored{e[0], -e[1], e[2], -e[3]};
        EXPECT_NE(std::find(edges.begin(), edges.end(), mirrored), edges.end());
    }
}

TEST(TerrainTest, BadMeshesAreTheCallersMistake) {
    EXPECT_THROW((void)Terrain::extruded({{0.0, 0.0}}, -1.0, 1.0), std::invalid_argument);
    EXPECT_THROW((void)Terrain::extruded({{0.0, 0.0}, {-1.0, 0.0}}, -1.0, 1.0),
                 std::invalid_argument);
    EXPECT_THROW((void)Terrain::extruded({{0.0, 0.0}, {0.0, 0.0}}, -1.0, 1.0),
                 std::invalid_argument);
    EXPECT_THROW((void)Terrain::grid(0.0, 0.0, 0.1, 2, 2, {0.0}), std::invalid_argument);
    EXPECT_THROW((void)Terrain::grid(0.0, 0.0, 0.0, 2, 2, {0.0, 0.0, 0.0, 0.0}),
                 std::invalid_argument);
}

// Ground of equal rows needs no discs between a wheel's outer ones.
TEST(TerrainTest, KnowsWhenItIsTheSameAcross) {
    std::vector<double> heights{0.0, 0.0, 0.0, 0.1, 0.1, 0.1, 0.05, 0.05, 0.05};
    EXPECT_TRUE(Terrain::grid(0.0, 0.0, 0.1, 3, 3, heights).sameAcross());
    EXPECT_TRUE(Terrain::extruded({{0.0, 0.0}, {1.0, 0.1}}, -1.0, 1.0).sameAcross());
    heights[4] += 1e-9;
    EXPECT_FALSE(Terrain::grid(0.0, 0.0, 0.1, 3, 3, heights).sameAcross());
    heights[4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(Terrain::grid(0.0, 0.0, 0.1, 3, 3, heights).sameAcross());
    EXPECT_FALSE(Terrain::fromMesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}).sameAcross());
}
