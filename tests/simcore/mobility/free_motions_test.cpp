// Free motions followed to and fro: as many as the mobility, with loops and contacts closed.
#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/mobility/constraint_system.h"
#include "simcore/mobility/free_motions.h"
#include "tests/support/linkages.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::mobility;
using namespace testsupport;

namespace {

Mechanism mechanismNamed(const std::string& name) {
    const auto project = io::loadProject(ROVER_SOURCE_DIR "/assets/mechanisms/" + name + ".rover");
    if (!project) {
        throw std::runtime_error(toString(project.problems()));
    }
    auto mechanism = project::resolve(*project);
    if (!mechanism) {
        throw std::runtime_error(toString(mechanism.problems()));
    }
    return std::move(mechanism).value();
}

/// Largest distance between the two points of any joint that leaves no slide free [m].
double openest(const Mechanism& mechanism, const std::vector<Pose>& bodies, Model model) {
    double most = 0.0;
    for (const auto& joint : mechanism.joints) {
        const auto freedoms = freedomsOf(joint, model);
        const bool slides =
            std::any_of(freedoms.begin(), freedoms.end(), [](const mechanism::Freedom& freedom) {
                return freedom.kind == mechanism::FreedomKind::Slide;
            });
        if (!slides) {
            most = std::max(most, (bodies[static_cast<std::size_t>(joint.first)] * joint.point -
                                   bodies[static_cast<std::size_t>(joint.second)] * joint.point)
                                      .norm());
        }
    }
    return most;
}

/// How far a body's centre of mass goes from one end of the swing to the other [m].
double travelOf(const Mechanism& mechanism, const Swing& swing, std::size_t body) {
    const Vec3& com = mechanism.bodies[body].com;
    return (swing.at(1.0)[body] * com - swing.at(-1.0)[body] * com).norm();
}

double turnOf(const Swing& swing, std::size_t body) {
    return swing.at(-1.0)[body].rotation.angularDistance(swing.at(1.0)[body].rotation);
}

void expectClosed(const Mechanism& mechanism, Model model, const Swing& swing) {
    SCOPED_TRACE(swing.description);
    EXPECT_LT(swing.closure, 1e-9);
    const ConstraintSystem system(mechanism, model, drawnStance(mechanism));
    for (const std::vector<Pose>& bodies : swing.poses) {
        Stance stance = system.start();
        stance.bodies = bodies;
        const Eigen::VectorXd residual = system.residual(stance);
        EXPECT_LT(residual.size() > 0 ? residual.cwiseAbs().maxCoeff() : 0.0, 1e-9);
    }
    // Between the poses, too: a tenth of a millimetre cannot be seen.
    for (double u = -1.0; u <= 1.0; u += 0.0173) {
        EXPECT_LT(openest(mechanism, swing.at(u), model), 1e-4) << u;
    }
}

const std::vector<std::string> kRovers{"solero", "shrimp", "rocker_bogie", "rocker_bogie_bar"};

}  // namespace

TEST(FreeMotionsTest, AreAsManyAsTheMobilityAndStayClosed) {
    for (const std::string& name : kRovers) {
        SCOPED_TRACE(name);
        const Mechanism rover = mechanismOf(name);
        for (const Model model : {Model::Built, Model::Relaxed}) {
            const Report report = analyse(rover, model);
            const std::vector<Swing> swings = freeMotions(rover, model);
            ASSERT_EQ(static_cast<int>(swings.size()), report.mobility);
            EXPECT_EQ(std::count_if(swings.begin(), swings.end(),
                                    [](const Swing& swing) { return swing.idle; }),
                      static_cast<long>(report.idle.size()));
            for (const Swing& swing : swings) {
                EXPECT_EQ(swing.continuation, Continuation::Finite);
                expectClosed(rover, model, swing);
            }
        }
    }
}

TEST(FreeMotionsTest, RoverRollsToAndFroByTheLimit) {
    const Mechanism rover = mechanismOf("solero");
    const std::vector<Swing> swings = freeMotions(rover, Model::Built);
    ASSERT_EQ(swings.size(), 1U);
    const Swing& swing = swings.front();
    EXPECT_EQ(swing.poses.size(), 49U);
    EXPECT_EQ(swing.middle, 24U);
    EXPECT_THAT(swing.description, testing::HasSubstr("moves along x; all wheels roll"));
    const auto chassis = static_cast<std::size_t>(rover.chassis);
    double turn = 0.0;
    double travel = 0.0;
    for (std::size_t b = 0; b < rover.bodies.size(); ++b) {
        turn = std::max(turn, turnOf(swing, b));
        travel = std::max(travel, travelOf(rover, swing, b));
    }
    // On level ground nothing bends the way, so one of the limits is met, but for the steps'
    // second order.
    EXPECT_NEAR(std::max(turn, travel / (0.1 * rover.wheelbase())), 1.0, 1e-4);
    // Wheels roll: way = radius times turn.
    for (const auto& wheel : rover.wheels) {
        EXPECT_NEAR(travelOf(rover, swing, chassis),
                    wheel.radius * turnOf(swing, static_cast<std::size_t>(wheel.body)), 1e-6);
    }
    EXPECT_GT(swing.at(1.0)[chassis].position.x(), 0.02);
    EXPECT_LT(swing.at(-1.0)[chassis].position.x(), -0.02);
    EXPECT_LT(swing.at(0.0)[chassis].position.norm(), 1e-15);
}

TEST(FreeMotionsTest, EveryIdleRodOfTheBarDifferentialTurnsOnItsOwn) {
    const Mechanism rover = mechanismOf("rocker_bogie_bar");
    const std::vector<Swing> swings = freeMotions(rover, Model::Built);
    ASSERT_EQ(swings.size(), 3U);
    EXPECT_FALSE(swings[0].idle);
    std::set<std::string> rods;
    for (std::size_t k = 1; k < 3; ++k) {
        SCOPED_TRACE(swings[k].description);
        EXPECT_TRUE(swings[k].idle);
        EXPECT_THAT(swings[k].description, testing::HasSubstr("nothing else moves"));
        rods.insert(swings[k].body);
        for (std::size_t b = 0; b < rover.bodies.size(); ++b) {
            if (rover.bodies[b].name == swings[k].body) {
                EXPECT_NEAR(turnOf(swings[k], b), 1.0, 1e-4);
            } else {
                EXPECT_LT(turnOf(swings[k], b), 1e-9) << rover.bodies[b].name;
                EXPECT_LT(travelOf(rover, swings[k], b), 1e-9) << rover.bodies[b].name;
            }
        }
    }
    EXPECT_EQ(rods.size(), 2U);
}

// The four-bar has a closed form: crank and follower turn as it says.
TEST(FreeMotionsTest, FourBarFollowsItsClosedForm) {
    const FourBar linkage;
    const double crank = 1.1;
    const Mechanism mechanism = linkage.make(crank);
    const std::vector<Swing> swings = freeMotions(mechanism, Model::Built);
    ASSERT_EQ(swings.size(), 1U);
    expectClosed(mechanism, Model::Built, swings.front());
    for (const double u : {-1.0, 0.5, 1.0}) {
        const std::vector<Pose> bodies = swings.front().at(u);
        // Angles count from +x to +z, which is a negative turn about y.
        const double turned = -turnAbout(bodies[1].rotation, Vec3::UnitY());
        const double follower = -turnAbout(bodies[3].rotation, Vec3::UnitY());
        EXPECT_GT(std::abs(turned), 0.05);
        EXPECT_NEAR(linkage.followerAngle(crank + turned) - linkage.followerAngle(crank), follower,
                    1e-6);
    }
}

TEST(FreeMotionsTest, SixFreedomsOfThePlatformAreIndependent) {
    const Mechanism mechanism = mechanismNamed("stewart_platform");
    const Report report = analyse(mechanism, Model::Built);
    const std::vector<Swing> swings = freeMotions(mechanism, Model::Built);
    ASSERT_EQ(static_cast<int>(swings.size()), report.mobility);
    for (const Swing& swing : swings) {
        EXPECT_EQ(swing.continuation, Continuation::Finite);
        expectClosed(mechanism, Model::Built, swing);
    }
}

TEST(FreeMotionsTest, WhatOnlyYieldsIsSaidToAndStaysAsDrawn) {
    const Mechanism mechanism = mechanismNamed("bars_in_line");
    const std::vector<Swing> swings = freeMotions(mechanism, Model::Built);
    ASSERT_EQ(swings.size(), 1U);
    EXPECT_EQ(swings.front().continuation, Continuation::Infinitesimal);
    EXPECT_EQ(swings.front().poses.size(), 1U);
    for (const Pose& body : swings.front().at(0.7)) {
        EXPECT_LT(body.position.norm(), 1e-15);
    }
}

TEST(FreeMotionsTest, BothMotionsOfTheFoldedParallelogramAreFollowed) {
    const Mechanism mechanism = mechanismNamed("parallelogram_folded");
    const std::vector<Swing> swings = freeMotions(mechanism, Model::Built);
    ASSERT_EQ(swings.size(), 2U);
    for (const Swing& swing : swings) {
        EXPECT_EQ(swing.continuation, Continuation::Branch);
        EXPECT_GT(swing.poses.size(), 1U);
        expectClosed(mechanism, Model::Built, swing);
    }
}

TEST(FreeMotionsTest, WhatCannotMoveHasNone) {
    Mechanism mechanism = FourBar().make(1.1);
    for (auto& joint : mechanism.joints) {
        joint.built.clear();
    }
    EXPECT_TRUE(freeMotions(mechanism, Model::Built).empty());
    EXPECT_THROW(freeMotions(mechanism, Model::Built, drawnStance(mechanism), {0.05, 0.5, 0}),
                 std::invalid_argument);
}
