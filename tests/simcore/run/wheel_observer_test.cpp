// Slip, contact angle and friction violation from motions and forces given by hand.
#include "simcore/run/wheel_observer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/carts.h"
#include "tests/support/posed_engine.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::run;
using namespace testsupport;
using project::TerrainKind;

namespace {

constexpr double kStep = 0.002;
constexpr double kRadius = 0.1;
constexpr int kStepsPerWindow = 10;  // 20 ms

/// A wheel on a carrier; moves are made step by step.
class WheelObserverTest : public ::testing::Test {
  protected:
    WheelObserverTest() {
        contact::Contact floor;
        floor.wheel = 0;
        floor.point = Vec3::Zero();
        contacts = {floor};
        engine.forces = {Vec3(0.0, 0.0, 20.0)};
    }

    static Mechanism wheelOnCarrier() {
        Mechanism mechanism = makeDrum(1.0, kRadius, 0.05, {0.0, 0.0, kRadius});
        mechanism.bodies.push_back(makeBody("carrier", 1.0, {0.0, 0.0, 0.2}));
        mechanism.wheels[0].carrier = 1;
        return mechanism;
    }

    Vec3 center() const { return engine.bodyPoses[0] * mechanism.wheels[0].center; }

    /// The wheel's centre moves and the wheel turns about its axle in one step.
    void move(const Vec3& shift, double turn, bool count = true) {
        const std::vector<Pose> before = engine.bodyPoses;
        const Vec3 target = center() + shift;
        Pose& pose = engine.bodyPoses[0];
        pose.rotation = Eigen::AngleAxisd(turn, Vec3::UnitY()) * pose.rotation;
        pose.position += target - center();
        engine.bodyVelocities[0] = {shift / kStep, turn / kStep * Vec3::UnitY()};
        observer.observe(engine, before, contacts, count, states);
        for (contact::Contact& contact : contacts) {
            if (contactFollows) {
                contact.point += shift;
            }
        }
    }

    const WheelState& state() const { return states[0]; }

    const Mechanism mechanism = wheelOnCarrier();
    PosedEngine engine{2};
    WheelObserver observer{mechanism, kStep};
    std::vector<contact::Contact> contacts;
    std::vector<WheelState> states{1};
    bool contactFollows = true;
};

}  // namespace

// Paper eq. 5: the centre moves by R times the turn, so there is no slip.
TEST_F(WheelObserverTest, PureRollingOnAPlaneHasNoSlip) {
    for (int i = 0; i < 500; ++i) {
        move({0.0002, 0.0, 0.0}, 0.0002 / kRadius);
    }
    EXPECT_NEAR(center().x(), 0.1, 1e-12);
    EXPECT_LT(state().slipAbs, 1e-12);
    EXPECT_LT(std::abs(state().slipSigned), 1e-12);
    EXPECT_NEAR(state().slipRatio, 0.0, 1e-9);
    EXPECT_NEAR(state().centerSpeed, 0.1, 1e-12);
    EXPECT_NEAR(state().rate, 1.0, 1e-12);
}

// A wheel that pivots about an edge turns as its centre goes round: no slip, although the centre
// moves up and the contact angle changes from 60 degrees to zero.
TEST_F(WheelObserverTest, PivotingAboutAnEdgeHasNoSlip) {
    contactFollows = false;
    const Vec3 edge(0.3, 0.0, 0.05);
    double angle = std::numbers::pi / 3.0;
    const auto above = [&] {
        return Vec3(edge + kRadius * Vec3(-std::sin(angle), 0.0, std::cos(angle)));
    };
    engine.bodyPoses[0].position = above() - mechanism.wheels[0].center;
    const int steps = 1000;
    const double turn = angle / steps;
    double traveled = 0.0;
    for (int i = 0; i < steps; ++i) {
        contacts[0].point = edge;
        contacts[0].normal = (center() - edge).normalized();
        engine.forces[0] = 20.0 * contacts[0].normal;
        const double expected = angle;
        angle -= turn;
        move(above() - center(), turn);
        EXPECT_NEAR(state().contactAngle, expected, 1e-9);
        traveled += state().centerSpeed * kStep;
    }
    EXPECT_NEAR(traveled, kRadius * std::numbers::pi / 3.0, 1e-6);
    EXPECT_LT(state().slipAbs, 1e-6);
}

// Other engines name contacts in an order of their own.
TEST_F(WheelObserverTest, OrderOfContactsDoesNotMatter) {
    contact::Contact body;
    body.body = 1;
    contacts.insert(contacts.begin(), body);
    engine.forces.insert(engine.forces.begin(), Vec3(0.0, 0.0, 7.0));
    move({0.0002, 0.0, 0.0}, 0.0002 / kRadius);
    EXPECT_TRUE(state().touching);
    EXPECT_EQ(state().normalForce, 20.0);
    EXPECT_LT(state().slipAbs, 1e-12);
}

// Slip counts the wheel's absolute turn: one that stands still while its carrier pitches does not
// slip, and one that is locked to a pitching carrier and moves as it turns does not either.
TEST_F(WheelObserverTest, PitchOfTheCarrierIsNotSlip) {
    for (int i = 0; i < 100; ++i) {
        engine.bodyPoses[1].rotation =
            Eigen::AngleAxisd(0.01, Vec3::UnitY()) * engine.bodyPoses[1].rotation;
        engine.bodyVelocities[1].angular = Vec3(0.0, 5.0, 0.0);
        move(Vec3::Zero(), 0.0);
    }
    EXPECT_LT(state().slipAbs, 1e-12);
    EXPECT_EQ(state().rate, 0.0);
    for (int i = 0; i < 100; ++i) {
        engine.bodyPoses[1].rotation =
            Eigen::AngleAxisd(0.01, Vec3::UnitY()) * engine.bodyPoses[1].rotation;
        move({0.01 * kRadius, 0.0, 0.0}, 0.01);
    }
    EXPECT_LT(state().slipAbs, 1e-12);
}

// A wheel spinning on the spot slips by -R times its turn, with a slip ratio of +1; a locked one
// that is dragged slips by its way, with -1.
TEST_F(WheelObserverTest, SpinningAndDraggedWheelsSlipByDefinition) {
    for (int i = 0; i < 100; ++i) {
        move(Vec3::Zero(), 0.003);
    }
    EXPECT_NEAR(state().slipSigned, -0.3 * kRadius, 1e-12);
    EXPECT_NEAR(state().slipAbs, 0.3 * kRadius, 1e-12);
    EXPECT_NEAR(state().slipRatio, 1.0, 1e-12);
    for (int i = 0; i < 100; ++i) {
        move({0.0004, 0.0, 0.0}, 0.0);
    }
    EXPECT_NEAR(state().slipSigned, 0.04 - 0.3 * kRadius, 1e-12);
    EXPECT_NEAR(state().slipAbs, 0.04 + 0.3 * kRadius, 1e-12);
    EXPECT_NEAR(state().slipRatio, -1.0, 1e-12);
}

// Near standstill the slip ratio is measured against 0.01 m/s.
TEST_F(WheelObserverTest, SlipRatioIsGuardedAtStandstill) {
    move(Vec3::Zero(), 0.002 * kStep / kRadius);
    EXPECT_NEAR(state().slipRatio, 0.2, 1e-9);
}

// Slips within a window of 20 ms cancel, the windows' absolute values add up.
TEST_F(WheelObserverTest, AbsoluteSlipSumsWindows) {
    for (int i = 0; i < 10 * kStepsPerWindow; ++i) {  // to and fro within each window
        move({i % 2 == 0 ? 0.001 : -0.001, 0.0, 0.0}, 0.0);
    }
    EXPECT_LT(state().slipAbs, 1e-12);
    for (int window = 0; window < 10; ++window) {  // to and fro from window to window
        for (int i = 0; i < kStepsPerWindow; ++i) {
            move({window % 2 == 0 ? 0.001 : -0.001, 0.0, 0.0}, 0.0);
        }
    }
    EXPECT_NEAR(state().slipAbs, 10 * kStepsPerWindow * 0.001, 1e-12);
    EXPECT_NEAR(state().slipSigned, 0.0, 1e-12);
}

// The last window may be shorter; what is not to be counted is not.
TEST_F(WheelObserverTest, CountsWhatItIsToldTo) {
    move({0.005, 0.0, 0.0}, 0.0, false);
    move({0.001, 0.0, 0.0}, 0.0);
    move({0.001, 0.0, 0.0}, 0.0);
    EXPECT_EQ(state().slipAbs, 0.0);
    observer.closeWindow(states);
    EXPECT_NEAR(state().slipAbs, 0.002, 1e-12);
    observer.closeWindow(states);
    EXPECT_NEAR(state().slipAbs, 0.002, 1e-12);
}

// Motion along the axle is lateral slip and nothing else.
TEST_F(WheelObserverTest, MotionAlongTheAxleIsLateralSlip) {
    for (int i = 0; i < 3 * kStepsPerWindow; ++i) {
        move({0.0, -0.001, 0.0}, 0.0);
    }
    EXPECT_NEAR(state().slipLateral, 0.03, 1e-12);
    EXPECT_LT(state().slipAbs, 1e-12);
}

// A wheel pressed into the ground by d rolls on R - d: that is not slip.
TEST_F(WheelObserverTest, PenetrationIsNotSlip) {
    const double depth = 0.002;
    engine.bodyPoses[0].position.z() = -depth;
    for (int i = 0; i < 100; ++i) {
        move({0.001, 0.0, 0.0}, 0.001 / (kRadius - depth));
    }
    EXPECT_LT(state().slipAbs, 1e-12);
}

// In the air the wheel keeps its last contact angle, and its centre's motion along that tangent
// against its turn is still counted.
TEST_F(WheelObserverTest, RollingFrameIsHeldInTheAir) {
    const double angle = 0.5;
    const Vec3 normal(-std::sin(angle), 0.0, std::cos(angle));
    const Vec3 tangent(std::cos(angle), 0.0, std::sin(angle));
    contacts[0].point = center() - kRadius * normal;
    contacts[0].normal = normal;
    engine.forces[0] = 10.0 * normal + 4.0 * tangent + 1.0 * Vec3::UnitY();
    move(0.001 * tangent, 0.001 / kRadius);
    EXPECT_TRUE(state().touching);
    EXPECT_NEAR(state().contactAngle, angle, 1e-12);
    EXPECT_NEAR(state().normalForce, 10.0, 1e-12);
    EXPECT_NEAR(state().tractionForce, 4.0, 1e-12);
    EXPECT_NEAR(state().lateralForce, 1.0, 1e-12);
    contacts.clear();
    engine.forces.clear();
    move(0.002 * tangent, 0.002 / kRadius);
    EXPECT_FALSE(state().touching);
    EXPECT_NEAR(state().contactAngle, angle, 1e-12);
    EXPECT_EQ(state().normalForce, 0.0);
    EXPECT_NEAR(state().centerSpeed, 0.002 / kStep, 1e-9);
    observer.closeWindow(states);
    EXPECT_LT(state().slipAbs, 1e-12);
}

// Of 10 steps of 1 mm, 4 in the air and 2 with less than 2 % of the weight, 4 are loaded slip.
TEST_F(WheelObserverTest, LoadedSlipIsThatOfStepsUnderLoad) {
    const double least = leastLoad(mechanism);
    EXPECT_DOUBLE_EQ(least, 0.02 * 2.0 * 9.81) << "two bodies of 1 kg, one wheel";
    const auto moveUnder = [&](int steps, double load) {
        engine.forces = {load * Vec3::UnitZ()};
        for (int i = 0; i < steps; ++i) {
            move({0.001, 0.0, 0.0}, 0.0);
        }
    };
    moveUnder(4, 20.0);
    moveUnder(4, 0.0);
    moveUnder(2, 0.99 * least);
    EXPECT_NEAR(state().slipAbs, 0.010, 1e-12);
    EXPECT_NEAR(state().slipLoaded, 0.004, 1e-12);
    moveUnder(kStepsPerWindow, 1.01 * least);
    EXPECT_NEAR(state().slipLoaded, 0.014, 1e-12);
}

// What presses does no friction work, nor does what moves along the normal: 3 N against 2 m/s.
TEST(FrictionPowerTest, IsTangentialForceAgainstSliding) {
    contact::Contact contact;
    contact.normal = Vec3(-0.6, 0.0, 0.8);
    const Vec3 tangent(0.8, 0.0, 0.6);
    const Vec3 force = 10.0 * contact.normal - 3.0 * tangent + Vec3(0.0, 5.0, 0.0);
    EXPECT_NEAR(frictionPower(contact, force, 2.0 * tangent - 7.0 * contact.normal), 6.0, 1e-12);
    EXPECT_NEAR(frictionPower(contact, force, 4.0 * contact.normal), 0.0, 1e-12);
    EXPECT_NEAR(frictionPower(contact, force, -Vec3::UnitY()), 5.0, 1e-12);
}

// At floor and wall the normal is the mean weighted by force: 3 against 4 give atan(4/3).
TEST_F(WheelObserverTest, ContactAngleIsWeightedByForce) {
    contact::Contact wall;
    wall.wheel = 0;
    wall.point = Vec3(kRadius, 0.0, kRadius);
    wall.normal = -Vec3::UnitX();
    contact::Contact other = wall;  // of another wheel: must not matter
    other.wheel = 1;
    contacts.push_back(wall);
    contacts.push_back(other);
    engine.forces = {Vec3(0.0, 0.0, 3.0), Vec3(-4.0, 0.0, 0.5), Vec3(-100.0, 0.0, 0.0)};
    move(Vec3::Zero(), 0.0);
    EXPECT_NEAR(state().contactAngle, std::atan2(4.0, 3.0), 1e-12);
    EXPECT_NEAR(state().normalForce, 7.0, 1e-12);
    const Vec3 mean = (3.0 * Vec3::Zero() + 4.0 * Vec3(kRadius, 0.0, kRadius)) / 7.0;
    EXPECT_LT((state().contactPoint - mean).norm(), 1e-12);
}

TEST_F(WheelObserverTest, ResetForgetsTheWindowAndTheFrame) {
    contacts[0].normal = Vec3(-0.6, 0.0, 0.8);
    engine.forces[0] = 10.0 * contacts[0].normal;
    move({0.001, 0.0, 0.0}, 0.0);
    observer.reset();
    contacts.clear();
    engine.forces.clear();
    states.assign(1, {});
    move(Vec3::Zero(), 0.0);
    observer.closeWindow(states);
    EXPECT_EQ(state().contactAngle, 0.0);
    EXPECT_EQ(state().slipAbs, 0.0);
}

namespace {

/// Four wheels of 20 N each: patches below 0.4 N do not count.
class FrictionMeterTest : public ::testing::Test {
  protected:
    static Mechanism fourWheels() {
        Mechanism mechanism = makeCart();
        mechanism.bodies[0].mass += 80.0 / 9.81 - mechanism.mass();
        return mechanism;
    }

    /// One step with one wheel touching at x with two discs, N on each.
    static void observe(FrictionMeter& meter, double x, double normal, const Vec3& tangential,
                        const Vec3& other) {
        std::vector<contact::Contact> contacts(2);
        for (int slice = 0; slice < 2; ++slice) {
            contacts[static_cast<std::size_t>(slice)].wheel = 0;
            contacts[static_cast<std::size_t>(slice)].slice = slice;
            contacts[static_cast<std::size_t>(slice)].point = {x, 0.0, 0.0};
        }
        const std::vector<Vec3> forces{Vec3(0.0, 0.0, normal) + tangential,
                                       Vec3(0.0, 0.0, normal) + other};
        meter.observe(contacts, forces, std::vector<double>(2, kMu));
    }

    static constexpr double kMu = 0.5;
    const Mechanism mechanism = fourWheels();
    const terrain::Terrain flat = levelGround();
    const terrain::Terrain step = made(spec(TerrainKind::Step, 0.1, 0.5));  // from x = 1 to 1.5
};

}  // namespace

// A patch is outside when |T| > 1.1 mu N + 0.2 N, T the whole tangential force, discs summed.
TEST_F(FrictionMeterTest, PatchIsOutsideBeyondTheConeOnly) {
    const double limit = 1.1 * kMu * 20.0 + 0.2;
    const auto percent = [&](const Vec3& first, const Vec3& second) {
        FrictionMeter meter(mechanism, flat);
        observe(meter, 0.0, 10.0, first, second);
        return meter.violationPercent();
    };
    const Vec3 diagonal = Vec3(0.6, 0.8, 0.0) * limit;
    EXPECT_EQ(percent(0.499 * diagonal, 0.499 * diagonal), 0.0);
    EXPECT_EQ(percent(0.501 * diagonal, 0.501 * diagonal), 100.0);
    EXPECT_EQ(percent(0.999 * diagonal, Vec3::Zero()), 0.0);
    EXPECT_EQ(percent(5.0 * diagonal, -5.0 * diagonal), 0.0);
}

// Three of four steps inside: 25 %. A patch without load does not count.
TEST_F(FrictionMeterTest, PercentIsOfLoadedPatches) {
    FrictionMeter meter(mechanism, flat);
    observe(meter, 0.0, 10.0, {20.0, 0.0, 0.0}, Vec3::Zero());
    for (int i = 0; i < 3; ++i) {
        observe(meter, 0.0, 10.0, Vec3::Zero(), Vec3::Zero());
        observe(meter, 0.0, 0.19, {20.0, 0.0, 0.0}, Vec3::Zero());
    }
    EXPECT_DOUBLE_EQ(meter.violationPercent(), 25.0);
}

// Only what lies between the first and the last contact with an obstacle counts.
TEST_F(FrictionMeterTest, CountsFromFirstToLastObstacleContact) {
    const Vec3 outside(20.0, 0.0, 0.0);
    FrictionMeter meter(mechanism, step);
    observe(meter, 0.5, 10.0, outside, outside);
    EXPECT_EQ(meter.violationPercent(), 0.0);
    observe(meter, 1.2, 10.0, Vec3::Zero(), Vec3::Zero());
    EXPECT_EQ(meter.violationPercent(), 0.0);
    observe(meter, 2.0, 10.0, outside, outside);  // not on the obstacle, perhaps in between
    EXPECT_EQ(meter.violationPercent(), 0.0);
    observe(meter, 1.4, 10.0, Vec3::Zero(), Vec3::Zero());  // in between it was: 1 of 3
    EXPECT_NEAR(meter.violationPercent(), 100.0 / 3.0, 1e-9);
    observe(meter, 2.0, 10.0, outside, outside);
    EXPECT_NEAR(meter.violationPercent(), 100.0 / 3.0, 1e-9);
    meter.reset();
    EXPECT_EQ(meter.violationPercent(), 0.0);
}
