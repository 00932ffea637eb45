// What controllers are for: less slip and less energy on the same ground.
#include <map>

#include <gtest/gtest.h>

#include "simcore/experiment/experiment.h"
#include "simcore/project/names.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::experiment;
using project::ControllerKind;

// Mild profiles that all controllers pass. Torque-driven rovers slip less than one with equal wheel
// speeds, and take less energy than one whose wheels have integrals of their own.
TEST(ControlRunTest, TorqueDrivenRoversSlipLess) {
    const project::Project solero = testsupport::shipped("solero");
    Plan plan;
    plan.distance = 2.5;
    for (const double friction : {0.5, 0.7}) {
        for (const int seed : {1, 3, 5}) {
            std::map<ControllerKind, Outcome> outcomes;
            for (const ControllerKind kind : {ControllerKind::Speed, ControllerKind::Synchronised,
                                              ControllerKind::Torque, ControllerKind::Hybrid}) {
                outcomes[kind] = drive(solero, plan, {seed, friction, kind});
                ASSERT_TRUE(outcomes[kind].completed)
                    << project::nameOf(kind) << seed << outcomes[kind].stopReason;
            }
            for (const ControllerKind kind : {ControllerKind::Torque, ControllerKind::Hybrid}) {
                EXPECT_LT(outcomes[kind].slipAbs, outcomes[ControllerKind::Speed].slipAbs)
                    << project::nameOf(kind) << seed << friction;
                EXPECT_LT(outcomes[kind].energy, outcomes[ControllerKind::Synchronised].energy)
                    << project::nameOf(kind) << seed << friction;
            }
        }
    }
}

// Bit for bit, whatever the controller keeps in mind.
TEST(ControlRunTest, RunsRepeat) {
    const project::Project solero = testsupport::shipped("solero");
    Plan plan;
    plan.set = TerrainSet::Terrains;
    plan.distance = 0.8;
    for (const ControllerKind kind : {ControllerKind::CommonIntegral, ControllerKind::Hybrid}) {
        const Case what{2, 0.5, kind};
        EXPECT_EQ(drive(solero, plan, what).stateHash, drive(solero, plan, what).stateHash);
    }
}

// This profile has an edge that the front bogie wheels climb only with a friction of 0.523. On 0.5
// no torques do it: a controller that says so after a try, instead of spinning 15 m of way off its
// wheels until the run is given up, has less to pay for.
TEST(ControlRunTest, WheelsRestWhereNoTorquesClimb) {
    const project::Project solero = testsupport::shipped("solero");
    for (const ControllerKind kind : {ControllerKind::Torque, ControllerKind::Hybrid}) {
        const Outcome outcome = drive(solero, {}, {102, 0.5, kind});
        EXPECT_FALSE(outcome.completed);
        EXPECT_EQ(outcome.stopReason, "stuck");
        EXPECT_NEAR(outcome.endX, 2.352, 0.002) << project::nameOf(kind);
        EXPECT_LT(outcome.slipAbs, 0.9) << project::nameOf(kind);
        EXPECT_LT(outcome.energy, 25.0) << project::nameOf(kind);
    }
}

// On 0.7 it can be climbed, but not with wheels that are trusted with 0.5: those that stand at
// their caps are given more.
TEST(ControlRunTest, StuckWheelsAreTrustedWithMore) {
    const project::Project solero = testsupport::shipped("solero");
    Plan plan;
    plan.distance = 2.6;
    ASSERT_EQ(plan.assumedFriction, 0.5);
    const Outcome outcome = drive(solero, plan, {102, 0.7, ControllerKind::Torque});
    EXPECT_TRUE(outcome.completed) << outcome.stopReason;
    EXPECT_LT(outcome.slipAbs, 0.02);
}
