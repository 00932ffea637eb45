// What is done about a rover that stands though it is to drive, look by look.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "simcore/control/stuck_wheels.h"

using namespace simcore::control;
using Stage = StuckWheels::Stage;

namespace {

constexpr double kPeriod = 0.01;
constexpr double kSpeed = 0.1;    // asked of the rover [m/s]
constexpr double kRolling = 1.5;  // of its wheels [rad/s]

/// A rover with two wheels, asked for `kSpeed`.
class StuckWheelsTest : public testing::Test {
  protected:
    /// Looks for this time [s], with the rover at this speed [m/s].
    void look(double time, double speed, double asked = kSpeed) {
        for (int k = 0; k < std::lround(time / kPeriod); ++k) {
            stuck.update(asked, speed, wheels);
        }
    }

    static StuckWheels::Wheel standing() { return {.bears = true, .rolling = kRolling}; }

    static StuckWheels::Wheel standingAtCap() {
        return {.bears = true, .atCap = true, .rolling = kRolling};
    }

    static StuckWheels::Wheel spinning() {
        return {.bears = true, .atCap = true, .rate = 0.3, .rolling = kRolling};
    }

    StuckWheels stuck{2, kPeriod};
    std::array<StuckWheels::Wheel, 2> wheels = {standing(), standing()};
};

}  // namespace

TEST_F(StuckWheelsTest, ARoverThatMovesDrives) {
    wheels = {spinning(), standingAtCap()};
    look(20.0, 0.3 * kSpeed);
    EXPECT_EQ(stuck.stage(), Stage::Drives);
    EXPECT_EQ(stuck.friction(1, 0.5), 0.5);
    look(0.8, 0.0);  // comes to an edge
    look(1.0, kSpeed);
    EXPECT_EQ(stuck.stage(), Stage::Drives);
}

// A rover that is to stand is not stuck.
TEST_F(StuckWheelsTest, StandingOnPurposeIsNoStall) {
    look(20.0, 0.0, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Drives);
}

// The wheel that stands at its cap has shown that the ground takes more; one that stands below it,
// and one that spins, have not.
TEST_F(StuckWheelsTest, OnlyAWheelThatStandsAtItsCapIsTrustedWithMore) {
    wheels = {standingAtCap(), standing()};
    look(1.5, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Tries);
    EXPECT_GT(stuck.friction(0, 0.5), 0.6);
    EXPECT_EQ(stuck.friction(1, 0.5), 0.5);
    wheels[1] = spinning();
    look(5.0, 0.0);
    EXPECT_EQ(stuck.friction(0, 0.5), StuckWheels::kMostFriction);
    EXPECT_EQ(stuck.friction(1, 0.5), 0.5);
    EXPECT_EQ(stuck.friction(0, 1.2), 1.2);  // never less than is assumed
    EXPECT_EQ(stuck.friction(0, 0.0), 0.0);  // no cap
    look(30.0, kSpeed);
    EXPECT_EQ(stuck.friction(0, 0.5), 0.5);
}

// 0.3 rad/s ahead of the ground, of which a rover that creeps on has some way.
TEST_F(StuckWheelsTest, WheelsOfAStalledRoverCreep) {
    look(1.5, 0.0);
    EXPECT_NEAR(stuck.creep(0), 0.3, 1e-12);
    look(2.0, 0.1 * kSpeed);
    EXPECT_EQ(stuck.stage(), Stage::Tries);
    EXPECT_NEAR(stuck.creep(0), 0.3 + 0.1 * kRolling, 1e-6);
}

// All spin, the rover stands: there is no more to be had. The wheels are trusted with less and less
// until they stand.
TEST_F(StuckWheelsTest, WheelsRestWhenAllSpinInVain) {
    wheels = {spinning(), spinning()};
    look(2.5, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Tries);
    look(0.6, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Rests);
    look(0.5, 0.0);
    const double spun = stuck.friction(0, 1.0);
    EXPECT_LT(spun, 0.8);
    EXPECT_LT(stuck.friction(0, 0.0), 0.8);  // with no cap, too
    wheels[0] = standingAtCap();
    look(0.5, 0.0);
    EXPECT_EQ(stuck.friction(0, 1.0), spun);
    EXPECT_LT(stuck.friction(1, 1.0), spun);
    look(60.0, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Rests);
    EXPECT_GT(stuck.friction(1, 1.0), 0.0);  // which would be no cap at all
    look(1.0, 0.5 * kSpeed);                 // something else moved it
    EXPECT_EQ(stuck.stage(), Stage::Drives);
    EXPECT_EQ(stuck.friction(1, 1.0), 1.0);
}

// A motor at its limit has no more to give either.
TEST_F(StuckWheelsTest, AMotorAtItsLimitIsSpent) {
    wheels = {spinning(), standingAtCap()};
    look(10.0, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Tries);
    wheels[1].atLimit = true;
    look(3.0, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Rests);
}

// Slowly, but it goes: 3 mm/s.
TEST_F(StuckWheelsTest, ARoverThatCreepsOnIsNotGivenUp) {
    wheels = {spinning(), spinning()};
    look(20.0, 0.03 * kSpeed);
    EXPECT_EQ(stuck.stage(), Stage::Tries);
}

// What hangs has nothing to give; a rover of which nothing is loaded does not rest for it.
TEST_F(StuckWheelsTest, WheelsThatHangDoNotCount) {
    wheels = {spinning(), {}};
    wheels[1].rolling = kRolling;
    look(3.5, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Rests);
    stuck.reset();
    wheels[0].bears = false;
    look(10.0, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Tries);
}

// The other way is a new attempt, with the same rules.
TEST_F(StuckWheelsTest, TurningBackIsANewAttempt) {
    wheels = {spinning(), spinning()};
    look(5.0, 0.0);
    EXPECT_EQ(stuck.stage(), Stage::Rests);
    for (StuckWheels::Wheel& wheel : wheels) {
        wheel.rate = -wheel.rate;
        wheel.rolling = -wheel.rolling;
    }
    look(kPeriod, 0.0, -kSpeed);
    EXPECT_EQ(stuck.stage(), Stage::Drives);
    look(1.5, 0.0, -kSpeed);
    EXPECT_EQ(stuck.stage(), Stage::Tries);
    EXPECT_NEAR(stuck.creep(0), 0.3, 1e-12);
    look(3.0, 0.0, -kSpeed);
    EXPECT_EQ(stuck.stage(), Stage::Rests);
}
