#pragma once

#include "simcore/control/sensors.h"

namespace simcore::control {

/// What makes a rover turn.
enum class TurnedBy { Steering, WheelSpeeds };

/// Keeps the heading while no turn is asked: a loop on the heading, which is the sum of the
/// inertial unit's yaw rate; PI by steering, P by wheel speeds. It knows the heading only against
/// that at its start, and drifts with the bias of that sensor.
class HeadingHold {
  public:
    /// @param period  between calls [s]
    /// @param wheelbase  the loop asks for no tighter circle than of this radius [m]
    HeadingHold(double period, double wheelbase, TurnedBy by)
        : period_(period),
          wheelbase_(wheelbase),
          by_(by) {}

    void reset() { heading_ = reference_ = integral_ = 0.0; }

    /// The turn to drive with [rad/s]: `asked`, or what brings the heading back.
    double turn(const Imu& imu, double speed, double asked);

  private:
    double period_;
    double wheelbase_;
    TurnedBy by_;
    double heading_ = 0.0;    ///< [rad]
    double reference_ = 0.0;  ///< [rad]
    double integral_ = 0.0;   ///< [rad/s]
};

}  // namespace simcore::control
