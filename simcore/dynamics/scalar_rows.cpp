#include "simcore/dynamics/scalar_rows.h"

#include <cmath>
#include <limits>

namespace simcore::dynamics {
namespace {

// Stops are springs with dampers, as contacts are, on arms of 0.1 m (assumed).
constexpr double kStopStiffness = 1e4;  // [N m/rad]
constexpr double kStopDamping = 15;     // [N m s/rad]
/// Stops further away than this are left out [rad].
constexpr double kStopMargin = 0.2;
/// A motor within its limit holds its rate to 1 urad/s per newton metre (assumed).
constexpr double kMotorDamping = 1e6;  // [N m s/rad]
/// A joint with dry friction turns from this rate on [rad/s] (assumed).
constexpr double kTurning = 1e-3;
/// Two stops, and a motor or dry friction.
constexpr std::size_t kRowsOfAJoint = 3;

}  // namespace

ScalarRows::ScalarRows(const mechanism::Mechanism& mechanism, const SpanningTree& tree)
    : mechanism_(mechanism),
      rows_(kRowsOfAJoint * mechanism.joints.size()) {
    for (const mechanism::Joint& joint : mechanism.joints) {
        joints_.push_back(between(tree, joint.first, joint.second));
    }
    rowJoints_.reserve(rows_.size());
    rowWrenches_.reserve(rows_.size());
    for (ScalarRow& row : rows_) {
        row.indices.reserve(static_cast<std::size_t>(tree.rateCount()));
        row.factors.reserve(static_cast<std::size_t>(tree.rateCount()));
    }
}

std::span<ScalarRow> ScalarRows::make(const TreeMotion& motion, const LoopClosures& loops,
                                      std::span<const double> rates,
                                      std::span<const JointMotor> motors, double step) {
    rowJoints_.clear();
    rowWrenches_.clear();
    motorOf_.assign(joints_.size(), nullptr);
    for (const JointMotor& motor : motors) {
        motorOf_[static_cast<std::size_t>(motor.joint)] = &motor;
    }
    const Place at{motion, loops, rates};
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
        addStops(joint, at, step);
    }
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
        addMotor(joint, at, step);
    }
    return std::span(rows_).first(rowJoints_.size());
}

ScalarRow& ScalarRows::add(std::size_t joint, const Vec6& wrench, const Place& at) {
    ScalarRow& row = rows_[rowJoints_.size()];
    pushOf(joints_[joint], wrench, at.motion, at.loops, row.indices, row.factors);
    row.impulse = 0.0;
    rowJoints_.push_back(joint);
    rowWrenches_.push_back(wrench);
    return row;
}

void ScalarRows::addStops(std::size_t index, const Place& at, double step) {
    const mechanism::Joint& joint = mechanism_.joints[index];
    if (!joint.stops) {
        return;
    }
    const double angle = jointAngle(joint, at.motion.poses());
    for (const double sign : {1.0, -1.0}) {
        const double gap = sign > 0.0 ? angle - joint.stops->first : joint.stops->second - angle;
        const Vec6 wrench = sign * axisOf(joint, at.motion);
        const double rate = rateAlong(joints_[index], wrench, at.motion.screws(), at.rates);
        if (gap > kStopMargin + std::abs(rate) * step) {
            continue;
        }
        ScalarRow& row = add(index, wrench, at);
        row.compliance = 1.0 / (step * (kStopStiffness * step + kStopDamping));
        row.bound = gap < 0.0 ? -gap * kStopStiffness / (kStopStiffness * step + kStopDamping)
                              : -gap / step;
        row.least = 0.0;
        row.most = std::numeric_limits<double>::infinity();
        row.start = gap < 0.0 ? 0 : -1;
    }
}

void ScalarRows::addMotor(std::size_t index, const Place& at, double step) {
    const mechanism::Joint& joint = mechanism_.joints[index];
    const JointMotor turning = withFriction(joint, motorOf_[index]);
    if (motorOf_[index] == nullptr && turning.torqueLimit == 0.0) {
        return;
    }
    const Vec6 wrench = axisOf(joint, at.motion);
    ScalarRow& row = add(index, wrench, at);
    row.compliance = 1.0 / (step * kMotorDamping);
    row.bound = turning.rate;
    row.most = step * turning.torqueLimit;
    row.least = -row.most;
    row.start = 0;
    if (motorOf_[index] == nullptr) {
        // A joint that turns goes on to be braked.
        const double rate = rateAlong(joints_[index], wrench, at.motion.screws(), at.rates);
        row.start = rate > kTurning ? -1 : (rate < -kTurning ? 1 : 0);
    }
}

void ScalarRows::wrenches(double step, std::vector<Vec6>& wrenches) const {
    wrenches.assign(joints_.size(), Vec6::Zero());
    for (std::size_t k = 0; k < rowJoints_.size(); ++k) {
        wrenches[rowJoints_[k]] += rows_[k].impulse / step * rowWrenches_[k];
    }
}

}  // namespace simcore::dynamics
