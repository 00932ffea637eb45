#pragma once

#include "tests/support/engine_cases.h"

/// Momenta and energy of a whole mechanism, to the last digit.
namespace testsupport {

/// Motion at one instant. Velocities of an engine are those with which it left the poses before its
/// last step, so both are of that instant.
struct Motion {
    Vec3 momentum = Vec3::Zero(), angularMomentum = Vec3::Zero();  ///< the latter about the origin
    double energy = 0.0;
};

/// Steps, and says with which motion.
inline Motion stepped(World& world) {
    const std::vector<simcore::Pose> poses = world.engine().poses();
    world.step();
    Motion motion;
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const Body& body = world.mechanism().bodies[i];
        const BodyVelocity& v = world.engine().velocities()[i];
        const Mat3 R = poses[i].rotation.toRotationMatrix();
        const Vec3 spin = R * world.mechanism().inertiaWithRotor(i) * R.transpose() * v.angular;
        motion.momentum += body.mass * v.linear;
        motion.angularMomentum += (poses[i] * body.com).cross(body.mass * v.linear) + spin;
        motion.energy += 0.5 * body.mass * v.linear.squaredNorm() + 0.5 * v.angular.dot(spin);
    }
    return motion;
}

}  // namespace testsupport
