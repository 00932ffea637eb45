// The drive of one wheel: limits of its motor, and its loop on a free wheel against closed forms.
#include "simcore/control/wheel_drive.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace simcore;
using namespace simcore::control;

namespace {

constexpr double kLimit = 2.0;       // [N m]
constexpr double kFastest = 4.0;     // [rad/s]
constexpr double kInertia = 0.0015;  // of a small wheel [kg m^2]

WheelDrive makeDrive(double inertia = kInertia) {
    mechanism::Wheel wheel;
    wheel.torqueLimit = kLimit;
    wheel.speedLimit = kFastest;
    return {wheel, inertia};
}

WheelCommand speedCommand(double speed, double proportional = kLoopProportional * kLimit,
                          double integral = kLoopIntegral * kLimit) {
    WheelCommand command;
    command.mode = WheelMode::Speed;
    command.speed = speed;
    command.proportional = proportional;
    command.integral = integral;
    command.torqueCap = kLimit;
    return command;
}

/// As equal-torque asks for it; `fastest` is far unless a test is about it.
WheelCommand torqueCommand(double torque, double fastest = 1e3) {
    WheelCommand command = speedCommand(fastest);
    command.mode = WheelMode::Torque;
    command.torque = torque;
    return command;
}

/// A free wheel under its drive: I d(rate)/dt = torque + load.
class FreeWheel {
  public:
    explicit FreeWheel(double step, double inertia = kInertia)
        : drive(makeDrive(inertia)),
          step_(step),
          inertia_(inertia) {}

    double advance(const WheelCommand& command, double load = 0.0) {
        const double torque = drive.torque(command, rate, step_);
        rate += step_ * (torque + load) / inertia_;
        return torque;
    }

    WheelDrive drive;
    double rate = 0.0;

  private:
    double step_;
    double inertia_;
};

}  // namespace

// No command gets more than the motor's torque or the command's cap, whichever is less.
TEST(WheelDriveTest, TorqueStaysBelowLimitAndCap) {
    for (const double sign : {1.0, -1.0}) {
        WheelDrive drive = makeDrive();
        EXPECT_EQ(drive.torque(torqueCommand(sign * 100.0), 0.0, 0.002), sign * kLimit);
        EXPECT_EQ(drive.commanded(), sign * 100.0);
        EXPECT_EQ(drive.torque(torqueCommand(sign * 0.5), 0.0, 0.002), sign * 0.5);
        WheelCommand capped = torqueCommand(sign * 1.5);
        capped.torqueCap = 0.7;
        EXPECT_EQ(drive.torque(capped, 0.0, 0.002), sign * 0.7);
        drive.reset();
        WheelCommand loop = speedCommand(sign * 1e4);
        EXPECT_EQ(drive.torque(loop, 0.0, 0.002), sign * kLimit);
        loop.torqueCap = 0.7;
        EXPECT_EQ(drive.torque(loop, 0.0, 0.002), sign * 0.7);
        loop.torqueCap = 1e3;
        EXPECT_EQ(drive.torque(loop, 0.0, 0.002), sign * kLimit);
    }
}

// Driving torque falls linearly from full at the speed limit to none 10 % above it; braking is
// possible at any speed.
TEST(WheelDriveTest, DrivingTorqueFadesAboveTheSpeedLimit) {
    WheelDrive drive = makeDrive();
    for (const double sign : {1.0, -1.0}) {
        const auto torqueAt = [&](double share) {
            return sign * drive.torque(torqueCommand(sign * 1.0), sign * share * kFastest, 0.002);
        };
        EXPECT_DOUBLE_EQ(torqueAt(0.5), 1.0);
        EXPECT_DOUBLE_EQ(torqueAt(1.0), 1.0);
        EXPECT_NEAR(torqueAt(1.025), 0.75, 1e-12);
        EXPECT_NEAR(torqueAt(1.05), 0.5, 1e-12);
        EXPECT_NEAR(torqueAt(1.1), 0.0, 1e-12);
        EXPECT_EQ(torqueAt(2.0), 0.0);
        EXPECT_EQ(torqueAt(-2.0), 1.0);
    }
}

// Without an integral and at long steps the loop is backward Euler: a free wheel's error shrinks by
// 1 / (1 + K h / I) in every step.
TEST(WheelDriveTest, ProportionalLoopIsBackwardEulerAtLongSteps) {
    for (const double step : {0.005, 0.01, 0.02}) {
        FreeWheel wheel(step);
        const double gain = 0.3;
        double error = 1.5;
        for (int i = 0; i < 20; ++i) {
            wheel.advance(speedCommand(1.5, gain, 0.0));
            error /= 1.0 + gain * step / kInertia;
            EXPECT_NEAR(1.5 - wheel.rate, error, 1e-12);
        }
    }
}

// At all usual steps the same error gives the same torque: the step must not change how stiffly a
// wheel is driven.
TEST(WheelDriveTest, UsualStepsDriveAWheelEquallyStiffly) {
    for (const double error : {0.01, -0.4, 1.0}) {
        const double torque = makeDrive().torque(speedCommand(error, 0.3, 0.0), 0.0, 0.005);
        EXPECT_GT(torque * error, 0.0);
        for (const double step : {0.00025, 0.0005, 0.001, 0.002}) {
            EXPECT_EQ(makeDrive().torque(speedCommand(error, 0.3, 0.0), 0.0, step), torque);
        }
    }
}

// What drove a wheel in another mode is no start for the loop that holds a torque-driven wheel
// below its highest rate: the torque asked for is there at once.
TEST(WheelDriveTest, ATorqueCommandTakesOverWithoutAJump) {
    for (const double sign : {1.0, -1.0}) {
        WheelDrive drive = makeDrive();
        drive.torque(torqueCommand(sign * 1.0, 2.0), 0.0, 0.002);
        drive.torque(speedCommand(sign * 1.8, 0.1, 0.0), sign * 1.8, 0.002);
        EXPECT_EQ(drive.torque(torqueCommand(sign * 1.0, 2.0), sign * 1.9, 0.002), sign * 1.0);
        EXPECT_LT(sign * drive.torque(torqueCommand(sign * 1.0, 2.0), sign * 2.1, 0.002), 1.0);
    }
}

// With a short step the PI loop's error follows I e'' + K e' + Ki e = 0 from e = w, e' = -K w / I,
// with the gains K and Ki of a loop that answers in 5 ms: divided by 1 + (K + Ki h) h / I.
TEST(WheelDriveTest, ShortStepsFollowTheDifferentialEquation) {
    const double step = 1e-5;
    const double givenK = 0.02;
    const double givenKi = 0.04;
    const double divisor = 1.0 + (givenK + givenKi * 0.005) * 0.005 / kInertia;
    const double K = givenK / divisor;
    const double Ki = givenKi / divisor;
    FreeWheel wheel(step);
    const double half = 0.5 * K / kInertia;
    const double root = std::sqrt(half * half - Ki / kInertia);
    const double fast = -half - root;
    const double slow = -half + root;
    const double target = 1.0;
    const double start = -K * target / kInertia;
    const double a = (start - slow * target) / (fast - slow);
    const double b = target - a;
    for (int i = 1; i <= 50000; ++i) {
        wheel.advance(speedCommand(target, givenK, givenKi));
        if (i % 5000 == 0) {
            const double t = i * step;
            const double expected = a * std::exp(fast * t) + b * std::exp(slow * t);
            EXPECT_NEAR(target - wheel.rate, expected, 2e-3 * target) << "t " << t;
        }
    }
}

// The default loop on a wheel that hangs free does not oscillate at any step the engine may take:
// its error changes sign once at most (a PI loop's overshoot), and it settles.
TEST(WheelDriveTest, FreeWheelDoesNotOscillate) {
    for (const double inertia : {0.0004, 0.0015, 0.01}) {
        for (const double step : {0.0005, 0.001, 0.002, 0.005, 0.02}) {
            FreeWheel wheel(step, inertia);
            const double target = 1.5;
            const WheelCommand command = speedCommand(target);
            int signChanges = 0;
            int turns = 0;
            double lastError = target;
            double lastTorque = 1.0;
            double highest = 0.0;
            for (int i = 0; i < std::lround(2.0 / step); ++i) {
                const double torque = wheel.advance(command);
                const double error = target - wheel.rate;
                const bool settled = std::abs(error) < 1e-6 * target;
                signChanges += !settled && error * lastError < 0.0 ? 1 : 0;
                turns += !settled && torque * lastTorque < 0.0 ? 1 : 0;
                lastError = error;
                lastTorque = torque;
                highest = std::max(highest, wheel.rate);
            }
            EXPECT_LE(signChanges, 1) << "step " << step << " inertia " << inertia;
            EXPECT_LE(turns, 2) << "step " << step << " inertia " << inertia;
            EXPECT_LT(highest, 1.3 * target) << "step " << step << " inertia " << inertia;
            EXPECT_NEAR(wheel.rate, target, 0.01 * target)
                << "step " << step << " inertia " << inertia;
        }
    }
}

// The integral balances a constant load without an error left.
TEST(WheelDriveTest, IntegralBalancesALoad) {
    for (const double step : {0.0005, 0.002, 0.005}) {
        FreeWheel wheel(step);
        double torque = 0.0;
        for (int i = 0; i < std::lround(5.0 / step); ++i) {
            torque = wheel.advance(speedCommand(1.0), -0.8);
        }
        EXPECT_NEAR(wheel.rate, 1.0, 1e-6) << "step " << step;
        EXPECT_NEAR(torque, 0.8, 1e-6) << "step " << step;
    }
}

// Anti-windup: a wheel that was blocked for long against its set-point lets go as soon as one that
// was blocked until the integral was full, cap / Ki e; unlimited it would take as long as the
// block.
TEST(WheelDriveTest, BlockedWheelDoesNotWindUp) {
    const double step = 0.002;
    const auto stepsToLetGo = [&](double blocked) {
        WheelDrive drive = makeDrive();
        for (int i = 0; i < std::lround(blocked / step); ++i) {
            (void)drive.torque(speedCommand(1.0), 0.0, step);
        }
        EXPECT_EQ(drive.torque(speedCommand(1.0), 0.0, step), kLimit);
        int steps = 0;
        while (drive.torque(speedCommand(-1.0), 0.0, step) > 0.0 && steps < 10000) {
            ++steps;
        }
        return steps;
    };
    const int soon = stepsToLetGo(5.0);
    EXPECT_EQ(stepsToLetGo(60.0), soon);
    EXPECT_LT(soon * step, 1.0);
}

// Reset forgets the integral.
TEST(WheelDriveTest, ResetForgetsTheIntegral) {
    WheelDrive drive = makeDrive();
    const double fresh = drive.torque(speedCommand(0.1), 0.0, 0.002);
    for (int i = 0; i < 100; ++i) {
        (void)drive.torque(speedCommand(0.1), 0.0, 0.002);
    }
    EXPECT_GT(drive.torque(speedCommand(0.1), 0.0, 0.002), fresh);
    drive.reset();
    EXPECT_EQ(drive.torque(speedCommand(0.1), 0.0, 0.002), fresh);
}

// A torque that would spin a free wheel up without bound is taken back at the highest rate, which
// the wheel then keeps, in either direction and at any step.
TEST(WheelDriveTest, TorqueModeHoldsTheHighestRate) {
    for (const double step : {0.0005, 0.001, 0.002, 0.005}) {
        for (const double sign : {1.0, -1.0}) {
            FreeWheel wheel(step);
            double highest = 0.0;
            for (int i = 0; i < std::lround(3.0 / step); ++i) {
                wheel.advance(torqueCommand(sign * 0.05, 2.0));
                highest = std::max(highest, sign * wheel.rate);
            }
            EXPECT_LT(highest, 1.3 * 2.0) << "step " << step;
            EXPECT_NEAR(sign * wheel.rate, 2.0, 0.02) << "step " << step;
        }
    }
}

// Below the highest rate, and when it brakes at any rate, the wheel gets exactly the torque.
TEST(WheelDriveTest, TorqueModeGivesTheTorqueAsked) {
    WheelDrive drive = makeDrive();
    for (const double rate : {0.0, 1.0, 1.9, -3.0}) {
        EXPECT_EQ(drive.torque(torqueCommand(0.4, 2.0), rate, 0.002), 0.4) << rate;
    }
    for (const double rate : {0.5, 2.5, 3.5}) {
        EXPECT_EQ(drive.torque(torqueCommand(-0.4, 2.0), rate, 0.002), -0.4) << rate;
    }
}

// Asked to brake right after its rate was held against a load, it brakes.
TEST(WheelDriveTest, TorqueModeBrakesAfterItsRateWasHeld) {
    const double step = 0.002;
    FreeWheel wheel(step);
    double torque = 0.0;
    for (int i = 0; i < 2000; ++i) {
        torque = wheel.advance(torqueCommand(1.8, 0.3), -1.5);
    }
    ASSERT_NEAR(wheel.rate, 0.3, 0.01);
    ASSERT_NEAR(torque, 1.5, 0.01);
    EXPECT_EQ(wheel.advance(torqueCommand(-0.1, 0.3), -1.5), -0.1);
}
