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
// cart creeps along the slope by less than 0.1 mm, and does not sink into it.
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
        EXPECT_LT(std::abs(moved.dot(normal)), 2e-5) << "body " << i;
    }
}

// A cart whose axles are rusted fast slides down a slope steeper than its friction: what friction
// takes is mu m g cos(slope) times the way, which weight gave and motion has not.
TEST_P(RoverConformanceTest, FrictionWorkOfASlidingCartIsForceTimesWay) {
    constexpr double kSlope = 0.5;
    constexpr double kMu = 0.3;
    Mechanism cart = makeCart();
    for (mechanism::Joint& axle : cart.joints) {
        axle.friction = 100.0;  // [N m]
    }
    ResolvedRun settings = runOf(tilted(cart, kSlope), slopeThroughOrigin(kSlope));
    settings.friction = kMu;
    settings.settle = 0.1;
    settings.ramp = 0.0;
    settings.duration = 1.0;
    settings.controller = project::ControllerKind::Manual;
    Simulation simulation(settings, GetParam().make);
    (void)runToEnd(simulation, settings.settle);
    const Vec3 start = simulation.snapshot().centerOfMass;
    const RunReport report = runToEnd(simulation, settings.duration);
    const double way = (simulation.snapshot().centerOfMass - start).norm();
    ASSERT_GT(way, 0.5);
    const double weight = settings.mechanism.mass() * dynamics::kGravity;
    const double work = kMu * weight * std::cos(kSlope) * way;
    EXPECT_NEAR(report.frictionWork, work, (GetParam().frictionSlack + 1e-3) * work);
    // Boxes of friction let the cart turn by some degrees, so that it slides sideways, too.
    EXPECT_NEAR(report.slipLoaded, 4.0 * way, (GetParam().frictionSlack + 1e-3) * way);
    EXPECT_NEAR(report.slipAbs, report.slipLoaded, 1e-9);
    double sum = 0.0;
    for (const WheelReport& wheel : report.wheels) {
        EXPECT_GT(wheel.frictionWork, 0.0) << wheel.name;
        sum += wheel.frictionWork;
    }
    EXPECT_NEAR(sum, report.frictionWork, 1e-9 * work);
}

// Wheels that spin in free fall slip by definition, but not under load, and nothing rubs.
TEST_P(RoverConformanceTest, FreeFlightIsNeitherLoadedSlipNorFrictionWork) {
    ResolvedRun settings =
        runOf(makeCart(), terrain::Terrain::extruded({{-5.0, -1.0}, {5.0, -1.0}}, -3.0, 3.0));
    settings.settle = 0.0;
    settings.ramp = 0.0;
    settings.speed = 0.1;
    settings.duration = 0.3;
    Simulation simulation(settings, GetParam().make);
    const RunReport report = runToEnd(simulation, settings.duration);
    EXPECT_GT(report.slipAbs, 4.0 * 0.5 * settings.speed * settings.duration);
    EXPECT_EQ(report.slipLoaded, 0.0);
    EXPECT_EQ(report.frictionWork, 0.0);
}

// A wheel that rolls down a slope loses nothing to friction, but for the creep of sticking.
TEST_P(RoverConformanceTest, RollingTakesNoFrictionWork) {
    constexpr double kSlope = 0.2;
    CartNumbers numbers;
    numbers.torqueLimit = 0.0;
    ResolvedRun settings = runOf(tilted(makeCart(numbers), -kSlope), slopeThroughOrigin(-kSlope));
    settings.friction = 0.7;
    settings.settle = 0.1;
    settings.ramp = 0.0;
    settings.duration = 1.0;
    settings.distance = 10.0;
    Simulation simulation(settings, GetParam().make);
    const RunReport report = runToEnd(simulation, settings.duration);
    ASSERT_GT(report.distance, 0.3);
    const double weight = settings.mechanism.mass() * dynamics::kGravity;
    EXPECT_LT(std::abs(report.frictionWork), 1e-4 * weight * std::sin(kSlope) * report.distance);
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
// cones. What a rough drive comes to is the same, but for what friction leaves open: ODE's agrees
// to 1 % with normal forces.
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
                        0.002 * load)
                << reports[0].wheels[i].name;
        }
        EXPECT_NEAR(reports[1].simTime, reports[0].simTime, 0.001 * reports[0].simTime);
        EXPECT_NEAR(reports[1].energy, reports[0].energy, 0.002 * reports[0].energy);
        EXPECT_NEAR(reports[1].slipAbs, reports[0].slipAbs, 0.02 * reports[0].slipAbs);
        EXPECT_LT((ends[1] - ends[0]).norm(), 2e-4);
        EXPECT_EQ(reports[1].frictionViolationPercent, 0.0);
    }
}

// Torque-driven wheels are held at no speed, so that every bounce at an edge is slip: it takes the
// same contacts to slip alike.
TEST(EnginesAgreeTest, OnSlipWithEqualTorques) {
    std::vector<RunReport> reports;
    for (const auto engine : {project::EngineKind::Ode, project::EngineKind::Reduced}) {
        ResolvedRun settings = shippedRun("solero", "rough-profile", 1.2);
        settings.controller = project::ControllerKind::EqualTorque;
        settings.engine = engine;
        Simulation simulation(settings);
        reports.push_back(runToEnd(simulation));
        ASSERT_TRUE(reports.back().completed);
    }
    ASSERT_GT(reports[1].slipAbs, 0.005);
    EXPECT_NEAR(reports[1].slipAbs, reports[0].slipAbs, 0.05 * reports[0].slipAbs);
    EXPECT_NEAR(reports[1].slipLoaded, reports[0].slipLoaded, 0.1 * reports[0].slipLoaded);
    EXPECT_NEAR(reports[1].energy, reports[0].energy, 0.005 * reports[0].energy);
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
