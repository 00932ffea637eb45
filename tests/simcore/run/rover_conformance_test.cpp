// Whole rovers on every engine that can run them: standing on slopes, relaxed joints,
// differentials, and the friction a climb needs.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/run/critical_friction.h"
#include "tests/support/engine_cases.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;

namespace {

class RoverConformanceTest : public ::testing::TestWithParam<EngineCase> {};

std::vector<EngineCase> enginesForRovers() {
    return enginesThatCan(Can::Joints);
}

ResolvedRun shippedRun(const std::string& rover, const std::string& scenario, double distance) {
    RunRequest request;
    request.scenario = scenario;
    request.distance = distance;
    auto prepared = prepareRun(shipped(rover), request);
    if (!prepared) {
        throw std::runtime_error(toString(prepared.problems()));
    }
    return std::move(prepared).value();
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, RoverConformanceTest, ::testing::ValuesIn(enginesForRovers()),
                         nameOfCase);

// At rest for a minute on a 20 deg slope with its wheels locked, friction 0.7 (it needs 0.36): the
// cart creeps along the slope by less than 0.1 mm. (Across it, wheels settle into the surface
// layer.)
TEST_P(RoverConformanceTest, LockedCartDoesNotCreepOnASlope) {
    constexpr double kSlope = 20.0 * std::numbers::pi / 180.0;
    ResolvedRun settings = runOf(tilted(makeCart(), kSlope), slopeThroughOrigin(kSlope));
    settings.friction = 0.7;
    settings.settle = 1e9;
    settings.duration = 61.0;
    settings.controller = project::ControllerKind::Manual;
    Simulation simulation(settings, GetParam().make);
    (void)runToEnd(simulation, 1.0);
    const std::vector<Pose> start = simulation.snapshot().bodies;
    (void)runToEnd(simulation, 61.0);
    const Vec3 normal(-std::sin(kSlope), 0.0, std::cos(kSlope));
    for (std::size_t i = 0; i < start.size(); ++i) {
        const Vec3 moved = simulation.snapshot().bodies[i].position - start[i].position;
        EXPECT_LT((moved - moved.dot(normal) * normal).norm(), 1e-4) << "body " << i;
        EXPECT_LT(std::abs(moved.dot(normal)), 5e-4) << "body " << i;
    }
}

// Relaxed joints carry the same wheel loads to the same slip: they leave out only what repeats.
TEST_P(RoverConformanceTest, RelaxedJointsGiveTheSameLoadsAndSlip) {
    ResolvedRun settings = shippedRun("solero", "rough-profile", 1.2);
    std::vector<RunReport> reports;
    for (const mechanism::Model joints : {mechanism::Model::Built, mechanism::Model::Relaxed}) {
        settings.joints = joints;
        Simulation simulation(settings, GetParam().make);
        reports.push_back(runToEnd(simulation));
        ASSERT_TRUE(reports.back().completed);
        EXPECT_LT(reports.back().loopErrorMax, 1e-5);
    }
    const double weight = settings.mechanism.mass() * dynamics::kGravity;
    double sides = 0.0;
    for (std::size_t i = 0; i < reports[0].wheels.size(); ++i) {
        EXPECT_NEAR(reports[1].wheels[i].meanNormalForce, reports[0].wheels[i].meanNormalForce,
                    0.01 * weight / 6.0)
            << reports[0].wheels[i].name;
        sides += reports[0].wheels[i].meanNormalForce;
    }
    EXPECT_GT(sides, 0.9 * weight);
    EXPECT_NEAR(reports[1].slipAbs, reports[0].slipAbs, 0.01 * reports[0].slipAbs + 1e-3);
}

// Two engines that share no solver: constraints and boxes of friction against free rates and
// cones. What a rough drive comes to is the same, but for what friction leaves open.
TEST(EnginesAgreeTest, OnWheelLoadsEnergyAndWay) {
    for (const std::string rover : {"solero", "rocker_bogie", "rocker_bogie_steered"}) {
        SCOPED_TRACE(rover);
        std::vector<RunReport> reports;
        std::vector<Vec3> ends;
        for (const auto engine : {project::EngineKind::Ode, project::EngineKind::Reduced}) {
            ResolvedRun settings = shippedRun(rover, "rough-3d", 1.0);
            settings.engine = engine;
            Simulation simulation(settings);
            reports.push_back(runToEnd(simulation));
            ends.push_back(simulation.snapshot().bodies[0].position);
        }
        EXPECT_EQ(reports[0].engine, "ode");
        EXPECT_EQ(reports[1].engine, "reduced");
        ASSERT_TRUE(reports[0].completed && reports[1].completed);
        double load = 0.0;
        for (const WheelReport& wheel : reports[0].wheels) {
            load += wheel.meanNormalForce / static_cast<double>(reports[0].wheels.size());
        }
        for (std::size_t i = 0; i < reports[0].wheels.size(); ++i) {
            EXPECT_NEAR(reports[1].wheels[i].meanNormalForce, reports[0].wheels[i].meanNormalForce,
                        0.03 * load)
                << reports[0].wheels[i].name;
        }
        EXPECT_NEAR(reports[1].simTime, reports[0].simTime, 0.02 * reports[0].simTime);
        EXPECT_NEAR(reports[1].energy, reports[0].energy, 0.05 * reports[0].energy);
        EXPECT_LT((ends[1] - ends[0]).norm(), 0.02);
        EXPECT_EQ(reports[1].frictionViolationPercent, 0.0);
    }
}

namespace {

/// Flat ground with a smooth hump under the left wheels only.
terrain::Terrain humpLeft(double height) {
    constexpr double kCell = 0.02;
    const int nx = 250;
    const int ny = 121;
    std::vector<double> heights;
    for (int ix = 0; ix < nx; ++ix) {
        for (int iy = 0; iy < ny; ++iy) {
            const double x = -1.5 + kCell * ix;
            const double y = -1.2 + kCell * iy;
            const double along = std::clamp((x - 0.7) / 0.5, 0.0, 1.0);
            heights.push_back(
                y > 0.1 ? 0.5 * height * (1.0 - std::cos(2.0 * std::numbers::pi * along)) : 0.0);
        }
    }
    return terrain::Terrain::grid(-1.5, -1.2, kCell, nx, ny, heights);
}

}  // namespace

// One side of a rocker-bogie drives over a hump: the differential keeps the chassis' pitch at the
// mean of its rockers'. A gear does so exactly, a bar up to the fourth power of their turns (with
// the factor of the shipped bar; see BarDifferentialPitchesByNearlyTheMean).
TEST_P(RoverConformanceTest, DifferentialHalvesTheRockersTurn) {
    for (const std::string name : {"rocker_bogie", "rocker_bogie_bar"}) {
        SCOPED_TRACE(name);
        const double excess = name == "rocker_bogie" ? 0.0 : 0.19;
        const mechanism::Mechanism rover = mechanismOf(name);
        ResolvedRun settings = runOf(rover, humpLeft(0.08));
        settings.distance = 0.8;
        Simulation simulation(settings, GetParam().make);
        const auto left = static_cast<std::size_t>(rover.findBody("rocker_left"));
        const auto right = static_cast<std::size_t>(rover.findBody("rocker_right"));
        const auto chassis = static_cast<std::size_t>(rover.chassis);
        double widest = 0.0;
        while (!simulation.finished()) {
            simulation.step();
            const auto& bodies = simulation.snapshot().bodies;
            // Turns of the rockers against the chassis about its pins are equal and opposite.
            const Vec3 y = bodies[chassis].rotation * Vec3::UnitY();
            const auto turnOf = [&](std::size_t body) {
                return turnAbout(bodies[body].rotation * bodies[chassis].rotation.conjugate(), y);
            };
            ASSERT_NEAR(turnOf(left) + turnOf(right), 0.0,
                        1e-4 + excess * std::pow(turnOf(left), 4));
            widest = std::max(widest, std::abs(turnOf(left) - turnOf(right)));
        }
        EXPECT_EQ(simulation.report().stopReason, StopReason::Completed);
        EXPECT_GT(widest, 0.05);
    }
}

// A cart on a ramp climbs when friction exceeds the slope's tangent, and not before.
TEST(CriticalFrictionTest, IsTheTangentOfASlope) {
    project::Project project = shipped("solero");
    project::Scenario scenario;
    scenario.name = "climb";
    scenario.terrain.kind = project::TerrainKind::Ramp;
    scenario.terrain.start = 0.5;
    scenario.terrain.slope = 0.3;
    scenario.terrain.length = 5.0;
    scenario.run.distance = 1.3;
    scenario.controller.speed = 0.2;
    project.scenarios = {scenario};
    RunRequest request;
    request.scenario = "climb";
    int told = 0;
    const auto found =
        findCriticalFriction(project, request, 0.25, 0.45, 0.06, [&told](double, bool) { ++told; });
    ASSERT_TRUE(found) << toString(found.problems());
    EXPECT_EQ(found->runs, told);
    EXPECT_LE(found->completes - found->fails, 0.06);
    // Rolling on the slope takes tan(slope) with all wheels equally loaded; speed control shares
    // traction less well than that.
    EXPECT_GE(found->completes, std::tan(0.3));
    EXPECT_LT(found->fails, std::tan(0.3) + 0.06);
    EXPECT_FALSE(findCriticalFriction(project, request, 0.6, 0.9, 0.03)) << "completes at 0.6";
    EXPECT_FALSE(findCriticalFriction(project, request, 0.5, 0.1, 0.03));
}
