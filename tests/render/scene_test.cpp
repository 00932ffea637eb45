// The scene graph of a rover, without OpenGL: nodes, poses, trail, highlight, picking, views.
#include <cmath>
#include <numbers>

#include <osg/MatrixTransform>

#include <gtest/gtest.h>

#include "render/palette.h"
#include "render/scene.h"
#include "simcore/base/random.h"
#include "tests/support/rovers.h"
#include "tests/support/scene_graph.h"
#include "tests/support/snapshots.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace testsupport;
using render::CameraPose;
using render::Pick;
using render::Scene;
using render::View;

namespace {

constexpr double kRounding = 1e-5;

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

class SceneTest : public testing::Test {
  protected:
    SceneTest() { scene.setMechanism(mechanism); }

    osg::Node& bodyNode(const std::string& name) {
        osg::Node* node = findNode(*scene.root(), name);
        if (node == nullptr) {
            throw std::runtime_error("no node " + name);
        }
        return *node;
    }

    std::vector<DrawnVertex> roverVertices() {
        std::vector<DrawnVertex> all;
        for (const auto& body : mechanism.bodies) {
            const auto part = verticesBelow(bodyNode(body.name));
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    }

    /// Mean place of a wheel's painted spoke, seen from its centre.
    Vec3 mark(const mechanism::Wheel& wheel) {
        const render::Rgb white = *render::parseColor("white");
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (const DrawnVertex& vertex :
             verticesBelow(bodyNode(mechanism.bodies[index(wheel.body)].name))) {
            if (vertex.color.r() == white.r && vertex.color.g() == white.g &&
                vertex.color.b() == white.b) {
                sum += vertex.place;
                ++count;
            }
        }
        EXPECT_GT(count, 0);
        return sum / count - scene.bodyPose(wheel.body) * wheel.center;
    }

    std::size_t drawnTrail() {
        osg::Node* node = findNode(*scene.root(), "trail");
        return node != nullptr ? verticesBelow(*node).size() : 0;
    }

    const mechanism::Mechanism mechanism = mechanismOf("solero");
    Scene scene;
};

Pose randomPose(Random& random) {
    const Vec3 axis(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    Pose pose = turnAbout(Vec3::Zero(), axis, random.uniform(-3, 3));
    pose.position = Vec3(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2));
    return pose;
}

/// Where a point lies in the picture: x and y from -1 to 1 are seen, when it is in front.
std::optional<Eigen::Vector2d> inPicture(const CameraPose& camera, double aspect, const Vec3& p) {
    const Vec3 ahead = (camera.center - camera.eye).normalized();
    const Vec3 right = ahead.cross(camera.up).normalized();
    const double depth = (p - camera.eye).dot(ahead);
    if (depth <= 0.0) {
        return std::nullopt;
    }
    const double half = std::tan(0.5 * render::kFieldOfView * std::numbers::pi / 180.0) * depth;
    return Eigen::Vector2d((p - camera.eye).dot(right) / (half * aspect),
                           (p - camera.eye).dot(right.cross(ahead)) / half);
}

}  // namespace

// Every body has a node of its name, with something to draw, where it was designed.
TEST_F(SceneTest, EveryBodyIsANodeOfItsName) {
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        osg::Node& node = bodyNode(mechanism.bodies[i].name);
        EXPECT_NE(dynamic_cast<osg::MatrixTransform*>(&node), nullptr);
        EXPECT_FALSE(verticesBelow(node).empty()) << mechanism.bodies[i].name;
        const Pose pose = scene.bodyPose(static_cast<int>(i));
        EXPECT_LT(pose.position.norm(), 1e-12);
        EXPECT_LT(pose.rotation.angularDistance(Eigen::Quaterniond::Identity()), 1e-9);
    }
}

// Whatever the poses are, the drawn points of each body go where its pose carries them.
TEST_F(SceneTest, SnapshotCarriesEveryBody) {
    Random random(5);
    std::vector<std::vector<DrawnVertex>> before;
    for (const auto& body : mechanism.bodies) {
        before.push_back(verticesBelow(bodyNode(body.name)));
    }
    auto snapshot = standing(mechanism);
    for (Pose& pose : snapshot.bodies) {
        pose = randomPose(random);
    }
    scene.setSnapshot(snapshot);
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const auto after = verticesBelow(bodyNode(mechanism.bodies[i].name));
        ASSERT_EQ(after.size(), before[i].size());
        for (std::size_t k = 0; k < after.size(); k += 7) {
            ASSERT_LT((after[k].place - snapshot.bodies[i] * before[i][k].place).norm(), kRounding);
            ASSERT_LT((after[k].normal - snapshot.bodies[i].rotation * before[i][k].normal).norm(),
                      kRounding);
        }
        EXPECT_LT(
            (scene.bodyPose(static_cast<int>(i)).position - snapshot.bodies[i].position).norm(),
            1e-9);
    }
}

// A turned wheel is seen to turn, by its angle, and the right way: a mark on top moves forward.
TEST_F(SceneTest, WheelsTurnWithTheirBodies) {
    constexpr double kTurn = 0.35;
    std::vector<Vec3> before;
    for (const auto& wheel : mechanism.wheels) {
        before.push_back(mark(wheel));
        EXPECT_GT(before.back().norm(), 0.2 * wheel.radius);
    }
    scene.setSnapshot(standing(mechanism, {}, kTurn));
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        const auto& wheel = mechanism.wheels[i];
        const Vec3 after = mark(wheel);
        const double sine = before[i].cross(after).dot(wheel.axis);
        EXPECT_NEAR(std::atan2(sine, before[i].dot(after)), kTurn, 1e-4) << wheel.name;
        const Vec3 top(0.0, 0.0, wheel.radius);
        EXPECT_GT((turnAbout(Vec3::Zero(), wheel.axis, kTurn) * top - top).x(), 0.0);
    }
}

// A snapshot of another rover is a programmer's mistake and is refused.
TEST_F(SceneTest, SnapshotOfAnotherRoverIsRefused) {
    auto snapshot = standing(mechanism);
    snapshot.bodies.pop_back();
    EXPECT_THROW(scene.setSnapshot(snapshot), std::invalid_argument);
    snapshot = standing(mechanism);
    snapshot.wheels.pop_back();
    EXPECT_THROW(scene.setSnapshot(snapshot), std::invalid_argument);
}

// Another rover takes the place of the first: none of its nodes stay, and it stands as designed.
TEST_F(SceneTest, AnotherRoverReplacesTheFirst) {
    scene.setSnapshot(rolled(mechanism, 2.0, 1.0));
    const auto other = mechanismOf("rocker_bogie");
    scene.setMechanism(other);
    for (const auto& body : mechanism.bodies) {
        if (other.findBody(body.name) < 0) {
            EXPECT_EQ(findNode(*scene.root(), body.name), nullptr) << body.name;
        }
    }
    for (std::size_t i = 0; i < other.bodies.size(); ++i) {
        EXPECT_NE(findNode(*scene.root(), other.bodies[i].name), nullptr);
        EXPECT_LT(scene.bodyPose(static_cast<int>(i)).position.norm(), 1e-12);
    }
}

// The ball that the views aim at holds the rover and moves with it.
TEST_F(SceneTest, FocusMovesWithTheRover) {
    Pose pose = turnAbout(Vec3::Zero(), Vec3::UnitZ(), 1.0);
    pose.position = Vec3(3.0, -1.0, 0.2);
    scene.setSnapshot(standing(mechanism, pose));
    for (const DrawnVertex& vertex : roverVertices()) {
        ASSERT_LE((vertex.place - scene.focus()).norm(), 1.01 * scene.focusRadius());
    }
}

// The trail grows as the rover drives: through every instant's centre of mass, in order.
TEST_F(SceneTest, TrailPassesThroughTheCentresOfMass) {
    scene.setOverlays({.trail = true});
    std::vector<Vec3> centers;
    for (int i = 0; i < 12; ++i) {
        const auto snapshot = rolled(mechanism, 0.05 * i, 0.1 * i);
        scene.setSnapshot(snapshot);
        centers.push_back(snapshot.centerOfMass);
        EXPECT_EQ(scene.trailLength(), i + 1);
    }
    const auto drawn = verticesBelow(*findNode(*scene.root(), "trail"));
    ASSERT_GE(drawn.size(), 2 * (centers.size() - 1));
    for (std::size_t i = 0; i + 1 < centers.size(); ++i) {
        EXPECT_LT((drawn[2 * i].place - centers[i]).norm(), kRounding);
        EXPECT_LT((drawn[2 * i + 1].place - centers[i + 1]).norm(), kRounding);
    }
}

// Every touching wheel leaves a track in its colour; one in the air leaves a gap.
TEST_F(SceneTest, WheelsLeaveTracksWhereTheyTouch) {
    scene.setOverlays({.trail = true});
    for (int i = 0; i < 10; ++i) {
        auto snapshot = rolled(mechanism, 0.05 * i, 0.1 * i);
        snapshot.wheels[0].touching = i < 4;
        scene.setSnapshot(snapshot);
    }
    std::array<int, 2> corners{};
    for (const DrawnVertex& vertex : verticesBelow(*findNode(*scene.root(), "trail"))) {
        for (int wheel = 0; wheel < 2; ++wheel) {
            const render::Rgb color = render::wheelColor(wheel);
            if (vertex.color.r() == color.r && vertex.color.g() == color.g &&
                vertex.color.b() == color.b) {
                ++corners[index(wheel)];
                EXPECT_GT(vertex.place.z(), 0.0);  // just above the ground, else it flickers
                EXPECT_LT(vertex.place.z(), 0.01);
            }
        }
    }
    EXPECT_EQ(corners[0], 2 * 3);
    EXPECT_EQ(corners[1], 2 * 9);
}

// Showing an instant again, or switching overlays, adds nothing to the trail.
TEST_F(SceneTest, TrailOfAnInstantShownTwiceIsTheSame) {
    scene.setSnapshot(rolled(mechanism, 0.0, 0.0));
    scene.setSnapshot(rolled(mechanism, 0.1, 1.0));
    const int length = scene.trailLength();
    scene.setSnapshot(rolled(mechanism, 0.1, 1.0));
    scene.setOverlays({.trail = true});
    scene.setOverlays({});
    scene.setTheme(true);
    EXPECT_EQ(scene.trailLength(), length);
}

// A rover that stands still does not fill the memory with trail.
TEST_F(SceneTest, StandingStillAddsNoTrail) {
    for (int i = 0; i < 100; ++i) {
        scene.setSnapshot(rolled(mechanism, 1e-5 * i, 0.02 * i));
    }
    EXPECT_LE(scene.trailLength(), 2);
}

// Looking back in time cuts off what had not been driven then.
TEST_F(SceneTest, TrailEndsAtTheInstantOnShow) {
    scene.setOverlays({.trail = true});
    for (int i = 0; i < 10; ++i) {
        scene.setSnapshot(rolled(mechanism, 0.1 * i, 0.1 * i));
    }
    scene.setSnapshot(rolled(mechanism, 0.4, 0.4));
    EXPECT_EQ(scene.trailLength(), 5);
    for (const DrawnVertex& vertex : verticesBelow(*findNode(*scene.root(), "trail"))) {
        EXPECT_LT(vertex.place.x(), 0.4 + scene.focusRadius());
    }
}

// Looking back and then at the end again shows the whole way, not a short cut through the air.
TEST_F(SceneTest, TrailIsWholeAgainAfterLookingBack) {
    scene.setOverlays({.trail = true});
    for (int i = 0; i < 10; ++i) {
        scene.setSnapshot(rolled(mechanism, 0.1 * i, 0.1 * i));
    }
    const std::size_t whole = drawnTrail();
    scene.setSnapshot(rolled(mechanism, 0.2, 0.2));
    EXPECT_LT(drawnTrail(), whole);
    scene.setSnapshot(rolled(mechanism, 0.9, 0.9));
    EXPECT_EQ(scene.trailLength(), 10);
    EXPECT_EQ(drawnTrail(), whole);
}

// The trail belongs to one rover on one terrain.
TEST_F(SceneTest, TrailIsClearedWithRoverAndTerrain) {
    const auto drive = [this] {
        for (int i = 0; i < 3; ++i) {
            scene.setSnapshot(rolled(mechanism, 0.1 * i, 0.1 * i));
        }
        return scene.trailLength();
    };
    EXPECT_EQ(drive(), 3);
    scene.clearTrail();
    EXPECT_EQ(scene.trailLength(), 0);
    EXPECT_EQ(drive(), 3);
    scene.setTerrain(nullptr);
    EXPECT_EQ(scene.trailLength(), 0);
    EXPECT_EQ(drive(), 3);
    scene.setMechanism(mechanism);
    EXPECT_EQ(scene.trailLength(), 0);
}

// A highlighted joint wears a ring about its pin, at its place in the instant on show.
TEST_F(SceneTest, HighlightedJointWearsARing) {
    Pose pose = turnAbout(Vec3::Zero(), Vec3(0.3, 0.2, 1.0), 0.9);
    pose.position = Vec3(1.0, 0.2, 0.1);
    scene.setSnapshot(standing(mechanism, pose));
    for (const auto& name : {"fork_a", "rear_axle"}) {
        const int joint = mechanism.findJoint(name);
        ASSERT_GE(joint, 0) << name;
        scene.highlight({{joint}, {}});
        const Vec3 place = pose * mechanism.joints[index(joint)].point;
        const Vec3 axis = pose.rotation * mechanism.joints[index(joint)].axis;
        Eigen::AlignedBox3d box;
        for (const DrawnVertex& vertex : verticesBelow(bodyNode("highlighted joint"))) {
            const Vec3 from = vertex.place - place;
            EXPECT_LT(std::abs(from.dot(axis)), 0.3 * from.norm());
            box.extend(vertex.place);
        }
        EXPECT_LT((box.center() - place).norm(), 0.02 * scene.focusRadius()) << name;
    }
    scene.highlight({});
    EXPECT_EQ(findNode(*scene.root(), "highlighted joint"), nullptr);
}

// Marks stand beside the highlight, and go with the rover they are of.
TEST_F(SceneTest, MarkedJointsWearRingsBesideTheHighlightedOne) {
    const auto rings = [this] {
        int count = 0;
        osg::Group* overlays = bodyNode("highlighted joint").getParent(0);
        for (unsigned i = 0; i < overlays->getNumChildren(); ++i) {
            count += overlays->getChild(i)->getName() == "marked joint" ? 1 : 0;
        }
        return count;
    };
    scene.highlight({{0}, {}});
    EXPECT_EQ(rings(), 0);
    scene.mark({1, 2, 4}, {0, 3});
    EXPECT_EQ(rings(), 3);
    EXPECT_EQ(scene.highlighted().joints, std::vector<int>{0});
    EXPECT_EQ(scene.markedBodies(), (std::vector<int>{0, 3}));
    float glow = 0.0F;
    bodyNode(mechanism.bodies[3].name).getOrCreateStateSet()->getUniform("highlight")->get(glow);
    EXPECT_GT(glow, 0.5F);
    const int joints = static_cast<int>(mechanism.joints.size());
    EXPECT_THROW(scene.mark({joints}, {}), std::invalid_argument);
    EXPECT_THROW(scene.mark({}, {-1}), std::invalid_argument);
    scene.setMechanism(mechanism);
    EXPECT_TRUE(scene.markedJoints().empty());
    EXPECT_TRUE(scene.markedBodies().empty());
}

// Only the highlighted body glows; -1 ends it; another rover starts without.
TEST_F(SceneTest, OnlyTheHighlightedBodyGlows) {
    const auto glowing = [this] {
        std::vector<int> bodies;
        for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
            osg::Uniform* glow =
                bodyNode(mechanism.bodies[i].name).getOrCreateStateSet()->getUniform("highlight");
            float value = 0.0F;
            if (glow != nullptr && glow->get(value) && value > 0.5F) {
                bodies.push_back(static_cast<int>(i));
            }
        }
        return bodies;
    };
    scene.highlight({{}, {2}});
    EXPECT_EQ(glowing(), std::vector<int>{2});
    scene.highlight({{}, {0, 3}});  // both copies of a mirrored one
    EXPECT_EQ(glowing(), (std::vector<int>{0, 3}));
    scene.highlight({});
    EXPECT_TRUE(glowing().empty());
    scene.highlight({{}, {3}});
    scene.setMechanism(mechanism);
    EXPECT_TRUE(glowing().empty());
}

// A highlighted shape has its own mark, at its place in the instant on show; its body does not
// glow.
TEST_F(SceneTest, HighlightedShapeIsMarkedAlone) {
    Pose pose = turnAbout(Vec3::Zero(), Vec3(0.3, 0.2, 1.0), 0.9);
    pose.position = Vec3(1.0, 0.2, 0.1);
    scene.setSnapshot(standing(mechanism, pose));
    const auto& shapes = mechanism.bodies[index(mechanism.chassis)].shapes;
    ASSERT_GT(shapes.size(), 1u);
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        scene.highlight({{}, {mechanism.chassis}, static_cast<int>(k)});
        Eigen::AlignedBox3d found;
        for (const DrawnVertex& vertex : verticesBelow(bodyNode("highlighted shape"))) {
            found.extend(pose.inverse() * vertex.place);
        }
        const bool box = shapes[k].kind == simcore::project::ShapeKind::Box;
        if (box && shapes[k].pitch == 0.0) {
            EXPECT_LT((found.center() - shapes[k].center).norm(), 1e-5) << k;
            EXPECT_LT((found.sizes() - shapes[k].size).norm(), 1e-5) << k;
        }
        EXPECT_LT(found.sizes().norm(), 4.0 * scene.focusRadius()) << k;
    }
    float glow = 1.0F;
    bodyNode(mechanism.bodies[index(mechanism.chassis)].name)
        .getOrCreateStateSet()
        ->getUniform("highlight")
        ->get(glow);
    EXPECT_EQ(glow, 0.0F);
    scene.highlight({{}, {mechanism.chassis}});
    EXPECT_EQ(findNode(*scene.root(), "highlighted shape"), nullptr);
    scene.highlight({{}, {mechanism.chassis}, 0});
    scene.setMechanism(mechanism);
    EXPECT_EQ(findNode(*scene.root(), "highlighted shape"), nullptr);
    EXPECT_THROW(scene.highlight({{}, {mechanism.chassis}, static_cast<int>(shapes.size())}),
                 std::invalid_argument);
    EXPECT_THROW(scene.highlight({{}, {-1}, 0}), std::invalid_argument);
}

// There is no joint and no body beyond the last.
TEST_F(SceneTest, HighlightBeyondTheLastIsRefused) {
    EXPECT_THROW(scene.highlight({{static_cast<int>(mechanism.joints.size())}, {}}),
                 std::invalid_argument);
    EXPECT_THROW(scene.highlight({{}, {static_cast<int>(mechanism.bodies.size())}}),
                 std::invalid_argument);
}

// A ray onto a wheel, away from its pins, hits that wheel's body on its near side: every wheel.
TEST_F(SceneTest, PickHitsTheWheelThatWasAimedAt) {
    Pose pose = turnAbout(Vec3::Zero(), Vec3::UnitZ(), 0.6);
    pose.position = Vec3(1.2, 0.4, 0.0);
    scene.setSnapshot(standing(mechanism, pose));
    for (const auto& wheel : mechanism.wheels) {
        const double side = wheel.center.y() < 0.0 ? -1.0 : 1.0;
        const Vec3 at = wheel.center + 0.85 * wheel.radius * Vec3::UnitX();
        const Pick pick = scene.pick(pose * (at + side * 3.0 * wheel.axis), pose * at, 1e-4);
        EXPECT_EQ(pick.body, wheel.body) << wheel.name;
        EXPECT_EQ(pick.joint, -1) << wheel.name;
        ASSERT_TRUE(pick.point.has_value());
        EXPECT_NEAR((*pick.point - pose * at).norm(), 0.5 * wheel.width, 0.2 * wheel.width);
    }
}

// A ray close by a pin picks the joint, one farther off than its reach does not.
TEST_F(SceneTest, PickFindsTheJointWithinReach) {
    scene.setSnapshot(rolled(mechanism, 0.7, 1.0));
    const Vec3 move(0.7, 0.0, 0.0);
    for (const auto& wheel : mechanism.wheels) {
        const auto& joint = mechanism.joints[index(wheel.axle)];
        const double side = joint.point.y() < 0.0 ? -1.0 : 1.0;
        const Vec3 at = joint.point + move + Vec3(0.004, 0.0, 0.0);
        const Vec3 from = at + side * 3.0 * Vec3::UnitY();
        EXPECT_EQ(scene.pick(from, at - side * Vec3::UnitY(), 0.01).joint, wheel.axle)
            << joint.name;
        EXPECT_NE(scene.pick(from, at - side * Vec3::UnitY(), 0.003).joint, wheel.axle);
    }
}

// Pins on the far side of the rover are not picked through it.
TEST_F(SceneTest, PickDoesNotReachThroughTheRover) {
    const int right = mechanism.wheels[index(mechanism.findWheel("bogie_right_front"))].axle;
    const int left = mechanism.wheels[index(mechanism.findWheel("bogie_left_front"))].axle;
    const Vec3 at = mechanism.joints[index(right)].point;
    EXPECT_EQ(scene.pick(at - 3.0 * Vec3::UnitY(), at + 3.0 * Vec3::UnitY(), 0.01).joint, right);
    EXPECT_EQ(scene.pick(at + 3.0 * Vec3::UnitY(), at - 3.0 * Vec3::UnitY(), 0.01).joint, left);
}

// A ray beside the rover hits the ground where the ground is, a ray to the sky hits nothing.
TEST_F(SceneTest, PickHitsTheGroundAtItsHeight) {
    const auto terrain = std::make_shared<const terrain::Terrain>(
        made(spec(project::TerrainKind::Particles, 0.0, 1.0, 0.11, 20, 3)));
    scene.setTerrain(terrain);
    Random random(3);
    for (int i = 0; i < 20; ++i) {
        const double x = random.uniform(1.5, 3.0), y = random.uniform(-0.8, 0.8);
        const Pick pick = scene.pick({x, y, 2.0}, {x, y, -2.0}, 0.01);
        EXPECT_EQ(pick.body, -1);
        EXPECT_EQ(pick.joint, -1);
        ASSERT_TRUE(pick.point.has_value());
        EXPECT_NEAR(pick.point->z(), terrain->heightAt(x, y), 1e-5);
    }
    const Pick sky = scene.pick({2.0, 0.0, 1.0}, {2.0, 0.0, 100.0}, 0.01);
    EXPECT_FALSE(sky.point.has_value());
    EXPECT_EQ(sky.body, -1);
}

// Overlays are not in the way of the mouse.
TEST_F(SceneTest, OverlaysAreNotPicked) {
    scene.setOverlays({.centerOfMass = true, .supportPolygon = true, .contactForces = true});
    auto snapshot = standing(mechanism);
    snapshot.wheels[0].contactPoint = Vec3(1.5, 0.0, 0.0);
    scene.setSnapshot(snapshot);
    const Pick pick = scene.pick({1.5, 0.0, 2.0}, {1.5, 0.0, -1.0}, 0.001);
    ASSERT_TRUE(pick.point.has_value());
    EXPECT_NEAR(pick.point->z(), 0.0, 1e-6);
}

// Standard views look from where they say, and hold the whole rover at any shape of the window.
TEST_F(SceneTest, StandardViewsHoldTheRover) {
    const std::vector<std::pair<View, Vec3>> views = {{View::Front, Vec3::UnitX()},
                                                      {View::Side, -Vec3::UnitY()},
                                                      {View::Top, Vec3::UnitZ()},
                                                      {View::Iso, Vec3(0.5, -0.75, 0.4)},
                                                      {View::Overview, Vec3(-0.2, -0.9, 0.4)}};
    scene.setSnapshot(rolled(mechanism, 1.0, 1.0));
    const auto drawn = roverVertices();
    for (const auto& [view, side] : views) {
        for (const double aspect : {0.5, 4.0 / 3.0, 3.0}) {
            const CameraPose camera = scene.view(view, aspect);
            const Vec3 back = (camera.eye - camera.center).normalized();
            EXPECT_GT(back.dot(side.normalized()), 0.95);
            double largest = 0.0;
            for (std::size_t i = 0; i < drawn.size(); i += 11) {
                const auto at = inPicture(camera, aspect, drawn[i].place);
                ASSERT_TRUE(at.has_value());
                largest = std::max(largest, at->cwiseAbs().maxCoeff());
            }
            EXPECT_LT(largest, 1.0) << "view " << static_cast<int>(view) << " at " << aspect;
            EXPECT_GT(largest, 0.3) << "view " << static_cast<int>(view) << " at " << aspect;
        }
    }
}

// In the side view the rover drives to the right, as time runs in the plots; from above, up.
TEST_F(SceneTest, SideViewDrivesToTheRight) {
    const Vec3 ahead = scene.focus() + 0.2 * Vec3::UnitX();
    EXPECT_GT(inPicture(scene.view(View::Side, 1.5), 1.5, ahead)->x(), 0.1);
    EXPECT_GT(inPicture(scene.view(View::Top, 1.5), 1.5, ahead)->y(), 0.1);
}

// Fitting keeps the direction of view.
TEST_F(SceneTest, FittingKeepsTheDirection) {
    CameraPose camera;
    camera.eye = Vec3(5.0, 3.0, 2.0);
    camera.center = Vec3(1.0, 0.0, 0.5);
    const CameraPose fitted = scene.fitted(camera, 1.5);
    EXPECT_LT((fitted.center - scene.focus()).norm(), 1e-12);
    const Vec3 before = (camera.eye - camera.center).normalized();
    EXPECT_LT(((fitted.eye - fitted.center).normalized() - before).norm(), 1e-9);
}
