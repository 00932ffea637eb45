#pragma once

#include "simcore/mechanism/mechanism.h"

/// Small mechanisms for tests, built by hand.
namespace testsupport {

using simcore::Mat3;
using simcore::Vec3;
using simcore::mechanism::Body;
using simcore::mechanism::Freedom;
using simcore::mechanism::FreedomKind;
using simcore::mechanism::Gear;
using simcore::mechanism::Joint;
using simcore::mechanism::Mechanism;

inline Body makeBody(const std::string& name, double mass, const Vec3& com,
                     const Vec3& moments = Vec3(0.01, 0.012, 0.015)) {
    Body body;
    body.name = name;
    body.parts = {name};
    body.mass = mass;
    body.com = com;
    body.inertia = moments.asDiagonal();
    return body;
}

inline Joint makePin(const std::string& name, int first, int second, const Vec3& point,
                     const Vec3& axis = Vec3::UnitY()) {
    Joint joint;
    joint.name = name;
    joint.first = first;
    joint.second = second;
    joint.point = point;
    joint.axis = axis.normalized();
    joint.built = {{FreedomKind::Turn, joint.axis}};
    joint.relaxed = joint.built;
    return joint;
}

/// Chassis with two rockers on one axis, coupled by a gear: turn(right) = ratio * turn(left).
inline Mechanism makeDifferential(double ratio) {
    Mechanism mechanism;
    mechanism.name = "differential";
    mechanism.bodies = {makeBody("chassis", 5.0, {0.0, 0.0, 0.3}, {0.1, 0.12, 0.15}),
                        makeBody("rocker_left", 1.0, {0.05, 0.3, 0.25}),
                        makeBody("rocker_right", 1.2, {-0.03, -0.3, 0.27})};
    mechanism.joints = {makePin("left", 0, 1, {0.02, 0.25, 0.3}),
                        makePin("right", 2, 0, {0.02, -0.25, 0.3})};
    Gear gear;
    gear.name = "differential";
    gear.firstJoint = 0;
    gear.secondJoint = 1;
    gear.ratio = ratio;
    mechanism.gears = {gear};
    return mechanism;
}

/// Planar parallelogram on a floating chassis: two pinned links and a bar, closed by four pins.
inline Mechanism makeFourBar() {
    Mechanism mechanism;
    mechanism.name = "four-bar";
    mechanism.bodies = {makeBody("chassis", 4.0, {0.0, 0.0, 0.2}, {0.05, 0.06, 0.07}),
                        makeBody("crank", 0.4, {-0.2, 0.1, 0.3}),
                        makeBody("coupler", 0.5, {0.05, 0.1, 0.42}),
                        makeBody("follower", 0.3, {0.25, 0.1, 0.33})};
    mechanism.joints = {makePin("a", 0, 1, {-0.2, 0.1, 0.2}), makePin("b", 1, 2, {-0.2, 0.1, 0.4}),
                        makePin("c", 2, 3, {0.3, 0.1, 0.45}), makePin("d", 3, 0, {0.2, 0.1, 0.2})};
    return mechanism;
}

}  // namespace testsupport
