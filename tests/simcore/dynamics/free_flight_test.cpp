// Shipped rovers adrift, wheels spinning and joints swinging: what nature keeps, the engine in free
// rates keeps.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/engine_cases.h"
#include "tests/support/motion.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

constexpr double kStep = 0.002;

/// The rover without what takes energy or stores it, and without stops to swing against.
Mechanism adrift(const std::string& name) {
    Mechanism rover = mechanismOf(name);
    rover.springs.clear();
    for (Joint& joint : rover.joints) {
        joint.damping = 0.0;
        joint.stops.reset();
    }
    return rover;
}

class FreeFlightTest : public ::testing::TestWithParam<std::string> {};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Rovers, FreeFlightTest,
                         ::testing::Values("solero", "bench_rover", "rocker_bogie",
                                           "rocker_bogie_bar", "shrimp"));

TEST_P(FreeFlightTest, KeepsEnergyMomentumAndLoops) {
    World world({"Reduced", {}, makeReducedEngine}, adrift(GetParam()), 0.0, kStep);
    // Torques that add up to none push the links apart; those from outside turn the whole.
    for (std::size_t i = 0; i < world.drive.size(); ++i) {
        world.drive[i] = i % 2 == 0 ? 0.1 : -0.08;
        world.external[i] = i % 3 == 0 ? 0.04 : 0.0;
    }
    world.run(0.3);
    world.drive.assign(world.drive.size(), 0.0);
    world.external.assign(world.drive.size(), 0.0);
    const Motion start = stepped(world);
    ASSERT_GT(start.energy, 0.1);
    ASSERT_GT(start.angularMomentum.norm(), 1e-3);
    double swing = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const Motion now = stepped(world);
        ASSERT_NEAR(now.energy, start.energy, 2e-4 * start.energy) << "at step " << i;
        ASSERT_LT((now.angularMomentum - start.angularMomentum).norm(),
                  1e-9 * start.angularMomentum.norm());
        ASSERT_LT((now.momentum - start.momentum).norm(),
                  1e-9 * std::sqrt(2.0 * world.mechanism().mass() * start.energy));
        ASSERT_LT(loopError(world.mechanism(), world.engine().poses()), 1e-9);
        for (const int joint : world.mechanism().encoderJoints()) {
            swing = std::max(swing, std::abs(jointAngle(
                                        world.mechanism().joints[static_cast<std::size_t>(joint)],
                                        world.engine().poses())));
        }
    }
    EXPECT_GT(swing, 1.0);
    EXPECT_EQ(world.engine().counters().solverMessages, 0);
}
