#include "simcore/mobility/constraint_system.h"

#include <cmath>
#include <stdexcept>

namespace simcore::mobility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using mechanism::directionsOf;
using mechanism::FreedomKind;
using mechanism::orthogonalComplement;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

}  // namespace

ConstraintSystem::ConstraintSystem(const mechanism::Mechanism& mechanism, Model model, Stance start)
    : mechanism_(mechanism),
      start_(std::move(start)),
      length_(characteristicLength(mechanism)) {
    if (start_.bodies.size() != mechanism.bodies.size() ||
        start_.wheels.size() != mechanism.wheels.size()) {
        throw std::invalid_argument(
            "a stance needs a pose of every body and a stand of every wheel");
    }
    reference_ =
        start_.bodies.empty() ? Vec3(Vec3::Zero()) : pose(start_, mechanism.chassis).position;
    for (const mechanism::Body& body : mechanism.bodies) {
        firstColumn_.push_back(body.fixed ? -1 : columns_);
        columns_ += body.fixed ? 0 : 6;
    }
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
        addJoint(static_cast<int>(i), model);
    }
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        addContact(static_cast<int>(i), model);
    }
    for (std::size_t i = 0; i < mechanism.gears.size(); ++i) {
        rows_.push_back(
            {Kind::Gear, static_cast<int>(i), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), 0});
    }
}

void ConstraintSystem::addJoint(int index, Model model) {
    const mechanism::Joint& joint = mechanism_.joints[at(index)];
    const auto& freedoms = freedomsOf(joint, model);
    for (const Vec3& held : orthogonalComplement(directionsOf(freedoms, FreedomKind::Slide))) {
        rows_.push_back({Kind::JointSlide, index, held, Vec3::Zero(), Vec3::Zero(), 0});
    }
    const auto turns = directionsOf(freedoms, FreedomKind::Turn);
    for (const Vec3& held : orthogonalComplement(turns)) {
        const Vec3 first = turns.empty() ? Vec3(Vec3::Zero()) : turns.front();
        const Vec3 second = turns.empty() ? Vec3(Vec3::Zero()) : turns.back();
        rows_.push_back(
            {Kind::JointTurn, index, held, first, second, static_cast<int>(turns.size())});
    }
}

void ConstraintSystem::addContact(int index, Model model) {
    if (!start_.wheels[at(index)].touching) {
        return;
    }
    const auto add = [&](Kind kind) {
        rows_.push_back({kind, index, Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), 0});
    };
    add(Kind::ContactNormal);
    add(Kind::ContactRolling);
    if (model == Model::Built || !mechanism_.wheels[at(index)].relaxedLateral) {
        add(Kind::ContactLateral);
    }
}

const Pose& ConstraintSystem::pose(const Stance& stance, int body) const {
    return stance.bodies[at(body)];
}

void ConstraintSystem::putSlide(MatrixXd& matrix, Index row, int first, int second,
                                const Vec3& point, const Vec3& direction) const {
    // d.(v + w x p) / L, with v of the reference point and over L already in the column.
    const Vec3 angular = (point - reference_).cross(direction) / length_;
    for (const auto& [body, sign] : {std::pair{second, 1.0}, std::pair{first, -1.0}}) {
        const int column = body < 0 ? -1 : firstColumn_[at(body)];
        if (column >= 0) {
            matrix.block<1, 3>(row, column) += sign * direction.transpose();
            matrix.block<1, 3>(row, column + 3) += sign * angular.transpose();
        }
    }
}

void ConstraintSystem::putTurn(MatrixXd& matrix, Index row, int first, int second,
                               const Vec3& direction) const {
    for (const auto& [body, sign] : {std::pair{second, 1.0}, std::pair{first, -1.0}}) {
        const int column = firstColumn_[at(body)];
        if (column >= 0) {
            matrix.block<1, 3>(row, column + 3) += sign * direction.transpose();
        }
    }
}

Vec3 ConstraintSystem::heldTurn(const Row& row, const Stance& stance) const {
    const mechanism::Joint& joint = mechanism_.joints[at(row.index)];
    const auto& R_first = pose(stance, joint.first).rotation;
    if (row.freeTurns != 2) {
        return R_first * row.direction;
    }
    const Vec3 across =
        (R_first * row.first).cross(pose(stance, joint.second).rotation * row.second);
    const double sign = row.first.cross(row.second).dot(row.direction) > 0.0 ? 1.0 : -1.0;
    return sign * across.normalized();
}

Vec3 ConstraintSystem::contactDirection(const Row& row, const Stance& stance) const {
    const Vec3& normal = start_.wheels[at(row.index)].normal;
    if (row.kind == Kind::ContactNormal) {
        return normal;
    }
    const mechanism::Wheel& wheel = mechanism_.wheels[at(row.index)];
    const Vec3 rolling = rollingDirection(wheel, pose(stance, wheel.body), normal);
    return row.kind == Kind::ContactRolling ? rolling : Vec3(normal.cross(rolling));
}

MatrixXd ConstraintSystem::matrix(const Stance& stance) const {
    MatrixXd matrix = MatrixXd::Zero(static_cast<Index>(rows_.size()), columns_);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        const auto r = static_cast<Index>(i);
        if (row.kind == Kind::JointSlide) {
            const mechanism::Joint& joint = mechanism_.joints[at(row.index)];
            putSlide(matrix, r, joint.first, joint.second, pose(stance, joint.second) * joint.point,
                     pose(stance, joint.first).rotation * row.direction);
        } else if (row.kind == Kind::JointTurn) {
            const mechanism::Joint& joint = mechanism_.joints[at(row.index)];
            putTurn(matrix, r, joint.first, joint.second, heldTurn(row, stance));
        } else if (row.kind == Kind::Gear) {  // turn(second) - ratio turn(first)
            const mechanism::Gear& gear = mechanism_.gears[at(row.index)];
            const mechanism::Joint& first = mechanism_.joints[at(gear.firstJoint)];
            const mechanism::Joint& second = mechanism_.joints[at(gear.secondJoint)];
            putTurn(matrix, r, second.first, second.second,
                    pose(stance, second.first).rotation * second.axis);
            putTurn(matrix, r, first.first, first.second,
                    -gear.ratio * (pose(stance, first.first).rotation * first.axis));
        } else {
            putSlide(matrix, r, -1, mechanism_.wheels[at(row.index)].body,
                     stance.wheels[at(row.index)].point, contactDirection(row, stance));
        }
    }
    return matrix;
}

ConstraintJacobian ConstraintSystem::jacobian() const {
    ConstraintJacobian jacobian;
    jacobian.matrix = matrix(start_);
    jacobian.firstColumn = firstColumn_;
    for (const Row& row : rows_) {
        if (row.kind == Kind::JointSlide || row.kind == Kind::JointTurn) {
            const mechanism::Joint& joint = mechanism_.joints[at(row.index)];
            const bool slide = row.kind == Kind::JointSlide;
            const Vec3 direction = slide ? Vec3(pose(start_, joint.first).rotation * row.direction)
                                         : heldTurn(row, start_);
            jacobian.names.push_back(
                {joint.name, slide ? "slide" : "turn", direction, row.index, -1, 0.0});
            jacobian.priorities.push_back(slide ? Priority::JointSlide : Priority::JointTurn);
        } else if (row.kind == Kind::Gear) {
            const mechanism::Gear& gear = mechanism_.gears[at(row.index)];
            const mechanism::Joint& second = mechanism_.joints[at(gear.secondJoint)];
            jacobian.names.push_back({gear.name, "gear",
                                      pose(start_, second.first).rotation * second.axis,
                                      gear.secondJoint, -1, 0.0});
            jacobian.priorities.push_back(Priority::Gear);
        } else {
            jacobian.names.push_back({contactOf(mechanism_.wheels[at(row.index)].name), "slide",
                                      contactDirection(row, start_), -1, row.index, 0.0});
            jacobian.priorities.push_back(row.kind == Kind::ContactNormal
                                              ? Priority::ContactNormal
                                              : (row.kind == Kind::ContactRolling
                                                     ? Priority::ContactRolling
                                                     : Priority::ContactLateral));
        }
    }
    return jacobian;
}

double ConstraintSystem::turnResidual(const Row& row, const Stance& stance) const {
    const mechanism::Joint& joint = mechanism_.joints[at(row.index)];
    // Rotation of the second body seen from the first.
    const Eigen::Quaterniond R_12 =
        pose(stance, joint.first).rotation.conjugate() * pose(stance, joint.second).rotation;
    if (row.freeTurns == 0) {
        return 2.0 * row.direction.dot(R_12.vec()) * (R_12.w() < 0.0 ? -1.0 : 1.0);
    }
    if (row.freeTurns == 1) {
        return row.direction.dot(row.first.cross(R_12 * row.first));
    }
    const Vec3 across = row.first.cross(row.second);
    const double sign = across.dot(row.direction) > 0.0 ? -1.0 : 1.0;
    return sign * (row.first.dot(R_12 * row.second) - row.first.dot(row.second)) / across.norm();
}

double ConstraintSystem::contactResidual(const Row& row, const Stance& stance) const {
    const mechanism::Wheel& wheel = mechanism_.wheels[at(row.index)];
    const Vec3& normal = start_.wheels[at(row.index)].normal;
    const Pose& before = pose(start_, wheel.body);
    const Pose& after = pose(stance, wheel.body);
    const Vec3 armBefore = rimPoint(wheel, before, normal) - before * wheel.center;
    const Vec3 armAfter = rimPoint(wheel, after, normal) - after * wheel.center;
    const Vec3 way = after * wheel.center - before * wheel.center;
    if (row.kind == Kind::ContactNormal) {
        return normal.dot(way + armAfter - armBefore) / length_;
    }
    const Eigen::AngleAxisd turn(after.rotation * before.rotation.conjugate());
    const Vec3 slip = way + turn.angle() * turn.axis().cross(0.5 * (armBefore + armAfter));
    const Vec3 mean = (contactDirection(row, start_) + contactDirection(row, stance)).normalized();
    return mean.dot(slip) / length_;
}

Eigen::VectorXd ConstraintSystem::residual(const Stance& stance) const {
    Eigen::VectorXd residual(static_cast<Index>(rows_.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Row& row = rows_[i];
        double& value = residual[static_cast<Index>(i)];
        if (row.kind == Kind::JointSlide) {
            const mechanism::Joint& joint = mechanism_.joints[at(row.index)];
            const Vec3 seen =
                pose(stance, joint.first).inverse() * (pose(stance, joint.second) * joint.point);
            value = row.direction.dot(seen - joint.point) / length_;
        } else if (row.kind == Kind::JointTurn) {
            value = turnResidual(row, stance);
        } else if (row.kind == Kind::Gear) {
            const mechanism::Gear& gear = mechanism_.gears[at(row.index)];
            value = jointAngle(mechanism_.joints[at(gear.secondJoint)], stance.bodies) -
                    gear.ratio * jointAngle(mechanism_.joints[at(gear.firstJoint)], stance.bodies);
        } else {
            value = contactResidual(row, stance);
        }
    }
    return residual;
}

Stance ConstraintSystem::moved(const Stance& stance, const Eigen::VectorXd& motion) const {
    Stance next = stance;
    for (std::size_t b = 0; b < next.bodies.size(); ++b) {
        if (firstColumn_[b] < 0) {
            continue;
        }
        const Vec3 slide = length_ * motion.segment<3>(firstColumn_[b]);
        const Vec3 turn = motion.segment<3>(firstColumn_[b] + 3);
        const double angle = turn.norm();
        const Eigen::Quaterniond rotation(angle > 0.0 ? Eigen::AngleAxisd(angle, turn / angle)
                                                      : Eigen::AngleAxisd::Identity());
        Pose& body = next.bodies[b];
        body.position = reference_ + slide + rotation * (body.position - reference_);
        body.rotation = (rotation * body.rotation).normalized();
    }
    for (std::size_t i = 0; i < next.wheels.size(); ++i) {
        const mechanism::Wheel& wheel = mechanism_.wheels[i];
        next.wheels[i].point = rimPoint(wheel, pose(next, wheel.body), next.wheels[i].normal);
    }
    return next;
}

}  // namespace simcore::mobility
