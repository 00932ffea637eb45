#pragma once

#include <vector>

#include "simcore/base/pose.h"
#include "simcore/control/controller.h"
#include "simcore/control/sensors.h"

namespace simcore::run {

/// One wheel at one instant. Forces are those of the ground on the wheel, of the step just made.
struct WheelState {
    bool touching = false;
    Vec3 contactPoint = Vec3::Zero();  ///< force-weighted mean [m], world
    Vec3 force = Vec3::Zero();         ///< ground on wheel [N], world
    double normalForce = 0.0;          ///< [N]
    double tractionForce = 0.0;        ///< along the rolling direction, + forward [N]
    double lateralForce = 0.0;         ///< along the axle, + left [N]
    /// In the wheel plane from world up to the contact normal, + when the obstacle is ahead [rad];
    /// held while the wheel is in the air.
    double contactAngle = 0.0;
    double rate = 0.0;             ///< absolute rotation rate, + forward [rad/s]
    double centerSpeed = 0.0;      ///< wheel centre along the contact tangent [m/s]
    double slipRatio = 0.0;        ///< (wR - v)/max(|wR|, |v|, 0.01 m/s) [-]
    double slipAbs = 0.0;          ///< cumulated |slip| since the start of counting [m]
    double slipLoaded = 0.0;       ///< the same of steps in which the wheel carries load [m]
    double slipSigned = 0.0;       ///< cumulated paper eq. 6 [m]
    double slipLateral = 0.0;      ///< cumulated |motion| of the centre along the axle [m]
    double frictionWork = 0.0;     ///< cumulated, lost where the wheel slides [J]
    double torqueCommanded = 0.0;  ///< [N m], + drives forward
    double torqueApplied = 0.0;    ///< after limits [N m]
    double power = 0.0;            ///< applied torque times rate against the carrier [W]
    double penetration = 0.0;      ///< of the deepest contact [m]
};

/// Turn of a joint about its axis: second body against first, 0 at the drawn pose.
struct JointState {
    double angle = 0.0;  ///< [rad]
    double rate = 0.0;   ///< [rad/s]
};

/// Everything a view needs about one instant of a run. Immutable once published.
struct Snapshot {
    double time = 0.0;  ///< simulated [s]
    long step = 0;
    std::vector<Pose> bodies;          ///< X_WB, mechanism order
    std::vector<WheelState> wheels;    ///< mechanism order
    Vec3 centerOfMass = Vec3::Zero();  ///< world [m]
    double distance = 0.0;             ///< chassis origin along x since the start [m]
    double speed = 0.0;                ///< chassis origin along the chassis' forward axis [m/s]
    Vec3 angularRate = Vec3::Zero();   ///< of the chassis, in its own axes [rad/s]
    std::vector<JointState> joints;    ///< Mechanism::encoderJoints()
    /// What the controller read at its last look; NaN before the first.
    control::Sensors measured;
    /// What the controller made of it; empty before the first look.
    control::Intent intent;
};

}  // namespace simcore::run
