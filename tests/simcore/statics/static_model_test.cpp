#include "simcore/statics/static_model.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/SVD>

#include "simcore/dynamics/engine.h"
#include "simcore/mobility/constraint_system.h"
#include "simcore/project/resolve.h"
#include "simcore/statics/static_study.h"
#include "simcore/statics/traction.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

mechanism::Mechanism rover(const std::string& name,
                           const std::vector<project::Assignment>& set = {}) {
    auto resolved = project::resolve(testsupport::shipped(name), {}, set);
    EXPECT_TRUE(resolved);
    return std::move(resolved).value();
}

std::vector<Contact> contactsOf(const StaticModel& model, const std::vector<double>& angles) {
    std::vector<Contact> contacts;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        contacts.push_back(
            contactAtAngle(model.mechanism(), static_cast<int>(i), model.poses(), angles[i]));
    }
    return contacts;
}

std::vector<double> level(const mechanism::Mechanism& mechanism) {
    return std::vector<double>(mechanism.wheels.size(), 0.0);
}

}  // namespace

// The paper's counts, from the motions and from the rank of all joints' constraints.
TEST(StaticModelTest, CountsAreThePapers) {
    for (const std::string name : {"solero", "shrimp"}) {
        for (const Model joints : {Model::Built, Model::Relaxed}) {
            const mechanism::Mechanism mechanism = rover(name);
            StaticModel model(mechanism, joints);
            const std::vector<Contact> contacts = contactsOf(model, level(mechanism));
            for (const auto& [set, columns, dimension] :
                 {std::tuple(ContactSet::Free, 20, 5), std::tuple(ContactSet::All, 24, 9)}) {
                const Equilibrium found = model.equilibrium(contacts, set, 9.81);
                EXPECT_EQ(found.matrix.rows(), 15) << name;
                EXPECT_EQ(found.matrix.cols(), columns) << name;
                EXPECT_EQ(Traction(found, mechanism, contacts).dimension(), dimension) << name;
            }
            mobility::Stance stance = mobility::drawnStance(mechanism);
            for (mobility::WheelStand& wheel : stance.wheels) {
                wheel.touching = false;
            }
            const mobility::ConstraintSystem joined(mechanism, joints, stance);
            const Eigen::MatrixXd rows = joined.matrix(stance);
            EXPECT_EQ(rows.cols(), 108) << name;
            Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows);
            svd.setThreshold(1e-9);
            EXPECT_EQ(svd.rank(), 93) << name;
        }
    }
}

// An independent route: the balance of all 18 bodies with every reaction of the joints as an
// unknown has the forces of M U = R among its solutions.
TEST(StaticModelTest, EveryBodyIsBalanced) {
    const mechanism::Mechanism mechanism = rover("solero");
    StaticModel model(mechanism, Model::Built);
    std::vector<double> angles = level(mechanism);
    angles[0] = 0.7;
    const std::vector<Contact> contacts = contactsOf(model, angles);
    const Equilibrium found = model.equilibrium(contacts, ContactSet::Free, 9.81);
    const Traction traction(found, mechanism, contacts);
    const Solution best = traction.best(Objective::Friction);
    ASSERT_NE(best.way, Way::None);

    // Forces and moments about the origin on each body, in the columns' order and sense.
    mobility::Stance stance = mobility::drawnStance(mechanism);
    for (mobility::WheelStand& wheel : stance.wheels) {
        wheel.touching = false;
    }
    std::vector<Eigen::Matrix<double, 6, 1>> load(mechanism.bodies.size(),
                                                  Eigen::Matrix<double, 6, 1>::Zero());
    const auto push = [&](int body, const Vec3& force, const Vec3& point) {
        load[static_cast<std::size_t>(body)].head<3>() += force;
        load[static_cast<std::size_t>(body)].tail<3>() += point.cross(force);
    };
    const auto turn = [&](int body, const Vec3& moment) {
        load[static_cast<std::size_t>(body)].tail<3>() += moment;
    };
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        push(static_cast<int>(i), {0.0, 0.0, -9.81 * mechanism.bodies[i].mass},
             mechanism.bodies[i].com);
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        const mechanism::Wheel& wheel = mechanism.wheels[i];
        push(wheel.body,
             best.forces.normal[i] * contacts[i].normal +
                 best.forces.traction[i] * contacts[i].forward +
                 best.forces.lateral[i] * contacts[i].normal.cross(contacts[i].forward),
             contacts[i].point);
        turn(wheel.body, best.forces.torque[i] * wheel.axis);
        turn(wheel.carrier, -best.forces.torque[i] * wheel.axis);
    }
    for (const mechanism::Spring& spring : mechanism.springs) {
        ASSERT_LT(spring.joint, 0);
        const Vec3 force = spring.preload * (spring.secondPoint - spring.firstPoint).normalized();
        push(spring.second, force, spring.secondPoint);
        push(spring.first, -force, spring.firstPoint);
    }
    // Joints transmit forces along the three axes and moments across their pins: every pin is one
    // of built freedom, so five unknowns each.
    const auto bodies = static_cast<Eigen::Index>(mechanism.bodies.size());
    const auto joints = static_cast<Eigen::Index>(mechanism.joints.size());
    Eigen::MatrixXd transmitted = Eigen::MatrixXd::Zero(6 * bodies, 5 * joints);
    for (Eigen::Index j = 0; j < joints; ++j) {
        const mechanism::Joint& joint = mechanism.joints[static_cast<std::size_t>(j)];
        ASSERT_EQ(joint.built.size(), 1U);
        const Vec3 a = joint.axis.unitOrthogonal();
        const Vec3 b = joint.axis.cross(a);
        for (Eigen::Index k = 0; k < 5; ++k) {
            Eigen::Matrix<double, 6, 1> unit = Eigen::Matrix<double, 6, 1>::Zero();
            if (k < 3) {
                unit.head<3>() = Vec3::Unit(k);
                unit.tail<3>() = joint.point.cross(Vec3::Unit(k));
            } else {
                unit.tail<3>() = k == 3 ? a : b;
            }
            transmitted.block<6, 1>(6 * joint.second, 5 * j + k) += unit;
            transmitted.block<6, 1>(6 * joint.first, 5 * j + k) -= unit;
        }
    }
    Eigen::VectorXd right(6 * bodies);
    for (Eigen::Index i = 0; i < bodies; ++i) {
        right.segment<6>(6 * i) = -load[static_cast<std::size_t>(i)];
    }
    const Eigen::VectorXd reactions = transmitted.completeOrthogonalDecomposition().solve(right);
    EXPECT_LT((transmitted * reactions - right).cwiseAbs().maxCoeff(), 1e-9 * right.norm());
}

// M is the work of forces: against finite differences of where points go.
TEST(StaticModelTest, MotionsAreDerivativesOfPoses) {
    const mechanism::Mechanism mechanism = rover("shrimp");
    StaticModel model(mechanism, Model::Built);
    const std::vector<Contact> contacts = contactsOf(model, level(mechanism));
    const Equilibrium found = model.equilibrium(contacts, ContactSet::All, 9.81);
    // Weight and springs do the work that the potential energy loses.
    const auto energyAt = [&](int motion, double step) {
        StaticModel moved(mechanism, Model::Built);
        dynamics::TreeState state = moved.reset();
        dynamics::advance(moved.tree(), state, model.change(motion, step));
        EXPECT_TRUE(moved.place(state));
        double energy = 0.0;
        for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
            energy +=
                9.81 * mechanism.bodies[i].mass * (moved.poses()[i] * mechanism.bodies[i].com).z();
        }
        for (const mechanism::Spring& spring : mechanism.springs) {
            const Vec3 a =
                moved.poses()[static_cast<std::size_t>(spring.first)] * spring.firstPoint;
            const Vec3 b =
                moved.poses()[static_cast<std::size_t>(spring.second)] * spring.secondPoint;
            const double stretch = (b - a).norm() - (spring.secondPoint - spring.firstPoint).norm();
            energy += -spring.preload * stretch + 0.5 * spring.stiffness * stretch * stretch;
        }
        return energy;
    };
    constexpr double kStep = 1e-5;
    for (int motion = 0; motion < model.motions(); ++motion) {
        const double slope = (energyAt(motion, kStep) - energyAt(motion, -kStep)) / (2.0 * kStep);
        EXPECT_NEAR(found.right[motion], slope, 1e-6 * 62.9) << motion;
    }
}

// On level ground, wheels that roll without slip all turn with v/R; against a wall the front wheel
// of a rover cannot go forwards at all.
TEST(StaticModelTest, RollingRatesOnLevelGround) {
    for (const std::string& name : testsupport::shippedNames()) {
        const mechanism::Mechanism mechanism = rover(name);
        if (mechanism.wheels.empty()) {
            continue;
        }
        StaticModel model(mechanism, Model::Built);
        const Eigen::VectorXd rates =
            model.rollingRates(contactsOf(model, level(mechanism)), 0.1, 0.0);
        for (std::size_t w = 0; w < mechanism.wheels.size(); ++w) {
            EXPECT_NEAR(rates[static_cast<Eigen::Index>(w)], 0.1 / mechanism.wheels[w].radius, 1e-9)
                << name;
        }
    }
}
