#include "simcore/statics/traction.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "simcore/mobility/advisor.h"
#include "simcore/project/resolve.h"
#include "simcore/statics/static_study.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

constexpr double kGravity = 9.81;

mechanism::Mechanism rover(const std::string& name,
                           const std::vector<project::Assignment>& set = {}) {
    auto resolved = project::resolve(testsupport::shipped(name), {}, set);
    EXPECT_TRUE(resolved);
    return std::move(resolved).value();
}

std::vector<WheelAngle> allAt(const mechanism::Mechanism& mechanism, double angle) {
    std::vector<WheelAngle> angles;
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        angles.push_back({wheel.name, angle});
    }
    return angles;
}

Study studyOf(const mechanism::Mechanism& mechanism, const StudyRequest& request = {}) {
    auto study = studyDrawnPose(mechanism, request);
    EXPECT_TRUE(study) << toString(study.problems());
    return std::move(study).value();
}

}  // namespace

// Whatever carries the weight, level ground carries all of it and asks for no friction.
TEST(TractionTest, LoadsSumToTheWeight) {
    for (const std::string& name : testsupport::shippedNames()) {
        const mechanism::Mechanism mechanism = rover(name);
        if (mechanism.wheels.empty()) {
            continue;
        }
        const Study study = studyOf(mechanism);
        ASSERT_TRUE(study.feasible) << name;
        double sum = 0.0;
        for (const WheelStudy& wheel : study.wheels) {
            sum += wheel.normal;
        }
        EXPECT_NEAR(sum, mechanism.mass() * 9.80665, 1e-3 * sum) << name;
        EXPECT_LT(study.frictionRequired, 1e-6) << name;
    }
}

// All contacts tilted alike stand for a slope: it needs the tangent of its angle, whatever the
// suspension and its springs do.
TEST(TractionTest, AUniformSlopeNeedsItsTangent) {
    for (const std::string name : {"solero", "shrimp", "rocker_bogie", "bench_rover"}) {
        const mechanism::Mechanism mechanism = rover(name);
        for (const double angle : {0.1, 0.35, -0.2}) {
            for (const ContactSet set : {ContactSet::Free, ContactSet::All}) {
                StudyRequest request;
                request.contacts = set;
                request.angles = allAt(mechanism, angle);
                const Study study = studyOf(mechanism, request);
                ASSERT_TRUE(study.feasible) << name << angle;
                EXPECT_NEAR(study.frictionRequired, std::tan(std::abs(angle)), 1e-6)
                    << name << angle;
            }
        }
    }
}

// The front wheel at a vertical wall, fork preload 10 N: values of two other solvers, which differ
// by 1 % from each other as they lump small parts differently.
TEST(TractionTest, ShrimpAtAWall) {
    const mechanism::Mechanism mechanism = rover("shrimp", {{"fork_preload", "10"}});
    StudyRequest request;
    request.angles = {{"front", 0.5 * M_PI}};
    const Study study = studyOf(mechanism, request);
    ASSERT_TRUE(study.feasible);
    EXPECT_NEAR(study.frictionRequired, 0.309, 0.02 * 0.309);
    EXPECT_NEAR(study.equalMaxRatio, 0.530, 0.02 * 0.530);
    ASSERT_TRUE(study.equalTorque);
    EXPECT_NEAR(*study.equalTorque, 0.3146, 0.025 * 0.3146);
    EXPECT_NEAR(study.wheels[0].torque, 0.317, 0.02 * 0.317);
    EXPECT_NEAR(study.wheels[1].torque, 0.193, 0.02 * 0.193);
    EXPECT_NEAR(study.wheels[5].torque, 0.253, 0.02 * 0.253);
}

// Ten exact relaxed models of SOLERO, found by search: all give the forces of the model as built.
TEST(TractionTest, TenExactRelaxationsGiveTheSame) {
    const project::Project project = testsupport::shipped("solero");
    mobility::AdvisorOptions options;
    options.alike = 10;
    options.seconds = 60.0;
    const auto advice = mobility::advise(project, options);
    ASSERT_TRUE(advice);
    ASSERT_EQ(advice->proposals.size(), 10U);
    StudyRequest request;
    request.angles = {{"front", 1.2}, {"bogie_left_front", 0.4}, {"rear", 0.3}};
    request.contacts = ContactSet::All;
    const Study built = studyOf(rover("solero"), request);
    ASSERT_TRUE(built.feasible);
    request.joints = Model::Relaxed;
    for (const mobility::Proposal& proposal : advice->proposals) {
        const auto relaxed = mobility::withRelaxation(project, proposal);
        ASSERT_TRUE(relaxed);
        auto mechanism = project::resolve(*relaxed);
        ASSERT_TRUE(mechanism);
        const Study study = studyOf(*mechanism, request);
        EXPECT_NEAR(study.frictionRequired, built.frictionRequired, 1e-7);
        for (std::size_t i = 0; i < study.wheels.size(); ++i) {
            EXPECT_NEAR(study.wheels[i].normal, built.wheels[i].normal, 1e-5) << proposal.why;
            EXPECT_NEAR(study.wheels[i].traction, built.wheels[i].traction, 1e-5) << proposal.why;
        }
    }
}

// What joints hold redundantly has no say in the forces on the ground.
TEST(TractionTest, BuiltAndRelaxedJointsGiveTheSame) {
    const mechanism::Mechanism mechanism = rover("solero");
    StudyRequest request;
    request.angles = {{"front", 1.2}, {"rear", 0.3}};
    const Study built = studyOf(mechanism, request);
    request.joints = Model::Relaxed;
    const Study relaxed = studyOf(mechanism, request);
    EXPECT_NEAR(built.frictionRequired, relaxed.frictionRequired, 1e-9);
    for (std::size_t i = 0; i < built.wheels.size(); ++i) {
        EXPECT_NEAR(built.wheels[i].normal, relaxed.wheels[i].normal, 1e-6);
        EXPECT_NEAR(built.wheels[i].traction, relaxed.wheels[i].traction, 1e-6);
    }
}

// A brute-force route: no torques on a fine grid round the answer need less friction.
TEST(TractionTest, NoTorquesNearbyAreBetter) {
    const mechanism::Mechanism mechanism = rover("solero");
    StaticModel model(mechanism, Model::Built);
    for (const std::vector<double>& angles :
         {std::vector<double>{1.3, 0.0, 0.0, 0.0, 0.0, 0.0},
          std::vector<double>{0.0, 1.2, 0.0, 1.2, 0.0, 0.0},
          std::vector<double>{0.2, -0.4, 0.9, -0.4, 0.9, 1.0}}) {
        std::vector<Contact> contacts;
        for (std::size_t i = 0; i < angles.size(); ++i) {
            contacts.push_back(
                contactAtAngle(mechanism, static_cast<int>(i), model.poses(), angles[i]));
        }
        const Equilibrium equilibrium = model.equilibrium(contacts, ContactSet::Free, kGravity);
        const Traction traction(equilibrium, mechanism, contacts);
        const Solution best = traction.best(Objective::Friction);
        ASSERT_NE(best.way, Way::None);
        // Equilibrium to the last digit.
        EXPECT_LT(traction.residual(best.forces), 1e-9);
        for (int axis = 0; axis < traction.dimension(); ++axis) {
            for (const double step : {-1e-2, -1e-4, 1e-4, 1e-2}) {
                EXPECT_GT(traction.moved(best.forces, axis, step).maxRatio(), best.friction - 1e-6);
            }
        }
        // Equal torques are one of the choices.
        EXPECT_LE(best.friction, traction.equalTorque().friction + 1e-9);
        EXPECT_LE(traction.best(Objective::Torque).forces.maxTorque(),
                  traction.equalTorque().forces.maxTorque() + 1e-6);
    }
}

// A motor that is too weak: no torques hold the rover on the slope, and that is said.
TEST(TractionTest, WeakMotorsCannotHold) {
    mechanism::Mechanism mechanism = rover("solero");
    StudyRequest request;
    request.angles = allAt(mechanism, 0.4);
    const double needed = studyOf(mechanism, request).minimumTorque;
    for (mechanism::Wheel& wheel : mechanism.wheels) {
        wheel.torqueLimit = 0.9 * needed;
    }
    const Study study = studyOf(mechanism, request);
    EXPECT_FALSE(study.feasible);
    EXPECT_EQ(study.flags.back(), "no-torques-hold-it");
    for (mechanism::Wheel& wheel : mechanism.wheels) {
        wheel.torqueLimit = 1.1 * needed;
    }
    EXPECT_TRUE(studyOf(mechanism, request).feasible);
}

TEST(StaticStudyTest, WhatCannotBeIsRefused) {
    const mechanism::Mechanism mechanism = rover("solero");
    StudyRequest request;
    request.angles = {{"nose", 0.1}};
    EXPECT_FALSE(studyDrawnPose(mechanism, request));
    request.angles = {{"front", 2.0}};
    EXPECT_FALSE(studyDrawnPose(mechanism, request));
    request.angles = {{"front", std::nan("")}};
    EXPECT_FALSE(studyDrawnPose(mechanism, request));
    EXPECT_FALSE(studyDrawnPose(mechanism::Mechanism{}, {}));
}
