#pragma once

#include <vector>

#include "simcore/base/pose.h"
#include "simcore/mechanism/mechanism.h"

namespace simcore::mobility {

/// Where a wheel stands: the ground there is the plane through `point` at right angles to `normal`.
struct WheelStand {
    bool touching = true;  ///< false: the wheel hangs, its contact holds nothing
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();  ///< unit, from the ground to the wheel
};

/// A pose of the mechanism and the ground under its wheels, in the world [m].
struct Stance {
    std::vector<Pose> bodies;        ///< X_WB, in the order of the mechanism's bodies
    std::vector<WheelStand> wheels;  ///< in the order of the mechanism's wheels
};

/// The drawn pose on level ground: every wheel touches at its lowest point.
Stance drawnStance(const mechanism::Mechanism& mechanism);

/// The point of a wheel's rim that is furthest against `normal` when its body is at `X_WB`.
Vec3 rimPoint(const mechanism::Wheel& wheel, const Pose& X_WB, const Vec3& normal);

/// Rolling direction (axle x normal) of a wheel whose body is at `X_WB`.
Vec3 rollingDirection(const mechanism::Wheel& wheel, const Pose& X_WB, const Vec3& normal);

/// A wheel that touches at its rim under the contact angle: in the wheel's plane, from up to the
/// normal, positive when the obstacle is ahead [rad].
WheelStand standAtAngle(const mechanism::Wheel& wheel, const Pose& X_WB, double angle);

/// That angle of a contact normal [rad].
/// @param axis  unit axle, to the rover's left, world
double contactAngle(const Vec3& normal, const Vec3& axis);

/// The length that makes translations and turns comparable [m]: the wheelbase or, without wheels in
/// a row, the diagonal of the box around all joint points; 1 m when that has no size either.
double characteristicLength(const mechanism::Mechanism& mechanism);

}  // namespace simcore::mobility
