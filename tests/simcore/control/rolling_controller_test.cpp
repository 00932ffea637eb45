// Controllers that know the mechanism, against closed forms of what they ask of the wheels.
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/control/controller.h"
#include "simcore/control/rover_estimate.h"
#include "simcore/control/wheel_drive.h"
#include "simcore/dynamics/engine.h"
#include "simcore/project/resolve.h"
#include "simcore/statics/traction.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::control;
using project::ControllerKind;

namespace {

constexpr ControllerKind kRolling[] = {ControllerKind::Synchronised, ControllerKind::CommonIntegral,
                                       ControllerKind::Torque, ControllerKind::Hybrid};

mechanism::Mechanism solero() {
    auto resolved = project::resolve(testsupport::shipped("solero"));
    EXPECT_TRUE(resolved);
    return std::move(resolved).value();
}

/// What sensors read where the drawn rover stands on a slope that rises ahead, or on level ground.
Sensors standing(const mechanism::Mechanism& mechanism, double slope, double speed) {
    Sensors sensors;
    sensors.bodySpeed = speed;
    sensors.imu.pitch = -slope;  // nose up
    sensors.joints.assign(mechanism.encoderJoints().size(), 0.0);
    const double load = mechanism.mass() * dynamics::kGravity * std::cos(slope) /
                        static_cast<double>(mechanism.wheels.size());
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        sensors.wheels.push_back(
            {.rate = speed / wheel.radius, .normalForce = load, .contactAngle = slope});
    }
    return sensors;
}

std::vector<WheelCommand> commandsOf(const mechanism::Mechanism& mechanism, ControllerKind kind,
                                     const Sensors& sensors, double speed, int periods) {
    ControllerSettings settings;
    settings.kind = kind;
    const auto controller = makeController(mechanism, settings);
    std::vector<WheelCommand> wheels(mechanism.wheels.size());
    for (int k = 0; k < periods; ++k) {
        controller->update(sensors, {.speed = speed}, wheels);
    }
    return wheels;
}

}  // namespace

// On even ground, sloping or not, all wheels roll with v/R.
TEST(RollingControllerTest, RatesOnEvenGroundAreSpeedOverRadius) {
    const mechanism::Mechanism mechanism = solero();
    for (const ControllerKind kind :
         {ControllerKind::Synchronised, ControllerKind::CommonIntegral, ControllerKind::Hybrid}) {
        for (const double slope : {0.0, 0.2}) {
            const auto commands =
                commandsOf(mechanism, kind, standing(mechanism, slope, 0.1), 0.1, 100);
            for (std::size_t i = 0; i < commands.size(); ++i) {
                EXPECT_EQ(commands[i].mode, WheelMode::Speed);
                EXPECT_NEAR(commands[i].speed, 0.1 / mechanism.wheels[i].radius, 1e-6);
            }
        }
    }
}

// At the speed asked, the torques are those that hold the rover: m g sin(slope) R in all, shared by
// load.
TEST(RollingControllerTest, TorquesHoldTheRoverOnASlope) {
    const mechanism::Mechanism mechanism = solero();
    constexpr double kSlope = 0.2;
    for (const ControllerKind kind : {ControllerKind::Torque, ControllerKind::Hybrid}) {
        const auto commands = commandsOf(mechanism, kind, standing(mechanism, kSlope, 0.1), 0.1, 1);
        double force = 0.0;
        for (std::size_t i = 0; i < commands.size(); ++i) {
            force += commands[i].torque / mechanism.wheels[i].radius;
        }
        EXPECT_NEAR(force, mechanism.mass() * dynamics::kGravity * std::sin(kSlope), 1e-6);
    }
}

// The optimum that goes out is the quasi-static model's, wheel by wheel.
TEST(RollingControllerTest, TorquesAreTheModelsOptimum) {
    const mechanism::Mechanism mechanism = solero();
    Sensors sensors = standing(mechanism, 0.0, 0.1);
    sensors.wheels[0].contactAngle = 0.8;
    const auto commands = commandsOf(mechanism, ControllerKind::Torque, sensors, 0.1, 1);
    RoverEstimate estimate(mechanism, 0.01);
    estimate.update(sensors);
    const statics::Traction traction(
        estimate.model().equilibrium(estimate.contacts(), statics::ContactSet::All,
                                     dynamics::kGravity),
        mechanism, estimate.contacts());
    const statics::Solution best = traction.best(statics::Objective::Friction);
    for (std::size_t i = 0; i < commands.size(); ++i) {
        EXPECT_NEAR(commands[i].torque, best.forces.torque[i], 1e-4) << i;
    }
}

// Who watches sees the model's forces: they balance the weight, and the torque that goes out is the
// planned one and the loop's share.
TEST(RollingControllerTest, TheIntentIsWhatGoesOut) {
    const mechanism::Mechanism mechanism = solero();
    constexpr double kSlope = 0.2;
    for (const ControllerKind kind : {ControllerKind::Torque, ControllerKind::Hybrid}) {
        ControllerSettings settings;
        settings.kind = kind;
        const auto controller = makeController(mechanism, settings);
        EXPECT_TRUE(controller->intent().wheels.empty());
        std::vector<WheelCommand> wheels(mechanism.wheels.size());
        controller->update(standing(mechanism, kSlope, 0.08), {.speed = 0.1}, wheels);
        const Intent& intent = controller->intent();
        double normal = 0.0;
        for (std::size_t i = 0; i < wheels.size(); ++i) {
            normal += intent.wheels[i].normalForce;
            EXPECT_GT(wheels[i].torque, intent.wheels[i].torque);  // the rover is too slow
        }
        EXPECT_NEAR(normal, mechanism.mass() * dynamics::kGravity * std::cos(kSlope), 1e-6);
        EXPECT_NEAR(intent.requiredFriction, std::tan(kSlope), 1e-6);
        EXPECT_GT(intent.commonTorque, 0.0);
        EXPECT_GT(intent.frictionCap, 0.0);
        controller->update(standing(mechanism, 0.0, 0.0), {.brake = true}, wheels);
        EXPECT_TRUE(std::isnan(controller->intent().requiredFriction));
        EXPECT_TRUE(std::isnan(controller->intent().wheels[0].torque));
    }
    const auto speed = makeController(mechanism, {});
    std::vector<WheelCommand> wheels(mechanism.wheels.size());
    speed->update(standing(mechanism, 0.0, 0.0), {.speed = 0.1}, wheels);
    EXPECT_NEAR(speed->intent().wheels[2].rate, 0.1 / mechanism.wheels[2].radius, 1e-12);
    EXPECT_TRUE(std::isnan(speed->intent().commonTorque));
}

// Encoders, tilt and contacts make the pose: bodies are where the engine's tree puts them.
TEST(RoverEstimateTest, TakesUpTheMeasuredPose) {
    const mechanism::Mechanism mechanism = solero();
    RoverEstimate estimate(mechanism, 0.01);
    Sensors sensors = standing(mechanism, 0.0, 0.0);
    sensors.imu.pitch = 0.1;
    sensors.imu.roll = -0.05;
    estimate.update(sensors);
    const Pose& chassis = estimate.model().poses()[static_cast<std::size_t>(mechanism.chassis)];
    const Vec3 forward = chassis.rotation * Vec3::UnitX();
    const Vec3 left = chassis.rotation * Vec3::UnitY();
    EXPECT_NEAR(forward.z(), -std::sin(0.1), 1e-12);                // nose down
    EXPECT_NEAR(left.z(), std::sin(-0.05) * std::cos(0.1), 1e-12);  // right side down is positive
}

// Where one wheel climbs so steeply that it would have to race, all others wait for it.
TEST(RollingControllerTest, OthersWaitForTheWheelThatClimbs) {
    const mechanism::Mechanism mechanism = solero();
    Sensors sensors = standing(mechanism, 0.0, 0.0);
    sensors.wheels[0].contactAngle = 1.5;
    const auto commands = commandsOf(mechanism, ControllerKind::Synchronised, sensors, 0.1, 100);
    const double level = 0.1 / mechanism.wheels[0].radius;
    EXPECT_GT(commands[0].speed, 1.9 * level);
    EXPECT_LT(commands[0].speed, 2.0 * level + 1e-9);
    EXPECT_LT(commands[5].speed, 0.5 * level);
}

// A wheel that hangs is not driven by torque, and does not count for the model.
TEST(RollingControllerTest, AHangingWheelFollowsGently) {
    const mechanism::Mechanism mechanism = solero();
    for (const ControllerKind kind : kRolling) {
        Sensors sensors = standing(mechanism, 0.1, 0.1);
        sensors.wheels[3].normalForce = 0.0;
        const auto commands = commandsOf(mechanism, kind, sensors, 0.1, 10);
        EXPECT_EQ(commands[3].mode, WheelMode::Speed);
        EXPECT_EQ(commands[3].torque, 0.0);
        EXPECT_NEAR(commands[3].speed, 0.1 / mechanism.wheels[3].radius, 1e-12);
        for (const WheelCommand& command : commands) {
            EXPECT_TRUE(std::isfinite(command.torque) && std::isfinite(command.speed));
        }
    }
}

// All wheels in the air, or nothing but zeros from the sensors: no number is lost.
TEST(RollingControllerTest, NothingMeasuredIsNoDisaster) {
    const mechanism::Mechanism mechanism = solero();
    for (const ControllerKind kind : kRolling) {
        Sensors sensors = standing(mechanism, 0.0, 0.0);
        for (WheelSensors& wheel : sensors.wheels) {
            wheel.normalForce = 0.0;
        }
        for (const WheelCommand& command : commandsOf(mechanism, kind, sensors, 0.1, 10)) {
            EXPECT_TRUE(std::isfinite(command.torque) && std::isfinite(command.speed));
        }
    }
}

// What a slipping wheel gives bounds what the others are asked for; it comes back by and by.
TEST(RollingControllerTest, HybridLearnsFrictionFromSlip) {
    const mechanism::Mechanism mechanism = solero();
    ControllerSettings settings;
    settings.kind = ControllerKind::Hybrid;
    const auto controller = makeController(mechanism, settings);
    std::vector<WheelCommand> commands(mechanism.wheels.size());
    constexpr double kSlope = 0.45;
    Sensors sensors = standing(mechanism, kSlope, 0.1);
    controller->update(sensors, {.speed = 0.1}, commands);
    const double before = commands[1].torque;
    sensors.wheels[0].rate += 1.0;  // runs ahead of the ground
    for (int k = 0; k < 10; ++k) {
        controller->update(sensors, {.speed = 0.1}, commands);
    }
    EXPECT_LT(commands[1].torque, 0.97 * before);
    sensors.wheels[0].rate -= 1.0;
    for (int k = 0; k < 1000; ++k) {
        controller->update(sensors, {.speed = 0.1}, commands);
    }
    EXPECT_NEAR(commands[1].torque, before, 0.05 * before);
}
