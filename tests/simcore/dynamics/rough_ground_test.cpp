// Rovers on rough ground, with many contacts that come and go: runs repeat to the last bit, forces
// keep Coulomb's law and Newton's.
#include <algorithm>
#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/engine_cases.h"
#include "tests/support/motion.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

constexpr double kStep = 0.002;

class RoughGroundTest : public ::testing::TestWithParam<EngineCase> {};

std::vector<EngineCase> enginesOnRoughGround() {
    return enginesThatCan(Can::Joints);
}

/// Waves that run at angles to each other, nowhere above zero: a rover drops onto them at once.
terrain::Terrain crossedWaves() {
    constexpr double kCell = 0.02;
    const int nx = 201;
    const int ny = 101;
    std::vector<double> heights;
    for (int ix = 0; ix < nx; ++ix) {
        for (int iy = 0; iy < ny; ++iy) {
            const double x = -2.0 + kCell * ix;
            const double y = -1.0 + kCell * iy;
            heights.push_back(-0.02 + 0.01 * std::sin(17.0 * x + 5.0 * y) +
                              0.01 * std::sin(11.0 * x - 19.0 * y));
        }
    }
    return terrain::Terrain::grid(-2.0, -1.0, kCell, nx, ny, heights);
}

class RoughWorld : public World {
  public:
    RoughWorld(const EngineCase& engine, const std::string& rover, const terrain::Terrain& ground,
               double friction)
        : World(engine, mechanismOf(rover), kGravity, kStep) {
        placeOn(ground, friction);
        for (std::size_t i = 0; i < drive.size(); ++i) {
            drive[i] = 0.8 + 0.1 * static_cast<double>(i);
        }
    }
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, RoughGroundTest, ::testing::ValuesIn(enginesOnRoughGround()),
                         nameOfCase);

// A state saved in the middle of it continues bit for bit: in the world it is from, and in others
// of which some have gone another way.
TEST_P(RoughGroundTest, RestoredRoversContinueBitForBit) {
    const terrain::Terrain ground = crossedWaves();
    for (const std::string rover : {"solero", "rocker_bogie_steered"}) {
        SCOPED_TRACE(rover);
        RoughWorld world(GetParam(), rover, ground, 0.5);
        world.run(0.4);
        EXPECT_GE(world.contacts().size(), 4u);
        const std::vector<double> saved = world.engine().saveState();
        world.run(0.2);
        const std::vector<double> straight = world.engine().saveState();
        EXPECT_NE(straight, saved);
        RoughWorld fresh(GetParam(), rover, ground, 0.5);
        RoughWorld driven(GetParam(), rover, ground, 0.5);
        driven.drive.assign(driven.drive.size(), -1.0);
        driven.run(0.1);
        driven.drive = world.drive;
        for (World* each : {static_cast<World*>(&world), static_cast<World*>(&fresh),
                            static_cast<World*>(&driven)}) {
            each->engine().restoreState(saved);
            EXPECT_EQ(each->engine().saveState(), saved);
            each->run(0.2);
            EXPECT_EQ(each->engine().saveState(), straight);
        }
    }
}

// Different rovers with different friction, side by side in threads, end as each did alone.
TEST_P(RoughGroundTest, WorldsInThreadsEndAsAlone) {
    const terrain::Terrain ground = crossedWaves();
    const std::vector<std::string> rovers{"solero", "rocker_bogie", "shrimp", "bench_rover"};
    const auto drive = [&](std::size_t i) {
        RoughWorld world(GetParam(), rovers[i], ground, 0.4 + 0.1 * static_cast<double>(i));
        world.run(0.3);
        return world.engine().saveState();
    };
    std::vector<std::vector<double>> together(rovers.size());
    std::vector<std::thread> threads;
    threads.reserve(rovers.size());
    for (std::size_t i = 0; i < rovers.size(); ++i) {
        threads.emplace_back([&, i] { together[i] = drive(i); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (std::size_t i = 0; i < rovers.size(); ++i) {
        EXPECT_EQ(together[i], drive(i)) << rovers[i];
    }
}

// SOLERO over its whole rough profile, every wheel held to its rate by a torque: in every step and
// at every contact the ground pushes, never pulls, and within Coulomb's cone; what it pushes in all
// is the change of the rover's momenta; and loops stay closed.
TEST(ReducedOnRoughGroundTest, ForcesKeepCoulombsLawAndNewtons) {
    constexpr double kTolerance = 2e-3;  // [N]; the engine asks for 1e-3 of all contacts
    run::RunRequest request;
    request.scenario = "rough-profile";
    const auto prepared = run::prepareRun(shipped("solero"), request);
    ASSERT_TRUE(prepared) << toString(prepared.problems());
    const double mu = prepared->friction;
    World world({"Reduced", {}, makeReducedEngine}, prepared->mechanism, kGravity, kStep);
    world.placeOn(*prepared->terrain, mu);
    Motion before;
    long loaded = 0;
    long sliding = 0;
    double highest = 0.0;
    const double end = prepared->distance;
    int steps = 0;
    for (; steps < 30000 && world.engine().poses()[0].position.x() < end; ++steps) {
        for (std::size_t i = 0; i < world.drive.size(); ++i) {
            const Wheel& wheel = world.mechanism().wheels[i];
            const double rate =
                wheelRate(wheel, world.engine().poses(), world.engine().velocities());
            world.drive[i] = std::clamp(4.0 * (0.15 / wheel.radius - rate), -wheel.torqueLimit,
                                        wheel.torqueLimit);
        }
        const Vec3 weight(0.0, 0.0, -world.mechanism().mass() * kGravity);
        Vec3 impulse = kStep * weight;
        Vec3 turning = kStep * world.mechanism().centerOfMass(world.engine().poses()).cross(weight);
        const Motion now = stepped(world);
        for (std::size_t i = 0; i < world.contacts().size(); ++i) {
            const contact::Contact& contact = world.contacts()[i];
            const Vec3& force = world.engine().contactForces()[i];
            const double normal = force.dot(contact.normal);
            const double tangential = (force - normal * contact.normal).norm();
            ASSERT_GE(normal, -kTolerance) << "step " << steps;
            ASSERT_LE(tangential, mu * normal + kTolerance) << "step " << steps;
            loaded += normal > 0.2 ? 1 : 0;
            sliding += normal > 0.2 && tangential > 0.999 * mu * normal ? 1 : 0;
            impulse += kStep * force;
            turning += kStep * contact.point.cross(force);
        }
        ASSERT_LT((now.momentum - before.momentum - impulse).norm(), 1e-9) << "step " << steps;
        ASSERT_LT((now.angularMomentum - before.angularMomentum - turning).norm(), 1e-9)
            << "step " << steps;
        before = now;
        ASSERT_LT(loopError(world.mechanism(), world.engine().poses()), 1e-9) << "step " << steps;
        highest = std::max(highest, world.engine().poses()[0].position.z());
    }
    EXPECT_GE(world.engine().poses()[0].position.x(), end) << "it did not get there";
    EXPECT_GT(loaded, 10L * steps);
    EXPECT_GT(sliding, 100) << "nothing came to its limit";
    EXPECT_GT(highest, 0.03);
    EXPECT_EQ(world.engine().counters().solverMessages, 0);
}
