// What every engine behind the port has to do, against closed forms. An engine is tested for what
// it says it can: free bodies always, contacts and joints by capability.
#include <cmath>
#include <numbers>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/engine_cases.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

constexpr double kStep = 0.001;
constexpr double kGravityHere = 9.81;

/// A body with three different moments of inertia; it can be turned about an oblique axis.
Mechanism makeTop() {
    Mechanism mechanism = makeDrum(2.0, 0.1, 0.05, {0.3, -0.2, 1.0});
    mechanism.bodies[0].inertia = Vec3(0.02, 0.03, 0.045).asDiagonal();
    mechanism.wheels[0].axis = Vec3(0.6, 0.64, 0.48);
    return mechanism;
}

constexpr double kRadius = 0.1;
constexpr double kMass = 2.0;

/// A solid drum that stands on the ground of slopeThroughOrigin().
Mechanism makeDrumOn(double slope) {
    return makeDrum(kMass, kRadius, 0.08,
                    {-kRadius * std::sin(slope), 0.0, kRadius * std::cos(slope)});
}

constexpr double kBoxHeight = 0.12;

/// A solid box without wheels, `gap` above the ground of slopeThroughOrigin(slope) and pitched by
/// `pitch` against it.
Mechanism makeBox(double slope, double gap, double pitch = 0.0) {
    const Vec3 size(0.3, 0.2, kBoxHeight);
    Mechanism mechanism;
    mechanism.name = "box";
    const Vec3 normal(-std::sin(slope), 0.0, std::cos(slope));
    const double low = 0.5 * (size.x() * std::abs(std::sin(pitch)) + size.z() * std::cos(pitch));
    mechanism::Shape shape;
    shape.center = (low + gap) * normal;
    shape.size = size;
    shape.pitch = pitch - slope;
    mechanism.bodies = {makeBody("box", kMass, shape.center)};
    mechanism.bodies[0].shapes = {shape};
    mechanism.bodies[0].inertia = mechanism::inertiaOfShapes({shape}, kMass);
    return mechanism;
}

/// Speed gained along the slope, downwards, per time [m/s^2]; measured once the drum has settled.
double accelerationDown(World& world, double slope, double& spinUp) {
    const Vec3 down(-std::cos(slope), 0.0, -std::sin(slope));
    world.run(0.2);
    const BodyVelocity start = world.engine().velocities()[0];
    world.run(0.4);
    const BodyVelocity end = world.engine().velocities()[0];
    spinUp = -(end.angular - start.angular).y() / 0.4;  // rolling down is a turn about -y
    return (end.linear - start.linear).dot(down) / 0.4;
}

}  // namespace

// -- every engine ---------------------------------------------------------------------------------

class EngineConformanceTest : public ::testing::TestWithParam<EngineCase> {};

INSTANTIATE_TEST_SUITE_P(Engines, EngineConformanceTest, ::testing::ValuesIn(allEngines()),
                         nameOfCase);

// g t^2 / 2, and no more off than a first-order method may be: g t dt / 2.
TEST_P(EngineConformanceTest, BodiesFallFreely) {
    for (const double step : {0.0005, 0.002, 0.005}) {
        Mechanism mechanism;
        mechanism.bodies = {makeBody("stone", 2.0, {0.1, 0.2, 5.0}),
                            makeBody("feather", 1e-3, {1.0, 0.0, 3.0}, {1e-6, 1e-6, 1e-6})};
        World world(GetParam(), mechanism, kGravityHere, step);
        world.run(0.5);
        for (std::size_t i = 0; i < 2; ++i) {
            const Pose& pose = world.engine().poses()[i];
            EXPECT_NEAR(pose.position.z(), -0.5 * kGravityHere * 0.25,
                        1.001 * 0.5 * kGravityHere * 0.5 * step);
            EXPECT_NEAR(world.engine().velocities()[i].linear.z(), -0.5 * kGravityHere, 1e-9);
            EXPECT_NEAR(pose.position.head<2>().norm(), 0.0, 1e-12);
            EXPECT_LT(pose.rotation.vec().norm(), 1e-12);
        }
    }
}

// A torque on a wheel alone gives the angular momentum of its impulse, and no push.
TEST_P(EngineConformanceTest, ExternalTorqueGivesItsImpulse) {
    World world(GetParam(), makeTop(), 0.0);
    world.external = {0.3};
    Vec3 impulse = Vec3::Zero();
    for (int i = 0; i < 200; ++i) {
        impulse += world.external[0] * kStep *
                   (world.engine().poses()[0].rotation * world.mechanism().wheels[0].axis);
        world.step();
    }
    EXPECT_GT(impulse.norm(), 0.05);
    EXPECT_LT((world.angularMomentum() - impulse).norm(), 2e-3 * impulse.norm());
    EXPECT_LT(world.momentum().norm(), 1e-12);
}

// A wheel's drive turns wheel and carrier against each other: rates torque t / I, sum zero.
TEST_P(EngineConformanceTest, DriveTorqueIsEqualAndOpposite) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("carrier", 3.0, {0.0, 0.0, 0.2}, {0.1, 0.12, 0.15}),
                        makeBody("wheel", 0.5, {0.0, 0.0, 0.2}, {0.002, 0.004, 0.002})};
    mechanism.wheels = makeDrum(0.5, 0.1, 0.05).wheels;
    mechanism.wheels[0].body = 1;
    World world(GetParam(), mechanism, 0.0);
    world.drive = {0.05};
    world.run(0.1);
    EXPECT_NEAR(world.engine().velocities()[1].angular.y(), 0.05 * 0.1 / 0.004, 1e-9);
    EXPECT_NEAR(world.engine().velocities()[0].angular.y(), -0.05 * 0.1 / 0.12, 1e-9);
    EXPECT_LT(world.angularMomentum().norm(), 1e-12);
}

// An unsymmetrical top tumbles; its momentum and energy stay.
TEST_P(EngineConformanceTest, TumblingBodyKeepsMomentumAndEnergy) {
    World world(GetParam(), makeTop(), 0.0);
    world.external = {0.5};
    world.run(0.2);
    world.external = {0.0};
    const Vec3 momentum = world.angularMomentum();
    const double energy = world.kineticEnergy();
    ASSERT_GT(energy, 0.01);
    const Vec3 spin = world.engine().velocities()[0].angular;
    double wandered = 0.0;
    for (int i = 0; i < 2000; ++i) {
        world.step();
        wandered = std::max(wandered,
                            (world.engine().velocities()[0].angular - spin).norm() / spin.norm());
    }
    EXPECT_GT(wandered, 0.05) << "the test needs a body that tumbles";
    EXPECT_LT((world.angularMomentum() - momentum).norm(), 0.01 * momentum.norm());
    EXPECT_NEAR(world.kineticEnergy(), energy, 0.01 * energy);
}

// Restoring a state, in this world or in another one of the same kind, continues bit for bit.
TEST_P(EngineConformanceTest, RestoredStateContinuesBitForBit) {
    World world(GetParam(), makeTop(), kGravityHere);
    world.external = {0.5};
    world.run(0.1);
    const std::vector<double> saved = world.engine().saveState();
    world.run(0.2);
    const std::vector<double> straight = world.engine().saveState();
    EXPECT_NE(straight, saved);
    world.engine().restoreState(saved);
    EXPECT_EQ(world.engine().saveState(), saved);
    world.run(0.2);
    EXPECT_EQ(world.engine().saveState(), straight);
    World other(GetParam(), makeTop(), kGravityHere);
    other.external = {0.5};
    other.engine().restoreState(saved);
    other.run(0.2);
    EXPECT_EQ(other.engine().saveState(), straight);
}

TEST_P(EngineConformanceTest, StateOfAnotherMechanismIsRefused) {
    World world(GetParam(), makeTop(), kGravityHere);
    EXPECT_THROW(world.engine().restoreState(std::vector<double>(5, 0.0)), std::invalid_argument);
}

// Reset puts every body back to the drawn pose, at rest, and counts from zero.
TEST_P(EngineConformanceTest, ResetStartsAgain) {
    World world(GetParam(), makeTop(), kGravityHere);
    const std::vector<double> start = world.engine().saveState();
    world.external = {0.5};
    world.run(0.3);
    EXPECT_EQ(world.engine().counters().steps, 300);
    EXPECT_GE(world.engine().counters().passes, 300);
    world.engine().reset();
    EXPECT_EQ(world.engine().saveState(), start);
    EXPECT_EQ(world.engine().counters().steps, 0);
    EXPECT_EQ(world.engine().poses()[0].position, Vec3::Zero().eval());
    EXPECT_EQ(world.engine().velocities()[0].angular, Vec3::Zero().eval());
}

// -- engines with contacts ------------------------------------------------------------------------

class ContactConformanceTest : public ::testing::TestWithParam<EngineCase> {};

INSTANTIATE_TEST_SUITE_P(Engines, ContactConformanceTest,
                         ::testing::ValuesIn(enginesThatCan(Can::Contacts)), nameOfCase);

// At rest the ground carries the weight, both discs of the wheel alike, and nothing sideways.
TEST_P(ContactConformanceTest, GroundCarriesTheWeight) {
    World world(GetParam(), makeDrumOn(0.0), kGravityHere);
    const terrain::Terrain ground = levelGround();
    world.placeOn(ground, 0.7);
    world.run(1.0);
    ASSERT_EQ(world.engine().contactForces().size(), 2u);
    EXPECT_NEAR(world.contactForce(Vec3::UnitZ()), kMass * kGravityHere,
                1e-3 * kMass * kGravityHere);
    EXPECT_NEAR(world.engine().contactForces()[0].z(), world.engine().contactForces()[1].z(), 0.01);
    EXPECT_NEAR(world.contactForce(Vec3::UnitX()), 0.0, 1e-3);
    EXPECT_NEAR(world.contactForce(Vec3::UnitY()), 0.0, 1e-3);
    EXPECT_LT(world.engine().velocities()[0].linear.norm(), 1e-3);
}

// A solid cylinder rolls down a slope with 2/3 g sin(slope) and turns as it moves.
TEST_P(ContactConformanceTest, DrumRollsDownASlope) {
    for (const double slope : {0.1, 0.3, 0.5}) {
        World world(GetParam(), makeDrumOn(slope), kGravityHere);
        const terrain::Terrain ground = slopeThroughOrigin(slope);
        world.placeOn(ground, 0.7);  // tan(slope) / 3 is needed to roll
        double spinUp = 0.0;
        const double expected = 2.0 / 3.0 * kGravityHere * std::sin(slope);
        EXPECT_NEAR(accelerationDown(world, slope, spinUp), expected, 0.01 * expected);
        EXPECT_NEAR(spinUp * kRadius, expected, 0.01 * expected);
    }
}

// With less friction than tan(slope) / 3 it slides with g (sin - mu cos), turned by mu m g cos R.
TEST_P(ContactConformanceTest, DrumSlidesDownASlope) {
    const double slope = 0.6;
    const terrain::Terrain ground = slopeThroughOrigin(slope);
    for (const double share : {0.0, 0.3, 0.9}) {
        const double friction = share * std::tan(slope) / 3.0;
        World world(GetParam(), makeDrumOn(slope), kGravityHere);
        world.placeOn(ground, friction);
        double spinUp = 0.0;
        const double expected = kGravityHere * (std::sin(slope) - friction * std::cos(slope));
        EXPECT_NEAR(accelerationDown(world, slope, spinUp), expected, 0.01 * expected) << share;
        const double expectedSpin = 2.0 * friction * kGravityHere * std::cos(slope) / kRadius;
        EXPECT_NEAR(spinUp, expectedSpin, 0.02 * expectedSpin + 1e-6) << share;
    }
}

// An external torque within the limit of friction pushes the drum with 2/3 torque / (m R).
TEST_P(ContactConformanceTest, DrumRollsUnderATorque) {
    World world(GetParam(), makeDrumOn(0.0), kGravityHere);
    const terrain::Terrain ground = levelGround();
    world.placeOn(ground, 0.7);
    world.external = {0.3};
    world.run(0.2);
    const double start = world.engine().velocities()[0].linear.x();
    world.run(0.5);
    const double gained = world.engine().velocities()[0].linear.x() - start;
    const double expected = 2.0 / 3.0 * 0.3 / (kMass * kRadius) * 0.5;
    EXPECT_NEAR(gained, expected, 0.01 * expected);
    EXPECT_NEAR(world.engine().velocities()[0].angular.y() * kRadius, start + expected,
                0.01 * (start + expected));
}

// What friction remembers from step to step is part of the state.
TEST_P(ContactConformanceTest, RestoredContactsContinueBitForBit) {
    const terrain::Terrain ground = slopeThroughOrigin(0.6);
    const auto make = [&] {
        auto world = std::make_unique<World>(GetParam(), makeDrumOn(0.6), kGravityHere);
        world->placeOn(ground, 0.15);
        return world;
    };
    const auto world = make();
    world->run(0.1);
    const std::vector<double> saved = world->engine().saveState();
    world->run(0.2);
    const std::vector<double> straight = world->engine().saveState();
    const auto other = make();
    other->engine().restoreState(saved);
    other->run(0.2);
    EXPECT_EQ(other->engine().saveState(), straight);
}

// A reset forgets the contacts too: the same steps again, bit for bit.
TEST_P(ContactConformanceTest, ResetForgetsTheContacts) {
    const terrain::Terrain ground = slopeThroughOrigin(0.6);
    World world(GetParam(), makeDrumOn(0.6), kGravityHere);
    world.placeOn(ground, 0.15);
    world.run(0.05);
    const std::vector<double> first = world.engine().saveState();
    world.engine().reset();
    world.run(0.05);
    EXPECT_EQ(world.engine().saveState(), first);
}

// Worlds share nothing: four at the same time in their own threads end as one alone.
TEST_P(ContactConformanceTest, WorldsInThreadsEndAsAlone) {
    const terrain::Terrain ground = slopeThroughOrigin(0.3);
    const auto roll = [&](double friction, std::vector<double>& end) {
        World world(GetParam(), makeDrumOn(0.3), kGravityHere);
        world.placeOn(ground, friction);
        world.run(0.5);
        end = world.engine().saveState();
    };
    std::vector<std::vector<double>> alone(4);
    std::vector<std::vector<double>> together(4);
    std::vector<std::thread> threads;
    threads.reserve(together.size());
    for (std::size_t i = 0; i < 4; ++i) {
        roll(0.05 * static_cast<double>(i), alone[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
        threads.emplace_back([&, i] { roll(0.05 * static_cast<double>(i), together[i]); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_EQ(together, alone);
    EXPECT_NE(alone[0], alone[1]);
}

// -- engines with joints --------------------------------------------------------------------------

namespace {

/// A four-bar in free flight whose crank is driven like a wheel.
Mechanism makeDrivenFourBar() {
    Mechanism mechanism = makeFourBar();
    mechanism.wheels = makeDrum(0.5, 0.1, 0.05).wheels;
    mechanism.wheels[0].body = 1;
    mechanism.wheels[0].carrier = 0;
    return mechanism;
}

}  // namespace

// -- bodies that touch the ground -----------------------------------------------------------------

// The engines that runs use. The free-body engine has no damping to speak of for what stands on
// corners: there a box chatters.
class BodyContactConformanceTest : public ::testing::TestWithParam<EngineCase> {};

INSTANTIATE_TEST_SUITE_P(Engines, BodyContactConformanceTest,
                         ::testing::ValuesIn(enginesThatCan(Can::Joints)), nameOfCase);

// Dropped level, or on an edge: it comes to lie on its belly, and the ground carries m g.
TEST_P(BodyContactConformanceTest, ADroppedBoxRestsOnItsBelly) {
    for (const double pitch : {0.0, 0.3, -0.5}) {
        World world(GetParam(), makeBox(0.0, 0.005, pitch), kGravityHere, kStep);
        const auto ground = levelGround();
        world.placeOn(ground, 0.6);
        world.run(3.0);
        const double weight = kMass * kGravityHere;
        EXPECT_NEAR(world.contactForce(Vec3::UnitZ()), weight, 0.01 * weight) << pitch;
        EXPECT_LT(world.engine().velocities()[0].linear.norm(), 1e-3) << pitch;
        EXPECT_LT(world.engine().velocities()[0].angular.norm(), 5e-3) << pitch;
        const Pose& pose = world.engine().poses()[0];
        EXPECT_NEAR(simcore::pitch(pose) + pitch, 0.0, 2e-3);
        EXPECT_NEAR((pose * world.mechanism().bodies[0].com).z(), 0.5 * kBoxHeight, 1e-3);
    }
}

// a = g (sin - mu cos) down a slope steeper than the angle of friction; else it stays.
TEST_P(BodyContactConformanceTest, ABoxSlidesWhereFrictionLetsIt) {
    constexpr double kSlope = 0.35;  // tangent 0.365
    const Vec3 down(-std::cos(kSlope), 0.0, -std::sin(kSlope));
    const auto ground = slopeThroughOrigin(kSlope);
    for (const double friction : {0.0, 0.2, 0.5}) {
        World world(GetParam(), makeBox(kSlope, 0.0), kGravityHere, kStep);
        world.placeOn(ground, friction);
        world.run(0.2);
        const double before = world.engine().velocities()[0].linear.dot(down);
        world.run(0.4);
        const double gained = world.engine().velocities()[0].linear.dot(down) - before;
        const double expected =
            std::max(0.0, kGravityHere * (std::sin(kSlope) - friction * std::cos(kSlope)));
        EXPECT_NEAR(gained / 0.4, expected, 0.02 * kGravityHere * std::sin(kSlope)) << friction;
        EXPECT_LT(world.engine().velocities()[0].angular.norm(), 0.01) << "it does not tumble";
    }
}

class JointConformanceTest : public ::testing::TestWithParam<EngineCase> {};

INSTANTIATE_TEST_SUITE_P(Engines, JointConformanceTest,
                         ::testing::ValuesIn(enginesThatCan(Can::Joints)), nameOfCase);

// The crank's drive is internal: its work becomes motion of the links, the momenta stay zero.
TEST_P(JointConformanceTest, InternalDriveDoesWorkButNoPush) {
    World world(GetParam(), makeDrivenFourBar(), 0.0);
    const Joint& crank = world.mechanism().joints[0];
    double work = 0.0;
    world.drive = {0.2};
    for (int i = 0; i < 200; ++i) {
        const double before = jointRate(crank, world.engine().poses(), world.engine().velocities());
        world.step();
        const double after = jointRate(crank, world.engine().poses(), world.engine().velocities());
        work += world.drive[0] * 0.5 * (before + after) * kStep;
    }
    ASSERT_GT(work, 0.01);
    EXPECT_NEAR(world.kineticEnergy(), work, 0.01 * work);
    EXPECT_LT(world.momentum().norm(), 1e-6);
    EXPECT_LT(world.angularMomentum().norm(), 1e-3 * std::sqrt(2.0 * work * 0.05));
}

// In free flight a mechanism keeps its energy and its momenta while its links swing.
TEST_P(JointConformanceTest, FreeFlyingMechanismKeepsEnergyAndMomentum) {
    World world(GetParam(), makeDrivenFourBar(), 0.0);
    world.drive = {0.1};
    world.external = {0.1};
    world.run(0.2);
    world.drive = world.external = {0.0};
    const double energy = world.kineticEnergy();
    const Vec3 momentum = world.momentum();
    const Vec3 spin = world.angularMomentum();
    ASSERT_GT(energy, 1e-3);
    ASSERT_GT(spin.norm(), 1e-3);
    double swing = 0.0;
    double gap = 0.0;
    for (int i = 0; i < 3000; ++i) {
        world.step();
        swing = std::max(swing,
                         std::abs(jointAngle(world.mechanism().joints[0], world.engine().poses())));
        gap = std::max(gap, loopError(world.mechanism(), world.engine().poses()));
    }
    EXPECT_GT(swing, 0.2) << "the links hardly moved";
    EXPECT_NEAR(world.kineticEnergy(), energy, 0.02 * energy);
    EXPECT_LT((world.momentum() - momentum).norm(), 1e-6);
    EXPECT_LT((world.angularMomentum() - spin).norm(), 0.01 * spin.norm());
    EXPECT_LT(gap, 1e-5);
}

// A rod that a torsion spring swings about a pin at its end: the pin carries it on its circle, and
// the period is that of its inertia about the pin.
TEST_P(JointConformanceTest, SprungRodSwingsAboutItsEnd) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 1e5, Vec3::Zero(), {1e5, 1e5, 1e5}),
                        makeBody("rod", 0.8, {0.0, 0.0, -0.3}, {0.024, 0.024, 1e-4})};
    mechanism.joints = {makePin("pin", 0, 1, Vec3::Zero())};
    simcore::mechanism::Spring spring;
    spring.joint = 0;
    spring.first = 0;
    spring.second = 1;
    spring.stiffness = 2.0;
    spring.preload = 0.2;  // equilibrium at 0.1 rad
    mechanism.springs = {spring};
    World world(GetParam(), mechanism, 0.0);
    const double inertia = 0.024 + 0.8 * 0.3 * 0.3;
    const double period = 2.0 * std::numbers::pi * std::sqrt(inertia / spring.stiffness);
    world.run(period / 2.0);
    EXPECT_NEAR(jointAngle(mechanism.joints[0], world.engine().poses()), 0.2, 1e-3);
    world.run(period / 2.0);
    EXPECT_NEAR(jointAngle(mechanism.joints[0], world.engine().poses()), 0.0, 1e-3);
}

TEST_P(JointConformanceTest, RestoredMechanismContinuesBitForBit) {
    World world(GetParam(), makeDrivenFourBar(), kGravityHere);
    world.drive = {0.2};
    world.run(0.1);
    const std::vector<double> saved = world.engine().saveState();
    world.run(0.3);
    const std::vector<double> straight = world.engine().saveState();
    World other(GetParam(), makeDrivenFourBar(), kGravityHere);
    other.drive = {0.2};
    other.engine().restoreState(saved);
    other.run(0.3);
    EXPECT_EQ(other.engine().saveState(), straight);
}
