#pragma once

#include "simcore/control/controller.h"

namespace simcore::control {

/// What a P loop of a drive gives per rad/s, at usual steps [N m s/rad]: less than it is set to
/// where the free wheel would answer within the loop's own time.
/// @param inertia  of wheel and rotor about the axle [kg m^2]
double loopGain(double proportional, double inertia);

/// Of a wheel and its motor's rotor about the axle [kg m^2].
double axleInertia(const mechanism::Mechanism& mechanism, const mechanism::Wheel& wheel);

/// Motor and gearbox of one wheel: follows a WheelCommand within torque and speed limits, at the
/// engine's step.
///
/// Its PI loop is semi-implicit: it anticipates how the free wheel's own inertia answers within the
/// loop's own time, or within a longer step. So a lifted wheel does not oscillate at any step, and
/// a wheel is driven equally stiffly at all usual ones.
class WheelDrive {
  public:
    /// @param inertia  of the wheel and the reflected rotor about the axle [kg m^2]
    WheelDrive(const mechanism::Wheel& wheel, double inertia);

    void reset() {
        integral_ = 0.0;
        heldSign_ = 1.0;
    }

    /// Torque for the next step [N m]. `rate`: wheel against carrier [rad/s].
    double torque(const WheelCommand& command, double rate, double step);

    /// What was asked for before limits, by the last call [N m].
    double commanded() const { return commanded_; }

  private:
    double loopTorque(const WheelCommand& command, double error, double step);
    double heldBelowSpeed(const WheelCommand& command, double rate, double step);
    double available(double torque, double rate) const;

    double torqueLimit_;
    double speedLimit_;
    double inertia_;
    double integral_ = 0.0;  ///< of the loop [N m]
    double heldSign_ = 1.0;  ///< of the torque in the last Torque command; 0: none
    double commanded_ = 0.0;
};

}  // namespace simcore::control
