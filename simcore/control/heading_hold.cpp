#include "simcore/control/heading_hold.h"

#include <algorithm>
#include <cmath>

namespace simcore::control {
namespace {

// A rover that turns as asked then has both poles at -1/s: slow against the delays of wheels,
// servos and sensors (assumed). One of whose turns only the share s comes about has a damping ratio
// of sqrt(s).
constexpr double kProportional = 2.0;  // [1/s]
constexpr double kIntegral = 1.0;      // [1/s^2]

}  // namespace

double HeadingHold::turn(const Imu& imu, double speed, double asked) {
    // Yaw rate from body rates, for roll about the axis that yaw and pitch have left.
    const double yawRate =
        (imu.angularRate.y() * std::sin(imu.roll) + imu.angularRate.z() * std::cos(imu.roll)) /
        std::cos(imu.pitch);
    heading_ += yawRate * period_;
    if (asked != 0.0) {
        reference_ = heading_;
        return asked;
    }
    const double most = std::abs(speed) / wheelbase_;
    if (most == 0.0) {
        return 0.0;
    }
    const double error = reference_ - heading_;
    // Wheels that have to slip for a turn do not begin before it is large enough. An integral would
    // grow until they do, and swing the rover from side to side.
    if (by_ == TurnedBy::Steering) {
        // Anti-windup: the integral alone never asks for more than may be asked for.
        integral_ = std::clamp(integral_ + kIntegral * error * period_, -most, most);
    }
    return std::clamp(kProportional * error + integral_, -most, most);
}

}  // namespace simcore::control
