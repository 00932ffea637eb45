// Steering geometry against closed forms, and against where a rigid rover carries its wheels.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "simcore/control/steering.h"
#include "tests/support/carts.h"

using namespace simcore;
using namespace simcore::control;
using namespace testsupport;
using Eigen::Rotation2Dd;
using Eigen::Vector2d;
using std::numbers::pi;

namespace {

/// Where the wheel's centre is at a steering angle, in the rover's axes.
Vector2d centerAt(const WheelPlan& wheel, double angle) {
    return wheel.pivot + Rotation2Dd(angle) * (wheel.center - wheel.pivot);
}

/// Velocity of the wheel's centre in the rover's axes, by carrying it along for a moment.
Vector2d velocityByDifference(const WheelPlan& wheel, const Twist& twist, double angle,
                              double angleRate) {
    const double h = 1e-5;
    const auto place = [&](double t) {
        return Vector2d(Vector2d(twist.forward, twist.left) * t +
                        Rotation2Dd(twist.yaw * t) * centerAt(wheel, angle + angleRate * t));
    };
    return (place(h) - place(-h)) / (2.0 * h);
}

}  // namespace

// Textbook Ackermann: front wheels steered, the rear axle straight. cot(outer) - cot(inner) =
// track / base, and the centre of the turn is on the rear axle's line.
TEST(SteeringTest, FrontSteeringIsAckermanns) {
    const CartNumbers numbers;
    SteeringNumbers steering;
    steering.frontOnly = true;
    const auto wheels = wheelPlans(makeSteeredCart(steering));
    for (const double turn : {0.05, -0.2, 0.3}) {
        const Twist twist = rollingTwist(wheels, 0.1, turn);
        EXPECT_NEAR(twist.left, turn * numbers.halfBase, 1e-12);
        const double left = steeringAngle(wheels[0], twist, 0.0).angle;
        const double right = steeringAngle(wheels[1], twist, 0.0).angle;
        EXPECT_NEAR(1.0 / std::tan(right) - 1.0 / std::tan(left),
                    numbers.halfTrack / numbers.halfBase, 1e-9);
        EXPECT_NEAR(std::tan(left), 2.0 * numbers.halfBase / (0.1 / turn - numbers.halfTrack),
                    1e-9);
    }
}

// All wheels steered: front and rear steer opposite ways about the rover's middle, and speeds are
// as the distances from the centre of the turn.
TEST(SteeringTest, FourWheelSteeringIsSymmetric) {
    const auto wheels = wheelPlans(makeSteeredCart());
    const double radius = 0.5;
    const Twist twist = rollingTwist(wheels, 0.1, 0.1 / radius);
    EXPECT_EQ(twist.left, 0.0);
    for (const WheelPlan& wheel : wheels) {
        const double angle = steeringAngle(wheel, twist, 0.0).angle;
        EXPECT_NEAR(angle, std::atan2(wheel.center.x(), radius - wheel.center.y()), 1e-12);
        EXPECT_NEAR(rollingSpeed(wheel, twist, angle),
                    0.1 / radius * std::hypot(wheel.center.x(), radius - wheel.center.y()), 1e-12);
    }
}

// Whatever the pins and the motion, a wheel at its angle does not slip sideways, and rolls what it
// moves: also while the steering turns.
TEST(SteeringTest, SteeredWheelsRollWithoutSlippingSideways) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    int exact = 0;
    for (int i = 0; i < 300; ++i) {
        SteeringNumbers steering;
        steering.stop = 3.1;
        steering.trail = 0.06 * any(random);
        steering.scrub = 0.06 * any(random);
        steering.reversed = any(random) > 0.0;
        const Twist twist{0.2 * any(random), 0.2 * any(random), any(random)};
        const double near = 1.5 * any(random);
        for (const WheelPlan& wheel : wheelPlans(makeSteeredCart(steering))) {
            const SteeringAngle found = steeringAngle(wheel, twist, near);
            const Vector2d heading = Rotation2Dd(found.angle) * Vector2d::UnitX();
            const Vector2d rolls = velocityByDifference(wheel, twist, found.angle, 0.0);
            if (found.exact) {
                ++exact;
                EXPECT_NEAR(rolls.x() * heading.y() - rolls.y() * heading.x(), 0.0, 1e-8);
            }
            EXPECT_NEAR(rollingSpeed(wheel, twist, found.angle), rolls.dot(heading), 1e-8);
            const double rate = any(random);
            EXPECT_NEAR(rollingSpeed(wheel, twist, found.angle, rate),
                        velocityByDifference(wheel, twist, found.angle, rate).dot(heading), 1e-8);
        }
    }
    EXPECT_GT(exact, 1000);
}

// The turn of a joint means the same steering whichever way its axis points and its bodies are
// listed.
TEST(SteeringTest, JointSignFollowsAxisAndBodies) {
    SteeringNumbers steering;
    EXPECT_EQ(wheelPlans(makeSteeredCart(steering))[0].jointSign, 1.0);
    steering.reversed = true;  // axis and bodies both
    EXPECT_EQ(wheelPlans(makeSteeredCart(steering))[0].jointSign, 1.0);
    Mechanism cart = makeSteeredCart();
    auto& joint = cart.joints[static_cast<std::size_t>(cart.wheels[0].steering)];
    joint.axis = -joint.axis;
    joint.stops = {-0.5, 1.0};
    const WheelPlan wheel = wheelPlans(cart)[0];
    EXPECT_EQ(wheel.jointSign, -1.0);
    EXPECT_EQ(wheel.low, -1.0);
    EXPECT_EQ(wheel.high, 0.5);
}

// Of the two angles half a turn apart the reachable one, and of two reachable ones the closer: so
// reversing does not steer, and a sideways drive steers to a quarter turn or not at all.
TEST(SteeringTest, TakesTheShortWayAndTheReachableAngle) {
    const WheelPlan wheel = wheelPlans(makeSteeredCart())[0];
    EXPECT_NEAR(steeringAngle(wheel, {-0.1, 0.0, 0.0}, 0.0).angle, 0.0, 1e-12);
    EXPECT_LT(rollingSpeed(wheel, {-0.1, 0.0, 0.0}, 0.0), 0.0);
    for (const double near : {1.2, -1.2}) {
        const SteeringAngle crab = steeringAngle(wheel, {0.0, 0.1, 0.0}, near);
        EXPECT_TRUE(crab.exact);
        EXPECT_NEAR(crab.angle, std::copysign(pi / 2.0, near), 1e-12);
        EXPECT_NEAR(rollingSpeed(wheel, {0.0, 0.1, 0.0}, crab.angle), std::copysign(0.1, near),
                    1e-12);
    }
    EXPECT_EQ(steeringAngle(wheel, {}, 0.3).angle, 0.3);

    SteeringNumbers narrow;
    narrow.stop = 0.5;
    const WheelPlan held = wheelPlans(makeSteeredCart(narrow))[0];
    const SteeringAngle crab = steeringAngle(held, {0.0, 0.1, 0.0}, 0.0);
    EXPECT_FALSE(crab.exact);
    EXPECT_NEAR(std::abs(crab.angle), 0.5, 1e-12);
    EXPECT_NEAR(std::abs(rollingSpeed(held, {0.0, 0.1, 0.0}, crab.angle)), 0.1 * std::sin(0.5),
                1e-12);
}

// The tightest circle of a front-steered cart has its inner wheel at the stop: its radius on the
// rear axle is base / tan(stop) + half the track.
TEST(SteeringTest, StopsLimitTheTurn) {
    const CartNumbers numbers;
    SteeringNumbers steering;
    steering.frontOnly = true;
    steering.stop = 0.5;
    const auto wheels = wheelPlans(makeSteeredCart(steering));
    const double tightest = 2.0 * numbers.halfBase / std::tan(0.5) + numbers.halfTrack;
    for (const double turn : {1.0, -3.0}) {
        EXPECT_NEAR(reachableTurn(wheels, 0.1, turn), std::copysign(0.1 / tightest, turn), 1e-6);
    }
    EXPECT_EQ(reachableTurn(wheels, 0.1, 0.09 / tightest), 0.09 / tightest);
    EXPECT_NEAR(reachableTurn(wheels, 0.0, 0.5), 0.0, 1e-5);
}

// The servo's error decays by exp(-t / time) below its speed limit, at any usual step.
TEST(SteeringTest, ServoErrorDecays) {
    for (const double step : {0.0005, 0.001, 0.002, 0.005}) {
        double angle = 0.0;
        for (int i = 0; i * step < 1.0 - 1e-9; ++i) {
            const double rate = servoRate(0.8, angle, 1.0);
            EXPECT_LE(rate, 1.0);
            EXPECT_GT(rate, 0.0);
            angle += step * rate;
        }
        // 0.7 s at the limit, then 0.1 rad of error for 0.3 s.
        EXPECT_NEAR(0.8 - angle, 0.1 * std::exp(-3.0), 0.2 * 0.1 * std::exp(-3.0)) << step;
    }
}
