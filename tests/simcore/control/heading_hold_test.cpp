// The heading loop against the closed form of what it controls.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "simcore/control/heading_hold.h"

using namespace simcore;
using control::HeadingHold;
using control::TurnedBy;

namespace {

constexpr double kPeriod = 0.01;
constexpr double kBase = 0.5;
constexpr double kSpeed = 1.0;  // so that the bound of kSpeed / kBase is far away

control::Imu yawing(double rate) {
    control::Imu imu;
    imu.angularRate.z() = rate;
    return imu;
}

/// A rover that turns by `share` of what it is asked, pushed round at a rate of `drift`.
struct Rover {
    double share = 1.0;
    double drift = 0.0;
    double deadBand = 0.0;  ///< turns up to this do not come about at all [rad/s]
    TurnedBy by = TurnedBy::Steering;
    HeadingHold hold{kPeriod, kBase, by};
    double heading = 0.0;
    double rate = 0.0;

    void drive(double time, double asked = 0.0, double speed = kSpeed) {
        for (long i = std::lround(time / kPeriod); i > 0; --i) {
            const double turn = hold.turn(yawing(rate), speed, asked);
            rate = share * (turn - std::clamp(turn, -deadBand, deadBand)) + drift;
            heading += rate * kPeriod;
        }
    }
};

}  // namespace

// Both poles at -1/s: a drift that sets in turns the rover by d t exp(-t), no further.
TEST(HeadingHoldTest, DriftIsUndoneAsDesigned) {
    Rover rover;
    rover.drift = 0.1;
    for (int second = 1; second <= 8; ++second) {
        rover.drive(1.0);
        EXPECT_NEAR(rover.heading, 0.1 * second * std::exp(-second), 0.002) << second;
    }
}

// A rover that turns by a third of what is asked comes back all the same, with one small swing.
TEST(HeadingHoldTest, HoldsARoverThatSlips) {
    Rover rover{.share = 0.3, .drift = 0.1};
    rover.drive(30.0);
    EXPECT_NEAR(rover.heading, 0.0, 1e-3);
}

// A skid-steered rover does not turn at all until the turn asked for makes its wheels slip, and
// then by a share. Knocked off its course it comes back to where its loop asks for no more than
// that, and never beyond the course.
TEST(HeadingHoldTest, DoesNotHuntWhereFrictionHoldsTheRover) {
    constexpr double kDeadBand = 0.02;
    Rover rover{.share = 0.6, .deadBand = kDeadBand, .by = TurnedBy::WheelSpeeds};
    rover.drift = 0.1;
    rover.drive(0.5);
    rover.drift = 0.0;
    const double knocked = rover.heading;
    EXPECT_GT(knocked, 0.03);
    double least = knocked;
    for (int i = 0; i < 3000; ++i) {
        rover.drive(kPeriod);
        least = std::min(least, rover.heading);
    }
    EXPECT_NEAR(rover.heading, kDeadBand / 2.0, 1e-3);  // the loop's gain is 2 /s
    EXPECT_GT(least, 0.0);
}

// While a turn is asked it is passed on; the heading it ends at is the one held.
TEST(HeadingHoldTest, HoldsTheHeadingATurnEndsAt) {
    Rover rover;
    rover.drift = 0.05;
    rover.drive(2.0, 0.3);
    const double reached = rover.heading;
    EXPECT_NEAR(reached, 2.0 * 0.35, 0.01);
    rover.drive(20.0);
    EXPECT_NEAR(rover.heading, reached, 5e-3);
}

// Standing it asks for nothing, and driving never for a tighter circle than of the wheelbase.
TEST(HeadingHoldTest, AsksForNoTightTurn) {
    HeadingHold hold(kPeriod, kBase, TurnedBy::Steering);
    for (int i = 0; i < 1000; ++i) {
        EXPECT_EQ(hold.turn(yawing(0.5), 0.0, 0.0), 0.0);
    }
    EXPECT_DOUBLE_EQ(hold.turn(yawing(0.5), 0.1, 0.0), -0.1 / kBase);
}

// On a slope the yaw rate is that about the vertical: a rover that turns about it reads the same
// whatever its roll and pitch.
TEST(HeadingHoldTest, YawIsAboutTheVertical) {
    const double rate = 0.2;
    for (const double roll : {0.0, 0.3, -0.4}) {
        for (const double pitch : {0.0, 0.25, -0.35}) {
            const Eigen::Quaterniond tilt =
                Eigen::AngleAxisd(pitch, Vec3::UnitY()) * Eigen::AngleAxisd(roll, Vec3::UnitX());
            control::Imu imu;
            imu.roll = roll;
            imu.pitch = pitch;
            imu.angularRate = tilt.conjugate() * Vec3(0.0, 0.0, rate);
            HeadingHold tilted(kPeriod, kBase, TurnedBy::Steering);
            HeadingHold level(kPeriod, kBase, TurnedBy::Steering);
            EXPECT_NEAR(tilted.turn(imu, kSpeed, 0.0), level.turn(yawing(rate), kSpeed, 0.0),
                        1e-12);
        }
    }
}
