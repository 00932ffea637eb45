#include "simcore/experiment/experiment.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simcore/experiment/ground_statics.h"
#include "simcore/io/experiment_json.h"
#include "simcore/run/simulation.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::experiment;
using project::ControllerKind;

namespace {

Plan shortPlan(TerrainSet set) {
    Plan plan;
    plan.set = set;
    plan.frictions = {0.7};
    plan.controllers = {ControllerKind::Speed, ControllerKind::EqualTorque};
    plan.distance = 0.3;
    return plan;
}

}  // namespace

TEST(TerrainSetTest, SeedsMakeOneGroundEach) {
    for (const TerrainSet set : {TerrainSet::Profiles, TerrainSet::Terrains}) {
        EXPECT_EQ(terrainOf(set, 3, 0.07), terrainOf(set, 3, 0.07));
        EXPECT_NE(terrainOf(set, 3, 0.07), terrainOf(set, 4, 0.07));
    }
}

TEST(TerrainSetTest, ProfilesAreMildForOddSeeds) {
    EXPECT_EQ(terrainOf(TerrainSet::Profiles, 1, 0.07).height, project::Quantity(0.035));
    EXPECT_EQ(terrainOf(TerrainSet::Profiles, 2, 0.07).height, project::Quantity(0.07));
}

TEST(PlanTest, CasesCoverEverything) {
    Plan plan = shortPlan(TerrainSet::Profiles);
    plan.lastSeed = 3;
    plan.frictions = {0.3, 0.5};
    const auto cases = casesOf(plan);
    ASSERT_TRUE(cases);
    EXPECT_EQ(cases->size(), 3U * 2U * 2U);
}

TEST(PlanTest, WhatCannotBeDrivenIsRefused) {
    for (const auto& spoil :
         {+[](Plan& plan) { plan.lastSeed = 0; }, +[](Plan& plan) { plan.frictions = {}; },
          +[](Plan& plan) { plan.frictions = {0.0}; }, +[](Plan& plan) { plan.controllers = {}; },
          +[](Plan& plan) { plan.controllers.push_back(ControllerKind::Manual); }}) {
        Plan plan = shortPlan(TerrainSet::Profiles);
        spoil(plan);
        EXPECT_FALSE(casesOf(plan));
    }
}

// The same numbers as the run itself gives.
TEST(ExperimentTest, DrivesAsARunDoes) {
    const project::Project solero = testsupport::shipped("solero");
    const Plan plan = shortPlan(TerrainSet::Terrains);
    const Case what{2, 0.7, ControllerKind::EqualTorque};
    const Outcome outcome = drive(solero, plan, what);
    ASSERT_TRUE(outcome.completed) << outcome.stopReason;
    EXPECT_GE(outcome.endX, 0.3);

    const auto own = projectOf(solero, plan, what);
    ASSERT_TRUE(own);
    run::RunRequest request;
    request.scenario = own->scenarios.front().name;
    auto prepared = run::prepareRun(*own, request);
    ASSERT_TRUE(prepared);
    run::Simulation simulation(std::move(prepared).value());
    while (!simulation.finished()) {
        simulation.step();
    }
    EXPECT_EQ(outcome.slipAbs, simulation.report().slipAbs);
    EXPECT_EQ(outcome.stateHash, simulation.report().stateHash);
}

TEST(ExperimentTest, ARoverWithoutWheelsIsAnOutcomeToo) {
    const Outcome outcome = drive(project::Project{}, shortPlan(TerrainSet::Profiles), {});
    EXPECT_FALSE(outcome.completed);
    EXPECT_FALSE(outcome.stopReason.empty());
}

// Lines between processes and in journals lose nothing.
TEST(ExperimentJsonTest, LinesReadBack) {
    Outcome outcome;
    outcome.ran = {12, 0.35, ControllerKind::EqualTorque};
    outcome.completed = true;
    outcome.stopReason = "completed, \"so\"\nit is";
    outcome.slipAbs = 0.1 + 0.2;
    outcome.endY = -1e-17;
    outcome.staticFriction = 0.4321;
    outcome.stateHash = "00ff";
    const std::string line = io::formatOutcome(outcome);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const auto back = io::parseOutcome(line);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->ran, outcome.ran);
    EXPECT_EQ(back->stopReason, outcome.stopReason);
    EXPECT_EQ(back->slipAbs, outcome.slipAbs);
    EXPECT_EQ(back->endY, outcome.endY);
    EXPECT_EQ(back->staticFriction, outcome.staticFriction);
    EXPECT_EQ(io::parseCase(io::formatCase(outcome.ran)), outcome.ran);

    const Plan plan = shortPlan(TerrainSet::Terrains);
    const project::Project solero = testsupport::shipped("solero");
    const auto parsed = io::parsePlan(io::formatPlan(plan, solero));
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->plan, plan);
    EXPECT_EQ(parsed->project, solero);
}

TEST(ExperimentJsonTest, OtherTextIsNone) {
    for (const char* text : {"", "{}", "[1]", "{\"seed\": 1}", "{\"seed\": \"a\", \"mu\": 1}",
                             "{\"seed\": 1, \"mu\": 0.5, \"controller\": \"none\"}"}) {
        EXPECT_FALSE(io::parseCase(text)) << text;
        EXPECT_FALSE(io::parseOutcome(text)) << text;
        EXPECT_FALSE(io::parsePlan(text)) << text;
    }
}

// A profile of seed 2 has steps up to a radius; the full terrain rolls, too.
TEST(GroundStaticsTest, EveryGroundAsksForSomeFriction) {
    const project::Project solero = testsupport::shipped("solero");
    for (const TerrainSet set : {TerrainSet::Profiles, TerrainSet::Terrains}) {
        Plan plan = shortPlan(set);
        plan.distance = 3.5;
        GroundStatics statics;
        const double required = statics.frictionRequired(solero, plan, 2);
        EXPECT_GT(required, 0.05);
        EXPECT_LT(required, 1.5);
        EXPECT_EQ(statics.frictionRequired(solero, plan, 2), required);
    }
    EXPECT_TRUE(std::isnan(
        GroundStatics().frictionRequired(project::Project{}, shortPlan(TerrainSet::Profiles), 1)));
}

TEST(SensorNoiseTest, IsNoneWithoutAndGrowsWithItsFactor) {
    EXPECT_EQ(sensorsWithNoise(0.0), project::Sensors{});
    EXPECT_EQ(sensorsWithNoise(2.0).tactileForce.noise, project::Quantity(1.0));
}
