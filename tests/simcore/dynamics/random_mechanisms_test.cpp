// Mechanisms by lot in two engines that share nothing but the port: constraints between bodies
// (ODE) and free rates. Both are of first order, so both are extrapolated to no step at all, where
// they have to be the same.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/engine_cases.h"
#include "tests/support/random_mechanisms.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;
using Eigen::VectorXd;

namespace {

constexpr double kTime = 0.4;
constexpr std::uint64_t kSeeds = 12;  ///< of each lot
constexpr double kFirstStep = 0.001;  ///< [s]

/// The centre of each body and three points at 0.1 m from it [m].
VectorXd pointsOf(const World& world) {
    const auto& bodies = world.mechanism().bodies;
    VectorXd points(12 * static_cast<Eigen::Index>(bodies.size()));
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (int k = 0; k < 4; ++k) {
            const Vec3 arm = k < 3 ? Vec3(0.1 * Vec3::Unit(k)) : Vec3::Zero();
            points.segment<3>(12 * static_cast<Eigen::Index>(i) + 3 * k) =
                world.engine().poses()[i] * (bodies[i].com + arm);
        }
    }
    return points;
}

/// What the joints of a step carry [N], [N m].
VectorXd reactionsOf(const World& world) {
    const auto& reactions = world.engine().jointReactions();
    VectorXd found(6 * static_cast<Eigen::Index>(reactions.size()));
    for (std::size_t i = 0; i < reactions.size(); ++i) {
        found.segment<6>(6 * static_cast<Eigen::Index>(i)) << reactions[i].force,
            reactions[i].torque;
    }
    return found;
}

struct End {
    VectorXd points, reactions;
    double loopError = 0.0;
    long solverMessages = 0;
    long dividedSteps = 0;
};

void setDrives(World& world) {
    for (std::size_t i = 0; i < world.drive.size(); ++i) {
        world.drive[i] = i % 2 == 0 ? 2.0 : -1.5;
        world.external[i] = i % 2 == 0 ? -0.5 : 0.7;
    }
}

const EngineCase& engineCalled(const std::string& name) {
    for (const EngineCase& engine : allEngines()) {
        if (engine.name == name) {
            return engine;
        }
    }
    throw std::invalid_argument(name);
}

double largest(const VectorXd& v) {
    return v.lpNorm<Eigen::Infinity>();
}

/// What is left over of Newton's and Euler's equations of every body that is not fixed, after a
/// first step from rest at the drawn pose.
class Balance {
  public:
    explicit Balance(const World& world) : mechanism_(world.mechanism()) {
        for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
            const Body& body = mechanism_.bodies[i];
            const BodyVelocity& velocity = world.engine().velocities()[i];
            forces_.emplace_back(-body.mass * velocity.linear / kFirstStep);
            torques_.emplace_back(-mechanism_.inertiaWithRotor(i) * velocity.angular / kFirstStep);
        }
    }

    /// A force at a point and a torque of one body on another.
    void act(int first, int second, const Vec3& point, const Vec3& force, const Vec3& torque) {
        largestForce_ = std::max(largestForce_, force.norm());
        for (const auto& [body, sign] : {std::pair(first, -1.0), std::pair(second, 1.0)}) {
            const auto i = static_cast<std::size_t>(body);
            forces_[i] += sign * force;
            torques_[i] += sign * (torque + (point - mechanism_.bodies[i].com).cross(force));
        }
    }

    void turn(int body, const Vec3& torque) { torques_[static_cast<std::size_t>(body)] += torque; }

    void weigh(double gravity) {
        for (std::size_t i = 0; i < forces_.size(); ++i) {
            forces_[i].z() -= mechanism_.bodies[i].mass * gravity;
        }
    }

    double largestForce() const { return largestForce_; }

    /// [N], [N m]
    double residual() const {
        double residual = 0.0;
        for (std::size_t i = 0; i < forces_.size(); ++i) {
            if (!mechanism_.bodies[i].fixed) {
                residual = std::max({residual, forces_[i].norm(), torques_[i].norm()});
            }
        }
        return residual;
    }

  private:
    const Mechanism& mechanism_;
    std::vector<Vec3> forces_, torques_;
    double largestForce_ = 0.0;
};

class RandomMechanismTest : public ::testing::TestWithParam<std::tuple<Lot, std::uint64_t>> {
  protected:
    /// ODE's gears have a part that weighs nothing, which would be felt in free fall.
    double gravity() const { return lot == Lot::Gears ? 0.0 : kGravity; }

    End endOf(const EngineCase& engine, double step) const {
        World world(engine, mechanism, gravity(), step);
        setDrives(world);
        world.run(kTime);
        return {pointsOf(world), reactionsOf(world), loopError(mechanism, world.engine().poses()),
                world.engine().counters().solverMessages, world.engine().counters().dividedSteps};
    }

    const Lot lot = std::get<0>(GetParam());
    const Mechanism mechanism = RandomMechanism(lot, std::get<1>(GetParam())).mechanism();
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Lots, RandomMechanismTest,
                         ::testing::Combine(::testing::Values(Lot::Tree, Lot::Gears,
                                                              Lot::PlaneLoops, Lot::SphericalLoop,
                                                              Lot::SpatialLoop),
                                            ::testing::Range<std::uint64_t>(0, kSeeds)),
                         [](const auto& each) {
                             return std::string(nameOf(std::get<0>(each.param))) +
                                    std::to_string(std::get<1>(each.param));
                         });

// Errors halve with the step, and what is extrapolated is the same motion: within a share of the
// errors that terms of second order may have. Trees carry the same forces, too: in loops some of
// them are open.
TEST_P(RandomMechanismTest, EnginesAgree) {
    if (const Problems problems = whyReducedCannotRun(mechanism); !problems.empty()) {
        GTEST_SKIP() << toString(problems);
    }
    const EngineCase& ode = engineCalled("Ode");
    const EngineCase& reduced = engineCalled("Reduced");
    const End odeCoarse = endOf(ode, 0.0002);
    const End odeFine = endOf(ode, 0.0001);
    const End coarse = endOf(reduced, 0.001);
    const End fine = endOf(reduced, 0.0005);
    const VectorXd expected = 2.0 * odeFine.points - odeCoarse.points;
    const double error = largest(coarse.points - expected);
    EXPECT_LT(error, 0.02);
    if (coarse.dividedSteps == 0) {
        EXPECT_NEAR(largest(fine.points - expected), 0.5 * error, 0.05 * error + 1e-6);
        EXPECT_LT(largest(2.0 * fine.points - coarse.points - expected), 0.03 * error + 1e-5);
    } else {
        // Coarse steps that were divided are better than the law.
        EXPECT_LT(largest(fine.points - expected), 0.8 * error);
    }
    EXPECT_LT(coarse.loopError, 1e-10);
    EXPECT_EQ(coarse.solverMessages, 0);
    if (lot == Lot::Tree) {
        const VectorXd forces = 2.0 * odeFine.reactions - odeCoarse.reactions;
        EXPECT_LT(largest(2.0 * fine.reactions - coarse.reactions - forces),
                  3e-4 * largest(forces));
    }
}

// In the first step from rest, springs as long as drawn, the forces of joints balance those that
// are known and the bodies' inertia, body by body, however they are split among joints that are
// redundant.
TEST_P(RandomMechanismTest, ReactionsBalanceEveryBody) {
    if (lot == Lot::Gears) {
        GTEST_SKIP() << "the forces of its teeth are not told";
    }
    if (const Problems problems = whyReducedCannotRun(mechanism); !problems.empty()) {
        GTEST_SKIP() << toString(problems);
    }
    Mechanism undamped = mechanism;
    for (Joint& joint : undamped.joints) {
        joint.damping = 0.0;
    }
    for (simcore::mechanism::Spring& spring : undamped.springs) {
        spring.damping = 0.0;
    }
    for (const EngineCase& engine : enginesThatCan(Can::Joints)) {
        SCOPED_TRACE(engine.name);
        World world(engine, undamped, gravity(), kFirstStep);
        setDrives(world);
        world.step();
        Balance balance(world);
        balance.weigh(gravity());
        for (std::size_t i = 0; i < undamped.joints.size(); ++i) {
            const Joint& joint = undamped.joints[i];
            const JointReaction& reaction = world.engine().jointReactions()[i];
            balance.act(joint.first, joint.second, joint.point, reaction.force, reaction.torque);
        }
        for (const simcore::mechanism::Spring& spring : undamped.springs) {
            if (spring.joint >= 0) {
                const Vec3& axis = undamped.joints[static_cast<std::size_t>(spring.joint)].axis;
                balance.act(spring.first, spring.second, Vec3::Zero(), Vec3::Zero(),
                            spring.preload * axis);
            } else {
                const Vec3 way = spring.secondPoint - spring.firstPoint;
                balance.act(spring.first, spring.second, spring.firstPoint,
                            spring.preload * way.normalized(), Vec3::Zero());
            }
        }
        for (std::size_t i = 0; i < undamped.wheels.size(); ++i) {
            const Wheel& wheel = undamped.wheels[i];
            balance.act(wheel.carrier, wheel.body, Vec3::Zero(), Vec3::Zero(),
                        world.drive[i] * wheel.axis);
            balance.turn(wheel.body, world.external[i] * wheel.axis);
        }
        EXPECT_GT(balance.largestForce(), 1.0);
        EXPECT_LT(balance.residual(), 1e-10 * balance.largestForce());
    }
}
