#include "simcore/io/snapshot_columns.h"

#include <cmath>

namespace simcore::io {
namespace {

/// Calls f(name, number) for every number of a snapshot. The one place that lists them: names,
/// writing and reading cannot disagree.
template <class Snapshot, class F>
void forEachNumber(Snapshot& s, F&& f) {
    const auto vector = [&f](const std::string& name, auto& v) {
        f(name + "x", v.x());
        f(name + "y", v.y());
        f(name + "z", v.z());
    };
    f("time", s.time);
    f("step", s.step);
    f("distance", s.distance);
    f("speed", s.speed);
    vector("center_of_mass/", s.centerOfMass);
    vector("angular_rate/", s.angularRate);
    f("measured/speed", s.measured.bodySpeed);
    f("measured/roll", s.measured.imu.roll);
    f("measured/pitch", s.measured.imu.pitch);
    vector("measured/angular_rate/", s.measured.imu.angularRate);
    vector("measured/acceleration/", s.measured.imu.acceleration);
    f("intent/common_torque", s.intent.commonTorque);
    f("intent/required_friction", s.intent.requiredFriction);
    f("intent/friction_cap", s.intent.frictionCap);
    for (std::size_t i = 0; i < s.bodies.size(); ++i) {
        const std::string name = "body/" + std::to_string(i) + "/";
        vector(name, s.bodies[i].position);
        f(name + "qx", s.bodies[i].rotation.x());
        f(name + "qy", s.bodies[i].rotation.y());
        f(name + "qz", s.bodies[i].rotation.z());
        f(name + "qw", s.bodies[i].rotation.w());
    }
    for (std::size_t i = 0; i < s.wheels.size(); ++i) {
        const std::string name = "wheel/" + std::to_string(i) + "/";
        auto& w = s.wheels[i];
        f(name + "touching", w.touching);
        vector(name + "contact_point/", w.contactPoint);
        vector(name + "force/", w.force);
        f(name + "normal_force", w.normalForce);
        f(name + "traction_force", w.tractionForce);
        f(name + "lateral_force", w.lateralForce);
        f(name + "contact_angle", w.contactAngle);
        f(name + "rate", w.rate);
        f(name + "center_speed", w.centerSpeed);
        f(name + "slip_ratio", w.slipRatio);
        f(name + "slip_abs", w.slipAbs);
        f(name + "slip_loaded", w.slipLoaded);
        f(name + "slip_signed", w.slipSigned);
        f(name + "slip_lateral", w.slipLateral);
        f(name + "friction_work", w.frictionWork);
        f(name + "torque_commanded", w.torqueCommanded);
        f(name + "torque_applied", w.torqueApplied);
        f(name + "power", w.power);
        f(name + "penetration", w.penetration);
    }
    for (std::size_t i = 0; i < s.measured.wheels.size(); ++i) {
        const std::string name = "measured/wheel/" + std::to_string(i) + "/";
        f(name + "rate", s.measured.wheels[i].rate);
        f(name + "normal_force", s.measured.wheels[i].normalForce);
        f(name + "contact_angle", s.measured.wheels[i].contactAngle);
    }
    for (std::size_t i = 0; i < s.intent.wheels.size(); ++i) {
        const std::string name = "intent/wheel/" + std::to_string(i) + "/";
        f(name + "torque", s.intent.wheels[i].torque);
        f(name + "normal_force", s.intent.wheels[i].normalForce);
        f(name + "rate", s.intent.wheels[i].rate);
    }
    for (std::size_t i = 0; i < s.joints.size(); ++i) {
        const std::string name = "joint/" + std::to_string(i) + "/";
        f(name + "angle", s.joints[i].angle);
        f(name + "rate", s.joints[i].rate);
    }
    for (std::size_t i = 0; i < s.measured.joints.size(); ++i) {
        f("measured/joint/" + std::to_string(i), s.measured.joints[i]);
    }
}

run::Snapshot sized(const SnapshotSize& size) {
    run::Snapshot snapshot;
    snapshot.bodies.resize(size.bodies);
    snapshot.wheels.resize(size.wheels);
    snapshot.joints.resize(size.joints);
    snapshot.measured.wheels.resize(size.wheels);
    snapshot.intent.wheels.resize(size.wheels);
    snapshot.measured.joints.resize(size.joints);
    return snapshot;
}

void assign(double number, double& value) {
    value = number;
}

void assign(double number, bool& value) {
    value = number != 0.0;
}

void assign(double number, long& value) {
    // Whole numbers beyond 2^53 are no step counts; NaN neither.
    value = std::abs(number) < 9007199254740992.0 ? static_cast<long>(number) : 0;
}

}  // namespace

std::vector<std::string> snapshotColumns(const SnapshotSize& size) {
    std::vector<std::string> names;
    const run::Snapshot snapshot = sized(size);
    forEachNumber(snapshot, [&](const std::string& name, const auto&) { names.push_back(name); });
    return names;
}

std::vector<double> toNumbers(const run::Snapshot& snapshot) {
    std::vector<double> numbers;
    forEachNumber(snapshot, [&](const std::string&, const auto& value) {
        numbers.push_back(static_cast<double>(value));
    });
    return numbers;
}

run::Snapshot snapshotFromNumbers(const SnapshotSize& size, const std::vector<int>& positions,
                                  const std::vector<double>& numbers) {
    run::Snapshot snapshot = sized(size);
    std::size_t next = 0;
    forEachNumber(snapshot, [&](const std::string&, auto& value) {
        const int at = positions.at(next++);
        if (at >= 0) {
            assign(numbers.at(static_cast<std::size_t>(at)), value);
        }
    });
    return snapshot;
}

}  // namespace simcore::io
