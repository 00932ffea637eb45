// Runs in which a chassis meets the ground.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/carts.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;
using testing::HasSubstr;

namespace {

constexpr double kClearance = 0.06;  // under the chassis [m]

Mechanism cartWithBelly() {
    Mechanism cart = makeCart();
    mechanism::Shape shape;
    shape.size = {0.34, 0.26, 0.06};
    shape.center = {0.0, 0.0, kClearance + 0.5 * shape.size.z()};
    cart.bodies[0].shapes = {shape};
    return cart;
}

/// Level ground with a ridge between the wheels, which rises to twice the clearance.
terrain::Terrain groundWithRidge() {
    constexpr double kCell = 0.02;
    constexpr int kNx = 201;
    constexpr int kNy = 101;
    std::vector<double> heights;
    for (int ix = 0; ix < kNx; ++ix) {
        for (int iy = 0; iy < kNy; ++iy) {
            const double x = -1.0 + kCell * ix;
            const double y = -1.0 + kCell * iy;
            const double rise = std::clamp(0.15 * (x - 0.3), 0.0, 2.0 * kClearance);
            heights.push_back(std::abs(y) < 0.11 ? rise : 0.0);
        }
    }
    return terrain::Terrain::grid(-1.0, -1.0, kCell, kNx, kNy, heights);
}

ResolvedRun onTheRidge(project::EngineKind engine, bool bodyContacts) {
    ResolvedRun run = runOf(cartWithBelly(), groundWithRidge());
    run.engine = engine;
    run.bodyContacts = bodyContacts;
    run.friction = 0.6;
    run.rollingResistance = 0.0;
    run.speed = 0.15;
    run.distance = 1.6;
    return run;
}

}  // namespace

class BodyContactRunTest : public testing::TestWithParam<project::EngineKind> {};

INSTANTIATE_TEST_SUITE_P(Engines, BodyContactRunTest,
                         testing::Values(project::EngineKind::Ode, project::EngineKind::Reduced),
                         [](const auto& engine) {
                             return engine.param == project::EngineKind::Ode ? "Ode" : "Reduced";
                         });

// The chassis runs onto the ridge and lifts the wheels until they cannot push it further. At rest
// wheels and belly carry the weight together.
TEST_P(BodyContactRunTest, ABellyThatRunsAgroundHoldsTheRover) {
    dynamics::Engine* engine = nullptr;
    const dynamics::EngineMaker real = GetParam() == project::EngineKind::Ode
                                           ? dynamics::makeOdeEngine
                                           : dynamics::makeReducedEngine;
    ResolvedRun run = onTheRidge(GetParam(), true);
    run.duration = 12.0;
    Simulation simulation(run, [&](const auto& mechanism, const auto& settings) {
        auto made = real(mechanism, settings);
        engine = made.get();
        return made;
    });
    const double weight = run.mechanism.mass() * dynamics::kGravity;
    double mean = 0.0;
    int counted = 0;
    while (!simulation.finished()) {
        simulation.step();
        if (simulation.snapshot().time > 11.0) {
            for (const Vec3& force : engine->contactForces()) {
                mean += force.z();
            }
            ++counted;
        }
    }
    ASSERT_GT(counted, 0);
    const RunReport report = simulation.report();
    EXPECT_LT(report.distance, 1.0) << "held by the ridge";
    EXPECT_NEAR(mean / counted, weight, 0.01 * weight);
    double wheels = 0.0;
    for (const WheelState& wheel : simulation.snapshot().wheels) {
        wheels += wheel.force.z();
    }
    EXPECT_LT(wheels, 0.9 * weight) << "the belly carries its share";
    ASSERT_EQ(report.bodies.size(), 1U);
    EXPECT_EQ(report.bodies[0].name, "chassis");
    EXPECT_GT(report.bodies[0].contactTime, 4.0);
    EXPECT_LT(report.bodies[0].contactTime, report.simTime);
    EXPECT_GT(report.bodies[0].maxForce, 0.1 * weight);
    EXPECT_TRUE(engine->velocities()[0].linear.norm() < 0.02);
}

TEST_P(BodyContactRunTest, WithoutBodyContactsItPassesThrough) {
    const RunReport report = reportOf(onTheRidge(GetParam(), false));
    EXPECT_EQ(report.stopReason, StopReason::Completed);
    EXPECT_TRUE(report.bodies.empty());
    EXPECT_LT(report.penetrationMax, 0.001) << "wheels only";
}

// What no body touches is the same run, bit for bit.
TEST_P(BodyContactRunTest, WhereNothingTouchesTheSwitchChangesNothing) {
    std::string hash;
    for (const bool on : {true, false}) {
        ResolvedRun run = runOf(cartWithBelly(), levelGround());
        run.engine = GetParam();
        run.bodyContacts = on;
        run.duration = 1.0;
        const RunReport report = reportOf(run);
        EXPECT_TRUE(report.bodies.empty());
        EXPECT_TRUE(hash.empty() || hash == report.stateHash);
        hash = report.stateHash;
    }
}

// Wheels are measured by their own contacts alone.
TEST_P(BodyContactRunTest, ABellyOnTheGroundIsNoWheel) {
    Mechanism cart = cartWithBelly();
    // A keel under the chassis that just touches level ground.
    mechanism::Shape keel;
    keel.size = {0.1, 0.1, kClearance + 1e-4};
    keel.center = {0.0, 0.0, 0.5 * keel.size.z() - 1e-4};
    cart.bodies[0].shapes.push_back(keel);
    ResolvedRun run = runOf(cart, levelGround());
    run.engine = GetParam();
    run.speed = 0.0;
    run.duration = 1.0;
    dynamics::Engine* engine = nullptr;
    Simulation simulation(run, [&](const auto& mechanism, const auto& settings) {
        auto made = GetParam() == project::EngineKind::Ode
                        ? dynamics::makeOdeEngine(mechanism, settings)
                        : dynamics::makeReducedEngine(mechanism, settings);
        engine = made.get();
        return made;
    });
    runToEnd(simulation);
    double all = 0.0;
    for (const Vec3& force : engine->contactForces()) {
        all += force.z();
    }
    double wheels = 0.0;
    for (const WheelState& wheel : simulation.snapshot().wheels) {
        wheels += wheel.force.z();
    }
    const double weight = run.mechanism.mass() * dynamics::kGravity;
    EXPECT_NEAR(all, weight, 0.01 * weight);
    EXPECT_LT(wheels, 0.98 * weight);
    ASSERT_EQ(simulation.report().bodies.size(), 1U);
}

TEST(BodyContactStartTest, ABodyThatStartsDeepInTheGroundIsAProblem) {
    project::Project project = shipped("solero");
    RunRequest request;
    request.scenario = "flat";
    ASSERT_TRUE(prepareRun(project, request));
    const auto lowered = [&](double depth) {
        project::Project changed = project;
        project::Shape keel;
        keel.size = {0.1, 0.1, 0.1};
        keel.center = {0.0, 0.0, 0.05 - depth};
        changed.rover.bodies[0].shapes.push_back(keel);
        return changed;
    };
    EXPECT_TRUE(prepareRun(lowered(0.004), request));
    // 80 mm is deeper than any contact of a run.
    for (const double depth : {0.006, 0.08}) {
        const auto deep = prepareRun(lowered(depth), request);
        ASSERT_FALSE(deep);
        EXPECT_THAT(toString(deep.problems()), HasSubstr("body chassis"));
        EXPECT_THAT(toString(deep.problems()), HasSubstr("deep in the ground"));
        project::Project off = lowered(depth);
        for (project::Scenario& scenario : off.scenarios) {
            scenario.run.bodyContacts = false;
        }
        EXPECT_TRUE(prepareRun(off, request));
    }
}

TEST(BodyContactStartTest, ShippedRoversStartAboveTheGround) {
    for (const std::string& name : shippedNames()) {
        const project::Project project = shipped(name);
        for (const project::Scenario& scenario : project.scenarios) {
            RunRequest request;
            request.scenario = scenario.name;
            request.files = shippedFile(name).parent_path();
            const auto run = prepareRun(project, request);
            EXPECT_TRUE(run) << name << " " << scenario.name << ": " << toString(run.problems());
        }
    }
}
