#include "simcore/run/channels.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "tests/support/fake_run.h"

namespace simcore::run {
namespace {

class ChannelsTest : public ::testing::Test {
  protected:
    double value(const std::string& quantity, const std::string& object) {
        std::vector<double> row;
        sampleChannels(mechanism, snapshot, row);
        const int index = findChannel(channels, quantity, object);
        return index < 0 ? std::nan("") : row.at(static_cast<std::size_t>(index));
    }

    void SetUp() override {
        snapshot.bodies.resize(1);
        snapshot.wheels.resize(mechanism.wheels.size());
    }

    mechanism::Mechanism mechanism = test_support::fakeRun().mechanism;
    std::vector<Channel> channels = makeChannels(mechanism);
    Snapshot snapshot;
};

TEST_F(ChannelsTest, TimeComesFirstAndColumnsAreUniqueAscii) {
    ASSERT_FALSE(channels.empty());
    EXPECT_EQ(channels.front().column(), "time [s]");
    std::set<std::string> columns;
    for (const Channel& channel : channels) {
        EXPECT_TRUE(columns.insert(channel.column()).second) << channel.column();
        for (const char c : channel.column()) {
            EXPECT_TRUE(c >= 0x20 && c < 0x7f) << channel.column();
        }
        EXPECT_FALSE(channel.meaning.empty()) << channel.column();
        EXPECT_FALSE(channel.label.empty()) << channel.column();
    }
}

TEST_F(ChannelsTest, WheelsAppearInFileOrder) {
    std::vector<std::string> order;
    for (const Channel& channel : channels) {
        if (channel.quantity == "slip_abs") {
            order.push_back(channel.object);
        }
    }
    std::vector<std::string> expected;
    for (const auto& wheel : mechanism.wheels) {
        expected.push_back(wheel.name);
    }
    EXPECT_EQ(order, expected);
}

TEST_F(ChannelsTest, RowIsAsLongAsTheListOfChannels) {
    std::vector<double> row{1.0, 2.0};
    sampleChannels(mechanism, snapshot, row);
    EXPECT_EQ(row.size(), channels.size());
}

TEST_F(ChannelsTest, EachWheelValueLandsInItsOwnColumn) {
    WheelState& wheel = snapshot.wheels[2];
    wheel.slipAbs = 1;
    wheel.slipSigned = 2;
    wheel.slipRatio = 3;
    wheel.slipLateral = 4;
    wheel.torqueCommanded = 5;
    wheel.torqueApplied = 6;
    wheel.normalForce = 7;
    wheel.tractionForce = 8;
    wheel.lateralForce = 9;
    wheel.contactAngle = 10;
    wheel.rate = 11;
    wheel.centerSpeed = 12;
    wheel.power = 13;
    wheel.penetration = 14;
    wheel.force = Vec3(15, 16, 17);
    wheel.slipLoaded = 18;
    wheel.frictionWork = 19;
    const std::vector<std::string> quantities{
        "slip_abs",       "slip_signed",  "slip_ratio",     "slip_lateral",  "torque_commanded",
        "torque_applied", "normal_force", "traction_force", "lateral_force", "contact_angle",
        "rate",           "center_speed", "power",          "penetration",   "force_x",
        "force_y",        "force_z",      "slip_loaded",    "friction_work"};
    for (std::size_t i = 0; i < quantities.size(); ++i) {
        EXPECT_EQ(value(quantities[i], "bogie_left_rear"), static_cast<double>(i + 1))
            << quantities[i];
        EXPECT_EQ(value(quantities[i], "front"), 0.0) << quantities[i];
    }
}

// Before the sensors' first look there is nothing to show; it is missing, not 0.
TEST_F(ChannelsTest, WhatIsNotMeasuredYetIsMissing) {
    EXPECT_TRUE(std::isnan(value("measured_rate", "front")));
    snapshot.measured.wheels.assign(mechanism.wheels.size(), {1.0, 2.0, 3.0});
    EXPECT_EQ(value("measured_rate", "front"), 1.0);
    EXPECT_EQ(value("measured_normal_force", "front"), 2.0);
    EXPECT_EQ(value("measured_contact_angle", "front"), 3.0);
}

TEST_F(ChannelsTest, JointsWithEncodersFollowTheWheels) {
    mechanism::Joint& pin = mechanism.joints.emplace_back();
    pin.name = "bogie_pin";
    pin.built.push_back({mechanism::FreedomKind::Turn, pin.axis});
    channels = makeChannels(mechanism);
    EXPECT_TRUE(std::isnan(value("joint_angle", "bogie_pin")));
    snapshot.joints.push_back({0.3, -0.2});
    snapshot.measured.joints.push_back(0.31);
    EXPECT_EQ(value("joint_angle", "bogie_pin"), 0.3);
    EXPECT_EQ(value("joint_rate", "bogie_pin"), -0.2);
    EXPECT_EQ(value("measured_joint_angle", "bogie_pin"), 0.31);
}

// A controller may read `measured` and `known` only: every measured number has a true one beside it
// that is marked oracle.
TEST_F(ChannelsTest, EveryMeasuredChannelSaysSoInItsName) {
    for (const Channel& channel : channels) {
        EXPECT_EQ(channel.quantity.starts_with("measured_"),
                  channel.source == ChannelSource::Measured)
            << channel.id();
        EXPECT_FALSE(channel.symbol.empty()) << channel.id();
    }
}

TEST_F(ChannelsTest, AnglesComeBackFromTheirRotation) {
    const double roll = 0.3, pitch = -0.4, yaw = 2.0;
    snapshot.bodies[0].rotation = Eigen::AngleAxisd(yaw, Vec3::UnitZ()) *
                                  Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
                                  Eigen::AngleAxisd(roll, Vec3::UnitX());
    EXPECT_NEAR(value("roll", "chassis"), roll, 1e-14);
    EXPECT_NEAR(value("pitch", "chassis"), pitch, 1e-14);
    EXPECT_NEAR(value("yaw", "chassis"), yaw, 1e-14);
}

TEST_F(ChannelsTest, PositivePitchIsNoseDown) {
    snapshot.bodies[0].rotation = Eigen::AngleAxisd(0.2, Vec3::UnitY());
    const Vec3 nose = snapshot.bodies[0] * Vec3::UnitX();
    EXPECT_LT(nose.z(), 0.0);
    EXPECT_GT(value("pitch", "chassis"), 0.0);
}

TEST_F(ChannelsTest, ChassisBodyMustExist) {
    std::vector<double> row;
    mechanism.chassis = 1;
    EXPECT_THROW(sampleChannels(mechanism, snapshot, row), std::invalid_argument);
    mechanism.chassis = -1;
    EXPECT_THROW(sampleChannels(mechanism, snapshot, row), std::invalid_argument);
}

}  // namespace
}  // namespace simcore::run
