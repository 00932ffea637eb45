// What each sensor measures, on a cart that is posed by hand.
#include "simcore/sensors/sensor_suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/carts.h"
#include "tests/support/posed_engine.h"

namespace simcore::sensors {
namespace {

using testsupport::makeCart;
using testsupport::PosedEngine;

/// A cart with a rocker on a pin of its own.
mechanism::Mechanism rockerCart() {
    mechanism::Mechanism mechanism = makeCart();
    const int rocker = static_cast<int>(mechanism.bodies.size());
    mechanism.bodies.push_back(testsupport::makeBody("rocker", 1.0, Vec3(0.0, 0.3, 0.1)));
    mechanism.joints.push_back(testsupport::makePin("rocker_pin", 0, rocker, {0.0, 0.2, 0.1}));
    return mechanism;
}

class SensorSuiteTest : public ::testing::Test {
  protected:
    SensorSuiteTest() {
        now.wheels.resize(mechanism.wheels.size());
        now.bodies.resize(mechanism.bodies.size());
        now.joints.resize(mechanism.encoderJoints().size());
    }

    control::Sensors read(SensorSuite& suite) {
        control::Sensors readings;
        suite.read(engine, now, readings);
        return readings;
    }

    mechanism::Mechanism mechanism = rockerCart();
    PosedEngine engine{mechanism.bodies.size()};
    run::Snapshot now;
    project::SensorValues ideal;
};

TEST_F(SensorSuiteTest, EncodersAreOnJointsThatAreNoAxles) {
    const std::vector<int> encoders = mechanism.encoderJoints();
    ASSERT_EQ(encoders.size(), 1U);
    EXPECT_EQ(mechanism.joints[static_cast<std::size_t>(encoders[0])].name, "rocker_pin");
    now.joints[0].angle = 0.3;
    SensorSuite suite(mechanism, ideal, 1);
    EXPECT_NEAR(read(suite).joints.at(0), 0.3, 1e-12);
}

TEST_F(SensorSuiteTest, WheelRateIsAgainstTheCarrier) {
    for (dynamics::BodyVelocity& velocity : engine.bodyVelocities) {
        velocity.angular = Vec3(0.0, 0.5, 0.0);  // all pitch together
    }
    const auto front = static_cast<std::size_t>(mechanism.wheels[0].body);
    engine.bodyVelocities[front].angular.y() += 2.0;
    now.wheels[0].normalForce = 12.0;
    now.wheels[0].contactAngle = 0.4;
    now.speed = 0.1;
    SensorSuite suite(mechanism, ideal, 1);
    const control::Sensors readings = read(suite);
    EXPECT_DOUBLE_EQ(readings.wheels[0].rate, 2.0);
    EXPECT_DOUBLE_EQ(readings.wheels[1].rate, 0.0);
    EXPECT_DOUBLE_EQ(readings.wheels[0].normalForce, 12.0);
    EXPECT_DOUBLE_EQ(readings.wheels[0].contactAngle, 0.4);
    EXPECT_DOUBLE_EQ(readings.bodySpeed, 0.1);
    EXPECT_DOUBLE_EQ(readings.imu.angularRate.y(), 0.5);
}

// At rest, nose down by theta, the chassis feels g along world up: (-sin, 0, cos) in its own axes.
TEST_F(SensorSuiteTest, AccelerometerFeelsWhatHoldsItUp) {
    const double theta = 0.2;
    engine.bodyPoses[0].rotation = Eigen::AngleAxisd(theta, Vec3::UnitY());
    SensorSuite suite(mechanism, ideal, 1);
    const control::Imu imu = read(suite).imu;
    EXPECT_NEAR(imu.pitch, theta, 1e-12);
    EXPECT_NEAR(imu.roll, 0.0, 1e-12);
    const Vec3 expected = dynamics::kGravity * Vec3(-std::sin(theta), 0.0, std::cos(theta));
    EXPECT_LT((imu.acceleration - expected).norm(), 1e-12);
}

TEST_F(SensorSuiteTest, AccelerometerFeelsNothingInFreeFallAndASpeedingUp) {
    SensorSuite suite(mechanism, ideal, 1);
    read(suite);
    now.time = 0.01;
    engine.bodyVelocities[0].linear = Vec3(0.02, 0.0, -dynamics::kGravity * now.time);
    const Vec3 felt = read(suite).imu.acceleration;
    EXPECT_LT((felt - Vec3(2.0, 0.0, 0.0)).norm(), 1e-12);
}

TEST_F(SensorSuiteTest, GyroTurnsWithTheChassis) {
    engine.bodyPoses[0].rotation = Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ());
    engine.bodyVelocities[0].angular = Vec3(0.0, 0.3, 0.1);  // rolls, facing world y
    SensorSuite suite(mechanism, ideal, 1);
    EXPECT_LT((read(suite).imu.angularRate - Vec3(0.3, 0.0, 0.1)).norm(), 1e-12);
}

TEST_F(SensorSuiteTest, EverySensorHasItsOwnStream) {
    project::SensorValues noisy;
    noisy.wheelRate.noise = 1.0;
    SensorSuite few(mechanism, noisy, 1);
    noisy.jointEncoder.noise = noisy.bodySpeed.noise = noisy.tactileForce.noise = 1.0;
    noisy.acceleration.noise = noisy.angularRate.noise = 1.0;
    SensorSuite many(mechanism, noisy, 1);
    const mechanism::Mechanism without = makeCart();  // no rocker, no encoder
    SensorSuite other(without, noisy, 1);
    SensorSuite seeded(mechanism, noisy, 2);
    for (int i = 0; i < 20; ++i) {
        now.time = 0.01 * i;
        const control::Sensors a = read(few);
        const control::Sensors b = read(many);
        const control::Sensors c = read(other);
        const control::Sensors d = read(seeded);
        std::vector<double> all{b.bodySpeed, b.joints[0]};
        for (int axis = 0; axis < 3; ++axis) {
            all.push_back(b.imu.angularRate[axis]);
            all.push_back(b.imu.acceleration[axis] - (axis == 2 ? dynamics::kGravity : 0.0));
        }
        for (std::size_t w = 0; w < a.wheels.size(); ++w) {
            EXPECT_EQ(a.wheels[w].rate, b.wheels[w].rate);
            EXPECT_EQ(b.wheels[w].rate, c.wheels[w].rate);
            EXPECT_NE(b.wheels[w].rate, d.wheels[w].rate);
            all.push_back(b.wheels[w].rate);
            all.push_back(b.wheels[w].normalForce);
        }
        std::sort(all.begin(), all.end());
        for (std::size_t k = 1; k < all.size(); ++k) {
            EXPECT_GT(all[k] - all[k - 1], 1e-12) << "two sensors share a stream";
        }
    }
}

TEST_F(SensorSuiteTest, ResetGivesTheSameReadingsAgain) {
    project::SensorValues errors;
    errors.bodySpeed = {.noise = 0.1, .bias = 0.0, .delay = 0.025, .resolution = 0.0};
    errors.acceleration.noise = 1.0;
    SensorSuite suite(mechanism, errors, 3);
    const auto drive = [&] {
        std::vector<double> values;
        for (int i = 0; i < 10; ++i) {
            now.time = 0.01 * i;
            now.speed = 0.1 * i;
            engine.bodyVelocities[0].linear.x() = 0.1 * i;
            const control::Sensors readings = read(suite);
            values.push_back(readings.bodySpeed);
            values.push_back(readings.imu.acceleration.x());
        }
        return values;
    };
    const std::vector<double> first = drive();
    suite.reset();
    EXPECT_EQ(drive(), first);
}

TEST_F(SensorSuiteTest, BeforeTheFirstLookThereAreNoReadings) {
    const control::Sensors none = noReadings(mechanism);
    EXPECT_TRUE(std::isnan(none.bodySpeed));
    ASSERT_EQ(none.joints.size(), 1U);
    EXPECT_TRUE(std::isnan(none.joints[0]));
    ASSERT_EQ(none.wheels.size(), 4U);
    EXPECT_TRUE(std::isnan(none.wheels[3].normalForce));
}

}  // namespace
}  // namespace simcore::sensors
