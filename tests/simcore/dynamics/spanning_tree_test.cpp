#include <cmath>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/loop_closures.h"
#include "simcore/project/resolve.h"
#include "tests/support/mechanisms.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;
using mechanism::Mechanism;
using mechanism::Model;

namespace {

constexpr double kStep = 1e-6;  // of finite differences

Mechanism mechanismOf(const std::string& name) {
    auto resolved = project::resolve(shipped(name));
    EXPECT_TRUE(resolved) << toString(resolved.problems());
    return std::move(resolved).value();
}

/// Random coordinates and rates; loops are not closed.
TreeState randomState(const SpanningTree& tree, Random& random) {
    TreeState state = tree.drawnState();
    std::vector<double> change(static_cast<std::size_t>(tree.rateCount()));
    for (double& value : change) {
        value = random.uniform(-0.5, 0.5);
    }
    advance(tree, state, change);
    for (double& rate : state.rates) {
        rate = random.uniform(-1.0, 1.0);
    }
    return state;
}

std::vector<Pose> posesAfter(const Mechanism& mechanism, const SpanningTree& tree, TreeState state,
                             double time) {
    std::vector<double> change = state.rates;
    for (double& value : change) {
        value *= time;
    }
    advance(tree, state, change);
    TreeMotion motion(mechanism, tree);
    motion.place(state);
    return motion.poses();
}

/// Linear velocity of the point of a body that is at `point`, from its twist about O.
Vec3 velocityAt(const Vec6& twist, const Vec3& origin, const Vec3& point) {
    return twist.tail<3>() + twist.head<3>().cross(point - origin);
}

}  // namespace

class TreeTest : public testing::TestWithParam<std::pair<const char*, Model>> {
  protected:
    const Mechanism mechanism = mechanismOf(GetParam().first);
    const SpanningTree tree{mechanism, GetParam().second};
};

// What the screws say of velocities is how the poses move.
TEST_P(TreeTest, TwistsAreTheMotionOfPoses) {
    Random random(3);
    for (int trial = 0; trial < 5; ++trial) {
        const TreeState state = randomState(tree, random);
        TreeMotion motion(mechanism, tree);
        motion.place(state);
        std::vector<Vec6> twists(tree.bodies().size());
        motion.twists(state.rates, twists);
        const auto before = posesAfter(mechanism, tree, state, -kStep);
        const auto after = posesAfter(mechanism, tree, state, kStep);
        for (std::size_t k = 0; k < twists.size(); ++k) {
            const auto body = static_cast<std::size_t>(tree.bodies()[k].body);
            const Vec3& com = mechanism.bodies[body].com;
            const Vec3 moved = (after[body] * com - before[body] * com) / (2.0 * kStep);
            const Vec3 point = motion.poses()[body] * com;
            EXPECT_LT((moved - velocityAt(twists[k], motion.origin(static_cast<int>(body)), point))
                          .norm(),
                      1e-7);
            const Eigen::AngleAxisd turn(after[body].rotation * before[body].rotation.conjugate());
            EXPECT_LT((turn.angle() * turn.axis() / (2.0 * kStep) - twists[k].head<3>()).norm(),
                      1e-7);
        }
    }
}

// Half u^T H u is the kinetic energy of all bodies, by their velocities and inertias.
TEST_P(TreeTest, MassMatrixIsTheKineticEnergy) {
    Random random(5);
    for (int trial = 0; trial < 5; ++trial) {
        const TreeState state = randomState(tree, random);
        TreeMotion motion(mechanism, tree);
        motion.place(state);
        motion.weigh();
        double byMatrix = 0.0;
        motion.visitMomenta([&](std::size_t, int j, const Vec6& momentum) {
            for (int i = j; i >= 0; i = tree.rateBefore(i)) {
                const double entry = motion.screws()[static_cast<std::size_t>(i)].dot(momentum);
                const double product = state.rates[static_cast<std::size_t>(i)] * entry *
                                       state.rates[static_cast<std::size_t>(j)];
                byMatrix += (i == j ? 0.5 : 1.0) * product;
            }
        });
        std::vector<Vec6> twists(tree.bodies().size());
        motion.twists(state.rates, twists);
        double byBodies = 0.0;
        for (std::size_t k = 0; k < twists.size(); ++k) {
            const auto index = static_cast<std::size_t>(tree.bodies()[k].body);
            const mechanism::Body& body = mechanism.bodies[index];
            const Pose& pose = motion.poses()[index];
            const Vec3 v =
                velocityAt(twists[k], motion.origin(static_cast<int>(index)), pose * body.com);
            const Vec3 w = pose.rotation.conjugate() * Vec3(twists[k].head<3>());
            byBodies += 0.5 * body.mass * v.squaredNorm() +
                        0.5 * w.dot(mechanism.inertiaWithRotor(index) * w);
        }
        EXPECT_NEAR(byMatrix, byBodies, 1e-9 * byBodies);
    }
}

// Inverse dynamics without motion: each rate's force is the potential energy's slope along it.
TEST_P(TreeTest, WeightIsTheSlopeOfPotentialEnergy) {
    Random random(7);
    TreeState state = randomState(tree, random);
    std::fill(state.rates.begin(), state.rates.end(), 0.0);
    TreeMotion motion(mechanism, tree);
    motion.place(state);
    motion.weigh();
    const std::vector<Vec6> none(tree.bodies().size(), Vec6::Zero());
    std::vector<double> forces(state.rates.size());
    motion.inverseDynamics(state.rates, state.rates, kGravity, none, forces);
    for (std::size_t rate = 0; rate < forces.size(); ++rate) {
        state.rates[rate] = 1.0;
        const auto height = [&](double time) {
            return mechanism.centerOfMass(posesAfter(mechanism, tree, state, time)).z();
        };
        const double slope =
            mechanism.mass() * kGravity * (height(kStep) - height(-kStep)) / (2.0 * kStep);
        state.rates[rate] = 0.0;
        EXPECT_NEAR(forces[rate], slope, 1e-5) << "rate " << rate;
    }
}

// Independent rates drive, dependent ones follow: bodies on both sides of every left-over joint
// move as the joint lets them, and after a step along them all loops close again.
TEST_P(TreeTest, LoopsStayClosedAlongIndependentRates) {
    Random random(11);
    LoopClosures loops(mechanism, tree, GetParam().second);
    TreeState state = tree.drawnState();
    TreeMotion motion(mechanism, tree);
    loops.reset(state, motion);
    EXPECT_LT(loops.gap(), 1e-10) << "drawn closed";
    std::vector<double> independent(static_cast<std::size_t>(loops.independentCount()));
    for (int trial = 0; trial < 20; ++trial) {
        for (double& rate : independent) {
            rate = random.uniform(-1.0, 1.0);
        }
        std::vector<double> change(static_cast<std::size_t>(tree.rateCount()), 0.0);
        for (int rate = 0; rate < tree.rateCount(); ++rate) {
            for (const RateTerm& term : loops.terms(rate)) {
                change[static_cast<std::size_t>(rate)] +=
                    1e-4 * term.factor * independent[static_cast<std::size_t>(term.index)];
            }
        }
        // Along the rates loops open in second order only: there is next to nothing to correct.
        TreeState moved = state;
        advance(tree, moved, change);
        motion.place(moved);
        const std::vector<Pose> uncorrected = motion.poses();
        const int choice = loops.choice();
        ASSERT_TRUE(loops.close(moved, motion));
        EXPECT_LT(loops.gap(), 1e-8);
        for (std::size_t i = 0; i < uncorrected.size(); ++i) {
            EXPECT_LT((motion.poses()[i].position - uncorrected[i].position).norm(), 1e-6);
        }
        state = moved;
        EXPECT_EQ(loops.choice(), choice) << "no reason to choose again";
    }
}

// A gear with one pin between bodies that do not move holds the other pin.
TEST(LoopClosuresTest, GearOnAFixedPinHoldsTheOther) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 1.0, Vec3::Zero()), makeBody("still", 1.0, Vec3::Zero()),
                        makeBody("arm", 1.0, Vec3::UnitX()), makeBody("swing", 1.0, Vec3::UnitX())};
    mechanism.bodies[0].fixed = mechanism.bodies[1].fixed = true;
    mechanism.joints = {makePin("stuck", 0, 1, Vec3::Zero()), makePin("held", 0, 2, Vec3::Zero()),
                        makePin("free", 0, 3, Vec3::Zero())};
    mechanism.gears = {{"gear", 0, 1, 2.0}};
    const auto engine = makeReducedEngine(mechanism, {});
    for (int i = 0; i < 100; ++i) {
        engine->step({});
    }
    EXPECT_LT((engine->poses()[2] * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-9);
    ASSERT_EQ(engine->counters().warnings.size(), 1U);
    EXPECT_EQ(engine->counters().warnings[0], "the loop of joints held cannot move");
}

// Without anything that moves there is nothing to simulate; the loops that hold it are named.
TEST(LoopClosuresTest, ImmovableMechanismIsRefusedWithItsLoop) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 1.0, Vec3::Zero()),
                        makeBody("left", 1.0, {0.0, 0.0, 0.5}),
                        makeBody("right", 1.0, {0.5, 0.0, 0.5})};
    mechanism.bodies[0].fixed = true;
    mechanism.joints = {makePin("foot", 0, 1, Vec3::Zero()), makePin("toe", 0, 2, Vec3::UnitX()),
                        makePin("top", 1, 2, {0.5, 0.0, 1.0})};
    const Problems problems = whyReducedCannotRun(mechanism);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_NE(toString(problems).find("the loop of joints foot, toe, top holds its bodies"),
              std::string::npos)
        << toString(problems);
    EXPECT_THROW(makeReducedEngine(mechanism, {}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Rovers, TreeTest,
                         testing::Values(std::pair("solero", Model::Built),
                                         std::pair("solero", Model::Relaxed),
                                         std::pair("rocker_bogie", Model::Built),
                                         std::pair("rocker_bogie_bar", Model::Built)),
                         [](const auto& test) {
                             return std::string(test.param.first) +
                                    (test.param.second == Model::Built ? "_built" : "_relaxed");
                         });
