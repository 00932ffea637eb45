#include "simcore/control/rover_estimate.h"

#include <algorithm>
#include <cmath>

namespace simcore::control {
namespace {

// Time constant of what tactile wheels measure [s] (assumed: three control periods).
constexpr double kSmoothing = 0.03;
// A wheel with less than this share of the mean load hangs (assumed).
constexpr double kLifted = 0.03;

}  // namespace

RoverEstimate::RoverEstimate(const mechanism::Mechanism& mechanism, double period)
    : model_(mechanism, mechanism::Model::Built),
      drawn_(model_.reset()),
      smoothing_(period / (kSmoothing + period)) {
    const std::vector<int> encoders = mechanism.encoderJoints();
    for (const dynamics::TreeBody& at : model_.tree().bodies()) {
        if (at.joint < 0) {
            if (at.body == mechanism.chassis && !at.elements.empty()) {
                chassisBall_ = at.elements.back().ball;
            }
            continue;
        }
        const auto found = std::find(encoders.begin(), encoders.end(), at.joint);
        if (found == encoders.end() || at.elements.size() != 1 ||
            at.elements.front().kind != dynamics::TreeElement::Kind::Turn) {
            continue;
        }
        const mechanism::Joint& joint = mechanism.joints[static_cast<std::size_t>(at.joint)];
        const double way = joint.second == at.body ? 1.0 : -1.0;
        const double sense = at.elements.front().axis.dot(joint.axis) < 0.0 ? -1.0 : 1.0;
        measured_.push_back({static_cast<std::size_t>(found - encoders.begin()),
                             static_cast<std::size_t>(at.elements.front().rate), way * sense});
    }
    reset();
}

void RoverEstimate::reset() {
    const std::size_t wheels = model_.mechanism().wheels.size();
    started_ = false;
    angles_.assign(wheels, 0.0);
    loads_.assign(wheels, 0.0);
    bears_.assign(wheels, false);
    contacts_.clear();
}

void RoverEstimate::update(const Sensors& sensors) {
    dynamics::TreeState state = drawn_;
    for (const Measured& m : measured_) {
        state.coordinates[m.rate] = m.sign * sensors.joints[m.encoder];
    }
    if (chassisBall_ >= 0) {
        state.balls[static_cast<std::size_t>(chassisBall_)] =
            Eigen::AngleAxisd(sensors.imu.pitch, Vec3::UnitY()) *
            Eigen::AngleAxisd(sensors.imu.roll, Vec3::UnitX());
    }
    model_.place(state);
    meanLoad_ = 0.0;
    for (const WheelSensors& wheel : sensors.wheels) {
        meanLoad_ += wheel.normalForce / static_cast<double>(sensors.wheels.size());
    }
    contacts_.clear();
    for (std::size_t i = 0; i < sensors.wheels.size(); ++i) {
        const WheelSensors& wheel = sensors.wheels[i];
        bears_[i] = wheel.normalForce > kLifted * meanLoad_;
        const double share = started_ ? smoothing_ : 1.0;
        loads_[i] += share * (wheel.normalForce - loads_[i]);
        if (bears_[i]) {
            angles_[i] += share * std::remainder(wheel.contactAngle - angles_[i], 2.0 * M_PI);
            contacts_.push_back(statics::contactAtAngle(model_.mechanism(), static_cast<int>(i),
                                                        model_.poses(), angles_[i]));
        }
    }
    started_ = true;
}

}  // namespace simcore::control
