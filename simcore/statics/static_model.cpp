#include "simcore/statics/static_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/QR>

#include "simcore/dynamics/engine.h"
#include "simcore/mobility/stance.h"

namespace simcore::statics {

using dynamics::RateTerm;
using dynamics::TreeBody;
using mechanism::Wheel;

Contact contactAtAngle(const mechanism::Mechanism& mechanism, int wheel,
                       const std::vector<Pose>& poses, double angle) {
    const Wheel& w = mechanism.wheels[static_cast<std::size_t>(wheel)];
    const Pose& X_WB = poses[static_cast<std::size_t>(w.body)];
    const mobility::WheelStand stand = mobility::standAtAngle(w, X_WB, angle);
    return {wheel, stand.point, stand.normal, mobility::rollingDirection(w, X_WB, stand.normal)};
}

StaticModel::StaticModel(const mechanism::Mechanism& mechanism, Model joints)
    : mechanism_(mechanism),
      tree_(mechanism_, joints),
      motion_(mechanism_, tree_),
      loops_(mechanism_, tree_, joints),
      inertia_(tree_, motion_, loops_),
      twists_(tree_.bodies().size()),
      wrenches_(tree_.bodies().size()) {
    if (const Problems problems = dynamics::whyNoEngineCanRun(mechanism); !problems.empty()) {
        throw std::invalid_argument(toString(problems));
    }
    reset();
}

dynamics::TreeState StaticModel::reset() {
    dynamics::TreeState state = tree_.drawnState();
    loops_.reset(state, motion_);
    renewMotions();
    return state;
}

bool StaticModel::place(dynamics::TreeState& state) {
    const bool closed = loops_.close(state, motion_);
    renewMotions();
    return closed;
}

void StaticModel::renewMotions() {
    const Eigen::Index n = loops_.independentCount();
    for (std::size_t k = 0; k < twists_.size(); ++k) {
        const TreeBody& at = tree_.bodies()[k];
        auto& twists = twists_[k];
        if (at.parent >= 0) {
            twists = twists_[static_cast<std::size_t>(at.parent)];
        } else {
            twists.setZero(6, n);
        }
        for (const dynamics::TreeElement& element : at.elements) {
            for (int rate = element.rate; rate < element.rate + element.rateCount(); ++rate) {
                for (const RateTerm& term : loops_.terms(rate)) {
                    twists.col(term.index) +=
                        term.factor * motion_.screws()[static_cast<std::size_t>(rate)];
                }
            }
        }
    }
}

std::vector<double> StaticModel::change(int motion, double amount) const {
    std::vector<double> change(static_cast<std::size_t>(tree_.rateCount()), 0.0);
    for (std::size_t rate = 0; rate < change.size(); ++rate) {
        for (const RateTerm& term : loops_.terms(static_cast<int>(rate))) {
            change[rate] += term.index == motion ? amount * term.factor : 0.0;
        }
    }
    return change;
}

void StaticModel::move(dynamics::TreeState& state, const Eigen::VectorXd& amounts) const {
    std::vector<double> change(static_cast<std::size_t>(tree_.rateCount()), 0.0);
    for (std::size_t rate = 0; rate < change.size(); ++rate) {
        for (const RateTerm& term : loops_.terms(static_cast<int>(rate))) {
            change[rate] += term.factor * amounts[term.index];
        }
    }
    dynamics::advance(tree_, state, change);
}

Vec3 StaticModel::velocityOf(int body, const Vec3& point, const Eigen::VectorXd& amounts) const {
    const int at = tree_.positionOf(body);
    if (at < 0) {
        return Vec3::Zero();
    }
    const dynamics::Vec6 twist = twists_[static_cast<std::size_t>(at)] * amounts;
    const Vec3 turn = twist.head<3>();
    return twist.tail<3>() + turn.cross(point - motion_.origin(body));
}

Eigen::MatrixXd StaticModel::inertia() {
    motion_.weigh();
    dynamics::RowMajor sum(motions(), motions());
    inertia_.assemble(sum);
    return sum;
}

Eigen::RowVectorXd StaticModel::workOf(int body, const Vec3& force, const Vec3& point) const {
    const int at = tree_.positionOf(body);
    if (at < 0) {
        return Eigen::RowVectorXd::Zero(motions());
    }
    return dynamics::forceAt(force, point - motion_.origin(body)).transpose() *
           twists_[static_cast<std::size_t>(at)];
}

Eigen::RowVectorXd StaticModel::workOfMoment(int body, const Vec3& moment) const {
    const int at = tree_.positionOf(body);
    if (at < 0) {
        return Eigen::RowVectorXd::Zero(motions());
    }
    return dynamics::spatial(moment, Vec3::Zero()).transpose() *
           twists_[static_cast<std::size_t>(at)];
}

Eigen::RowVectorXd StaticModel::workAboutJoint(const mechanism::Joint& joint) const {
    const Vec3 axis = poses()[static_cast<std::size_t>(joint.first)].rotation * joint.axis;
    return workOfMoment(joint.second, axis) - workOfMoment(joint.first, axis);
}

Eigen::RowVectorXd StaticModel::torqueWork(const Wheel& wheel) const {
    const Vec3 axis = poses()[static_cast<std::size_t>(wheel.body)].rotation * wheel.axis;
    return workOfMoment(wheel.body, axis) - workOfMoment(wheel.carrier, axis);
}

double StaticModel::potential(double gravity) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
        const mechanism::Body& body = mechanism_.bodies[i];
        sum += body.mass * gravity * (poses()[i] * body.com).z();
    }
    for (const mechanism::Spring& spring : mechanism_.springs) {
        double stretch = 0.0;  // in the sense in which the preload pushes
        if (spring.joint >= 0) {
            stretch = mechanism::jointAngle(
                mechanism_.joints[static_cast<std::size_t>(spring.joint)], poses());
        } else {
            const Vec3 a = poses()[static_cast<std::size_t>(spring.first)] * spring.firstPoint;
            const Vec3 b = poses()[static_cast<std::size_t>(spring.second)] * spring.secondPoint;
            stretch = (b - a).norm() - (spring.secondPoint - spring.firstPoint).norm();
        }
        sum += stretch * (0.5 * spring.stiffness * stretch - spring.preload);
    }
    return sum;
}

Eigen::VectorXd StaticModel::loads(double gravity) const {
    std::fill(wrenches_.begin(), wrenches_.end(), dynamics::Vec6::Zero());
    const auto push = [&](int body, const Vec3& force, const Vec3& point) {
        if (const int at = tree_.positionOf(body); at >= 0) {
            wrenches_[static_cast<std::size_t>(at)] +=
                dynamics::forceAt(force, point - motion_.origin(body));
        }
    };
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
        const mechanism::Body& body = mechanism_.bodies[i];
        push(static_cast<int>(i), {0.0, 0.0, -body.mass * gravity}, poses()[i] * body.com);
    }
    for (const mechanism::Spring& spring : mechanism_.springs) {
        if (spring.joint >= 0) {
            const mechanism::Joint& joint =
                mechanism_.joints[static_cast<std::size_t>(spring.joint)];
            const double torque =
                spring.preload - spring.stiffness * mechanism::jointAngle(joint, poses());
            const Vec3 axis = poses()[static_cast<std::size_t>(joint.first)].rotation * joint.axis;
            dynamics::pushBetween(tree_, joint.first, joint.second,
                                  dynamics::spatial(torque * axis, Vec3::Zero()), wrenches_);
            continue;
        }
        const Vec3 a = poses()[static_cast<std::size_t>(spring.first)] * spring.firstPoint;
        const Vec3 b = poses()[static_cast<std::size_t>(spring.second)] * spring.secondPoint;
        const double drawn = (spring.secondPoint - spring.firstPoint).norm();
        const double thrust = spring.preload + spring.stiffness * (drawn - (b - a).norm());
        const Vec3 force = thrust * (b - a).normalized();
        push(spring.second, force, b);
        push(spring.first, -force, a);
    }
    // All that comes after a rate works on it.
    std::vector<double> forces(static_cast<std::size_t>(tree_.rateCount()));
    for (std::size_t k = wrenches_.size(); k-- > 0;) {
        const TreeBody& at = tree_.bodies()[k];
        for (const dynamics::TreeElement& element : at.elements) {
            for (int rate = element.rate; rate < element.rate + element.rateCount(); ++rate) {
                const auto at_ = static_cast<std::size_t>(rate);
                forces[at_] = motion_.screws()[at_].dot(wrenches_[k]);
            }
        }
        if (at.parent >= 0) {
            wrenches_[static_cast<std::size_t>(at.parent)] += wrenches_[k];
        }
    }
    Eigen::VectorXd work;
    inertia_.project(forces, 1.0, work);
    return work;
}

Equilibrium StaticModel::equilibrium(std::span<const Contact> contacts, ContactSet set,
                                     double gravity, std::span<const JointStop> stops) {
    Equilibrium result;
    int columns = 0;
    std::vector<bool> touches(mechanism_.wheels.size(), false);
    for (const Contact& contact : contacts) {
        touches[static_cast<std::size_t>(contact.wheel)] = true;
        result.normal.push_back(columns++);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        result.traction.push_back(columns++);
    }
    for (const Contact& contact : contacts) {
        const Wheel& wheel = mechanism_.wheels[static_cast<std::size_t>(contact.wheel)];
        const bool free = set == ContactSet::Free && wheel.relaxedLateral;
        result.lateral.push_back(free ? -1 : columns++);
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
        result.stop.push_back(columns++);
    }
    for (const bool touching : touches) {
        result.torque.push_back(touching ? columns++ : -1);
    }
    result.matrix.setZero(motions(), columns);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& contact = contacts[i];
        const int body = mechanism_.wheels[static_cast<std::size_t>(contact.wheel)].body;
        const auto put = [&](int column, const Vec3& direction) {
            if (column >= 0) {
                result.matrix.col(column) = workOf(body, direction, contact.point).transpose();
            }
        };
        put(result.normal[i], contact.normal);
        put(result.traction[i], contact.forward);
        put(result.lateral[i], contact.normal.cross(contact.forward));
    }
    for (std::size_t w = 0; w < touches.size(); ++w) {
        if (touches[w]) {
            result.matrix.col(result.torque[w]) = torqueWork(mechanism_.wheels[w]).transpose();
        }
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const mechanism::Joint& joint = mechanism_.joints[static_cast<std::size_t>(stops[i].joint)];
        result.matrix.col(result.stop[i]) = stops[i].sign * workAboutJoint(joint).transpose();
    }
    result.right = -loads(gravity);
    return result;
}

Eigen::MatrixXd StaticModel::rollingRows(std::span<const Contact> contacts) const {
    const Pose& chassis = poses()[static_cast<std::size_t>(mechanism_.chassis)];
    const Vec3 forward = chassis.rotation * Vec3::UnitX();
    const Vec3 left = Vec3::UnitZ().cross(forward).normalized();
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(3 + 2 * contacts.size()), motions());
    matrix.row(0) = workOf(mechanism_.chassis, forward, chassis.position);
    matrix.row(1) = workOf(mechanism_.chassis, left, chassis.position);
    matrix.row(2) = workOfMoment(mechanism_.chassis, Vec3::UnitZ());
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const Contact& contact = contacts[i];
        const int body = mechanism_.wheels[static_cast<std::size_t>(contact.wheel)].body;
        const auto row = static_cast<Eigen::Index>(3 + 2 * i);
        matrix.row(row) = workOf(body, contact.normal, contact.point);
        matrix.row(row + 1) = workOf(body, contact.forward, contact.point);
    }
    return matrix;
}

double StaticModel::rollingConflict(std::span<const Contact> contacts) {
    if (contacts.empty()) {
        return 0.0;
    }
    const Eigen::MatrixXd matrix = rollingRows(contacts);
    const Eigen::VectorXd right = Eigen::VectorXd::Unit(matrix.rows(), 0);
    const Eigen::VectorXd motion = matrix.completeOrthogonalDecomposition().solve(right);
    const Eigen::VectorXd slips = (matrix * motion - right).tail(matrix.rows() - 3);
    const double forward = std::abs(matrix.row(0).dot(motion));
    return slips.norm() / std::sqrt(static_cast<double>(contacts.size())) / std::max(1e-3, forward);
}

Eigen::VectorXd StaticModel::rollingRates(std::span<const Contact> contacts, double speed,
                                          double turn) {
    const auto& wheels = mechanism_.wheels;
    const Eigen::MatrixXd matrix = rollingRows(contacts);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix.rows());
    right[0] = speed;
    right[2] = turn;
    const Eigen::VectorXd motion = matrix.completeOrthogonalDecomposition().solve(right);
    Eigen::VectorXd rates(static_cast<Eigen::Index>(wheels.size()));
    for (std::size_t w = 0; w < wheels.size(); ++w) {
        const bool touches = std::any_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
            return c.wheel == static_cast<int>(w);
        });
        rates[static_cast<Eigen::Index>(w)] =
            touches ? torqueWork(wheels[w]).dot(motion) : speed / wheels[w].radius;
    }
    return rates;
}

}  // namespace simcore::statics
