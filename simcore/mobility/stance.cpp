#include "simcore/mobility/stance.h"

#include <cmath>

namespace simcore::mobility {

Vec3 rollingDirection(const mechanism::Wheel& wheel, const Pose& X_WB, const Vec3& normal) {
    return (X_WB.rotation * wheel.axis).cross(normal).normalized();
}

Vec3 rimPoint(const mechanism::Wheel& wheel, const Pose& X_WB, const Vec3& normal) {
    const Vec3 axis = X_WB.rotation * wheel.axis;
    const Vec3 forward = rollingDirection(wheel, X_WB, normal);
    return X_WB * wheel.center - wheel.radius * forward.cross(axis);
}

WheelStand standAtAngle(const mechanism::Wheel& wheel, const Pose& X_WB, double angle) {
    const Vec3 axis = X_WB.rotation * wheel.axis;
    const Vec3 forward = rollingDirection(wheel, X_WB, Vec3::UnitZ());
    // Ground that rises ahead has a normal that leans back.
    const Vec3 normal = std::cos(angle) * forward.cross(axis) - std::sin(angle) * forward;
    return {true, X_WB * wheel.center - wheel.radius * normal, normal};
}

Stance drawnStance(const mechanism::Mechanism& mechanism) {
    Stance stance;
    stance.bodies.resize(mechanism.bodies.size());
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        stance.wheels.push_back({true, rimPoint(wheel, Pose{}, Vec3::UnitZ()), Vec3::UnitZ()});
    }
    return stance;
}

double characteristicLength(const mechanism::Mechanism& mechanism) {
    if (mechanism.wheels.size() >= 2 || mechanism.joints.empty()) {
        return mechanism.wheelbase();
    }
    Vec3 low = mechanism.joints.front().point;
    Vec3 high = low;
    for (const mechanism::Joint& joint : mechanism.joints) {
        low = low.cwiseMin(joint.point);
        high = high.cwiseMax(joint.point);
    }
    const double extent = (high - low).norm();
    return extent > 1e-6 ? extent : 1.0;
}

double contactAngle(const Vec3& normal, const Vec3& axis) {
    const Vec3 forward = axis.cross(Vec3::UnitZ()).normalized();
    const Vec3 up = forward.cross(axis);
    return std::atan2(-normal.dot(forward), normal.dot(up));
}

}  // namespace simcore::mobility
