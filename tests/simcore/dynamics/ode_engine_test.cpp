#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/dynamics/engine.h"
#include "tests/support/mechanisms.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

constexpr double kStep = 0.001;

void run(Engine& engine, double seconds, double step = kStep) {
    const long steps = std::lround(seconds / step);
    for (long i = 0; i < steps; ++i) {
        engine.step({});
    }
}

Vec3 linearMomentum(const Mechanism& mechanism, const Engine& engine) {
    Vec3 p = Vec3::Zero();
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        p += mechanism.bodies[i].mass * engine.velocities()[i].linear;
    }
    return p;
}

/// Sets linear and angular velocities through the state, which is 13 numbers a body.
void setVelocity(Engine& engine, std::size_t body, const Vec3& linear, const Vec3& angular) {
    std::vector<double> state = engine.saveState();
    for (int k = 0; k < 3; ++k) {
        state[body * 13 + 7 + static_cast<std::size_t>(k)] = linear[k];
        state[body * 13 + 10 + static_cast<std::size_t>(k)] = angular[k];
    }
    engine.restoreState(state);
}

}  // namespace

// A body in free fall is at -g t^2 / 2; semi-implicit Euler is off by g t dt / 2.
TEST(OdeEngineTest, BodyFallsFreely) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("stone", 2.0, {0.1, 0.2, 5.0})};
    const auto engine = makeOdeEngine(mechanism, {kStep, 9.81});
    run(*engine, 0.5);
    EXPECT_NEAR(engine->poses()[0].position.z(), -0.5 * 9.81 * 0.25, 9.81 * 0.5 * kStep);
    EXPECT_NEAR(engine->velocities()[0].linear.z(), -9.81 * 0.5, 1e-9);
}

// A torsion spring on a very heavy frame: period 2 pi sqrt(I / k) about the angle preload / k.
TEST(OdeEngineTest, TorsionPendulumHasItsPeriod) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 1e5, Vec3::Zero(), {1e5, 1e5, 1e5}),
                        makeBody("bob", 1.0, Vec3::Zero(), {0.02, 0.02, 0.02})};
    mechanism.joints = {makePin("pin", 0, 1, Vec3::Zero())};
    simcore::mechanism::Spring spring;
    spring.joint = 0;
    spring.first = 0;
    spring.second = 1;
    spring.stiffness = 0.8;
    spring.preload = 0.08;  // equilibrium at 0.1 rad
    mechanism.springs = {spring};
    const auto engine = makeOdeEngine(mechanism, {kStep, 0.0});
    const double period = 2.0 * std::numbers::pi * std::sqrt(0.02 / 0.8);
    run(*engine, period / 2.0);
    EXPECT_NEAR(jointAngle(mechanism.joints[0], engine->poses()), 0.2, 1e-4);
    run(*engine, period / 2.0);
    EXPECT_NEAR(jointAngle(mechanism.joints[0], engine->poses()), 0.0, 1e-3);
}

TEST(OdeEngineTest, StopsHoldTheTurnOfTheSecondBody) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 1e4, Vec3::Zero(), {1e4, 1e4, 1e4}),
                        makeBody("arm", 1.0, Vec3::Zero(), {0.02, 0.02, 0.02})};
    for (const bool swapped : {false, true}) {
        mechanism.joints = {swapped ? makePin("pin", 1, 0, Vec3::Zero())
                                    : makePin("pin", 0, 1, Vec3::Zero())};
        mechanism.joints[0].stops = {-0.2, 0.5};
        for (const double spin : {1.0, -1.0}) {
            const auto engine = makeOdeEngine(mechanism, {kStep, 0.0});
            setVelocity(*engine, 1, Vec3::Zero(), {0.0, spin, 0.0});
            double reached = 0.0;
            for (int i = 0; i < 800; ++i) {
                engine->step({});
                const double angle = jointAngle(mechanism.joints[0], engine->poses());
                reached = std::abs(angle) > std::abs(reached) ? angle : reached;
            }
            const bool forward = (spin > 0.0) != swapped;
            EXPECT_NEAR(reached, forward ? 0.5 : -0.2, 2e-3);
        }
    }
}

// turn(second) = ratio * turn(first), whatever the carrier does.
TEST(OdeEngineTest, GearHoldsItsRatio) {
    for (const double ratio : {-1.0, 1.0, -2.0, 0.5}) {
        const Mechanism mechanism = makeDifferential(ratio);
        const auto engine = makeOdeEngine(mechanism, {kStep, 0.0});
        setVelocity(*engine, 1, Vec3::Zero(), {0.2, 1.5, -0.1});
        setVelocity(*engine, 0, {0.1, 0.0, 0.0}, {0.3, 0.2, 0.4});
        double largest = 0.0;
        for (int i = 0; i < 600; ++i) {
            engine->step({});
            const double left = jointAngle(mechanism.joints[0], engine->poses());
            const double right = jointAngle(mechanism.joints[1], engine->poses());
            ASSERT_NEAR(right, ratio * left, 1e-4) << "ratio " << ratio << " step " << i;
            largest = std::max(largest, std::abs(left));
        }
        EXPECT_GT(largest, 0.1) << "the gear jams at ratio " << ratio;
    }
}

// A gear is internal: it must not push the mechanism as a whole.
TEST(OdeEngineTest, FreeMechanismKeepsItsMomentum) {
    for (const Mechanism& mechanism : {makeDifferential(-1.0), makeFourBar()}) {
        const auto engine = makeOdeEngine(mechanism, {kStep, 0.0});
        setVelocity(*engine, 0, {0.1, -0.2, 0.05}, {0.3, 0.8, 0.4});
        engine->step({});
        const Vec3 start = linearMomentum(mechanism, *engine);
        run(*engine, 1.0);
        EXPECT_LT((linearMomentum(mechanism, *engine) - start).norm(), 1e-2 * start.norm() + 1e-6)
            << mechanism.name;
    }
}

TEST(OdeEngineTest, FourBarStaysClosed) {
    const Mechanism mechanism = makeFourBar();
    const auto engine = makeOdeEngine(mechanism, {kStep, 9.81});
    setVelocity(*engine, 1, Vec3::Zero(), {0.0, 2.0, 0.0});
    double worst = 0.0;
    double swing = 0.0;
    for (int i = 0; i < 1000; ++i) {
        engine->step({});
        worst = std::max(worst, loopError(mechanism, engine->poses()));
        swing = std::max(swing, std::abs(jointAngle(mechanism.joints[0], engine->poses())));
    }
    EXPECT_GT(swing, 0.05);
    EXPECT_LT(worst, 1e-5);
}

TEST(OdeEngineTest, RestoredStateContinuesBitForBit) {
    const Mechanism mechanism = makeDifferential(-1.0);
    const auto engine = makeOdeEngine(mechanism, {kStep, 9.81});
    setVelocity(*engine, 1, Vec3::Zero(), {0.2, 1.5, -0.1});
    run(*engine, 0.2);
    const std::vector<double> saved = engine->saveState();
    run(*engine, 0.2);
    const std::vector<double> straight = engine->saveState();
    engine->restoreState(saved);
    run(*engine, 0.2);
    EXPECT_EQ(engine->saveState(), straight);
    const auto other = makeOdeEngine(mechanism, {kStep, 9.81});
    other->restoreState(saved);
    run(*other, 0.2);
    EXPECT_EQ(other->saveState(), straight);
}

// A gear needs a body that both its pins turn in.
TEST(OdeEngineTest, RefusesAGearWithoutACarrier) {
    Mechanism mechanism = makeFourBar();
    Gear gear;
    gear.name = "far";
    gear.firstJoint = 0;   // chassis - crank
    gear.secondJoint = 2;  // coupler - follower
    mechanism.gears = {gear};
    const Problems problems = whyOdeCannotRun(mechanism);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].element, "gear far");
    EXPECT_THROW((void)makeOdeEngine(mechanism, {}), std::invalid_argument);
}
