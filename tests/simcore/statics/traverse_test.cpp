#include "simcore/statics/traverse.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/dynamics/engine.h"
#include "simcore/run/critical_friction.h"
#include "simcore/statics/capability.h"
#include "simcore/terrain/profiles.h"
#include "tests/support/projects.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

terrain::Terrain step(double height) {
    return terrain::Terrain::extruded({{-20.0, 0.0}, {0.0, 0.0}, {0.0, height}, {20.0, height}},
                                      -5.0, 5.0);
}

Traverse overStep(const std::string& rover, double height) {
    StaticModel model(testsupport::mechanismOf(rover), Model::Built);
    const terrain::Terrain ground = step(height);
    PoseSolver solver(model, ground);
    TraverseRequest request;
    request.from.x = -0.7;
    request.distance = 1.4;
    return traverse(solver, request);
}

/// Index of the first sample with this event; the number of samples when there is none.
std::size_t firstWith(const Traverse& traverse, const std::string& event) {
    for (std::size_t i = 0; i < traverse.samples.size(); ++i) {
        const auto& events = traverse.samples[i].events;
        if (std::find(events.begin(), events.end(), event) != events.end()) {
            return i;
        }
    }
    return traverse.samples.size();
}

}  // namespace

// Wheel by wheel up the step, and no other events.
TEST(TraverseTest, SoleroMeetsAStepWheelByWheel) {
    const Traverse result = overStep("solero", 0.1);
    ASSERT_EQ(result.end, TraverseEnd::Arrived);
    std::vector<std::size_t> meets;
    for (const char* event : {"front meets", "front leaves", "bogie_left_front meets",
                              "bogie_left_rear meets", "rear meets", "rear leaves"}) {
        meets.push_back(firstWith(result, event));
        ASSERT_LT(meets.back(), result.samples.size()) << event;
    }
    EXPECT_TRUE(std::is_sorted(meets.begin(), meets.end()));
    // Just before the wall and just at it the rover is in the same place.
    const TraverseSample& at = result.samples[meets.front()];
    const TraverseSample& before = result.samples[meets.front() - 1];
    EXPECT_LT(at.way - before.way, 2e-7);
    EXPECT_LT(before.study.frictionRequired, 1e-6);
    EXPECT_GT(at.study.frictionRequired, 0.3);
}

// A wheel of radius R that meets a step of height h < R meets its edge: its centre is then R - h
// above the edge and sqrt(R^2 - (R - h)^2) before it, under arccos((R - h) / R). It turns about the
// edge until its centre is over it. Up a wall higher than R it rolls until its centre is as high as
// the edge. Down the step all comes in reverse.
TEST(TraverseTest, EdgesAreReachedAndLeftWhereTheyAre) {
    const mechanism::Mechanism mechanism = testsupport::mechanismOf("solero");
    const auto index = static_cast<std::size_t>(mechanism.findWheel("front"));
    const mechanism::Wheel& wheel = mechanism.wheels[index];
    const double r = wheel.radius;
    const auto centerAt = [&](const TraverseSample& sample) {
        return sample.pose.bodies[static_cast<std::size_t>(wheel.body)] * wheel.center;
    };
    // Of the foremost foothold.
    const auto angleAt = [&](const TraverseSample& sample) {
        double angle = 0.0;
        for (const Foothold& foothold : sample.pose.footholds) {
            if (foothold.contact.wheel == static_cast<int>(index)) {
                angle = foothold.angle;
            }
        }
        return angle;
    };
    for (const double height : {0.02, 0.05, 0.1}) {
        SCOPED_TRACE(height);
        const Traverse result = overStep("solero", height);
        ASSERT_EQ(result.end, TraverseEnd::Arrived);
        const std::size_t reaches = firstWith(result, "front reaches edge");
        const std::size_t leaves = firstWith(result, "front leaves edge");
        ASSERT_LT(reaches, leaves);
        ASSERT_LT(leaves, result.samples.size());
        const double angle = height < r ? std::acos((r - height) / r) : 0.5 * std::numbers::pi;
        // To what counts as touching, which is steep in the angle near the floor.
        EXPECT_NEAR(angleAt(result.samples[reaches]), angle, 2e-4);
        EXPECT_NEAR(centerAt(result.samples[reaches]).x(), -r * std::sin(angle), 1e-5);
        EXPECT_NEAR(centerAt(result.samples[reaches]).z(), std::max(r, height), 1e-5);
        EXPECT_NEAR(angleAt(result.samples[leaves]), 0.0, 2e-4);
        EXPECT_NEAR(centerAt(result.samples[leaves]).x(), 0.0, 1e-5);
        EXPECT_NEAR(centerAt(result.samples[leaves]).z(), height + r, 1e-5);
        // With a sample just before each.
        for (const std::size_t at : {reaches, leaves}) {
            EXPECT_LT(result.samples[at].way - result.samples[at - 1].way, 2e-7);
        }
        const bool met = height < r;  // at the edge itself, not at the wall before it
        EXPECT_EQ(firstWith(result, "front meets") == reaches, met);
    }
}

TEST(TraverseTest, DownAStepWheelsTurnAboutItsEdge) {
    const mechanism::Mechanism mechanism = testsupport::mechanismOf("solero");
    const mechanism::Wheel& wheel =
        mechanism.wheels[static_cast<std::size_t>(mechanism.findWheel("front"))];
    StaticModel model(mechanism, Model::Built);
    const terrain::Terrain ground = terrain::Terrain::extruded(
        {{-20.0, 0.05}, {0.0, 0.05}, {0.0, 0.0}, {20.0, 0.0}}, -5.0, 5.0);
    PoseSolver solver(model, ground);
    TraverseRequest request;
    request.from.x = -0.7;
    request.distance = 1.4;
    request.study = false;
    const Traverse result = traverse(solver, request);
    ASSERT_EQ(result.end, TraverseEnd::Arrived);
    const auto centerAt = [&](const std::string& event) {
        const TraverseSample& sample = result.samples.at(firstWith(result, event));
        return Vec3(sample.pose.bodies[static_cast<std::size_t>(wheel.body)] * wheel.center);
    };
    const double r = wheel.radius;
    EXPECT_NEAR(centerAt("front reaches edge").x(), 0.0, 1e-5);
    EXPECT_NEAR(centerAt("front meets").x(), std::sqrt(r * r - (r - 0.05) * (r - 0.05)), 1e-5);
    EXPECT_EQ(firstWith(result, "front leaves edge"), firstWith(result, "front leaves"));
    EXPECT_GT(firstWith(result, "front leaves edge"), firstWith(result, "front meets"));
}

// Where the ground turns by less than 20 deg at a time it is one face to a wheel.
TEST(TraverseTest, ARoundedHillHasNoEdges) {
    std::vector<Eigen::Vector2d> profile{{-20.0, 0.0}};
    for (int i = -20; i <= 20; ++i) {
        profile.emplace_back(0.02 * i, 0.04 * (1.0 + std::cos(std::numbers::pi * i / 20.0)));
    }
    profile.emplace_back(20.0, 0.0);
    StaticModel model(testsupport::mechanismOf("solero"), Model::Built);
    const terrain::Terrain ground = terrain::Terrain::extruded(profile, -5.0, 5.0);
    PoseSolver solver(model, ground);
    TraverseRequest request;
    request.from.x = -1.0;
    request.distance = 2.0;
    request.study = false;
    const Traverse result = traverse(solver, request);
    ASSERT_EQ(result.end, TraverseEnd::Arrived);
    EXPECT_EQ(firstWith(result, "front reaches edge"), result.samples.size());
}

// At the wall the rover stands as drawn, one wheel against a vertical face: the study of the drawn
// pose must say the same.
TEST(TraverseTest, FirstTouchOfAWallIsTheDrawnPoseAtNinetyDegrees) {
    for (const std::string name : {"solero", "shrimp"}) {
        const Traverse result = overStep(name, 0.15);
        const std::size_t at = firstWith(result, "front meets");
        ASSERT_LT(at, result.samples.size());
        StudyRequest request;
        request.angles = {{"front", 0.5 * std::numbers::pi}};
        const auto drawn = studyDrawnPose(testsupport::mechanismOf(name), request);
        ASSERT_TRUE(drawn);
        EXPECT_NEAR(result.samples[at].study.frictionRequired, drawn->frictionRequired,
                    2e-3 * drawn->frictionRequired)
            << name;
    }
}

// Rolled by arc length a rover comes to the poses in which it stands when it is put down there.
TEST(TraverseTest, PosesAreThoseOfSettling) {
    const mechanism::Mechanism mechanism = testsupport::mechanismOf("solero");
    StaticModel model(mechanism, Model::Built);
    const terrain::Terrain ground = step(0.05);
    PoseSolver solver(model, ground);
    TraverseRequest request;
    request.from.x = -0.7;
    request.distance = 1.4;
    request.study = false;
    const Traverse result = traverse(solver, request);
    ASSERT_EQ(result.end, TraverseEnd::Arrived);
    int same = 0;
    int all = 0;
    for (std::size_t i = 0; i < result.samples.size(); i += 10) {
        const Pose& rolled = result.samples[i].pose.bodies[0];
        const StandingPose settled = solver.settle({rolled.position.x(), 0.0, 0.0});
        ASSERT_EQ(settled.standing, Standing::Stands);
        same += (settled.bodies[0].position - rolled.position).norm() < 1e-5 ? 1 : 0;
        ++all;
    }
    // At an edge the front may stand on either side of it.
    EXPECT_GE(same, all - all / 10);
}

// Energy: without friction the work of lifting the rover is what its centre of mass gains.
TEST(TraverseTest, EndsOneStepHigher) {
    const Traverse result = overStep("solero", 0.08);
    ASSERT_EQ(result.end, TraverseEnd::Arrived);
    const mechanism::Mechanism mechanism = testsupport::mechanismOf("solero");
    EXPECT_NEAR(result.samples.back().pose.potential - result.samples.front().pose.potential,
                mechanism.mass() * dynamics::kGravity * 0.08, 1e-4);
}

// What the paper's torque controller needs to climb, with perfect sensors and no rolling
// resistance, is what statics says. Slowly: at 0.1 m/s its motion carries it over the 5 cm at a
// friction that is 12 % lower.
TEST(TraverseTest, RequiredFrictionIsWhatTheTorqueControllerNeeds) {
    for (const double height : {0.05, 0.08}) {
        const double required = overStep("solero", height).frictionRequired();
        project::Project project = testsupport::shipped("solero");
        for (project::Scenario& scenario : project.scenarios) {
            if (scenario.name == "step") {
                scenario.terrain = {};
                scenario.terrain.kind = project::TerrainKind::Step;
                scenario.terrain.height = height;
                scenario.terrain.start = 0.7;
                scenario.soil.rollingResistance = 0.0;
                scenario.controller.kind = project::ControllerKind::Torque;
                scenario.controller.assumedFriction = 0.0;
                scenario.controller.speed = 0.05;
                scenario.run.distance = 1.4;
            }
        }
        run::RunRequest request;
        request.scenario = "step";
        request.engine = project::EngineKind::Reduced;
        const auto critical =
            run::findCriticalFriction(project, request, 0.7 * required, 1.4 * required, 0.005);
        ASSERT_TRUE(critical) << toString(critical.problems());
        EXPECT_NEAR(critical->middle(), required, 0.03 * required) << height;
    }
}

TEST(TraverseTest, StopsWhenItsWatcherSaysSo) {
    StaticModel model(testsupport::mechanismOf("solero"), Model::Built);
    const terrain::Terrain ground = step(0.1);
    PoseSolver solver(model, ground);
    TraverseRequest request;
    request.from.x = -1.0;
    int seen = 0;
    const Traverse result =
        traverse(solver, request, [&](const TraverseSample&) { return ++seen < 5; });
    EXPECT_EQ(result.end, TraverseEnd::Stopped);
    EXPECT_EQ(result.samples.size(), 5U);
}

// A wall higher than anything: no endless climb.
TEST(TraverseTest, DoesNotArriveBeyondAWall) {
    StaticModel model(testsupport::mechanismOf("solero"), Model::Built);
    const terrain::Terrain ground = step(3.0);
    PoseSolver solver(model, ground);
    TraverseRequest request;
    request.from.x = -0.7;
    request.distance = 1.4;
    request.study = false;
    const Traverse result = traverse(solver, request);
    EXPECT_NE(result.end, TraverseEnd::Arrived);
    EXPECT_TRUE(std::isinf(result.frictionRequired()));
}

TEST(CapabilityTest, MoreFrictionClimbsMore) {
    const mechanism::Mechanism solero = testsupport::mechanismOf("solero");
    Capability last;
    for (const double friction : {0.3, 0.5, 0.7}) {
        ClimbRequest request;
        request.friction = friction;
        const Capability can = whatItClimbs(solero, request);
        EXPECT_GT(can.step, last.step);
        EXPECT_GE(can.stair, last.stair);
        EXPECT_LE(can.slope, std::atan(friction) + 1e-6);
        last = can;
    }
    // A gentle slope is climbed up to the friction angle.
    ClimbRequest request;
    request.friction = 0.3;
    EXPECT_NEAR(whatItClimbs(solero, request).slope, std::atan(0.3), 3e-4);
}

// The bisected step is climbed, and half a millimetre more is not.
TEST(CapabilityTest, StepIsTheBorder) {
    const mechanism::Mechanism shrimp = testsupport::mechanismOf("shrimp");
    ClimbRequest request;
    request.friction = 0.5;
    for (const bool backwards : {false, true}) {
        request.backwards = backwards;
        const double height = whatItClimbs(shrimp, request).step;
        EXPECT_TRUE(climbsStairs(shrimp, request, height, 1.0, 1));
        EXPECT_FALSE(climbsStairs(shrimp, request, height + 6e-4, 1.0, 1));
    }
}
