#pragma once

#include <Eigen/QR>

#include "simcore/mechanism/mechanism.h"

namespace testsupport {

struct WheelLoads {
    std::vector<double> loads;  ///< vertical, in the order of the wheels [N]
    double residual = 0.0;      ///< of the balances [N], [N m]: 0 when the mechanism can stand
};

/// Wheel loads of a rover that stands level at its drawn pose, from Newton's balances of every
/// single body in the vertical plane along the rover (fx, fz and the moment about y), with the two
/// forces of every pin, the torque of every gear and one vertical force a wheel as unknowns. What
/// redundant pins leave open is split evenly, which for a symmetrical rover leaves the loads.
inline WheelLoads wheelLoadsAtRest(const simcore::mechanism::Mechanism& mechanism, double gravity) {
    using simcore::Vec3;
    const auto bodies = static_cast<Eigen::Index>(mechanism.bodies.size());
    const auto joints = static_cast<Eigen::Index>(mechanism.joints.size());
    const auto gears = static_cast<Eigen::Index>(mechanism.gears.size());
    const auto wheels = static_cast<Eigen::Index>(mechanism.wheels.size());
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(3 * bodies, 2 * joints + gears + wheels);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(3 * bodies);
    const auto com = [&](int body) { return mechanism.bodies[static_cast<std::size_t>(body)].com; };
    // Rows of a force (fx, fz) at `point` on `body`, as a column of A or a part of b.
    const auto place = [&](auto column, int body, const Vec3& point, double fx, double fz) {
        const Vec3 arm = point - com(body);
        column(3 * body) += fx;
        column(3 * body + 1) += fz;
        column(3 * body + 2) += arm.z() * fx - arm.x() * fz;
    };
    for (Eigen::Index i = 0; i < joints; ++i) {
        const auto& joint = mechanism.joints[static_cast<std::size_t>(i)];
        for (int k = 0; k < 2; ++k) {
            const double fx = k == 0 ? 1.0 : 0.0;
            place(A.col(2 * i + k), joint.second, joint.point, fx, 1.0 - fx);
            place(A.col(2 * i + k), joint.first, joint.point, -fx, fx - 1.0);
        }
    }
    const auto addTorque = [&](auto column, int joint, double torque) {
        const auto& j = mechanism.joints[static_cast<std::size_t>(joint)];
        column(3 * j.second + 2) += torque * j.axis.y();
        column(3 * j.first + 2) -= torque * j.axis.y();
    };
    for (Eigen::Index i = 0; i < gears; ++i) {
        // No work at turn(second) = ratio turn(first).
        const auto& gear = mechanism.gears[static_cast<std::size_t>(i)];
        addTorque(A.col(2 * joints + i), gear.secondJoint, 1.0);
        addTorque(A.col(2 * joints + i), gear.firstJoint, -gear.ratio);
    }
    for (Eigen::Index i = 0; i < wheels; ++i) {
        const auto& wheel = mechanism.wheels[static_cast<std::size_t>(i)];
        place(A.col(2 * joints + gears + i), wheel.body, wheel.center, 0.0, 1.0);
    }
    for (const auto& spring : mechanism.springs) {
        if (spring.joint >= 0) {
            addTorque(b.col(0), spring.joint, spring.preload);
            continue;
        }
        const Vec3 push = spring.preload * (spring.secondPoint - spring.firstPoint).normalized();
        place(b.col(0), spring.second, spring.secondPoint, push.x(), push.z());
        place(b.col(0), spring.first, spring.firstPoint, -push.x(), -push.z());
    }
    for (Eigen::Index i = 0; i < bodies; ++i) {
        b(3 * i + 1) -= mechanism.bodies[static_cast<std::size_t>(i)].mass * gravity;
    }
    const Eigen::VectorXd x = A.completeOrthogonalDecomposition().solve(-b);
    WheelLoads result;
    result.residual = (A * x + b).norm();
    for (Eigen::Index i = 0; i < wheels; ++i) {
        result.loads.push_back(x(2 * joints + gears + i));
    }
    return result;
}

}  // namespace testsupport
