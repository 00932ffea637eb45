// Steered rovers in the engine: the curves they drive, how little they slip, and what keeps their
// heading. A wheel in the air under every controller.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/dynamics/engine.h"
#include "simcore/run/simulation.h"
#include "tests/support/carts.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;
using project::ControllerKind;
using project::SteeringMode;

namespace {

ResolvedRun steeredRover(const std::string& scenario, double duration) {
    RunRequest request;
    request.scenario = scenario;
    request.duration = duration;
    auto run = prepareRun(shipped("rocker_bogie_steered"), request);
    if (!run) {
        throw std::runtime_error(toString(run.problems()));
    }
    return std::move(run).value();
}

double yawOf(const Snapshot& snapshot) {
    const Vec3 nose = snapshot.bodies[0].rotation * Vec3::UnitX();
    return std::atan2(nose.y(), nose.x());
}

double lateralSlip(const RunReport& report) {
    double sum = 0.0;
    for (const WheelReport& wheel : report.wheels) {
        sum += wheel.slipLateral;
    }
    return sum;
}

/// What a drive came to: the heading turned through and the way of the chassis' origin.
struct Drive {
    double yaw = 0.0;
    double path = 0.0;
    Vec3 end;
    double lateral = 0.0;
};

Drive drive(const ResolvedRun& run, const ManualCommand& command, double from) {
    Simulation simulation(run);
    simulation.setManualCommand(command);
    runToEnd(simulation, from);
    Drive out;
    double last = yawOf(simulation.snapshot());
    Vec3 place = simulation.snapshot().bodies[0].position;
    while (!simulation.finished()) {
        simulation.step();
        const double yaw = yawOf(simulation.snapshot());
        out.yaw += std::remainder(yaw - last, 2.0 * std::numbers::pi);
        last = yaw;
        const Vec3 next = simulation.snapshot().bodies[0].position;
        out.path += (next - place).norm();
        place = next;
    }
    out.end = place;
    out.lateral = lateralSlip(simulation.report());
    return out;
}

}  // namespace

// The circle of the scenario comes out with the radius asked, and its wheels slip sideways by a
// small part of what skid steering makes them.
TEST(SteeringRunTest, SteeredRoverDrivesTheCircleAsked) {
    const Drive steered = drive(steeredRover("circle", 16.0), {}, 6.0);
    EXPECT_NEAR(steered.path / steered.yaw, 0.8, 0.02 * 0.8);
    // The rover's wheels may roll on either edge, so that their way is uncertain by half a width.
    EXPECT_NEAR(steered.yaw, 10.0 * 0.1 / 0.8, 0.03 / 0.8 * 1.25);
    const Drive skid = drive(steeredRover("circle-skid", 16.0), {}, 6.0);
    EXPECT_GT(skid.path / skid.yaw, 0.8);
    EXPECT_LT(steered.lateral, 0.1 * skid.lateral);
}

// Asked to turn without going anywhere, it turns about its middle, as fast as asked but for half a
// wheel's width over the nearest wheels' distance from there.
TEST(SteeringRunTest, SteeredRoverTurnsOnTheSpot) {
    ResolvedRun run = steeredRover("by-hand", 12.0);
    const Drive turned = drive(run, {.speed = 0.0, .turn = 0.2}, 2.5);
    EXPECT_NEAR(turned.yaw, 9.5 * 0.2, 0.03 / 0.25 * 1.9);
    EXPECT_LT(turned.end.norm(), 0.02);
    EXPECT_LT(turned.path, 0.03);
}

// To the left and to the right are mirror images.
TEST(SteeringRunTest, LeftAndRightMirror) {
    const ResolvedRun run = steeredRover("by-hand", 5.0);
    const Drive left = drive(run, {.speed = 0.1, .turn = 0.15}, 0.0);
    const Drive right = drive(run, {.speed = 0.1, .turn = -0.15}, 0.0);
    EXPECT_GT(left.yaw, 0.4);
    EXPECT_NEAR(left.yaw, -right.yaw, 0.01 * left.yaw);
    EXPECT_NEAR(left.end.y(), -right.end.y(), 0.01 * left.end.y());
}

// The resolved rover: welded for analyses and for controllers that do not steer.
TEST(SteeringRunTest, OnlyControllersThatSteerFreeTheJoints) {
    const project::Project project = shipped("rocker_bogie_steered");
    const auto jointsWith = [&](ControllerKind kind, SteeringMode steering, double turn,
                                bool hold) {
        project::Project changed = project;
        for (auto& scenario : changed.scenarios) {
            scenario.controller.kind = kind;
            scenario.controller.steering = steering;
            scenario.controller.turn = turn;
            scenario.controller.headingHold = hold;
        }
        RunRequest request;
        request.scenario = "flat";
        const auto run = prepareRun(changed, request);
        return run ? run->mechanism.joints.size() : 0;
    };
    constexpr std::size_t kWelded = 10;
    EXPECT_EQ(jointsWith(ControllerKind::Speed, SteeringMode::Auto, 0.0, false), kWelded);
    EXPECT_EQ(jointsWith(ControllerKind::EqualTorque, SteeringMode::Auto, 0.1, true), kWelded);
    EXPECT_EQ(jointsWith(ControllerKind::Manual, SteeringMode::Skid, 0.0, false), kWelded);
    EXPECT_EQ(jointsWith(ControllerKind::Manual, SteeringMode::Auto, 0.0, false), kWelded + 4);
    EXPECT_EQ(jointsWith(ControllerKind::Speed, SteeringMode::Ackermann, 0.1, false), kWelded + 4);
    EXPECT_EQ(jointsWith(ControllerKind::Speed, SteeringMode::Auto, 0.0, true), kWelded + 4);
}

// -- heading hold ---------------------------------------------------------------------------------

namespace {

/// Level ground with waves on its left half from 0.5 m on, 3 cm high: there the way is longer.
terrain::Terrain wavesOnTheLeft() {
    constexpr double kCell = 0.025;
    constexpr int kNx = 200;
    constexpr int kNy = 121;
    std::vector<double> heights;
    for (int i = 0; i < kNx; ++i) {
        const double x = -1.0 + kCell * i;
        for (int k = 0; k < kNy; ++k) {
            const bool wavy = x > 0.5 && k > kNy / 2;
            const double wave = 0.015 * (1.0 - std::cos(2.0 * std::numbers::pi * (x - 0.5) / 0.2));
            heights.push_back(wavy ? wave : 0.0);
        }
    }
    return terrain::Terrain::grid(-1.0, -1.5, kCell, kNx, kNy, heights);
}

/// Heading at the end of a drive over them [rad].
double headingAfterWaves(const Mechanism& rover, bool hold) {
    ResolvedRun run = runOf(rover, wavesOnTheLeft());
    run.controller = ControllerKind::Speed;
    run.headingHold = hold;
    run.speed = 0.15;
    run.distance = 2.6;
    Simulation simulation(run);
    EXPECT_TRUE(runToEnd(simulation).completed);
    return yawOf(simulation.snapshot());
}

}  // namespace

// On ground that is rough on one side only a rover turns to that side. Heading hold keeps it on
// course: by wheel speeds, and by steering.
TEST(HeadingHoldRunTest, HoldsTheHeadingOnOneSidedGround) {
    CartNumbers shortCart;  // a long one turns hardly at all unless its wheels make it
    shortCart.halfBase = 0.09;
    shortCart.halfTrack = 0.3;
    for (const Mechanism& rover : {makeCart(shortCart), makeSteeredCart({}, shortCart)}) {
        const double without = headingAfterWaves(rover, false);
        EXPECT_GT(without, 0.05);
        EXPECT_LT(std::abs(headingAfterWaves(rover, true)), 0.25 * without);
    }
}

namespace {

struct HeldDrive {
    double worst = 0.0;  ///< heading [rad]
    double end = 0.0;    ///< [rad]
    double slip = 0.0;   ///< of all wheels [m]
    bool completed = false;
};

/// A skid-steered cart starts hard, within 50 ms, on ground with a friction of 0.3 under its left
/// wheels and of 0.7 under its right ones: the left ones slip and it turns to the left.
HeldDrive driveOnUnevenFriction(double slope, bool hold) {
    CartNumbers shortCart;
    shortCart.halfBase = 0.09;
    shortCart.halfTrack = 0.3;
    ResolvedRun run = runOf(tilted(makeCart(shortCart), slope), slopeThroughOrigin(slope));
    run.controller = ControllerKind::Speed;
    run.headingHold = hold;
    run.speed = 0.4;
    run.ramp = 0.05;
    run.distance = 1.8;
    project::GroundRegion left;
    left.friction = 0.3;
    left.xMin = -10.0;
    left.xMax = 10.0;
    left.yMax = 10.0;
    run.regions = {left};
    Simulation simulation(run);
    HeldDrive drive;
    while (!simulation.finished()) {
        simulation.step();
        drive.end = yawOf(simulation.snapshot());
        drive.worst = std::max(drive.worst, std::abs(drive.end));
    }
    drive.slip = simulation.report().slipAbs;
    drive.completed = simulation.report().completed;
    return drive;
}

}  // namespace

// Uneven friction turns a skid-steered rover, the more the steeper it climbs. Heading hold brings
// it back to its course, on level ground and on gentle rises, without swinging beyond it. At 0.2
// rad the left wheels are near their limit: it takes longer, and costs slip.
TEST(HeadingHoldRunTest, UndoesWhatUnevenFrictionDid) {
    for (const double slope : {0.0, 0.1, 0.2}) {
        SCOPED_TRACE(slope);
        const HeldDrive without = driveOnUnevenFriction(slope, false);
        const HeldDrive with = driveOnUnevenFriction(slope, true);
        ASSERT_TRUE(without.completed && with.completed);
        EXPECT_GT(without.end, 0.007);
        EXPECT_LT(std::abs(with.end), (slope < 0.2 ? 0.1 : 0.3) * without.end);
        EXPECT_GT(with.end, -0.001);
        EXPECT_LE(with.worst, without.worst);
        EXPECT_LT(with.slip, (slope < 0.2 ? 2.0 : 4.0) * without.slip);
    }
}

// Where the left wheels are at their limit from climbing alone, 0.25 rad, it helps little. It does
// not spin the wheels until the rover stands, either.
TEST(HeadingHoldRunTest, DoesNotStallAClimbOnUnevenFriction) {
    const HeldDrive without = driveOnUnevenFriction(0.25, false);
    const HeldDrive with = driveOnUnevenFriction(0.25, true);
    EXPECT_TRUE(with.completed);
    EXPECT_LT(with.worst, without.worst);
}

// Parked on a slope it does not creep.
TEST(ParkingTest, ParkedRoverDoesNotCreep) {
    const double slope = 0.2;
    ResolvedRun run = runOf(tilted(makeCart(), slope), slopeThroughOrigin(slope));
    run.controller = ControllerKind::Manual;
    Simulation simulation(run);
    runToEnd(simulation, 1.0);
    simulation.setManualCommand({.speed = 0.1, .turn = 0.0});
    runToEnd(simulation, 3.0);
    simulation.setManualCommand({});
    runToEnd(simulation, 4.0);
    const Vec3 parked = simulation.snapshot().bodies[0].position;
    runToEnd(simulation, 14.0);
    EXPECT_LT((simulation.snapshot().bodies[0].position - parked).norm(), 1e-4);
}

// -- a wheel in the air ---------------------------------------------------------------------------

struct LiftedCase {
    ControllerKind kind;
    double step;
};

class LiftedWheelTest : public ::testing::TestWithParam<LiftedCase> {};

INSTANTIATE_TEST_SUITE_P(ControllersAndSteps, LiftedWheelTest,
                         ::testing::Values(LiftedCase{ControllerKind::Speed, 0.0005},
                                           LiftedCase{ControllerKind::Speed, 0.001},
                                           LiftedCase{ControllerKind::Speed, 0.002},
                                           LiftedCase{ControllerKind::Speed, 0.005},
                                           LiftedCase{ControllerKind::EqualTorque, 0.0005},
                                           LiftedCase{ControllerKind::EqualTorque, 0.001},
                                           LiftedCase{ControllerKind::EqualTorque, 0.002},
                                           LiftedCase{ControllerKind::EqualTorque, 0.005},
                                           LiftedCase{ControllerKind::Manual, 0.0005},
                                           LiftedCase{ControllerKind::Manual, 0.001},
                                           LiftedCase{ControllerKind::Manual, 0.002},
                                           LiftedCase{ControllerKind::Manual, 0.005}),
                         [](const auto& each) {
                             const auto kind = each.param.kind;
                             return std::string(kind == ControllerKind::Speed ? "Speed"
                                                : kind == ControllerKind::EqualTorque
                                                    ? "EqualTorque"
                                                    : "Manual") +
                                    std::to_string(std::lround(1e6 * each.param.step)) + "us";
                         });

// The light front wheel of a cart hangs in the air, on a steering pin where the rover is driven by
// hand. It takes up the commanded rate within half a second and then keeps it to 1 %; nor does it
// swing about it on the way by more than that, step by step.
TEST_P(LiftedWheelTest, TakesUpItsRateWithoutOscillation) {
    CartNumbers numbers;
    numbers.comX = -0.12;
    const bool manual = GetParam().kind == ControllerKind::Manual;
    Mechanism cart = manual ? makeSteeredCart({}, numbers) : makeCart(numbers);
    constexpr double kLift = 0.03;
    Wheel& wheel = cart.wheels[0];
    wheel.center.z() += kLift;
    cart.bodies[static_cast<std::size_t>(wheel.body)].com.z() += kLift;
    cart.joints[static_cast<std::size_t>(wheel.axle)].point.z() += kLift;
    ResolvedRun run = runOf(cart, levelGround());
    run.controller = GetParam().kind;
    run.step = GetParam().step;
    run.speed = 0.1;
    run.ramp = 0.0;
    run.distance = 100.0;
    run.duration = 2.2;
    Simulation simulation(run);
    simulation.setManualCommand({.speed = 0.1, .turn = 0.0});
    runToEnd(simulation, 0.2);
    const double wanted = 0.1 / wheel.radius;
    double lastError = 0.0;
    int crossings = 0;
    while (!simulation.finished()) {
        simulation.step();
        ASSERT_FALSE(simulation.snapshot().wheels[0].touching);
        const double error = simulation.snapshot().wheels[0].rate - wanted;
        // Beyond 1 % on both sides of two steps: an oscillation.
        if (error * lastError < 0.0 && std::abs(error - lastError) > 0.02 * wanted) {
            ++crossings;
        }
        lastError = error;
        if (simulation.snapshot().time > 0.7) {
            ASSERT_NEAR(error, 0.0, 0.01 * wanted) << simulation.snapshot().time;
        }
    }
    EXPECT_LE(crossings, 1);  // one overshoot
    for (const JointState& joint : simulation.snapshot().joints) {
        EXPECT_NEAR(joint.angle, 0.0, 1e-3);
        EXPECT_NEAR(joint.rate, 0.0, 1e-3);
    }
}
