#pragma once

#include <Eigen/Geometry>

#include "simcore/mechanism/mechanism.h"
#include "simcore/run/snapshot.h"

/// Instants of a run made by hand, without an engine.
namespace testsupport {

/// Turn about an axis through a point.
inline simcore::Pose turnAbout(const simcore::Vec3& point, const simcore::Vec3& axis,
                               double angle) {
    simcore::Pose pose;
    pose.rotation = Eigen::AngleAxisd(angle, axis.normalized());
    pose.position = point - pose.rotation * point;
    return pose;
}

/// The rover as drawn, carried to X_WR as a whole, its wheels turned by `wheelTurn` [rad]. Every
/// wheel touches below its centre and carries the same share of the weight.
inline simcore::run::Snapshot standing(const simcore::mechanism::Mechanism& mechanism,
                                       const simcore::Pose& X_WR = {}, double wheelTurn = 0.0,
                                       double time = 0.0) {
    simcore::run::Snapshot snapshot;
    snapshot.time = time;
    snapshot.bodies.assign(mechanism.bodies.size(), X_WR);
    for (const auto& wheel : mechanism.wheels) {
        snapshot.bodies.at(static_cast<std::size_t>(wheel.body)) =
            X_WR * turnAbout(wheel.center, wheel.axis, wheelTurn);
        auto& state = snapshot.wheels.emplace_back();
        state.touching = true;
        state.contactPoint = X_WR * (wheel.center - wheel.radius * simcore::Vec3::UnitZ());
        const double load = mechanism.mass() * 9.81 / static_cast<double>(mechanism.wheels.size());
        state.force = load * simcore::Vec3::UnitZ();
        state.normalForce = load;
    }
    snapshot.centerOfMass = mechanism.centerOfMass(snapshot.bodies);
    return snapshot;
}

/// The rover as drawn, `x` [m] further on, its wheels turned as rolling would.
inline simcore::run::Snapshot rolled(const simcore::mechanism::Mechanism& mechanism, double x,
                                     double time) {
    simcore::Pose pose;
    pose.position = simcore::Vec3(x, 0.0, 0.0);
    const double radius = mechanism.wheels.empty() ? 1.0 : mechanism.wheels.front().radius;
    return standing(mechanism, pose, x / radius, time);
}

}  // namespace testsupport
