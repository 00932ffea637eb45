// What the controllers ask of the wheels, against their definitions (docs/controllers.md).
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/control/controller.h"
#include "simcore/control/wheel_drive.h"
#include "tests/support/carts.h"

using namespace simcore;
using namespace simcore::control;
using namespace testsupport;
using project::ControllerKind;

namespace {

ControllerSettings settingsOf(ControllerKind kind) {
    ControllerSettings settings;
    settings.kind = kind;
    return settings;
}

Sensors sensorsOf(const std::vector<double>& loads, double bodySpeed = 0.0) {
    Sensors sensors;
    sensors.bodySpeed = bodySpeed;
    for (const double load : loads) {
        sensors.wheels.push_back({.rate = 0.0, .normalForce = load, .contactAngle = 0.0});
    }
    return sensors;
}

std::vector<WheelCommand> commandsOf(Controller& controller, const Sensors& sensors,
                                     const DriveCommand& command) {
    std::vector<WheelCommand> wheels(sensors.wheels.size());
    controller.update(sensors, command, wheels);
    return wheels;
}

std::vector<WheelCommand> commandsOf(ControllerKind kind, const DriveCommand& command,
                                     const Mechanism& mechanism = makeCart()) {
    const auto controller = makeController(mechanism, settingsOf(kind));
    return commandsOf(*controller, sensorsOf({20.0, 20.0, 20.0, 20.0}), command);
}

}  // namespace

// -- speed and manual -----------------------------------------------------------------------------

// Every wheel gets the rover's speed over its own radius, and may use all its torque.
TEST(SpeedControllerTest, WheelRateIsSpeedOverRadius) {
    Mechanism cart = makeCart();
    cart.wheels[1].radius = 0.1;
    cart.wheels[2].torqueLimit = 1.7;
    for (const double speed : {0.1, -0.25, 0.0}) {
        const auto wheels =
            commandsOf(ControllerKind::Speed, {.speed = speed, .turn = 0.0, .brake = false}, cart);
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(wheels[i].mode, WheelMode::Speed);
            EXPECT_DOUBLE_EQ(wheels[i].speed, speed / cart.wheels[i].radius);
            EXPECT_EQ(wheels[i].torqueCap, cart.wheels[i].torqueLimit);
            EXPECT_DOUBLE_EQ(wheels[i].proportional, 0.5 * cart.wheels[i].torqueLimit);
            EXPECT_DOUBLE_EQ(wheels[i].integral, 5.0 * cart.wheels[i].torqueLimit);
        }
    }
}

TEST(SpeedControllerTest, GivenGainsReplaceTheDefaults) {
    ControllerSettings settings = settingsOf(ControllerKind::Speed);
    settings.proportional = 0.3;
    settings.integral = 4.0;
    const auto controller = makeController(makeCart(), settings);
    for (const WheelCommand& wheel :
         commandsOf(*controller, sensorsOf({20, 20, 20, 20}), {.speed = 0.1})) {
        EXPECT_EQ(wheel.proportional, 0.3);
        EXPECT_EQ(wheel.integral, 4.0);
    }
}

// A left turn (positive) slows the left wheels and speeds the right ones by turn times y.
TEST(SpeedControllerTest, SkidSteeringSlowsTheInnerSide) {
    const Mechanism cart = makeCart();
    const DriveCommand command{.speed = 0.1, .turn = 0.2, .brake = false};
    for (const ControllerKind kind : {ControllerKind::Manual, ControllerKind::Speed}) {
        const auto wheels = commandsOf(kind, command);
        for (std::size_t i = 0; i < 4; ++i) {
            const double y = cart.wheels[i].center.y();
            EXPECT_NEAR(wheels[i].speed * cart.wheels[i].radius, 0.1 - 0.2 * y, 1e-12);
        }
    }
}

// More than the motors can do is driven slower, along the same curve.
TEST(SpeedControllerTest, SpeedLimitKeepsTheCurve) {
    const DriveCommand slow{.speed = 0.1, .turn = 0.3, .brake = false};
    const DriveCommand fast{.speed = 10.0, .turn = 30.0, .brake = false};
    const auto a = commandsOf(ControllerKind::Speed, slow);
    const auto b = commandsOf(ControllerKind::Speed, fast);
    EXPECT_NEAR(b[1].speed, CartNumbers().speedLimit, 1e-12);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(b[i].speed / b[1].speed, a[i].speed / a[1].speed, 1e-12);
    }
}

// Half a second without a command, and a rover driven by hand is parked; any command lets it go.
// One that drives itself is not.
TEST(ManualControllerTest, ParksWhenNobodyDrives) {
    const Sensors sensors = sensorsOf({20.0, 20.0, 20.0, 20.0});
    const auto controller = makeController(makeCart(), settingsOf(ControllerKind::Manual));
    EXPECT_EQ(commandsOf(*controller, sensors, {})[0].mode, WheelMode::Lock);
    for (const DriveCommand& command : {DriveCommand{.speed = 0.1}, DriveCommand{.turn = -0.1}}) {
        EXPECT_EQ(commandsOf(*controller, sensors, command)[0].mode, WheelMode::Speed);
        for (int i = 0; i < 49; ++i) {
            const auto wheels = commandsOf(*controller, sensors, {});
            ASSERT_EQ(wheels[0].mode, WheelMode::Speed) << i;
            ASSERT_EQ(wheels[0].speed, 0.0);
        }
        for (int i = 0; i < 2; ++i) {
            (void)commandsOf(*controller, sensors, {});
        }
        EXPECT_EQ(commandsOf(*controller, sensors, {})[3].mode, WheelMode::Lock);
    }
    EXPECT_EQ(commandsOf(ControllerKind::Speed, {})[0].mode, WheelMode::Speed);
}

// A steered rover's wheels wait while they point the wrong way, and then roll round the centre of
// the turn; skid never steers.
TEST(ManualControllerTest, SteersThenDrives) {
    const Mechanism cart = makeSteeredCart();
    ControllerSettings settings = settingsOf(ControllerKind::Manual);
    Sensors sensors = sensorsOf({20.0, 20.0, 20.0, 20.0});
    sensors.joints.assign(4, 0.0);
    const DriveCommand onTheSpot{.speed = 0.0, .turn = 0.3};
    const auto controller = makeController(cart, settings);
    auto wheels = commandsOf(*controller, sensors, onTheSpot);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(wheels[i].speed, 0.0);
        const Vec3& c = cart.wheels[i].center;
        EXPECT_NEAR(std::abs(wheels[i].steering), std::atan2(std::abs(c.x()), std::abs(c.y())),
                    1e-9);
        sensors.joints[i] = wheels[i].steering;
    }
    wheels = commandsOf(*controller, sensors, onTheSpot);
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3& c = cart.wheels[i].center;
        EXPECT_NEAR(std::abs(wheels[i].speed) * cart.wheels[i].radius,
                    0.3 * std::hypot(c.x(), c.y()), 1e-9);
        EXPECT_EQ(wheels[i].speed > 0.0, c.y() < 0.0);
    }
    settings.steering = project::SteeringMode::Skid;
    sensors.joints.assign(4, 0.0);
    wheels = commandsOf(*makeController(cart, settings), sensors, onTheSpot);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(wheels[i].steering, 0.0);
        EXPECT_NEAR(wheels[i].speed * cart.wheels[i].radius, -0.3 * cart.wheels[i].center.y(),
                    1e-12);
    }
}

// While it settles every controller locks the wheels, with what torque their motors have.
TEST(SpeedControllerTest, BrakeHoldsTheWheels) {
    for (const ControllerKind kind :
         {ControllerKind::Speed, ControllerKind::Manual, ControllerKind::EqualTorque}) {
        for (const WheelCommand& wheel :
             commandsOf(kind, {.speed = 0.1, .turn = 0.3, .brake = true})) {
            EXPECT_EQ(wheel.mode, WheelMode::Lock);
            EXPECT_EQ(wheel.torqueCap, 3.0);
        }
    }
}

// -- equal torque ---------------------------------------------------------------------------------

class EqualTorqueTest : public ::testing::Test {
  protected:
    const Mechanism cart = makeCart();
    const double radius = cart.wheels[0].radius;
    ControllerSettings settings = settingsOf(ControllerKind::EqualTorque);
};

// Paper eq. 4: a wheel's torque is the common torque times N_i / N_mean, so torques are to each
// other as the loads, and their sum is n times the common torque.
TEST_F(EqualTorqueTest, TorqueIsSharedByLoad) {
    settings.proportional = 2.0;
    settings.integral = 3.0;
    const auto controller = makeController(cart, settings);
    const std::vector<double> loads{10.0, 30.0, 15.0, 25.0};
    const auto wheels = commandsOf(*controller, sensorsOf(loads, 0.04), {.speed = 0.1});
    const double common = 2.0 * 0.06 + 3.0 * 0.06 * settings.period;
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(wheels[i].mode, WheelMode::Torque);
        EXPECT_NEAR(wheels[i].torque, common * loads[i] / 20.0, 1e-12);
        sum += wheels[i].torque;
    }
    EXPECT_NEAR(sum, 4.0 * common, 1e-12);
}

// The derivative acts on the measured speed alone: a jump of the command does not kick, a jump of
// the speed does.
TEST_F(EqualTorqueTest, DerivativeActsOnTheMeasuredSpeed) {
    settings.proportional = 1e-9;
    settings.integral = 1e-9;
    settings.derivative = 0.5;
    const auto controller = makeController(cart, settings);
    const std::vector<double> loads(4, 20.0);
    (void)commandsOf(*controller, sensorsOf(loads, 0.02), {.speed = 0.0});
    EXPECT_NEAR(commandsOf(*controller, sensorsOf(loads, 0.02), {.speed = 5.0})[0].torque, 0.0,
                1e-6);
    EXPECT_NEAR(commandsOf(*controller, sensorsOf(loads, 0.05), {.speed = 5.0})[0].torque,
                -0.5 * 0.03 / settings.period, 1e-6);
}

// Caps: assumed_mu N R, never more than the motor has; with assumed_mu 0 only the motor's.
TEST_F(EqualTorqueTest, CapsFollowTheAssumedFriction) {
    const std::vector<double> loads{10.0, 30.0, 15.0, 300.0};
    settings.assumedFriction = 0.5;
    const auto capped =
        commandsOf(*makeController(cart, settings), sensorsOf(loads), {.speed = 0.1});
    settings.assumedFriction = 0.0;
    const auto free = commandsOf(*makeController(cart, settings), sensorsOf(loads), {.speed = 0.1});
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_DOUBLE_EQ(capped[i].torqueCap, std::min(3.0, 0.5 * loads[i] * radius));
        EXPECT_EQ(free[i].torqueCap, 3.0);
        EXPECT_EQ(capped[i].torque, free[i].torque);
    }
}

// A lifted wheel (less than 3 % of the mean load) follows the commanded speed gently; one with a
// little more load takes its share. With no load at all every wheel counts as lifted.
TEST_F(EqualTorqueTest, LiftedWheelFollowsTheSpeedGently) {
    const auto controller = makeController(cart, settings);
    // Means of (loads of 20, 20, 20 and x): 3 % of it is 0.453 N at x = 0.457.
    const auto wheels =
        commandsOf(*controller, sensorsOf({20.0, 0.44, 20.0, 20.0}), {.speed = 0.1});
    EXPECT_EQ(wheels[1].mode, WheelMode::Speed);
    EXPECT_DOUBLE_EQ(wheels[1].speed, 0.1 / radius);
    EXPECT_DOUBLE_EQ(wheels[1].proportional, 0.1 * 3.0);
    EXPECT_EQ(wheels[1].integral, 0.0);
    EXPECT_EQ(wheels[0].mode, WheelMode::Torque);
    EXPECT_EQ(commandsOf(*controller, sensorsOf({20.0, 0.47, 20.0, 20.0}), {.speed = 0.1})[1].mode,
              WheelMode::Torque);
    for (const WheelCommand& wheel :
         commandsOf(*controller, sensorsOf({0.0, 0.0, 0.0, 0.0}), {.speed = -0.1})) {
        EXPECT_EQ(wheel.mode, WheelMode::Speed);
        EXPECT_DOUBLE_EQ(wheel.speed, -0.1 / radius);
    }
}

// A torque-driven wheel may run 1.5 times as fast as the command, in either direction.
TEST_F(EqualTorqueTest, RateCapIsOneAndAHalfTimesTheCommand) {
    const auto controller = makeController(cart, settings);
    const Sensors sensors = sensorsOf({20.0, 20.0, 20.0, 20.0});
    EXPECT_DOUBLE_EQ(commandsOf(*controller, sensors, {.speed = 0.1})[0].speed, 0.15 / radius);
    EXPECT_DOUBLE_EQ(commandsOf(*controller, sensors, {.speed = -0.1})[0].speed, 0.15 / radius);
    EXPECT_GT(commandsOf(*controller, sensors, {.speed = 0.0})[0].speed, 0.0);
}

// With a free wheel among three on the ground, drive and cap together keep it below the cap.
TEST_F(EqualTorqueTest, WheelWithoutGripDoesNotRace) {
    const auto controller = makeController(cart, settings);
    Sensors sensors = sensorsOf({20.0, 5.0, 20.0, 20.0});  // loaded, but on ice
    WheelDrive drive(cart.wheels[1], 0.0015);
    std::vector<WheelCommand> wheels(4);
    double rate = 0.0;
    double highest = 0.0;
    for (int i = 0; i < 2000; ++i) {
        if (i % 5 == 0) {
            sensors.wheels[1].rate = rate;
            controller->update(sensors, {.speed = 0.1}, wheels);
        }
        rate += 0.002 * drive.torque(wheels[1], rate, 0.002) / 0.0015;
        highest = std::max(highest, rate);
    }
    EXPECT_NEAR(rate, 0.15 / radius, 0.02 * 0.15 / radius);
    EXPECT_LT(highest, 1.3 * 0.15 / radius);
}

namespace {

/// A point mass pushed by the torques of all wheels against a resistance [N].
class PointMass {
  public:
    PointMass(const Mechanism& mechanism, const ControllerSettings& settings)
        : mechanism_(mechanism),
          controller_(makeController(mechanism, settings)),
          period_(settings.period),
          wheels_(mechanism.wheels.size()) {}

    void run(double time, double wanted, double resistance) {
        Sensors sensors = sensorsOf({10.0, 30.0, 15.0, 25.0});
        for (long i = std::lround(time / period_); i > 0; --i) {
            sensors.bodySpeed = speed;
            controller_->update(sensors, {.speed = wanted}, wheels_);
            double push = -resistance;
            for (std::size_t k = 0; k < wheels_.size(); ++k) {
                const double cap = wheels_[k].torqueCap;
                push += std::clamp(wheels_[k].torque, -cap, cap) / mechanism_.wheels[k].radius;
            }
            speed += period_ * push / mechanism_.mass();
        }
    }

    double speed = 0.0;

  private:
    const Mechanism& mechanism_;
    std::unique_ptr<Controller> controller_;
    double period_;
    std::vector<WheelCommand> wheels_;
};

}  // namespace

// The default gains put both poles of a point mass at -6/s: the error of a step is
// v (1 - 6 t) exp(-6 t).
TEST_F(EqualTorqueTest, DefaultGainsPlaceTheirPoles) {
    settings.assumedFriction = 0.0;
    settings.period = 1e-4;
    PointMass mass(cart, settings);
    double time = 0.0;
    for (int i = 0; i < 10; ++i) {
        mass.run(0.1, 0.1, 0.0);
        time += 0.1;
        EXPECT_NEAR(0.1 - mass.speed, 0.1 * (1.0 - 6.0 * time) * std::exp(-6.0 * time), 1e-4);
    }
}

// Against a constant resistance the integral leaves no error, at the usual period, with caps on.
TEST_F(EqualTorqueTest, IntegralLeavesNoErrorAgainstAResistance) {
    for (const double resistance : {5.0, -5.0, 12.0}) {
        PointMass mass(cart, settings);
        mass.run(6.0, 0.1, resistance);
        EXPECT_NEAR(mass.speed, 0.1, 1e-6) << resistance;
    }
}

// A brake forgets the integral: what follows starts afresh.
TEST_F(EqualTorqueTest, BrakeForgetsTheIntegral) {
    const auto controller = makeController(cart, settings);
    const Sensors sensors = sensorsOf({20.0, 20.0, 20.0, 20.0});
    const double fresh = commandsOf(*controller, sensors, {.speed = 0.1})[0].torque;
    for (int i = 0; i < 50; ++i) {
        (void)commandsOf(*controller, sensors, {.speed = 0.1});
    }
    EXPECT_GT(commandsOf(*controller, sensors, {.speed = 0.1})[0].torque, 1.5 * fresh);
    (void)commandsOf(*controller, sensors, {.speed = 0.1, .turn = 0.0, .brake = true});
    EXPECT_DOUBLE_EQ(commandsOf(*controller, sensors, {.speed = 0.1})[0].torque, fresh);
}

// Stuck for a minute, the integral never asks for more than the motors have.
TEST_F(EqualTorqueTest, IntegralDoesNotWindUp) {
    const auto controller = makeController(cart, settings);
    const Sensors sensors = sensorsOf({20.0, 20.0, 20.0, 20.0});
    std::vector<WheelCommand> wheels(4);
    for (int i = 0; i < 6000; ++i) {
        controller->update(sensors, {.speed = 0.1}, wheels);
    }
    const double m = cart.mass();
    EXPECT_NEAR(wheels[0].torque, 3.0 + 12.0 * radius * m / 4.0 * 0.1, 1e-9);
}
