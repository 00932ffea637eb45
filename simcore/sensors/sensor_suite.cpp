#include "simcore/sensors/sensor_suite.h"

#include <limits>

#include "simcore/base/hash.h"

namespace simcore::sensors {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

control::Sensors noReadings(const mechanism::Mechanism& mechanism) {
    control::Sensors none;
    none.bodySpeed = none.imu.roll = none.imu.pitch = kNone;
    none.imu.angularRate.setConstant(kNone);
    none.imu.acceleration.setConstant(kNone);
    none.joints.assign(mechanism.encoderJoints().size(), kNone);
    none.wheels.assign(mechanism.wheels.size(), {kNone, kNone, kNone});
    return none;
}

SensorSuite::SensorSuite(const mechanism::Mechanism& mechanism, const project::SensorValues& errors,
                         int seed)
    : mechanism_(mechanism),
      seed_(seed),
      bodySpeed_(line(errors.bodySpeed, "body speed")),
      roll_(line(errors.orientation, "roll")),
      pitch_(line(errors.orientation, "pitch")) {
    for (const char* axis : {"x", "y", "z"}) {
        angularRate_.push_back(line(errors.angularRate, std::string("angular rate ") + axis));
        acceleration_.push_back(line(errors.acceleration, std::string("acceleration ") + axis));
    }
    for (const int joint : mechanism.encoderJoints()) {
        const std::string& name = mechanism.joints[static_cast<std::size_t>(joint)].name;
        joints_.push_back(line(errors.jointEncoder, "joint encoder " + name));
    }
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        wheels_.push_back({line(errors.wheelRate, "wheel rate " + wheel.name),
                           line(errors.tactileForce, "tactile force " + wheel.name),
                           line(errors.tactileAngle, "tactile angle " + wheel.name)});
    }
}

SensorLine SensorSuite::line(const project::SensorErrorValues& error,
                             const std::string& name) const {
    StateHash hash;
    hash.add(std::string_view(name));
    hash.add(static_cast<std::uint64_t>(static_cast<std::uint32_t>(seed_)));
    return {error, hash.value()};
}

void SensorSuite::reset() {
    lastVelocity_ = Vec3::Zero();
    lastLook_ = 0.0;
    for (SensorLine* one : {&bodySpeed_, &roll_, &pitch_}) {
        one->reset();
    }
    for (std::vector<SensorLine>* lines : {&angularRate_, &acceleration_, &joints_}) {
        for (SensorLine& one : *lines) {
            one.reset();
        }
    }
    for (WheelLines& wheel : wheels_) {
        wheel.rate.reset();
        wheel.normalForce.reset();
        wheel.contactAngle.reset();
    }
}

void SensorSuite::look(const dynamics::Engine& engine, const run::Snapshot& now,
                       control::Sensors& truth) {
    const auto chassis = static_cast<std::size_t>(mechanism_.chassis);
    const Pose& X_WC = engine.poses()[chassis];
    const dynamics::BodyVelocity& velocity = engine.velocities()[chassis];
    const Eigen::Quaterniond R_CW = X_WC.rotation.conjugate();
    truth.bodySpeed = now.speed;
    truth.imu.roll = roll(X_WC);
    truth.imu.pitch = pitch(X_WC);
    truth.imu.angularRate = R_CW * velocity.angular;
    // Mean since the last look, as a unit that sums its samples up reports it.
    const double period = now.time - lastLook_;
    const Vec3 acceleration =
        period > 0.0 ? Vec3((velocity.linear - lastVelocity_) / period) : Vec3(Vec3::Zero());
    lastVelocity_ = velocity.linear;
    lastLook_ = now.time;
    truth.imu.acceleration = R_CW * (acceleration + dynamics::kGravity * Vec3::UnitZ());
    truth.joints.clear();
    for (const run::JointState& joint : now.joints) {
        truth.joints.push_back(joint.angle);
    }
    truth.wheels.clear();
    for (std::size_t i = 0; i < mechanism_.wheels.size(); ++i) {
        truth.wheels.push_back(
            {dynamics::wheelRate(mechanism_.wheels[i], engine.poses(), engine.velocities()),
             now.wheels[i].normalForce, now.wheels[i].contactAngle});
    }
}

void SensorSuite::read(const dynamics::Engine& engine, const run::Snapshot& now,
                       control::Sensors& readings) {
    look(engine, now, readings);
    readings.bodySpeed = bodySpeed_.read(now.time, readings.bodySpeed);
    readings.imu.roll = roll_.read(now.time, readings.imu.roll);
    readings.imu.pitch = pitch_.read(now.time, readings.imu.pitch);
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        readings.imu.angularRate[axis] =
            angularRate_[i].read(now.time, readings.imu.angularRate[axis]);
        readings.imu.acceleration[axis] =
            acceleration_[i].read(now.time, readings.imu.acceleration[axis]);
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        readings.joints[i] = joints_[i].read(now.time, readings.joints[i]);
    }
    for (std::size_t i = 0; i < wheels_.size(); ++i) {
        control::WheelSensors& wheel = readings.wheels[i];
        wheel.rate = wheels_[i].rate.read(now.time, wheel.rate);
        wheel.normalForce = wheels_[i].normalForce.read(now.time, wheel.normalForce);
        wheel.contactAngle = wheels_[i].contactAngle.read(now.time, wheel.contactAngle);
    }
}

}  // namespace simcore::sensors
