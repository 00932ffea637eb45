// Coulomb's law against statics: a locked cart on slopes, a wheel before a step that is pulled or
// turned over it.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/engine_cases.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

class SlopesAndStepsTest : public ::testing::TestWithParam<EngineCase> {};

std::vector<EngineCase> enginesForWheels() {
    return enginesThatCan(Can::Joints);
}

/// A rover with locked wheels on a slope.
class Locked : public World {
  public:
    Locked(const EngineCase& engine, const Mechanism& rover, double slope, double step)
        : World(engine, tilted(rover, slope), kGravity, step),
          down_(-std::cos(slope), 0.0, -std::sin(slope)) {
        for (const Wheel& wheel : mechanism().wheels) {
            motors.push_back({wheel.axle, 0.0, 100.0});
        }
    }

    /// Speed down the slope [m/s].
    double speed() const { return engine().velocities()[0].linear.dot(down_); }

  private:
    Vec3 down_;
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Engines, SlopesAndStepsTest, ::testing::ValuesIn(enginesForWheels()),
                         nameOfCase);

// It sticks below the angle of friction, and above slides with g (sin - mu cos), whatever the step.
TEST_P(SlopesAndStepsTest, LockedCartSlidesByCoulombsLaw) {
    for (const double step : {0.001, 0.002}) {
        for (const double mu : {0.3, 0.6, 0.9}) {
            const double limit = std::atan(mu);
            for (const double slope : {0.98 * limit, 1.03 * limit, 1.2 * limit}) {
                Locked world(GetParam(), makeCart(), slope, step);
                const terrain::Terrain ground = slopeThroughOrigin(slope, 20.0);
                world.placeOn(ground, mu);
                world.run(0.3);
                const double before = world.speed();
                world.run(0.5);
                if (slope < limit) {
                    EXPECT_LT(std::abs(world.speed()), 1e-5) << "mu " << mu << ", slope " << slope;
                    continue;
                }
                const double expected = kGravity * (std::sin(slope) - mu * std::cos(slope));
                EXPECT_NEAR((world.speed() - before) / 0.5, expected,
                            GetParam().frictionSlack * mu * kGravity * std::cos(slope))
                    << "mu " << mu << ", slope " << slope;
            }
        }
    }
}

// What sticks creeps, and so do locks: the reduced engine's contacts with 1e-7 m/s per newton, its
// motors with 1e-6 rad/s per newton metre (docs/engines.md), whatever the step. All contacts of a
// rover that stands creep alike, so they share what pulls it down.
TEST(CreepTest, LockedRoversCreepAsDesigned) {
    constexpr double kContactCreep = 1e-7;  // [m/(N s)]
    constexpr double kLockCreep = 1e-6;     // [rad/(N m s)]
    const double slope = 20.0 * std::numbers::pi / 180.0;
    const terrain::Terrain ground = slopeThroughOrigin(slope);
    for (const Mechanism& rover : {makeCart(), mechanismOf("solero")}) {
        for (const double step : {0.0005, 0.002, 0.005}) {
            SCOPED_TRACE(rover.name + " at " + std::to_string(step));
            Locked world({"Reduced", {}, makeReducedEngine}, rover, slope, step);
            world.placeOn(ground, 0.7);
            world.run(6.0);  // springs come to rest, to far below a micrometre per second
            const double ofWheel = rover.mass() * kGravity * std::sin(slope) /
                                   static_cast<double>(rover.wheels.size());
            const double radius = rover.wheels[0].radius;
            const double expected =
                kContactCreep * ofWheel / 2.0 + kLockCreep * ofWheel * radius * radius;
            EXPECT_LT(world.speed(), 5e-6);
            EXPECT_NEAR(world.speed(), expected, 1e-3 * expected);
        }
    }
}

namespace {

constexpr double kRadius = 0.1;
constexpr double kMass = 2.0;
constexpr double kWeight = kMass * kGravity;

/// A drum that stands on the floor and touches the edge of a step ahead.
class DrumBeforeStep {
  public:
    DrumBeforeStep(const EngineCase& engine, double height, double friction, double pull = 0.0)
        : edge_(std::acos(1.0 - height / kRadius)),
          step_(terrain::Terrain::extruded({{-5.0, 0.0},
                                            {kRadius * std::sin(edge_), 0.0},
                                            {kRadius * std::sin(edge_), height},
                                            {5.0, height}},
                                           -1.0, 1.0)),
          world_(engine, pulled(pull), kGravity, 0.001) {
        world_.placeOn(step_, friction);
    }

    /// Angle at the drum's centre between straight down and the edge [rad].
    double edge() const { return edge_; }

    void run(double torque, double seconds) {
        world_.external = {torque};
        world_.run(seconds);
    }

    /// How far its centre has risen [m].
    double risen() const {
        return (world_.engine().poses()[0] * Vec3(0, 0, kRadius)).z() - kRadius;
    }

    double rate() const { return world_.engine().velocities()[0].angular.y(); }

  private:
    /// With a weightless rope so long that it pulls level wherever the drum is.
    static Mechanism pulled(double force) {
        constexpr double kFar = 1e4;
        Mechanism mechanism = makeDrum(kMass, kRadius, 0.08, {0.0, 0.0, kRadius});
        mechanism.bodies.push_back(makeBody("post", 1.0, {kFar, 0.0, kRadius}));
        mechanism.bodies[1].fixed = true;
        simcore::mechanism::Spring rope;
        rope.first = 0;
        rope.second = 1;
        rope.firstPoint = {0.0, 0.0, kRadius};
        rope.secondPoint = {kFar, 0.0, kRadius};
        rope.preload = -force;
        mechanism.springs = {rope};
        return mechanism;
    }

    double edge_;
    terrain::Terrain step_;
    World world_;
};

constexpr double kHeights[] = {0.01, 0.02, 0.04};

}  // namespace

// Pulled at its axle a wheel leaves the floor when the moments about the edge say so, with whatever
// friction: W R sin(edge) = F R cos(edge).
TEST_P(SlopesAndStepsTest, PulledWheelClimbsAtThePullOfStatics) {
    for (const double height : kHeights) {
        for (const double mu : {0.0, 0.2, 0.9}) {
            const double pull = kWeight * std::tan(DrumBeforeStep(GetParam(), height, mu).edge());
            DrumBeforeStep held(GetParam(), height, mu, 0.98 * pull);
            held.run(0.0, 0.5);
            EXPECT_LT(held.risen(), 1e-4) << height << ", " << mu;
            DrumBeforeStep lifted(GetParam(), height, mu, 1.02 * pull);
            lifted.run(0.0, 0.5);
            EXPECT_GT(lifted.risen(), 0.002) << height << ", " << mu;
        }
    }
}

// Turned by a torque alone it leaves the floor at W R sin(edge), the edge carrying its weight
// straight up; so it does if friction allows a force that is off the normal by the edge's angle.
TEST_P(SlopesAndStepsTest, TurnedWheelClimbsAtTheTorqueOfStatics) {
    for (const double height : kHeights) {
        const double edge = DrumBeforeStep(GetParam(), height, 0.0).edge();
        const double torque = kWeight * kRadius * std::sin(edge);
        DrumBeforeStep drum(GetParam(), height, 1.05 * std::tan(edge));
        drum.run(0.5 * torque, 0.2);
        drum.run(0.98 * torque, 0.5);
        EXPECT_LT(drum.risen(), 1e-4) << height;
        EXPECT_LT(std::abs(drum.rate()), 1e-3) << height;
        drum.run(1.02 * torque, 0.5);
        EXPECT_GT(drum.risen(), 0.002) << height;
    }
}

// With less friction it slips at floor and edge before that, where F1 = mu N1 and F2 = mu N2
// balance the weight: N1 = N2 (sin - mu cos) / mu, N1 + N2 (cos + mu sin) = W. Then it stays, and
// what the torque has in excess spins it up.
TEST_P(SlopesAndStepsTest, TurnedWheelSpinsWithoutTheFrictionOfStatics) {
    for (const double height : kHeights) {
        const double edge = DrumBeforeStep(GetParam(), height, 0.0).edge();
        for (const double share : {0.5, 0.95}) {
            const double mu = share * std::tan(edge);
            const double floorShare = (std::sin(edge) - mu * std::cos(edge)) / mu;
            const double atEdge = kWeight / (floorShare + std::cos(edge) + mu * std::sin(edge));
            const double torque = kRadius * mu * atEdge * (1.0 + floorShare);
            ASSERT_LT(torque, kWeight * kRadius * std::sin(edge));
            DrumBeforeStep drum(GetParam(), height, mu);
            drum.run(0.5 * torque, 0.2);
            drum.run(0.98 * torque, 0.5);
            EXPECT_LT(std::abs(drum.rate()), 1e-3) << height << ", " << share;
            drum.run(1.1 * torque, 0.1);
            const double before = drum.rate();
            drum.run(1.1 * torque, 0.3);
            const double inertia = 0.5 * kMass * kRadius * kRadius;
            EXPECT_NEAR(inertia * (drum.rate() - before) / 0.3, 0.1 * torque,
                        (GetParam().frictionSlack + 1e-3) * torque)
                << height << ", " << share;
            EXPECT_LT(drum.risen(), 1e-4) << height << ", " << share;
        }
    }
}
