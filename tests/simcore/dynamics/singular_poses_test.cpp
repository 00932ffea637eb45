// Loops that pass a pose in which all their bars lie in line, or nearly so: joints do no work, so
// energy must be kept, or the engine must say that it could not.
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/dynamics/engine.h"
#include "simcore/run/simulation.h"
#include "tests/support/carts.h"
#include "tests/support/engine_cases.h"
#include "tests/support/linkages.h"

namespace {

using namespace simcore;
using namespace testsupport;

constexpr double kStep = 0.002;
constexpr double kTime = 10.0;

/// A parallelogram of a fixed frame, whose crank starts upright, by how much its coupler is too
/// long for its frame.
struct Parallelogram {
    double longer = 0.0;

    Mechanism make() const {
        FourBar bars;
        bars.ground = 0.30;
        bars.crank = 0.10;
        bars.follower = 0.10;
        bars.coupler = 0.30 + longer;
        return bars.make(std::numbers::pi / 2.0);
    }
};

/// Kinetic energy of all bodies that move [J].
double kineticEnergy(const Mechanism& mechanism, const dynamics::Engine& engine) {
    double energy = 0.0;
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const mechanism::Body& body = mechanism.bodies[i];
        const Mat3 turn = engine.poses()[i].rotation.toRotationMatrix();
        const dynamics::BodyVelocity& v = engine.velocities()[i];
        energy += body.fixed
                      ? 0.0
                      : 0.5 * body.mass * v.linear.squaredNorm() +
                            0.5 * v.angular.dot(turn * body.inertia * turn.transpose() * v.angular);
    }
    return energy;
}

struct Passage {
    double energyStart = 0.0;  ///< [J]
    double energyWorst = 0.0;  ///< furthest from it [J]
    double turned = 0.0;       ///< by the crank, to and fro [rad]
    double gap = 0.0;          ///< of any joint [m]
    std::string trouble;
    dynamics::EngineCounters counters;
};

/// Lets the crank be turned up to 3 rad/s by a motor, then go on by itself without weight.
Passage spin(const Mechanism& mechanism, double step = kStep) {
    const auto engine = dynamics::makeReducedEngine(mechanism, {step, 0.0});
    const dynamics::JointMotor motor{0, 3.0, 100.0};
    engine->step({{}, {}, {}, {}, {&motor, 1}});
    engine->step({});
    Passage passage;
    passage.energyStart = passage.energyWorst = kineticEnergy(mechanism, *engine);
    const int steps = static_cast<int>(kTime / step);
    for (int i = 0; i < steps && passage.trouble.empty(); ++i) {
        engine->step({});
        const double energy = kineticEnergy(mechanism, *engine);
        passage.trouble = engine->trouble();
        if (!passage.trouble.empty()) {
            break;
        }
        if (std::abs(energy - passage.energyStart) >
            std::abs(passage.energyWorst - passage.energyStart)) {
            passage.energyWorst = energy;
        }
        passage.turned += step * std::abs(dynamics::jointRate(mechanism.joints[0], engine->poses(),
                                                              engine->velocities()));
        passage.gap = std::max(passage.gap, dynamics::loopError(mechanism, engine->poses()));
    }
    passage.counters = engine->counters();
    return passage;
}

class ChangePointTest : public ::testing::TestWithParam<double> {};

// By how much the coupler is longer than the frame: equal bars have a change point, others pass
// next to one, the nearer the faster.
INSTANTIATE_TEST_SUITE_P(Lengths, ChangePointTest,
                         ::testing::Values(0.0, 0.0001, 0.001, 0.01, -0.001, -0.01),
                         [](const auto& param) {
                             return (param.param < 0.0 ? "Shorter" : "Longer") +
                                    std::to_string(static_cast<int>(1e6 * std::abs(param.param)));
                         });

TEST_P(ChangePointTest, KeepsEnergyOrSaysThatItCannot) {
    const Mechanism mechanism = Parallelogram{GetParam()}.make();
    const Passage passage = spin(mechanism);
    EXPECT_LT(passage.gap, 1e-6);
    EXPECT_NEAR(passage.energyWorst, passage.energyStart, 0.01 * passage.energyStart)
        << "trouble: " << passage.trouble << ", divided steps: " << passage.counters.dividedSteps
        << ", pivot ratio " << passage.counters.leastPivotRatio;
    if (passage.trouble.empty()) {
        EXPECT_GT(passage.turned, 10.0) << "it did not come to the change point";
    } else {
        EXPECT_NE(passage.trouble.find("the loop of joints a, b, c, d"), std::string::npos)
            << passage.trouble;
    }
}

/// Four bars of some millimetres.
FourBar smallBars() {
    FourBar bars;
    bars.ground = 0.0030;
    bars.crank = 0.0010;
    bars.coupler = 0.0028;
    bars.follower = 0.0022;
    return bars;
}

// A crank thrown on by many turns in one step, however short its parts, leads to no pose at which
// the loop closes. The engine says so and does not pretend. From its start it goes on as ever.
TEST(OpenLoopTest, StepThatCannotBeClosedIsTrouble) {
    const Mechanism mechanism = smallBars().make(1.0);
    const auto engine = dynamics::makeReducedEngine(mechanism, {0.02, 0.0});
    const dynamics::JointMotor thrown{0, 5e4, 1e12};
    engine->step({{}, {}, {}, {}, {&thrown, 1}});
    EXPECT_EQ(engine->trouble(), "the loop of joints a, b, c, d cannot be closed");
    EXPECT_GT(engine->counters().dividedSteps, 0);
    engine->reset();
    EXPECT_EQ(engine->trouble(), "");
    const dynamics::JointMotor turned{0, 5.0, 1e12};
    for (int i = 0; i < 100; ++i) {
        engine->step({{}, {}, {}, {}, {&turned, 1}});
    }
    EXPECT_EQ(engine->trouble(), "");
    EXPECT_LT(dynamics::loopError(mechanism, engine->poses()), 1e-9);
}

// The run ends before that step, with the state that it started from.
TEST(OpenLoopTest, EndsTheRunAndNamesTheLoop) {
    Mechanism cart = makeCart();
    const Mechanism bars = smallBars().make(1.0);
    const int first = static_cast<int>(cart.bodies.size()) - 1;  // the frame is the chassis
    for (std::size_t i = 1; i < bars.bodies.size(); ++i) {
        cart.bodies.push_back(bars.bodies[i]);
        cart.bodies.back().inertia = 1e-6 * Mat3::Identity();
    }
    for (mechanism::Joint joint : bars.joints) {
        joint.first += joint.first > 0 ? first : 0;
        joint.second += first;
        cart.joints.push_back(joint);
    }
    mechanism::Spring thrower;
    thrower.joint = static_cast<int>(cart.joints.size() - bars.joints.size());
    thrower.first = cart.joints[static_cast<std::size_t>(thrower.joint)].first;
    thrower.second = cart.joints[static_cast<std::size_t>(thrower.joint)].second;
    thrower.preload = 10.0;  // [N m]
    cart.springs = {thrower};
    run::ResolvedRun settings = runOf(cart, levelGround());
    settings.engine = project::EngineKind::Reduced;
    settings.step = 0.02;
    run::Simulation simulation(settings);
    const run::RunReport report = runToEnd(simulation, 1.0);
    EXPECT_EQ(run::toString(report.stopReason), "singular-pose");
    EXPECT_EQ(report.stopDetail, "the loop of joints a, b, c, d cannot be closed");
    EXPECT_FALSE(report.completed);
    EXPECT_LT(dynamics::loopError(cart, simulation.snapshot().bodies), 1e-9);
}

// A joint has one place, which both its bodies take from the drawn pose: no change of a parameter
// can draw a loop that is open. Bars of any lengths that can be drawn start closed.
TEST(OpenLoopTest, NothingThatCanBeDrawnStartsOpen) {
    for (const double coupler : {0.03, 0.28, 0.41}) {  // 0.02 to 0.42 m can be drawn
        FourBar bars;
        bars.coupler = coupler;
        const Mechanism mechanism = bars.make(0.0);
        EXPECT_TRUE(dynamics::whyReducedCannotRun(mechanism).empty());
        const auto engine = dynamics::makeReducedEngine(mechanism, {kStep, 9.81});
        EXPECT_EQ(dynamics::loopError(mechanism, engine->poses()), 0.0);
        engine->step({});
        EXPECT_EQ(engine->trouble(), "");
        EXPECT_LT(dynamics::loopError(mechanism, engine->poses()), 1e-10);
    }
}

}  // namespace
