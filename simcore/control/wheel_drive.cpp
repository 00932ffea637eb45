#include "simcore/control/wheel_drive.h"

#include <algorithm>
#include <cmath>

namespace simcore::control {
namespace {

// Drive torque fades to zero over this share of the speed limit (assumed torque-speed line).
constexpr double kFade = 0.1;
// A drive's loop answers no faster than this [s] (assumed: twice in a control period of 10 ms).
// Being longer than usual steps, it makes the loop the same at all of them.
constexpr double kLoopTime = 0.005;

}  // namespace

double loopGain(double proportional, double inertia) {
    return proportional / (1.0 + proportional * kLoopTime / inertia);
}

double axleInertia(const mechanism::Mechanism& mechanism, const mechanism::Wheel& wheel) {
    const Mat3& inertia = mechanism.bodies[static_cast<std::size_t>(wheel.body)].inertia;
    return wheel.axis.dot(inertia * wheel.axis) + wheel.rotorInertia;
}

WheelDrive::WheelDrive(const mechanism::Wheel& wheel, double inertia)
    : torqueLimit_(wheel.torqueLimit),
      speedLimit_(wheel.speedLimit),
      inertia_(inertia) {}

double WheelDrive::available(double torque, double rate) const {
    const double limited = std::clamp(torque, -torqueLimit_, torqueLimit_);
    if (limited * rate <= 0.0) {
        return limited;  // braking is possible at any speed
    }
    const double share = (speedLimit_ * (1.0 + kFade) - std::abs(rate)) / (kFade * speedLimit_);
    return limited * std::clamp(share, 0.0, 1.0);
}

double WheelDrive::loopTorque(const WheelCommand& command, double error, double step) {
    // Backward Euler for a free wheel: its error shrinks by h tau / I within h. The integral is
    // what balances the load, so it is not divided.
    const double h = std::max(step, kLoopTime);
    const double divisor = 1.0 + (command.proportional + command.integral * h) * h / inertia_;
    const double cap = std::min(command.torqueCap, torqueLimit_);
    // Anti-windup: the integral stays where the limits leave it of use.
    integral_ = command.integral > 0.0
                    ? std::clamp(integral_ + command.integral * error * step / divisor, -cap, cap)
                    : 0.0;
    return integral_ + command.proportional * error / divisor;
}

double WheelDrive::heldBelowSpeed(const WheelCommand& command, double rate, double step) {
    const double sign = command.torque < 0.0 ? -1.0 : 1.0;
    if (sign != heldSign_) {
        // What held the wheel one way must not push against a torque the other way.
        heldSign_ = sign;
        integral_ = command.torque;
    }
    const double bound = sign * loopTorque(command, sign * command.speed - rate, step);
    if (bound < sign * command.torque) {
        return sign * bound;
    }
    // The loop waits at the torque in force, and takes over from there.
    integral_ = command.torque;
    return command.torque;
}

double WheelDrive::torque(const WheelCommand& command, double rate, double step) {
    if (command.mode == WheelMode::Lock) {
        // The brake holds; the motor starts from there.
        reset();
        commanded_ = 0.0;
        return 0.0;
    }
    const double cap = std::min(command.torqueCap, torqueLimit_);
    if (command.mode == WheelMode::Torque) {
        WheelCommand capped = command;
        capped.torque = std::clamp(command.torque, -cap, cap);
        const double held = heldBelowSpeed(capped, rate, step);
        commanded_ = held == capped.torque ? command.torque : held;
    } else {
        heldSign_ = 0.0;  // a Torque command starts at its torque, not where this loop was
        commanded_ = command.torque + loopTorque(command, command.speed - rate, step);
    }
    return std::clamp(available(commanded_, rate), -cap, cap);
}

}  // namespace simcore::control
