// What is drawn over the rover: centre of mass, support polygon, forces, freedoms, trail.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/overlays/overlay_nodes.h"
#include "render/overlays/support_polygon.h"
#include "render/palette.h"
#include "simcore/base/random.h"
#include "tests/support/rovers.h"
#include "tests/support/scene_graph.h"
#include "tests/support/snapshots.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace testsupport;
using render::Scene;
using Points = std::vector<Eigen::Vector2d>;

namespace {

constexpr double kRounding = 1e-5;

class OverlayTest : public testing::Test {
  protected:
    OverlayTest() { scene.setMechanism(mechanism); }

    void show(bool render::Overlays::*overlay) {
        render::Overlays overlays;
        overlays.*overlay = true;
        scene.setOverlays(overlays);
    }

    bool isShown(const std::string& name) { return findNode(*scene.root(), name) != nullptr; }

    std::vector<DrawnVertex> drawn(const std::string& name) {
        osg::Node* node = findNode(*scene.root(), name);
        EXPECT_NE(node, nullptr) << name;
        return node != nullptr ? verticesBelow(*node) : std::vector<DrawnVertex>{};
    }

    /// Vertices in the colour of a wheel.
    static std::vector<Vec3> ofWheel(const std::vector<DrawnVertex>& drawn, int wheel) {
        const render::Rgb color = render::wheelColor(wheel);
        std::vector<Vec3> places;
        for (const DrawnVertex& vertex : drawn) {
            if (vertex.color.r() == color.r && vertex.color.g() == color.g &&
                vertex.color.b() == color.b) {
                places.push_back(vertex.place);
            }
        }
        return places;
    }

    /// How far the arrow of a wheel reaches along a direction from its contact point [m].
    double reach(const run::Snapshot& snapshot, int wheel, const Vec3& direction) {
        double farthest = 0.0;
        for (const Vec3& p : ofWheel(drawn("contact forces"), wheel)) {
            const Vec3 from = p - snapshot.wheels[static_cast<std::size_t>(wheel)].contactPoint;
            farthest = std::max(farthest, from.dot(direction));
        }
        return farthest;
    }

    const mechanism::Mechanism mechanism = mechanismOf("solero");
    Scene scene;
};

/// Where the ground contacts of a rover of six wheels may be, in any height.
run::Snapshot onPoints(run::Snapshot snapshot, const std::vector<Vec3>& points) {
    for (std::size_t i = 0; i < snapshot.wheels.size(); ++i) {
        snapshot.wheels[i].touching = i < points.size();
        if (i < points.size()) {
            snapshot.wheels[i].contactPoint = points[i];
        }
    }
    return snapshot;
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    const Eigen::Vector2d p = b - a, q = c - a;
    return p.x() * q.y() - p.y() * q.x();
}

}  // namespace

// The marker stands at the mechanism's centre of mass, its line on the ground below.
TEST_F(OverlayTest, CentreOfMassIsWhereTheMechanismSays) {
    show(&render::Overlays::centerOfMass);
    const Vec3 com = mechanism.centerOfMass();
    Eigen::AlignedBox3d box;
    for (const DrawnVertex& vertex : drawn("centre of mass")) {
        box.extend(vertex.place);
    }
    EXPECT_LT((box.center().head<2>() - com.head<2>()).norm(), kRounding);
    EXPECT_NEAR(box.min().z(), 0.0, kRounding);
    const double size = 0.5 * box.sizes().x();
    EXPECT_NEAR(box.max().z(), com.z() + size, kRounding);
    EXPECT_LT(size, 0.1 * scene.focusRadius());
}

// In a run the marker follows the instant, and its line ends on the terrain, not at z = 0.
TEST_F(OverlayTest, CentreOfMassFollowsTheRunOntoTheTerrain) {
    scene.setTerrain(
        std::make_shared<const terrain::Terrain>(made(spec(project::TerrainKind::Step, 0.1, 1.2))));
    show(&render::Overlays::centerOfMass);
    auto snapshot = standing(mechanism);
    snapshot.centerOfMass = Vec3(1.6, 0.05, 0.4);  // over the step
    scene.setSnapshot(snapshot);
    Eigen::AlignedBox3d box;
    for (const DrawnVertex& vertex : drawn("centre of mass")) {
        box.extend(vertex.place);
    }
    EXPECT_NEAR(box.center().x(), 1.6, kRounding);
    EXPECT_NEAR(box.min().z(), 0.1, kRounding);
}

// Six wheels on flat ground: the polygon spans the outermost contacts at the height of the ground.
TEST_F(OverlayTest, SupportPolygonSpansTheContactPoints) {
    show(&render::Overlays::supportPolygon);
    const auto snapshot = onPoints(standing(mechanism), {{0.5, 0.0, 0.02},
                                                         {0.2, 0.3, 0.0},
                                                         {-0.2, 0.3, 0.01},
                                                         {0.2, -0.3, 0.0},
                                                         {-0.2, -0.3, 0.03},
                                                         {0.1, 0.1, 0.0}});
    scene.setSnapshot(snapshot);
    double area = 0.0;
    const auto all = drawn("support polygon");
    std::vector<DrawnVertex> sheet;
    for (const DrawnVertex& vertex : all) {
        if (vertex.color.a() < 128) {
            sheet.push_back(vertex);
        }
    }
    ASSERT_EQ(sheet.size(), 9U);  // a pentagon is three triangles
    for (std::size_t i = 0; i < sheet.size(); i += 3) {
        area += 0.5 * std::abs(turn(sheet[i].place.head<2>(), sheet[i + 1].place.head<2>(),
                                    sheet[i + 2].place.head<2>()));
    }
    EXPECT_NEAR(area, 0.4 * 0.6 + 0.5 * 0.6 * 0.3, 1e-6);
    for (const DrawnVertex& vertex : sheet) {
        double nearest = 1.0;
        for (std::size_t i = 0; i < 5; ++i) {  // the sixth contact lies inside
            nearest = std::min(nearest, (vertex.place - snapshot.wheels[i].contactPoint).norm());
        }
        EXPECT_LT(nearest, kRounding);
    }
}

// Wheels in the air do not support; two wheels and three in a row span nothing.
TEST_F(OverlayTest, OnlyTouchingWheelsSupport) {
    show(&render::Overlays::supportPolygon);
    scene.setSnapshot(onPoints(standing(mechanism), {{0.5, 0, 0}, {-0.3, 0.3, 0}}));
    EXPECT_EQ(scene.support(), Scene::Support::None);
    EXPECT_FALSE(isShown("support polygon"));
    scene.setSnapshot(onPoints(standing(mechanism), {{0.5, 0, 0}, {0.1, 0, 0}, {-0.3, 0, 0}}));
    EXPECT_EQ(scene.support(), Scene::Support::None);
    EXPECT_FALSE(isShown("support polygon"));
    scene.setSnapshot(
        onPoints(standing(mechanism), {{0.5, 0, 0}, {-0.3, 0.3, 0}, {-0.3, -0.3, 0}}));
    EXPECT_NE(scene.support(), Scene::Support::None);
    EXPECT_TRUE(isShown("support polygon"));
}

// The polygon turns red exactly when the centre of mass leaves it.
TEST_F(OverlayTest, PolygonWarnsWhenTheCentreOfMassIsOutside) {
    show(&render::Overlays::supportPolygon);
    auto snapshot = onPoints(standing(mechanism), {{0.5, 0, 0}, {-0.3, 0.3, 0}, {-0.3, -0.3, 0}});
    for (const auto& [x, expected] : {std::pair{0.0, Scene::Support::Inside},
                                      {0.499, Scene::Support::Inside},
                                      {0.501, Scene::Support::Outside},
                                      {-0.31, Scene::Support::Outside}}) {
        snapshot.centerOfMass = Vec3(x, 0.0, 0.3);
        scene.setSnapshot(snapshot);
        EXPECT_EQ(scene.support(), expected) << x;
        const osg::Vec4ub color = drawn("support polygon").front().color;
        EXPECT_EQ(color.r() > color.g(), expected == Scene::Support::Outside) << x;
    }
}

// Hulls of random points, by definition: all points on the left of every edge, corners convex.
TEST(ConvexHull, HoldsAllPointsAndOnlyCorners) {
    Random random(11);
    for (int trial = 0; trial < 200; ++trial) {
        Points points;
        for (int i = 0; i < 3 + trial % 9; ++i) {
            points.emplace_back(random.uniform(-1, 1), random.uniform(-1, 1));
        }
        const auto hull = render::convexHull(points);
        ASSERT_GE(hull.size(), 3U);
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const auto at = [&](std::size_t k) {
                return points[static_cast<std::size_t>(hull[k % hull.size()])];
            };
            EXPECT_GT(turn(at(i), at(i + 1), at(i + 2)), 0.0);
            for (const auto& p : points) {
                EXPECT_GE(turn(at(i), at(i + 1), p), -1e-9);
            }
        }
    }
}

// No points, equal points and points in a row have no hull that spans an area.
TEST(ConvexHull, DegenerateSetsSpanNothing) {
    EXPECT_TRUE(render::convexHull({}).empty());
    EXPECT_LT(render::convexHull({{1, 2}}).size(), 3U);
    EXPECT_LT(render::convexHull({{1, 2}, {1, 2}, {1, 2}, {1, 2}}).size(), 3U);
    EXPECT_LT(render::convexHull({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).size(), 3U);
    EXPECT_THAT(render::convexHull({{0, 0}, {1, 0}, {2, 0}, {2, 2}}),
                testing::UnorderedElementsAre(0, 2, 3));
}

// An arrow starts at its contact and points along the force, oblique ones too.
TEST_F(OverlayTest, ForceArrowPointsAlongTheForce) {
    show(&render::Overlays::contactForces);
    auto snapshot = standing(mechanism);
    const Vec3 force(12.0, -5.0, 20.0);
    snapshot.wheels[2].force = force;
    scene.setSnapshot(snapshot);
    const auto arrow = ofWheel(drawn("contact forces"), 2);
    ASSERT_FALSE(arrow.empty());
    const Vec3 along = force.normalized();
    double least = 1.0, aside = 0.0;
    Vec3 tip = snapshot.wheels[2].contactPoint;
    for (const Vec3& p : arrow) {
        const Vec3 from = p - snapshot.wheels[2].contactPoint;
        least = std::min(least, from.dot(along));
        aside = std::max(aside, (from - from.dot(along) * along).norm());
        if (from.dot(along) > (tip - snapshot.wheels[2].contactPoint).dot(along)) {
            tip = p;
        }
    }
    EXPECT_NEAR(least, 0.0, kRounding);
    EXPECT_LT((tip - snapshot.wheels[2].contactPoint).normalized().cross(along).norm(), 1e-4);
    EXPECT_LT(aside, 0.05 * scene.focusRadius());
}

// Lengths are to scale: twice the force, twice the arrow, the same scale for every wheel. A wheel
// with its share of the weight has an arrow that is well seen beside the rover.
TEST_F(OverlayTest, ForceArrowsAreToScale) {
    show(&render::Overlays::contactForces);
    auto snapshot = standing(mechanism);
    scene.setSnapshot(snapshot);
    const double share = reach(snapshot, 0, Vec3::UnitZ());
    EXPECT_GT(share, 0.2 * scene.focusRadius());
    EXPECT_LT(share, scene.focusRadius());
    snapshot.wheels[0].force *= 2.0;
    snapshot.wheels[3].force *= 0.5;
    scene.setSnapshot(snapshot);
    EXPECT_NEAR(reach(snapshot, 0, Vec3::UnitZ()), 2.0 * share, kRounding);
    EXPECT_NEAR(reach(snapshot, 3, Vec3::UnitZ()), 0.5 * share, kRounding);
    EXPECT_NEAR(reach(snapshot, 5, Vec3::UnitZ()), share, kRounding);
}

// Nothing pushes a wheel in the air, and a number that is none is not drawn.
TEST_F(OverlayTest, WheelsInTheAirHaveNoArrow) {
    show(&render::Overlays::contactForces);
    auto snapshot = standing(mechanism);
    snapshot.wheels[1].touching = false;
    snapshot.wheels[4].force.x() = std::numeric_limits<double>::quiet_NaN();
    scene.setSnapshot(snapshot);
    const auto all = drawn("contact forces");
    for (int wheel = 0; wheel < 6; ++wheel) {
        EXPECT_EQ(ofWheel(all, wheel).empty(), wheel == 1 || wheel == 4) << wheel;
    }
    for (auto& wheel : snapshot.wheels) {
        wheel.touching = false;
    }
    scene.setSnapshot(snapshot);
    EXPECT_FALSE(isShown("contact forces"));
}

// In the drawn pose nothing pushes: there are no forces to show yet.
TEST_F(OverlayTest, DesignShowsNoForces) {
    show(&render::Overlays::contactForces);
    EXPECT_TRUE(!isShown("contact forces") || drawn("contact forces").empty());
}

// The number at each joint is its count, at the joint's place, of the built and the relaxed model.
TEST_F(OverlayTest, FreedomsStandAtTheirJoints) {
    show(&render::Overlays::jointFreedoms);
    for (const bool built : {true, false}) {
        std::vector<int> counts;
        for (const auto& joint : mechanism.joints) {
            counts.push_back(static_cast<int>((built ? joint.built : joint.relaxed).size()));
        }
        scene.setJointFreedomCounts(counts);
        const auto labels = drawn("joint freedoms");
        ASSERT_EQ(labels.size(), mechanism.joints.size());
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_LT((labels[i].place - mechanism.joints[i].point).norm(), kRounding);
            EXPECT_EQ(labels[i].color.r(), counts[i]) << mechanism.joints[i].name;
        }
    }
}

// The numbers go where the joints go.
TEST_F(OverlayTest, FreedomsFollowTheRover) {
    show(&render::Overlays::jointFreedoms);
    scene.setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 3));
    Pose pose = turnAbout(Vec3(0.2, 0.1, 0.0), Vec3(0.1, 1.0, 0.2), 0.4);
    pose.position += Vec3(1.5, 0.3, 0.1);
    scene.setSnapshot(standing(mechanism, pose));
    const auto labels = drawn("joint freedoms");
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_LT((labels[i].place - pose * mechanism.joints[i].point).norm(), kRounding);
    }
}

// Counts of another rover are refused, none at all clears the labels, as does another rover.
TEST_F(OverlayTest, FreedomsBelongToOneRover) {
    show(&render::Overlays::jointFreedoms);
    EXPECT_THROW(scene.setJointFreedomCounts({1, 2, 3}), std::invalid_argument);
    scene.setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 1));
    EXPECT_FALSE(drawn("joint freedoms").empty());
    scene.setJointFreedomCounts({});
    EXPECT_TRUE(drawn("joint freedoms").empty());
    scene.setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 1));
    scene.setMechanism(mechanismOf("shrimp"));
    EXPECT_TRUE(drawn("joint freedoms").empty());
}

// What is switched off is not there at all; each switch has its own node.
TEST_F(OverlayTest, EachOverlayHasItsSwitch) {
    const std::vector<std::pair<bool render::Overlays::*, std::string>> all = {
        {&render::Overlays::centerOfMass, "centre of mass"},
        {&render::Overlays::supportPolygon, "support polygon"},
        {&render::Overlays::contactForces, "contact forces"},
        {&render::Overlays::trail, "trail"},
        {&render::Overlays::axes, "axes"}};
    scene.setSnapshot(standing(mechanism));
    for (const auto& [overlay, name] : all) {
        show(overlay);
        for (const auto& [other, otherName] : all) {
            EXPECT_EQ(isShown(otherName), otherName == name) << name << ", " << otherName;
        }
    }
}

// The axes are the world's: red along x, green along y, blue along z.
TEST_F(OverlayTest, AxesAreRedGreenBlue) {
    show(&render::Overlays::axes);
    std::array<Vec3, 3> farthest = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (const DrawnVertex& vertex : drawn("axes")) {
        const std::array<int, 3> rgb = {vertex.color.r(), vertex.color.g(), vertex.color.b()};
        if (*std::min_element(rgb.begin(), rgb.end()) > 200) {
            continue;  // the white ball at the origin
        }
        const auto axis =
            static_cast<std::size_t>(std::max_element(rgb.begin(), rgb.end()) - rgb.begin());
        if (vertex.place.norm() > farthest[axis].norm()) {
            farthest[axis] = vertex.place;
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3& tip = farthest[static_cast<std::size_t>(axis)];
        EXPECT_GT(tip.dot(Vec3::Unit(axis)), 0.999 * tip.norm());
    }
}
