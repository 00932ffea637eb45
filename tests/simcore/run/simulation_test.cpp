// Runs against closed forms: a plain cart where one exists, the shipped rovers for what they must
// hold.
#include "simcore/run/simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ostream>
#include <set>
#include <thread>

#include "simcore/dynamics/engine.h"
#include "simcore/run/run_worker.h"
#include "tests/support/carts.h"
#include "tests/support/rovers.h"
#include "tests/support/statics.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;
using project::ControllerKind;
using testing::HasSubstr;

namespace simcore::run {

/// GoogleTest's name of a stop reason.
static void PrintTo(StopReason reason, std::ostream* out) {  // NOLINT: name given by gtest
    *out << toString(reason);
}

}  // namespace simcore::run

namespace {

constexpr double kG = dynamics::kGravity;

ResolvedRun prepared(const project::Project& project, const RunRequest& request) {
    auto run = prepareRun(project, request);
    if (!run) {
        throw std::runtime_error(toString(run.problems()));
    }
    return std::move(run).value();
}

RunRequest request(const std::string& scenario, double duration = -1.0) {
    RunRequest request;
    request.scenario = scenario;
    if (duration >= 0.0) {
        request.duration = duration;
    }
    return request;
}

/// Inertia of a wheel of makeCart() about its axle [kg m^2].
double wheelInertia(const CartNumbers& cart) {
    return 0.5 * cart.wheelMass * cart.radius * cart.radius + cart.rotorInertia;
}

}  // namespace

// -- at rest --------------------------------------------------------------------------------------

class ShippedRoverTest : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Rovers, ShippedRoverTest, ::testing::ValuesIn(shippedNames()),
                         [](const auto& rover) { return rover.param; });

// Standing on level ground every wheel carries what the balances of all bodies say, within 1 %.
TEST_P(ShippedRoverTest, WheelLoadsAtRestAreThoseOfStatics) {
    ResolvedRun run = prepared(shipped(GetParam()), request("flat", 2.0));
    run.speed = 0.0;
    const WheelLoads expected = wheelLoadsAtRest(run.mechanism, kG);
    ASSERT_LT(expected.residual, 1e-9);
    const RunReport report = reportOf(run);
    ASSERT_EQ(report.stopReason, StopReason::TimeUp);
    ASSERT_EQ(report.wheels.size(), 6u);
    double sum = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_GT(expected.loads[i], 0.0) << report.wheels[i].name;
        EXPECT_NEAR(report.wheels[i].meanNormalForce, expected.loads[i], 0.01 * expected.loads[i])
            << report.wheels[i].name;
        sum += report.wheels[i].meanNormalForce;
    }
    EXPECT_NEAR(sum, run.mechanism.mass() * kG, 1e-3 * run.mechanism.mass() * kG);
    EXPECT_NEAR(report.distance, 0.0, 1e-3);
}

// The lever rule on a cart whose centre of mass stands off the middle.
TEST(SimulationTest, CartLoadsFollowTheLeverRule) {
    CartNumbers numbers;
    numbers.comX = 0.08;
    ResolvedRun run = runOf(makeCart(numbers), levelGround());
    run.speed = 0.0;
    run.duration = 1.0;
    const RunReport report = reportOf(run);
    const double own = numbers.wheelMass * kG;
    const double chassis = numbers.chassisMass * kG;
    const double front = 0.5 * chassis * (numbers.halfBase + numbers.comX) / (2 * numbers.halfBase);
    const double rear = 0.5 * chassis - front;
    for (std::size_t i = 0; i < 4; ++i) {
        const double expected = own + (i < 2 ? front : rear);
        EXPECT_NEAR(report.wheels[i].meanNormalForce, expected, 0.002 * expected);
    }
}

// -- rolling --------------------------------------------------------------------------------------

// Rolling 3.5 m on a plane slips less than 1 mm at any wheel, and leaves the loops closed.
TEST(SimulationTest, SoleroRollsOnAPlaneWithoutSlip) {
    const RunReport report = reportOf(prepared(shipped("solero"), request("flat")));
    EXPECT_EQ(report.stopReason, StopReason::Completed);
    EXPECT_GE(report.distance, 3.5);
    for (const WheelReport& wheel : report.wheels) {
        EXPECT_LT(wheel.slipAbs, 1e-3) << wheel.name;
        EXPECT_LT(wheel.slipLateral, 1e-3) << wheel.name;
        EXPECT_EQ(wheel.airTime, 0.0) << wheel.name;
    }
    EXPECT_LT(report.loopErrorMax, 1e-5);
    EXPECT_EQ(report.frictionViolationPercent, 0.0);
}

// A coasting cart is slowed by c g m / (m + sum of I / R^2): rolling resistance c N R per wheel
// against the inertia of chassis, wheels and rotors.
TEST(SimulationTest, RollingResistanceSlowsACoastingCart) {
    for (const double rotorInertia : {0.0, 0.004}) {
        for (const double coefficient : {0.0, 0.02, 0.05}) {
            CartNumbers numbers;
            numbers.torqueLimit = 0.0;  // nothing drives or brakes
            numbers.rotorInertia = rotorInertia;
            const double slope = 0.15;
            // Down a slope of 0.8 m, then level: the cart starts on the slope, nose down.
            ResolvedRun run = runOf(tilted(makeCart(numbers), -slope),
                                    terrain::Terrain::extruded({{-2.0, 2.0 * std::tan(slope)},
                                                                {0.8, -0.8 * std::tan(slope)},
                                                                {20.0, -0.8 * std::tan(slope)}},
                                                               -3.0, 3.0));
            run.rollingResistance = coefficient;
            run.duration = 30.0;
            run.distance = 50.0;
            Simulation simulation(run);
            const auto com = [&] { return simulation.snapshot().centerOfMass.x(); };
            while (com() < 1.2 && !simulation.finished()) {
                simulation.step();
            }
            const double x0 = com();
            const double t0 = simulation.snapshot().time;
            runToEnd(simulation, t0 + 0.3);
            const double x1 = com();
            runToEnd(simulation, t0 + 0.6);
            const double x2 = com();
            ASSERT_GT(x2 - x1, 0.1) << "it has to move";
            const double deceleration = -(x2 - 2.0 * x1 + x0) / (0.3 * 0.3);
            const double mass = run.mechanism.mass();
            const double radius2 = numbers.radius * numbers.radius;
            const double expected =
                coefficient * kG * mass / (mass + 4.0 * wheelInertia(numbers) / radius2);
            EXPECT_NEAR(deceleration, expected, 0.01 * expected + 2e-3)
                << "c " << coefficient << " rotor " << rotorInertia;
        }
    }
}

// Without friction the wheels spin on the spot: slip is -R times the turn, the slip ratio 1.
TEST(SimulationTest, WheelsWithoutFrictionSpinOnTheSpot) {
    ResolvedRun run = runOf(makeCart(), levelGround());
    run.friction = 0.0;
    run.duration = 2.4;
    Simulation simulation(run);
    runToEnd(simulation, 0.4);
    std::vector<double> turned(4, 0.0);
    while (!simulation.finished()) {
        simulation.step();
        for (std::size_t i = 0; i < 4; ++i) {
            turned[i] += simulation.snapshot().wheels[i].rate * run.step;
        }
    }
    const RunReport report = simulation.report();
    EXPECT_NEAR(report.distance, 0.0, 1e-6);
    for (std::size_t i = 0; i < 4; ++i) {
        const double radius = run.mechanism.wheels[i].radius;
        EXPECT_NEAR(turned[i] * radius, run.speed * 2.0, 0.02 * run.speed * 2.0);
        EXPECT_NEAR(report.wheels[i].slipSigned, -radius * turned[i], 0.005 * radius * turned[i]);
        EXPECT_NEAR(report.wheels[i].slipAbs, radius * turned[i], 0.005 * radius * turned[i]);
        EXPECT_NEAR(simulation.snapshot().wheels[i].slipRatio, 1.0, 1e-3);
        EXPECT_NEAR(simulation.snapshot().wheels[i].tractionForce, 0.0, 1e-6);
    }
    EXPECT_NEAR(report.slipSigned, 4.0 * report.wheels[0].slipSigned, 0.01 * report.slipAbs);
}

// -- slopes ---------------------------------------------------------------------------------------

// On a slope the contact angle is the slope, positive uphill, and the wheels carry m g cos(slope).
TEST(SimulationTest, ContactAngleOnASlopeIsTheSlope) {
    for (const double slope : {-0.3, 0.15, 0.35}) {
        ResolvedRun run = runOf(tilted(makeCart(), slope), slopeThroughOrigin(slope));
        run.settle = 10.0;
        run.duration = 1.0;
        Simulation simulation(run);
        runToEnd(simulation);
        double load = 0.0;
        double traction = 0.0;
        for (const WheelState& wheel : simulation.snapshot().wheels) {
            ASSERT_TRUE(wheel.touching);
            EXPECT_NEAR(wheel.contactAngle, slope, 1e-6);
            load += wheel.normalForce;
            traction += wheel.tractionForce;
        }
        const double weight = run.mechanism.mass() * kG;
        EXPECT_NEAR(load, weight * std::cos(slope), 0.002 * weight);
        EXPECT_NEAR(traction, weight * std::sin(slope), 0.005 * weight);
    }
}

// Held by its brakes a rover stays on a slope while mu > tan(slope), and slides with
// g (sin - mu cos) when mu is less.
TEST(SimulationTest, BrakedRoverSlidesWhenTheSlopeExceedsFrictionOnly) {
    for (const std::string& rover : {std::string("cart"), std::string("solero")}) {
        const Mechanism level = rover == "cart" ? makeCart() : mechanismOf(rover);
        for (const double slope : {0.2, 0.4}) {
            const auto moved = [&](double friction, double time) {
                ResolvedRun run = runOf(tilted(level, slope), slopeThroughOrigin(slope));
                run.friction = friction;
                run.settle = 10.0;  // the brakes hold as long as it settles
                run.duration = time;
                Simulation simulation(run);
                runToEnd(simulation, 0.5 * time);
                const double start = simulation.snapshot().distance;
                runToEnd(simulation);
                return std::pair(start, simulation.snapshot().distance);
            };
            const double limit = std::tan(slope);
            const auto [held, heldLater] = moved(1.03 * limit, 2.0);
            EXPECT_LT(std::abs(heldLater - held), 1e-4) << rover << " slope " << slope;
            EXPECT_LT(std::abs(held), 0.015) << rover << " slope " << slope;
            const auto [slid, slidLater] = moved(0.9 * limit, 1.0);
            // x(t) = -a t^2 / 2 along the slope, from rest: 1/8 and 1/2 of a after 0.5 and 1 s.
            const double a = kG * 0.1 * std::sin(slope) * std::cos(slope);
            EXPECT_NEAR(slidLater - slid, -0.375 * a, 0.05 * a) << rover << " slope " << slope;
        }
    }
}

// -- obstacles ------------------------------------------------------------------------------------

// A cart before a high wall, all wheels driven: the rear wheels slide and press it to the wall with
// F = mu N_r, where the front wheels slide up with mu F, so N_r + mu F = m g. It lifts its front
// when the moments about the rear contacts, mu F (L + R) + F R, exceed m g a, a the distance of the
// centre of mass ahead of the rear axle. The wall carries nothing without the floor's friction.
TEST(SimulationTest, CartLiftsItsFrontAtAWallWhenStaticsSaysSo) {
    const double mu = 0.7;
    CartNumbers numbers;
    numbers.torqueLimit = 6.0;
    const double base = 2.0 * numbers.halfBase;
    const double critical = mu / (1.0 + mu * mu) * (mu * (base + numbers.radius) + numbers.radius);
    const auto highest = [&](double arm) {
        // The centre of mass of the whole cart at `arm`, through that of the chassis.
        const double total = numbers.chassisMass + 4.0 * numbers.wheelMass;
        numbers.comX = (arm - numbers.halfBase) * total / numbers.chassisMass;
        numbers.comZ = numbers.radius;
        const double wall = numbers.halfBase + numbers.radius + 0.01;
        ResolvedRun run = runOf(
            makeCart(numbers),
            terrain::Terrain::extruded({{-5.0, 0.0}, {wall, 0.0}, {wall, 1.0}, {5.0, 1.0}}, -3, 3));
        run.friction = mu;
        run.duration = 4.0;
        Simulation simulation(run);
        double height = 0.0;
        while (!simulation.finished()) {
            simulation.step();
            height = std::max(
                height, (simulation.snapshot().bodies[1] * run.mechanism.wheels[0].center).z());
        }
        return height - numbers.radius;
    };
    EXPECT_GT(highest(0.9 * critical), 0.05);
    EXPECT_LT(highest(1.1 * critical), 0.005);
}

// Loops stay closed within 0.01 mm and friction agrees with the normal forces of the same step on
// every scenario that is shipped, at twice the shipped speed, which is half as long and harder.
class ShippedScenarioTest : public ::testing::TestWithParam<std::pair<std::string, std::string>> {};

namespace {

std::vector<std::pair<std::string, std::string>> shippedScenarios() {
    std::vector<std::pair<std::string, std::string>> found;
    for (const std::string& rover : shippedNames()) {
        for (const project::Scenario& scenario : shipped(rover).scenarios) {
            if (scenario.controller.kind != ControllerKind::Manual) {  // nobody drives here
                found.emplace_back(rover, scenario.name);
            }
        }
    }
    return found;
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Scenarios, ShippedScenarioTest, ::testing::ValuesIn(shippedScenarios()),
                         [](const auto& scenario) {
                             std::string name = scenario.param.first + "_" + scenario.param.second;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(ShippedScenarioTest, LoopsStayClosed) {
    const auto& [rover, scenario] = GetParam();
    ResolvedRun run = prepared(shipped(rover), request(scenario));
    run.speed *= 2.0;
    run.distance = scenario == "flat" ? 0.4 : 1.5;  // the whole rover is over the first obstacle
    const RunReport report = reportOf(run);
    EXPECT_EQ(report.stopReason, StopReason::Completed) << report.stopDetail;
    EXPECT_LT(report.loopErrorMax, 1e-5);
    EXPECT_LT(report.frictionViolationPercent, 3.0);
    EXPECT_LT(report.penetrationMax, 0.005);
}

// The engine in free rates keeps loops closed to a nanometre and friction to its cone.
TEST_P(ShippedScenarioTest, ReducedKeepsLoopsAndCone) {
    const auto& [rover, scenario] = GetParam();
    ResolvedRun run = prepared(shipped(rover), request(scenario));
    run.engine = project::EngineKind::Reduced;
    run.speed *= 2.0;
    run.distance = scenario == "flat" ? 0.4 : 1.5;
    const RunReport report = reportOf(run);
    EXPECT_EQ(report.engine, "reduced");
    EXPECT_EQ(report.stopReason, StopReason::Completed) << report.stopDetail;
    EXPECT_LT(report.loopErrorMax, 1e-9);
    EXPECT_EQ(report.frictionViolationPercent, 0.0);
    EXPECT_LT(report.frictionWorstPercent, 1.0);
    EXPECT_LT(report.penetrationMax, 1e-3);
    EXPECT_EQ(report.solverMessages, 0);
}

// -- the same numbers again -----------------------------------------------------------------------

namespace {

/// SOLERO in front of its step, so near that it climbs from the start; 0.8 s.
ResolvedRun climbing() {
    project::Project project = shipped("solero");
    for (project::Scenario& scenario : project.scenarios) {
        scenario.terrain.start =
            project::Quantity::expression("front_wheel_x + wheel_radius + 0.005");
        scenario.run.settle = 0.1;
        scenario.run.ramp = 0.1;
    }
    return prepared(project, request("step", 0.8));
}

RunReport workerReport(const ResolvedRun& run, double factor) {
    RunWorker worker(run);
    worker.setSpeedFactor(factor);
    worker.play();
    for (int i = 0; worker.state() != WorkerState::Finished && i < 60000; ++i) {
        if (i % 50 == 49) {  // a window that pauses now and then
            worker.pause();
            worker.play();
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return worker.report();
}

}  // namespace

// The same run ends in the same state: again, after a reset in mid-run, in another thread.
TEST(RepeatabilityTest, SameRunGivesTheSameHash) {
    const ResolvedRun run = climbing();
    Simulation simulation(run);
    const RunReport first = runToEnd(simulation);
    EXPECT_EQ(first.steps, 400);
    EXPECT_GT(simulation.snapshot().wheels[0].contactAngle, 0.2) << "it should be at the step";
    simulation.reset();
    EXPECT_EQ(simulation.report().steps, 0);
    runToEnd(simulation, 0.306);  // in the middle of a window of slip
    EXPECT_NE(simulation.report().stateHash, first.stateHash);
    simulation.reset();
    const RunReport again = runToEnd(simulation);
    EXPECT_EQ(again.stateHash, first.stateHash);
    EXPECT_EQ(again.slipAbs, first.slipAbs);
    EXPECT_EQ(again.energy, first.energy);
    EXPECT_EQ(again.frictionViolationPercent, first.frictionViolationPercent);
    EXPECT_EQ(reportOf(run).stateHash, first.stateHash);
    std::vector<std::string> together(2);
    std::vector<std::thread> threads;
    threads.reserve(together.size());
    for (std::string& hash : together) {
        threads.emplace_back([&] { hash = reportOf(run).stateHash; });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(together, std::vector<std::string>(2, first.stateHash));
}

// A reset forgets what a controller has summed up, also without settling, which would forget it.
TEST(RepeatabilityTest, ResetForgetsTheController) {
    ResolvedRun run = climbing();
    run.controller = ControllerKind::EqualTorque;
    run.settle = run.ramp = 0.0;
    run.duration = 0.1;
    Simulation simulation(run);
    const RunReport first = runToEnd(simulation);
    simulation.reset();
    EXPECT_EQ(runToEnd(simulation).stateHash, first.stateHash);
}

// A worker ends in the same state at any pacing, with pauses.
TEST(RepeatabilityTest, PacingDoesNotChangeTheHash) {
    const ResolvedRun run = climbing();
    const RunReport expected = reportOf(run);
    for (const double factor : {0.0, 1.0, 5.0}) {
        const RunReport report = workerReport(run, factor);
        EXPECT_EQ(report.stateHash, expected.stateHash) << "factor " << factor;
        EXPECT_EQ(report.steps, expected.steps);
        EXPECT_EQ(report.stopReason, expected.stopReason);
    }
}

// Noise of the sensors is the only thing the seed of a run has a say in; the same seed is the same
// run, also after a reset. The hash covers every step: a run that was disturbed stays another one.
TEST(RepeatabilityTest, SeedMattersWithNoisySensorsOnly) {
    ResolvedRun run = climbing();
    run.controller = ControllerKind::EqualTorque;
    run.settle = run.ramp = 0.0;
    run.duration = 0.2;
    ResolvedRun reseeded = run;
    reseeded.seed = run.seed + 1;
    const RunReport quiet = reportOf(run);
    EXPECT_EQ(reportOf(reseeded).stateHash, quiet.stateHash);
    run.sensors.bodySpeed.noise = reseeded.sensors.bodySpeed.noise = 0.01;
    Simulation simulation(run);
    const RunReport noisy = runToEnd(simulation);
    EXPECT_NE(noisy.stateHash, quiet.stateHash);
    EXPECT_NE(reportOf(reseeded).stateHash, noisy.stateHash);
    simulation.reset();
    EXPECT_EQ(runToEnd(simulation).stateHash, noisy.stateHash);
}

// A controller sees the delayed speed: what was measured is what was true `delay` ago.
TEST(SensorsOfARunTest, DelayShowsInTheChannels) {
    ResolvedRun run = climbing();
    run.settle = run.ramp = 0.0;
    run.sensors.bodySpeed.delay = 0.05;
    run.duration = 0.3;
    Simulation simulation(run);
    std::vector<double> truth;  // at the looks
    double changed = 0.0;
    while (!simulation.finished()) {
        const double before = simulation.snapshot().speed;
        const bool look = simulation.snapshot().step % 5 == 0;  // 10 ms at 2 ms a step
        simulation.step();
        if (look) {
            truth.push_back(before);
            const std::size_t late = truth.size() > 5 ? truth.size() - 6 : 0;
            EXPECT_NEAR(simulation.snapshot().measured.bodySpeed, truth[late], 1e-9);
            changed = std::max(changed, std::abs(truth[late] - before));
        }
    }
    EXPECT_GT(changed, 1e-3) << "the speed should change within the delay";
}

// Another friction, step or obstacle is another run.
TEST(RepeatabilityTest, AnotherRunGivesAnotherHash) {
    const ResolvedRun run = climbing();
    const std::string hash = reportOf(run).stateHash;
    ResolvedRun other = run;
    other.friction = std::nextafter(run.friction, 1.0);
    EXPECT_NE(reportOf(other).stateHash, hash);
    other = run;
    other.step = 0.001;
    EXPECT_NE(reportOf(other).stateHash, hash);
}

// -- the end of a run -----------------------------------------------------------------------------

class EndOfRunTest : public ::testing::Test {
  protected:
    static ResolvedRun cart(const CartNumbers& numbers = {}) {
        ResolvedRun run = runOf(makeCart(numbers), levelGround());
        run.distance = 0.1;
        return run;
    }
};

// Completed where the way passes the distance, forwards or backwards, and no step later.
TEST_F(EndOfRunTest, CompletesWhenTheDistanceIsPassed) {
    for (const double speed : {0.1, -0.1}) {
        ResolvedRun run = cart();
        run.speed = speed;
        const RunReport report = reportOf(run);
        EXPECT_EQ(report.stopReason, StopReason::Completed);
        EXPECT_TRUE(report.completed);
        EXPECT_GE(std::abs(report.distance), 0.1);
        EXPECT_LT(std::abs(report.distance), 0.1 + 1.5 * 0.1 * run.step);
        EXPECT_EQ(report.distance > 0.0, speed > 0.0);
        // Settling, ramp at half the speed, then the rest.
        EXPECT_NEAR(report.simTime, 0.2 + 0.1 + 1.0, 0.1);
        EXPECT_NEAR(report.simTime, static_cast<double>(report.steps) * run.step, 1e-12);
    }
}

// A duration that was asked for ends the run as wanted; the default limit is a failure.
TEST_F(EndOfRunTest, TimeUpCountsAsCompletedWhenADurationWasGiven) {
    ResolvedRun run = cart();
    run.duration = 0.5;
    RunReport report = reportOf(run);
    EXPECT_EQ(report.stopReason, StopReason::TimeUp);
    EXPECT_TRUE(report.completed);
    EXPECT_NEAR(report.simTime, 0.5, 1e-9);

    CartNumbers slow;
    slow.speedLimit = 0.4 * 0.1 / slow.radius;  // motors for 0.044 m/s at most
    run = cart(slow);
    run.distance = 0.2;
    report = reportOf(run);
    EXPECT_EQ(report.stopReason, StopReason::TimeUp);
    EXPECT_FALSE(report.completed);
    EXPECT_GT(report.distance, 0.05);
    EXPECT_NEAR(report.simTime, 0.2 + 0.2 + 1.0 + 1.6 * 0.2 / 0.1, 1e-9);
}

// A rover whose wheels spin on the spot is stuck 10 s after its ramp.
TEST_F(EndOfRunTest, StuckWhenNothingIsGained) {
    ResolvedRun run = cart();
    run.friction = 0.0;
    run.distance = 3.5;
    const RunReport report = reportOf(run);
    EXPECT_EQ(report.stopReason, StopReason::Stuck);
    EXPECT_FALSE(report.completed);
    EXPECT_NEAR(report.simTime, 0.4 + 10.0, 0.01);
    EXPECT_FALSE(report.stopDetail.empty());
}

// A controller that has tried all that the ground takes says so.
TEST_F(EndOfRunTest, StuckSaysWhenNothingMoreIsToBeHad) {
    ResolvedRun run = cart();
    run.controller = ControllerKind::Hybrid;
    run.friction = 0.0;
    run.distance = 3.5;
    const RunReport report = reportOf(run);
    EXPECT_EQ(report.stopReason, StopReason::Stuck);
    EXPECT_NE(report.stopDetail.find("every wheel gave all that the ground takes"),
              std::string::npos)
        << report.stopDetail;
}

// Nothing moves once a run has ended.
TEST_F(EndOfRunTest, StepsAfterTheEndDoNothing) {
    ResolvedRun run = cart();
    run.duration = 0.1;
    Simulation simulation(run);
    const RunReport report = runToEnd(simulation);
    simulation.step();
    EXPECT_EQ(simulation.report().steps, report.steps);
    EXPECT_EQ(simulation.report().stateHash, report.stateHash);
}

// A spring far too stiff for the step throws the rover apart: the run stops in that step, names a
// body, and keeps what it has measured; every number it shows is finite.
TEST_F(EndOfRunTest, BlowUpStopsTheRunAndKeepsItsData) {
    project::Project project = shipped("solero");
    project.rover.springs.at(0).stiffness = 1e12;
    ResolvedRun run = prepared(project, request("flat", 5.0));
    Simulation simulation(run);
    const RunReport report = runToEnd(simulation);
    EXPECT_EQ(report.stopReason, StopReason::NonFinite);
    EXPECT_FALSE(report.completed);
    ASSERT_EQ(report.stopDetail.substr(0, 5), "body ");
    EXPECT_GE(run.mechanism.findBody(report.stopDetail.substr(5)), 0) << report.stopDetail;
    EXPECT_GT(report.steps, 0);
    EXPECT_LT(report.simTime, 5.0);
    const Snapshot& last = simulation.snapshot();
    EXPECT_EQ(last.step, report.steps);
    for (const Pose& pose : last.bodies) {
        EXPECT_TRUE(pose.position.allFinite() && pose.rotation.coeffs().allFinite());
    }
    std::vector<double> row;
    sampleChannels(run.mechanism, last, row);
    const std::vector<Channel> channels = makeChannels(run.mechanism);
    for (std::size_t i = 0; i < row.size(); ++i) {
        // Speed control has neither torques nor loads in mind, nor rates while it brakes.
        const std::set<std::string> missing{"common_torque",        "required_friction",
                                            "friction_cap",         "torque_planned",
                                            "normal_force_planned", "rate_planned"};
        EXPECT_TRUE(std::isfinite(row[i]) || missing.count(channels[i].quantity) == 1)
            << channels[i].id();
    }
    EXPECT_TRUE(std::isfinite(report.loopErrorMax) && std::isfinite(report.energy));
    // The state kept is that of the last good step.
    Simulation before(run);
    while (before.snapshot().step < report.steps) {
        before.step();
    }
    EXPECT_FALSE(before.finished());
    EXPECT_EQ(before.report().stateHash, report.stateHash);
    // The same happens under a worker, which keeps the rows up to there.
    RunWorker worker(run);
    worker.setSpeedFactor(0.0);
    worker.play();
    while (worker.state() != WorkerState::Finished) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(worker.report().stopReason, StopReason::NonFinite);
    EXPECT_EQ(worker.report().stopDetail, report.stopDetail);
    std::vector<std::vector<double>> rows;
    std::vector<std::shared_ptr<const Snapshot>> frames;
    worker.drain(rows, frames);
    EXPECT_GE(rows.size(), 2u);
    EXPECT_NEAR(rows.back()[0], report.simTime, 1e-12);
}

// -- manual ---------------------------------------------------------------------------------------

class ManualTest : public ::testing::Test {
  protected:
    /// Drives for 3 s after settling; position, yaw and yaw rate of the cart's chassis then.
    struct End {
        Vec3 position;
        double yaw;
    };

    static End drive(const ManualCommand& command) {
        ResolvedRun run = runOf(makeCart(), levelGround());
        run.controller = ControllerKind::Manual;
        run.distance = 100.0;
        run.duration = 3.2;
        Simulation simulation(run);
        simulation.setManualCommand(command);
        runToEnd(simulation);
        const Pose& pose = simulation.snapshot().bodies[0];
        const Vec3 nose = pose.rotation * Vec3::UnitX();
        return {pose.position, std::atan2(nose.y(), nose.x())};
    }
};

// Straight ahead it goes speed times time, and back.
TEST_F(ManualTest, DrivesAtTheSpeedAsked) {
    for (const double speed : {0.15, -0.15}) {
        const End end = drive({.speed = speed, .turn = 0.0});
        EXPECT_NEAR(end.position.x(), 3.0 * speed, 0.03 * 3.0 * std::abs(speed));
        EXPECT_NEAR(end.position.y(), 0.0, 1e-3);
        EXPECT_NEAR(end.yaw, 0.0, 1e-3);
    }
}

// Turning on the spot it yaws to the side asked, no further than the wheels would take a cart that
// did not slip sideways, and mirrored to the other side.
TEST_F(ManualTest, TurnsToTheSideAsked) {
    const End left = drive({.speed = 0.0, .turn = 0.5});
    EXPECT_GT(left.yaw, 0.2);
    EXPECT_LT(left.yaw, 1.5);
    EXPECT_LT(left.position.norm(), 0.02);
    const End right = drive({.speed = 0.0, .turn = -0.5});
    EXPECT_NEAR(right.yaw, -left.yaw, 0.02 * left.yaw);
}

// A left turn while driving curves to the left.
TEST_F(ManualTest, CurvesToTheSideAsked) {
    const End end = drive({.speed = 0.15, .turn = 0.3});
    EXPECT_GT(end.position.x(), 0.2);
    EXPECT_GT(end.position.y(), 0.02);
    EXPECT_GT(end.yaw, 0.1);
}

// Without a command it stands, and it is never stuck.
TEST_F(ManualTest, StandsWithoutACommand) {
    ResolvedRun run = runOf(makeCart(), levelGround());
    run.controller = ControllerKind::Manual;
    Simulation simulation(run);
    runToEnd(simulation, 12.0);
    EXPECT_FALSE(simulation.finished());
    EXPECT_NEAR(simulation.snapshot().distance, 0.0, 1e-4);
}

// -- controllers in the loop ----------------------------------------------------------------------

// Torque control reaches the speed asked uphill and against rolling resistance: its integral takes
// over the load, m g sin(slope) + c m g cos(slope), shared by N_i.
TEST(SimulationTest, EqualTorqueHoldsItsSpeedUphill) {
    const double slope = 0.15;
    CartNumbers numbers;
    numbers.comX = 0.05;
    ResolvedRun run = runOf(tilted(makeCart(numbers), slope), slopeThroughOrigin(slope));
    run.controller = ControllerKind::EqualTorque;
    run.rollingResistance = 0.02;
    run.duration = 6.0;
    run.distance = 100.0;
    Simulation simulation(run);
    runToEnd(simulation, 4.0);
    const Vec3 start = simulation.snapshot().centerOfMass;
    runToEnd(simulation, 6.0);
    const double speed = (simulation.snapshot().centerOfMass - start).norm() / 2.0;
    // The chassis is drawn nose up, so its forward axis is the world's x: the speed sensed is the
    // part along x.
    EXPECT_NEAR(speed * std::cos(slope), run.speed, 0.01 * run.speed);
    const double weight = run.mechanism.mass() * kG;
    double torque = 0.0;
    for (const WheelState& wheel : simulation.snapshot().wheels) {
        torque += wheel.torqueApplied;
    }
    const double needed =
        numbers.radius * weight * (std::sin(slope) + run.rollingResistance * std::cos(slope));
    EXPECT_NEAR(torque, needed, 0.02 * needed);
    const auto& wheels = simulation.snapshot().wheels;
    EXPECT_NEAR(wheels[0].torqueApplied / wheels[2].torqueApplied,
                wheels[0].normalForce / wheels[2].normalForce, 0.01);
    EXPECT_NE(wheels[0].normalForce, wheels[2].normalForce);
}

// The hardest on the joints: down from a 0.1 m step, with torques. Loops stay closed within 0.01 mm
// and friction within its goal.
TEST(StepDownTest, KeepsLoopsClosedUnderTorques) {
    RunRequest asked = request("step");
    asked.controller = ControllerKind::EqualTorque;
    Simulation simulation(prepared(shipped("solero"), asked));
    runToEnd(simulation);
    const RunReport report = simulation.report();
    EXPECT_TRUE(report.completed) << report.stopDetail;
    EXPECT_LT(report.loopErrorMax, 1e-5);
    EXPECT_LT(report.frictionViolationPercent, 1.0);
}

// -- preparing ------------------------------------------------------------------------------------

// All that is wrong comes back as problems that name the place; nothing throws.
TEST(PrepareRunTest, SaysWhatIsWrong) {
    const project::Project solero = shipped("solero");
    const auto unknown = prepareRun(solero, request("moon"));
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.problems().at(0).remedy.find("rough-profile"), std::string::npos);

    RunRequest bad = request("flat");
    bad.step = 0.5;
    bad.friction = -1.0;
    const auto numbers = prepareRun(solero, bad);
    ASSERT_FALSE(numbers);
    EXPECT_EQ(numbers.problems().size(), 2u);

    project::Project inside = solero;
    for (project::Scenario& scenario : inside.scenarios) {
        scenario.terrain.start = 0.1;
    }
    const auto buried = prepareRun(inside, request("step"));
    ASSERT_FALSE(buried);
    EXPECT_EQ(buried.problems().at(0).element.substr(0, 6), "wheel ");
}

// What is asked for on top of a scenario replaces the scenario's, the seed the terrain's too.
// A rover that drives backwards has ground all the way and beyond, whatever the ground.
TEST(PrepareRunTest, GroundReachesBeyondABackwardRun) {
    for (const char* scenario : {"flat", "step", "rough-profile", "rough-3d"}) {
        project::Project backward = shipped("solero");
        for (auto& one : backward.scenarios) {
            one.controller.speed = -0.1;
            one.run.distance = 6.0;
        }
        const auto run = prepareRun(backward, request(scenario));
        ASSERT_TRUE(run) << toString(run.problems());
        EXPECT_EQ(run->terrain->heightAt(-8.0, 0.0), 0.0) << scenario;
        EXPECT_EQ(run->terrain->heightAt(0.0, 0.0), 0.0) << scenario;
    }
}

// An editor learns of bad terrain and of what the engine cannot run without running anything.
TEST(CheckProjectTest, NamesWhatKeepsAScenarioFromRunning) {
    EXPECT_TRUE(checkProject(shipped("solero")).empty());
    project::Project deep = shipped("solero");
    for (auto& scenario : deep.scenarios) {
        if (scenario.name == "step") {
            scenario.terrain.height = 5.0;
        }
    }
    const Problems terrain = checkProject(deep);
    ASSERT_EQ(terrain.size(), 1U) << toString(terrain);
    EXPECT_THAT(terrain[0].element, HasSubstr("scenario step, terrain step, height"));

    project::Project far = shipped("solero");
    far.rover.gears = {{"far", "bogie_left_front_axle", "bogie_right_front_axle", -1.0}};
    EXPECT_THAT(toString(checkProject(far)), HasSubstr("do not turn in one common body"));
}

TEST(PrepareRunTest, RequestReplacesTheScenariosValues) {
    RunRequest asked = request("rough-profile", 7.0);
    asked.controller = ControllerKind::EqualTorque;
    asked.friction = 0.45;
    asked.step = 0.001;
    asked.seed = 9;
    asked.assignments = {{"wheel_radius", "75 mm"}};
    const project::Project solero = shipped("solero");
    const ResolvedRun run = prepared(solero, asked);
    EXPECT_EQ(run.controller, ControllerKind::EqualTorque);
    EXPECT_EQ(run.friction, 0.45);
    EXPECT_EQ(run.step, 0.001);
    EXPECT_EQ(run.duration, 7.0);
    EXPECT_NEAR(run.mechanism.wheels[0].radius, 0.075, 1e-12);
    EXPECT_NE(run.terrain->profile(),
              prepared(solero, request("rough-profile")).terrain->profile());
}
