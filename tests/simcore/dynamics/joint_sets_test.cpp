// Every set of free directions a joint may have: what is held stays, what is free is not braked.
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "simcore/dynamics/engine.h"
#include "tests/support/mechanisms.h"

using namespace simcore;
using namespace simcore::dynamics;
using namespace testsupport;

namespace {

constexpr double kStep = 0.001;
constexpr std::size_t kNumbersPerBody = 13;

Vec3 randomDirection(Random& random) {
    return Vec3(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0))
        .normalized();
}

/// Three directions that span space without being at right angles.
std::vector<Vec3> randomDirections(Random& random) {
    for (;;) {
        const std::vector<Vec3> d{randomDirection(random), randomDirection(random),
                                  randomDirection(random)};
        if (std::abs(d[0].cross(d[1]).dot(d[2])) > 0.4) {
            return d;
        }
    }
}

/// A body on a fixed one, with the turns and slides whose bits are set.
Mechanism makeJoined(unsigned turns, unsigned slides, Random& random) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 3.0, {0.1, 0.0, 0.2}),
                        makeBody("part", 0.8, {0.15, -0.1, 0.4}, {0.004, 0.006, 0.005})};
    mechanism.bodies[0].fixed = true;
    Joint joint = makePin("joint", 0, 1, {0.1, 0.05, 0.3});
    joint.built.clear();
    const std::vector<Vec3> turnAxes = randomDirections(random);
    const std::vector<Vec3> slideAxes = randomDirections(random);
    for (std::size_t k = 0; k < 3; ++k) {
        if ((turns >> k & 1U) != 0) {
            joint.built.push_back({FreedomKind::Turn, turnAxes[k]});
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if ((slides >> k & 1U) != 0) {
            joint.built.push_back({FreedomKind::Slide, slideAxes[k]});
        }
    }
    joint.relaxed = joint.built;
    mechanism.joints = {joint};
    return mechanism;
}

std::vector<Vec3> freeOf(const Joint& joint, FreedomKind kind) {
    std::vector<Vec3> found;
    for (const Freedom& freedom : joint.built) {
        if (freedom.kind == kind) {
            found.push_back(freedom.direction);
        }
    }
    return found;
}

/// How far a vector reaches out of the span of some directions.
double outside(const Vec3& v, const std::vector<Vec3>& span) {
    if (span.size() == 3) {
        return 0.0;
    }
    if (span.size() == 2) {
        return std::abs(v.dot(span[0].cross(span[1]).normalized()));
    }
    return span.empty() ? v.norm() : (v - v.dot(span[0]) * span[0]).norm();
}

/// How far the joint's held directions are off, [m] and [rad].
std::pair<double, double> errorsOf(const Mechanism& mechanism, const std::vector<Pose>& poses) {
    const Joint& joint = mechanism.joints[0];
    const Vec3 moved = poses[1] * joint.point - joint.point;
    const std::vector<Vec3> turns = freeOf(joint, FreedomKind::Turn);
    double turned = 0.0;
    if (turns.size() == 2) {
        // The angle between the axis in the first body and the one in the second.
        turned = std::abs(turns[0].dot(poses[1].rotation * turns[1]) - turns[0].dot(turns[1]));
    } else if (turns.size() < 2) {
        const Eigen::AngleAxisd turn(poses[1].rotation);
        turned = outside(turn.angle() * turn.axis(), turns);
    }
    return {outside(moved, freeOf(joint, FreedomKind::Slide)), turned};
}

double kineticEnergy(const Mechanism& mechanism, const Engine& engine) {
    const Mat3 R = engine.poses()[1].rotation.toRotationMatrix();
    const BodyVelocity& v = engine.velocities()[1];
    return 0.5 * mechanism.bodies[1].mass * v.linear.squaredNorm() +
           0.5 * v.angular.dot(R * mechanism.bodies[1].inertia * R.transpose() * v.angular);
}

/// A velocity of the part that the joint lets be: combinations of its free directions.
BodyVelocity freeVelocity(const Mechanism& mechanism, Random& random) {
    const Joint& joint = mechanism.joints[0];
    Vec3 point = Vec3::Zero();
    BodyVelocity velocity;
    for (const Freedom& freedom : joint.built) {
        const double size = random.uniform(0.3, 1.0);
        if (freedom.kind == FreedomKind::Turn) {
            velocity.angular += size * freedom.direction;
        } else {
            point += 0.2 * size * freedom.direction;
        }
    }
    velocity.linear = point + velocity.angular.cross(mechanism.bodies[1].com - joint.point);
    return velocity;
}

void setVelocity(Engine& engine, std::size_t body, const BodyVelocity& velocity) {
    std::vector<double> state = engine.saveState();
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        state[body * kNumbersPerBody + 7 + k] = velocity.linear[axis];
        state[body * kNumbersPerBody + 10 + k] = velocity.angular[axis];
    }
    engine.restoreState(state);
}

class JointSetTest : public ::testing::TestWithParam<unsigned> {};

std::string nameOfSet(const ::testing::TestParamInfo<unsigned>& info) {
    std::string name = "Turns";
    for (unsigned k = 0; k < 3; ++k) {
        name += (info.param >> k & 1U) != 0 ? std::to_string(k) : "";
    }
    name += "Slides";
    for (unsigned k = 0; k < 3; ++k) {
        name += (info.param >> (3 + k) & 1U) != 0 ? std::to_string(k) : "";
    }
    return name;
}

}  // namespace

INSTANTIATE_TEST_SUITE_P(Sets, JointSetTest, ::testing::Range(1U, 64U), nameOfSet);

// No force acts but the joint's: what it holds stays put, and as it does no work, energy stays too.
TEST_P(JointSetTest, HoldsWhatItHoldsAndBrakesNothing) {
    Random random(GetParam());
    const Mechanism mechanism = makeJoined(GetParam() & 7U, GetParam() >> 3U, random);
    const auto engine = makeOdeEngine(mechanism, {kStep, 0.0});
    setVelocity(*engine, 1, freeVelocity(mechanism, random));
    const double energy = kineticEnergy(mechanism, *engine);
    ASSERT_GT(energy, 1e-4);
    for (int i = 0; i < 400; ++i) {
        engine->step({});
        const auto [moved, turned] = errorsOf(mechanism, engine->poses());
        ASSERT_LT(moved, 1e-5) << "at step " << i;
        ASSERT_LT(turned, 1e-5) << "at step " << i;
        ASSERT_NEAR(loopError(mechanism, engine->poses()), moved, 1e-12) << "at step " << i;
    }
    EXPECT_NEAR(kineticEnergy(mechanism, *engine), energy, 0.01 * energy);
    EXPECT_EQ(engine->poses()[0].position, Vec3::Zero()) << "the frame is fixed";
}

// A part at rest under gravity: the reaction has no part along a free direction, and what is held
// entirely carries the weight and its moment about the joint's point.
TEST_P(JointSetTest, ReactionActsAlongHeldDirectionsOnly) {
    Random random(100 + GetParam());
    const Mechanism mechanism = makeJoined(GetParam() & 7U, GetParam() >> 3U, random);
    const auto engine = makeOdeEngine(mechanism, {kStep, kGravity});
    engine->step({});
    const JointReaction& reaction = engine->jointReactions()[0];
    for (const Freedom& freedom : mechanism.joints[0].built) {
        const Vec3& part = freedom.kind == FreedomKind::Turn ? reaction.torque : reaction.force;
        EXPECT_NEAR(part.dot(freedom.direction), 0.0, 1e-3);
    }
    // Newton and Euler for the one step: the reaction and the weight make the motion.
    const Body& part = mechanism.bodies[1];
    const BodyVelocity& v = engine->velocities()[1];
    const Vec3 weight(0.0, 0.0, -part.mass * kGravity);
    EXPECT_LT((reaction.force + weight - part.mass * v.linear / kStep).norm(), 1e-6);
    const Vec3 arm = mechanism.joints[0].point - part.com;
    EXPECT_LT(
        (reaction.torque + arm.cross(reaction.force) - part.inertia * v.angular / kStep).norm(),
        1e-6);
}

namespace {

/// A part on a fixed frame that a motor turns about y at its place, with the given free turns.
Mechanism makeTurned(const std::vector<Freedom>& freedoms) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("frame", 3.0, Vec3::Zero()),
                        makeBody("part", 0.8, Vec3::Zero(), {0.004, 0.006, 0.005})};
    mechanism.bodies[0].fixed = true;
    mechanism.joints = {makePin("joint", 0, 1, Vec3::Zero())};
    mechanism.joints[0].built = freedoms;
    return mechanism;
}

const std::vector<std::vector<Freedom>>& turnSets() {
    static const std::vector<std::vector<Freedom>> sets{
        {{FreedomKind::Turn, Vec3::UnitY()}},
        {{FreedomKind::Turn, -Vec3::UnitY()}},
        {{FreedomKind::Turn, Vec3::UnitX()}, {FreedomKind::Turn, Vec3::UnitY()}},
        {{FreedomKind::Turn, Vec3::UnitX()},
         {FreedomKind::Turn, Vec3::UnitY()},
         {FreedomKind::Turn, Vec3::UnitZ()}},
        {{FreedomKind::Turn, Vec3::UnitY()}, {FreedomKind::Slide, Vec3::UnitZ()}}};
    return sets;
}

}  // namespace

// A motor reaches its rate with its torque limit, I w = t T, and then keeps it.
TEST(JointMotorTest, TurnsAnyJointAboutItsAxis) {
    for (const auto& freedoms : turnSets()) {
        const Mechanism mechanism = makeTurned(freedoms);
        const auto engine = makeOdeEngine(mechanism, {kStep, 0.0});
        const std::vector<JointMotor> motors{{0, 1.5, 0.06}};
        StepInput input;
        input.motors = motors;
        for (int i = 0; i < 100; ++i) {  // 0.06 N m / 0.006 kg m^2: 1 rad/s in 0.1 s
            engine->step(input);
        }
        EXPECT_NEAR(jointRate(mechanism.joints[0], engine->poses(), engine->velocities()), 1.0,
                    1e-6);
        EXPECT_NEAR(engine->jointReactions()[0].torque.y(), 0.06, 1e-9);
        for (int i = 0; i < 100; ++i) {
            engine->step(input);
        }
        EXPECT_NEAR(jointRate(mechanism.joints[0], engine->poses(), engine->velocities()), 1.5,
                    1e-6);
        engine->step({});  // without a motor it goes on turning
        EXPECT_NEAR(jointRate(mechanism.joints[0], engine->poses(), engine->velocities()), 1.5,
                    1e-6);
    }
}

// Stops hold the turn about the axis whatever else a joint leaves free.
TEST(JointMotorTest, StopsHoldAnyJoint) {
    for (const auto& freedoms : turnSets()) {
        for (const double sign : {1.0, -1.0}) {
            Mechanism mechanism = makeTurned(freedoms);
            mechanism.joints[0].stops = {-0.1, 0.2};
            const auto engine = makeOdeEngine(mechanism, {kStep, 0.0});
            const std::vector<JointMotor> motors{{0, sign, 0.05}};
            StepInput input;
            input.motors = motors;
            for (int i = 0; i < 1500; ++i) {
                engine->step(input);
            }
            EXPECT_NEAR(jointAngle(mechanism.joints[0], engine->poses()), sign > 0 ? 0.2 : -0.1,
                        2e-3);
        }
    }
}
