// Every check finds what it is for, and not more.
#include "simcore/review/review.h"
#include "simcore/review/way_review.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::project;
using review::Finding;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

std::vector<Finding> findingsOf(const Project& project) {
    const auto parameters = evaluateParameters(project.rover);
    EXPECT_TRUE(parameters);
    const auto mechanism = resolve(project.rover, *parameters);
    EXPECT_TRUE(mechanism) << toString(mechanism.problems());
    return review::review(project, *parameters, *mechanism,
                          mobility::analyse(*mechanism, mobility::Model::Built),
                          mobility::analyse(*mechanism, mobility::Model::Relaxed));
}

auto kind(const std::string& name) {
    return Field("kind", &Finding::kind, name);
}

const Finding& only(const std::vector<Finding>& findings, const std::string& name) {
    const auto found = std::find_if(findings.begin(), findings.end(),
                                    [&](const Finding& f) { return f.kind == name; });
    EXPECT_NE(found, findings.end()) << name;
    return *found;
}

/// A rigid cart of four wheels on axles through numbers, level and well balanced.
Project cart() {
    auto project = io::parseProject(R"({
      "format": "roverstudio-project", "version": 1,
      "rover": {
        "name": "cart",
        "bodies": [
          {"name": "chassis", "mass": 6, "com": [0, 0, 0.2], "inertia": [0.1, 0.1, 0.1, 0, 0, 0]},
          {"name": "front", "mirror": true, "mass": 1, "com": [0.2, 0.2, 0.1],
           "inertia": [0.003, 0.005, 0.003, 0, 0, 0]},
          {"name": "rear", "mirror": true, "mass": 1, "com": [-0.2, 0.2, 0.1],
           "inertia": [0.003, 0.005, 0.003, 0, 0, 0]}
        ],
        "joints": [
          {"name": "front_axle", "mirror": true, "first": "chassis", "second": "front",
           "point": [0.2, 0.2, 0.1]},
          {"name": "rear_axle", "mirror": true, "first": "chassis", "second": "rear",
           "point": [-0.2, 0.2, 0.1]}
        ],
        "wheels": [
          {"name": "front", "mirror": true, "body": "front", "axle": "front_axle", "radius": 0.1,
           "width": 0.05, "grousers": 0},
          {"name": "rear", "mirror": true, "body": "rear", "axle": "rear_axle", "radius": 0.1,
           "width": 0.05, "grousers": 0}
        ]
      }
    })",
                                    "test");
    EXPECT_TRUE(project) << toString(project.problems());
    Project result = std::move(project).value();
    result.scenarios.emplace_back().name = "go";
    return result;
}

}  // namespace

TEST(ReviewTest, ShippedRoversAreWise) {
    for (const char* name : {"solero", "shrimp", "bench_rover"}) {
        EXPECT_THAT(findingsOf(testsupport::shipped(name)), IsEmpty()) << name;
    }
    // Nobody has relaxed the rocker-bogie.
    EXPECT_EQ(only(findingsOf(testsupport::shipped("rocker_bogie")), "hyperstatic").value, 4.0);
}

TEST(ReviewTest, EveryKindHasATitle) {
    std::set<std::string> names;
    for (const auto& [name, title] : review::kinds()) {
        EXPECT_TRUE(names.insert(name).second);
        EXPECT_FALSE(title.empty());
    }
    for (const Finding& finding : findingsOf(cart())) {
        EXPECT_EQ(names.count(finding.kind), 1U) << finding.kind;
    }
}

TEST(ReviewTest, SupportIsTheDistanceToTheHullOfTheFeet) {
    Project project = cart();
    const auto margin = [&] { return *review::supportMargin(*resolve(project)); };
    EXPECT_NEAR(margin(), 0.2, 1e-12);
    EXPECT_THAT(findingsOf(project), Not(Contains(kind("support"))));
    // 6 of 10 kg at 0.31 m: the whole at 0.186 m, 14 mm inside the front feet at 0.2 m.
    project.rover.bodies[0].com[0] = 0.31;
    EXPECT_NEAR(margin(), 0.2 - 0.6 * 0.31, 1e-12);
    EXPECT_EQ(only(findingsOf(project), "support").severity, Severity::Info);
    project.rover.bodies[0].com[0] = 0.4;
    EXPECT_NEAR(margin(), 0.2 - 0.6 * 0.4, 1e-12);
    EXPECT_EQ(only(findingsOf(project), "support").severity, Severity::Warning);
    EXPECT_THAT(only(findingsOf(project), "support").reason, HasSubstr("40 mm outside"));
    // Only the feet that stand lowest count: two in a row span nothing.
    project.rover.joints[1].point[2] = 0.15;
    EXPECT_FALSE(review::supportMargin(*resolve(project)));
}

TEST(ReviewTest, AWheelThatHangsIsNamedWithItsHeight) {
    Project project = cart();
    project.rover.joints[1].point[2] = 0.112;
    const Finding& finding = only(findingsOf(project), "off-ground");
    EXPECT_NEAR(finding.value, 0.012, 1e-12);
    EXPECT_THAT(finding.element, HasSubstr("rear"));
    project.rover.joints[1].point[2] = 0.1005;
    EXPECT_THAT(findingsOf(project), Not(Contains(kind("off-ground"))));
}

TEST(ReviewTest, MassesAndInertiasOfNoRealPart) {
    Project project = cart();
    project.rover.bodies[1].mass = 0.02;
    EXPECT_NEAR(only(findingsOf(project), "mass-ratio").value, 300.0, 1e-9);
    project = cart();
    (*project.rover.bodies[0].inertia)[0] = 0.19999;  // kg m^2 of 6 kg: within what can be
    EXPECT_THAT(findingsOf(project), Not(Contains(kind("inertia"))));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        (*project.rover.bodies[0].inertia)[axis] = 40.0;  // g m^2, typed as kg m^2
    }
    EXPECT_EQ(only(findingsOf(project), "inertia").severity, Severity::Warning);
}

TEST(ReviewTest, WheelsInOneAnother) {
    Project project = cart();
    project.rover.joints[0].point[0] = -0.05;
    EXPECT_NEAR(only(findingsOf(project), "overlap").value, 0.05, 1e-12);
    // One behind the other on another track: beside, not in.
    project.rover.joints[0].point[1] = 0.26;
    EXPECT_THAT(findingsOf(project), Not(Contains(kind("overlap"))));
}

TEST(ReviewTest, ATooLargeStepIsFixedByARoundOne) {
    Project project = cart();
    project.scenarios[0].controller.speed = 0.4;
    project.scenarios[0].run.step = 0.01;
    const auto findings = findingsOf(project);
    const Finding& finding = only(findings, "step");
    EXPECT_NEAR(finding.value, 0.004, 1e-12);
    EXPECT_NEAR(finding.limit, 0.001, 1e-12);
    ASSERT_TRUE(finding.fix);
    EXPECT_EQ(finding.fix->project.scenarios[0].run.step.literal(), 0.002);
    EXPECT_THAT(findingsOf(finding.fix->project), Not(Contains(kind("step"))));
}

TEST(ReviewTest, SlopesBeyondFrictionAndTorque) {
    Project project = cart();
    project.scenarios[0].terrain.kind = TerrainKind::Ramp;
    project.scenarios[0].terrain.slope = 0.5;
    project.scenarios[0].soil.friction = 0.6;
    EXPECT_THAT(findingsOf(project), Not(Contains(kind("friction"))));  // tan 0.5 = 0.546
    project.scenarios[0].soil.friction = 0.5;
    EXPECT_NEAR(only(findingsOf(project), "friction").limit, std::tan(0.5), 1e-12);
    EXPECT_THAT(findingsOf(project), Not(Contains(kind("torque"))));  // 80 N against 47 N
    for (Wheel& wheel : project.rover.wheels) {
        wheel.motor.torqueLimit = 1.0;
    }
    EXPECT_NEAR(only(findingsOf(project), "torque").limit, 10.0 * 9.81 * std::sin(0.5), 0.1);
    project.scenarios[0].terrain.kind = TerrainKind::CrossSlope;
    EXPECT_THAT(findingsOf(project), Not(Contains(kind("torque"))));
    EXPECT_THAT(findingsOf(project), Contains(kind("friction")));
}

namespace {

/// The cart before a step.
Project beforeStep(double height, double friction, double torque) {
    Project project = cart();
    Scenario& scenario = project.scenarios[0];
    scenario.terrain.kind = TerrainKind::Step;
    scenario.terrain.start = 0.6;
    scenario.terrain.height = height;
    scenario.terrain.length = 2.0;
    scenario.run.distance = 1.5;
    scenario.soil.friction = friction;
    for (Wheel& wheel : project.rover.wheels) {
        wheel.motor.torqueLimit = torque;
    }
    return project;
}

}  // namespace

// A step of 30 mm: strong motors on good ground climb it, weak ones or slippery ground do not.
TEST(WayReviewTest, StepsBeyondFrictionAndTorque) {
    EXPECT_THAT(review::reviewWay(beforeStep(0.03, 0.9, 10.0), "go"), IsEmpty());

    const auto slippery = review::reviewWay(beforeStep(0.03, 0.2, 10.0), "go");
    ASSERT_EQ(slippery.size(), 1U);
    EXPECT_EQ(slippery[0].kind, "friction");
    EXPECT_EQ(slippery[0].element, "scenario go");
    EXPECT_EQ(slippery[0].value, 0.2);
    EXPECT_GT(slippery[0].limit, 0.2);
    // It is exactly what the ground must give.
    const double enough = slippery[0].limit + 0.001;
    EXPECT_THAT(review::reviewWay(beforeStep(0.03, enough, 10.0), "go"), IsEmpty());

    const auto weak = review::reviewWay(beforeStep(0.03, 0.9, 0.5), "go");
    ASSERT_EQ(weak.size(), 1U);
    EXPECT_EQ(weak[0].kind, "torque");
    EXPECT_EQ(weak[0].value, 0.5);
    EXPECT_GT(weak[0].limit, 0.5);
    EXPECT_THAT(weak[0].reason, HasSubstr("its motor gives 0.50 N m"));
    EXPECT_THAT(review::reviewWay(beforeStep(0.03, 0.9, weak[0].limit + 0.001), "go"), IsEmpty());
}

TEST(WayReviewTest, WhatIsEvenOrAnotherRoverOrGivenUpIsNotLookedAt) {
    Project project = beforeStep(0.03, 0.2, 10.0);
    EXPECT_THAT(review::reviewWay(project, "nowhere"), IsEmpty());
    EXPECT_THAT(review::reviewWay(project, "go", {}, [] { return false; }), IsEmpty());
    project.scenarios[0].terrain.kind = TerrainKind::Flat;
    EXPECT_FALSE(review::hasObstacles(project.scenarios[0]));
    EXPECT_THAT(review::reviewWay(project, "go"), IsEmpty());
}

// Higher than anything a wheel of 0.1 m can climb against.
TEST(WayReviewTest, AWallThatNoFrictionClimbsIsTold) {
    const auto wall = review::reviewWay(beforeStep(0.5, 0.9, 10.0), "go");
    ASSERT_EQ(wall.size(), 1U);
    EXPECT_EQ(wall[0].kind, "friction");
}
