#include "simcore/experiment/verdict.h"

#include <gtest/gtest.h>

#include "simcore/experiment/comparison.h"
#include "tests/support/projects.h"

namespace simcore::experiment {
namespace {

Outcome ended(double slip, double energy, bool completed, double x, double y) {
    Outcome outcome;
    outcome.slipAbs = slip;
    outcome.slipLoaded = 0.5 * slip;
    outcome.energy = energy;
    outcome.completed = completed;
    outcome.endX = x;
    outcome.endY = y;
    return outcome;
}

TEST(VerdictTest, LessSlipWinsByMoreThanTheResolution) {
    const Verdict verdict =
        judge(ended(0.1, 9.0, true, 3.5, 0.0), ended(0.3, 6.0, true, 3.5, 0.03));
    EXPECT_TRUE(verdict.bothCompleted);
    EXPECT_TRUE(verdict.sameWay);
    EXPECT_NEAR(verdict.apart, 0.03, 1e-12);
    EXPECT_EQ(verdict.slip.less, Less::First);
    EXPECT_NEAR(verdict.slip.ratio, 3.0, 1e-12);
    EXPECT_EQ(verdict.energy.less, Less::Second);
    EXPECT_NEAR(verdict.energy.ratio, 2.0 / 3.0, 1e-12);
    EXPECT_EQ(
        judge(ended(0.1, 1.0, true, 0, 0), ended(0.1 + 0.9 * kSlipResolution, 1.0, true, 0, 0))
            .slip.less,
        Less::Neither);
}

TEST(VerdictTest, AnotherWayOrAFailureIsNoPair) {
    EXPECT_FALSE(
        judge(ended(0.1, 1.0, true, 3.5, 0.0), ended(0.2, 1.0, true, 3.5, kSameEnd)).sameWay);
    const Verdict failed = judge(ended(0.1, 1.0, false, 1.0, 0.0), ended(0.2, 1.0, true, 3.5, 0.0));
    EXPECT_FALSE(failed.bothCompleted);
    EXPECT_FALSE(failed.sameWay);
    EXPECT_EQ(failed.failed, Less::First);
    EXPECT_EQ(judge(ended(0.1, 1.0, false, 1, 0), ended(0.2, 1.0, false, 1, 0)).failed,
              Less::Neither);
}

// Held against a plain run of each.
TEST(VerdictTest, DrivesTheScenarioWithEachController) {
    const auto project = testsupport::shipped("solero");
    run::RunRequest request;
    request.scenario = "flat";
    request.duration = 1.5;
    request.engine = project::EngineKind::Reduced;
    const auto outcomes = driveEach(
        project, request, {project::ControllerKind::Torque, project::ControllerKind::Speed});
    ASSERT_TRUE(outcomes) << toString(outcomes.problems());
    ASSERT_EQ(outcomes->size(), 2U);
    for (const Outcome& outcome : *outcomes) {
        request.controller = outcome.ran.controller;
        run::Simulation simulation(run::prepareRun(project, request).value());
        while (!simulation.finished()) {
            simulation.step();
        }
        EXPECT_EQ(outcome.stateHash, simulation.report().stateHash);
        EXPECT_EQ(outcome.energy, simulation.report().energy);
        EXPECT_TRUE(outcome.completed);
        EXPECT_NEAR(outcome.time, 1.5, 1e-9);
        EXPECT_EQ(outcome.endX, simulation.snapshot().bodies[0].position.x());
    }
    request.scenario = "nowhere";
    EXPECT_FALSE(driveEach(project, request, {project::ControllerKind::Speed}));
}

}  // namespace
}  // namespace simcore::experiment
