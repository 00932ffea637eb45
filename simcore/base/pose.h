#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace simcore {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Rigid placement of a frame B in a frame A: p_A = rotation * p_B + position [m].
struct Pose {
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Vec3 position = Vec3::Zero();

    Vec3 operator*(const Vec3& p_B) const { return rotation * p_B + position; }

    Pose operator*(const Pose& X_BC) const {
        return {rotation * X_BC.rotation, rotation * X_BC.position + position};
    }

    Pose inverse() const {
        const Eigen::Quaterniond inverseRotation = rotation.conjugate();
        return {inverseRotation, -(inverseRotation * position)};
    }
};

/// The part of a rotation that turns about a unit axis [rad], (-pi, pi].
inline double turnAbout(const Eigen::Quaterniond& rotation, const Vec3& axis) {
    const double half = std::atan2(axis.dot(rotation.vec()), rotation.w());
    return std::remainder(2.0 * half, 2.0 * std::numbers::pi);
}

// Roll, pitch and yaw [rad] of R = Rz(yaw) Ry(pitch) Rx(roll): positive with the right side down,
// nose down, and to the left.

inline double roll(const Pose& pose) {
    const Mat3 R = pose.rotation.toRotationMatrix();
    return std::atan2(R(2, 1), R(2, 2));
}

inline double pitch(const Pose& pose) {
    const Mat3 R = pose.rotation.toRotationMatrix();
    return std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
}

inline double yaw(const Pose& pose) {
    const Mat3 R = pose.rotation.toRotationMatrix();
    return std::atan2(R(1, 0), R(0, 0));
}

}  // namespace simcore
