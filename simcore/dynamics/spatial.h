#pragma once

#include <Eigen/Core>

#include "simcore/base/pose.h"

/// Spatial vectors: motions and forces of rigid bodies as six numbers, all in world axes and about
/// one common point O, so that nothing has to be transformed from body to body
/// (R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 2).
namespace simcore::dynamics {

/// A twist: angular velocity, then velocity of the body's point at O. Or a wrench: moment about O,
/// then force. The product of the two is power.
using Vec6 = Eigen::Matrix<double, 6, 1>;

inline Vec6 spatial(const Vec3& angular, const Vec3& linear) {
    Vec6 v;
    v << angular, linear;
    return v;
}

/// Unit turn about an axis through a point (from O).
inline Vec6 turnAt(const Vec3& axis, const Vec3& point) {
    return spatial(axis, point.cross(axis));
}

/// Unit slide along a direction.
inline Vec6 slideAlong(const Vec3& direction) {
    return spatial(Vec3::Zero(), direction);
}

/// Force that acts at a point (from O).
inline Vec6 forceAt(const Vec3& force, const Vec3& point) {
    return spatial(point.cross(force), force);
}

/// How a motion carried along with `velocity` changes.
inline Vec6 crossMotion(const Vec6& velocity, const Vec6& motion) {
    const Vec3 w = velocity.head<3>();
    return spatial(w.cross(motion.head<3>()),
                   w.cross(motion.tail<3>()) + velocity.tail<3>().cross(motion.head<3>()));
}

/// How a force carried along with `velocity` changes.
inline Vec6 crossForce(const Vec6& velocity, const Vec6& force) {
    const Vec3 w = velocity.head<3>();
    return spatial(w.cross(force.head<3>()) + velocity.tail<3>().cross(force.tail<3>()),
                   w.cross(force.tail<3>()));
}

/// Inertia of a body, or of several that move as one, about O.
struct SpatialInertia {
    double mass = 0.0;            ///< [kg]
    Vec3 moment = Vec3::Zero();   ///< mass times centre of mass from O [kg m]
    Mat3 inertia = Mat3::Zero();  ///< about O [kg m^2]

    /// @param center   centre of mass from O [m]
    /// @param central  inertia about it, world axes [kg m^2]
    static SpatialInertia of(double mass, const Vec3& center, const Mat3& central) {
        const double square = center.squaredNorm();
        return {mass, mass * center,
                central + mass * (square * Mat3::Identity() - center * center.transpose())};
    }

    SpatialInertia& operator+=(const SpatialInertia& other) {
        mass += other.mass;
        moment += other.moment;
        inertia += other.inertia;
        return *this;
    }

    /// Momentum of a motion; force of an acceleration.
    Vec6 operator*(const Vec6& motion) const {
        const Vec3 w = motion.head<3>();
        const Vec3 v = motion.tail<3>();
        return spatial(inertia * w + moment.cross(v), mass * v - moment.cross(w));
    }
};

}  // namespace simcore::dynamics
