#include "simcore/control/wheel_drive.h"

#include <algorithm>
#include <cmath>

namespace simcore::control {
namespace {

// Drive torque fades to zero over this share of the speed limit (assumed torque-speed line).
constexpr double kFade = 0.1;

}  // namespace

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

double WheelDrive::torque(const WheelCommand& command, double rate, double step) {
    const double cap = std::min(command.torqueCap, torqueLimit_);
    const double error = command.speed - rate;
    const bool loop = command.proportional > 0.0 || command.integral > 0.0;
    if (!loop) {
        integral_ = 0.0;
    } else if (command.integral > 0.0) {
        integral_ += command.integral * error * step;
    }
    // Backward Euler for a free wheel: tau = K (error - step tau / I) + integral, solved for tau.
    const double gain = command.proportional + command.integral * step;
    const double feedback =
        (command.proportional * error + integral_) / (1.0 + gain * step / inertia_);
    commanded_ = command.torque + (loop ? feedback : 0.0);
    const double torque = std::clamp(available(commanded_, rate), -cap, cap);
    // Anti-windup: the integral stays where the limits leave it of use.
    integral_ = std::clamp(integral_, -cap, cap);
    return torque;
}

}  // namespace simcore::control
