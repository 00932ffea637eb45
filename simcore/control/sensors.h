#pragma once

#include <vector>

#include "simcore/base/pose.h"

/// What a controller may know: the readings of the rover's sensors (docs/sensors.md).
namespace simcore::control {

struct WheelSensors {
    double rate = 0.0;          ///< encoder: wheel against its carrier [rad/s], + forward
    double normalForce = 0.0;   ///< tactile [N]
    double contactAngle = 0.0;  ///< tactile [rad]
};

/// Inertial unit at the chassis' centre of mass, in the chassis' axes.
struct Imu {
    double roll = 0.0;                 ///< [rad], right side down
    double pitch = 0.0;                ///< [rad], nose down
    Vec3 angularRate = Vec3::Zero();   ///< [rad/s]
    Vec3 acceleration = Vec3::Zero();  ///< less gravity, as it is felt: (0, 0, +g) at rest [m/s^2]
};

struct Sensors {
    double bodySpeed = 0.0;  ///< chassis origin along the chassis' forward axis [m/s]
    Imu imu;
    std::vector<double> joints;  ///< encoders: turn of Mechanism::encoderJoints() [rad]
    std::vector<WheelSensors> wheels;
};

}  // namespace simcore::control
