#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;

namespace {

project::Project solero(const project::Soil& soil) {
    project::Project project = shipped("solero");
    for (project::Scenario& scenario : project.scenarios) {
        scenario.soil = soil;
    }
    return project;
}

/// Drives on flat ground for the time given.
std::unique_ptr<Simulation> driven(const project::Soil& soil, double duration) {
    RunRequest request;
    request.scenario = "flat";
    request.duration = duration;
    auto run = prepareRun(solero(soil), request);
    EXPECT_TRUE(run) << toString(run.problems());
    auto simulation = std::make_unique<Simulation>(std::move(run).value());
    while (!simulation->finished()) {
        simulation->step();
    }
    return simulation;
}

project::SoilRegion region(double xMin, double xMax, double yMin, double yMax, double friction,
                           double rolling) {
    return {{xMin, xMax}, {yMin, yMax}, friction, rolling};
}

}  // namespace

TEST(GroundRegionsTest, TheLastRegionThatHoldsAPointCounts) {
    project::ScenarioValues values;
    values.friction = 0.7;
    values.rollingResistance = 0.01;
    project::GroundRegion wide;
    wide.friction = 0.3;
    wide.xMin = 1.0;
    wide.xMax = 2.0;
    wide.yMin = -5.0;
    wide.yMax = 5.0;
    project::GroundRegion narrow = wide;
    narrow.friction = 0.1;
    narrow.rollingResistance = 0.2;
    narrow.yMin = 0.0;
    values.regions = {wide, narrow};
    EXPECT_EQ(groundAt(values, 0.99, 0.0).friction, 0.7);
    EXPECT_EQ(groundAt(values, 0.99, 0.0).rollingResistance, 0.01);
    EXPECT_EQ(groundAt(values, 1.0, -0.1).friction, 0.3);
    EXPECT_EQ(groundAt(values, 2.0, 0.0).friction, 0.1);
    EXPECT_EQ(groundAt(values, 2.0, 0.0).rollingResistance, 0.2);
}

TEST(GroundRegionsTest, ARegionOverEverythingIsTheSoilItself) {
    project::Soil base;
    base.friction = 0.4;
    base.rollingResistance = 0.03;
    project::Soil covered;
    covered.regions = {region(-100, 100, -100, 100, 0.4, 0.03)};
    EXPECT_EQ(driven(base, 2.5)->report().stateHash, driven(covered, 2.5)->report().stateHash);
}

TEST(GroundRegionsTest, WheelsSpinOnIceAlone) {
    project::Soil ice;
    ice.regions = {region(-100, 100, -100, 100, 0.0, 0.0)};
    const RunReport spinning = driven(ice, 3.0)->report();
    EXPECT_LT(std::abs(spinning.distance), 1e-3);
    // Six rims at 0.1 m/s for the 2 s after settling and ramp.
    EXPECT_NEAR(spinning.slipAbs, 6.0 * 0.1 * 2.0, 0.1);
    project::Soil thawed;
    thawed.friction = 0.0;
    thawed.regions = {region(-100, 100, -100, 100, 0.7, 0.1)};
    const RunReport rolling = driven(thawed, 3.0)->report();
    EXPECT_GT(rolling.distance, 0.2);
    EXPECT_LT(rolling.frictionViolationPercent, 1.0) << "measured with the region's friction";
}

// Rolling steadily, the motors do the work of rolling resistance: sum tau = R sum c N.
TEST(GroundRegionsTest, MotorsOvercomeTheResistanceOfTheirGround) {
    constexpr double kC = 0.1;
    project::Soil soil;
    soil.regions = {region(-100, 100, -100, 0, 0.7, kC)};
    const auto simulation = driven(soil, 4.0);
    const Snapshot& now = simulation->snapshot();
    double torque = 0.0;
    double resistance = 0.0;
    for (std::size_t i = 0; i < now.wheels.size(); ++i) {
        const mechanism::Wheel& wheel = simulation->settings().mechanism.wheels[i];
        // Wheels on the middle line have one disc in the region.
        const double y = wheel.center.y();
        const double share = std::abs(y) < 0.01 ? 0.5 : y < 0.0 ? 1.0 : 0.0;
        torque += now.wheels[i].torqueApplied;
        resistance += kC * share * now.wheels[i].normalForce * wheel.radius;
    }
    EXPECT_GT(resistance, 0.2);
    EXPECT_NEAR(torque, resistance, 0.05 * resistance);
}

TEST(GroundRegionsTest, BadRegionsAreNamed) {
    project::Soil soil;
    soil.regions = {region(2.0, 1.0, -1.0, 1.0, 0.3, 0.0)};
    RunRequest request;
    request.scenario = "flat";
    EXPECT_THAT(toString(prepareRun(solero(soil), request).problems()),
                testing::HasSubstr("region 1, x to"));
    soil.regions = {region(1.0, 2.0, -1.0, 1.0, -0.3, 0.0)};
    EXPECT_THAT(toString(prepareRun(solero(soil), request).problems()),
                testing::HasSubstr("region 1, friction"));
}
