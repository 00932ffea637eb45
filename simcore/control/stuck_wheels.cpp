#include "simcore/control/stuck_wheels.h"

#include <algorithm>
#include <cmath>

namespace simcore::control {
namespace {

// All numbers are assumed.
// A rover slower than this share of what is asked, for this time [s], is stalled.
constexpr double kStalled = 0.2;
constexpr double kStalledTime = 1.0;
// Time constant of the body's speed [s].
constexpr double kSmoothing = 0.1;
// How far ahead of the ground a wheel of a stalled rover may turn [rad/s]: with dry friction it
// pulls no less than a fast one. Above the second it spins.
constexpr double kCreep = 0.3;
constexpr double kSpins = 0.15;
// A stuck wheel is trusted with more by this rate [1/s], which fades by the other when it is over.
constexpr double kRaise = 0.5;
constexpr double kFade = 0.1;
// After this time [s] of all giving what they can, with less way than this share of what is asked,
// the wheels rest.
constexpr double kTryTime = 2.0;
constexpr double kNoWay = 0.01;
// A wheel that is brought to rest is trusted with less by this rate [1/s], as long as it turns
// faster than this [rad/s].
constexpr double kRelease = 0.5;
constexpr double kTurns = 0.02;
constexpr double kLeastFriction = 0.01;

}  // namespace

StuckWheels::StuckWheels(std::size_t wheels, double period)
    : period_(period),
      slips_(wheels),
      creep_(wheels),
      raised_(wheels),
      restingBelow_(wheels) {
    reset();
}

void StuckWheels::reset() {
    stage_ = Stage::Drives;
    speed_ = stalled_ = spun_ = advance_ = 0.0;
    std::fill(slips_.begin(), slips_.end(), false);
    std::fill(creep_.begin(), creep_.end(), 0.0);
    std::fill(raised_.begin(), raised_.end(), 0.0);
}

void StuckWheels::update(double asked, double speed, std::span<const Wheel> wheels) {
    if ((asked > 0.0) != forward_) {
        reset();
        forward_ = asked > 0.0;
    }
    speed_ += period_ / (kSmoothing + period_) * (speed - speed_);
    stalled_ = std::abs(speed_) < kStalled * std::abs(asked) ? stalled_ + period_ : 0.0;
    if (stalled_ <= kStalledTime) {
        stage_ = Stage::Drives;
        for (double& raised : raised_) {
            raised = std::max(0.0, raised - kFade * period_);
        }
        return;
    }
    if (stage_ == Stage::Drives) {
        stage_ = Stage::Tries;
        spun_ = advance_ = 0.0;
    }
    attempt(asked, wheels);
}

/// Of a stalled rover.
void StuckWheels::attempt(double asked, std::span<const Wheel> wheels) {
    const double way = forward_ ? 1.0 : -1.0;
    bool allSpent = true;
    bool anySlips = false;
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        const Wheel& wheel = wheels[i];
        const double rolls = wheel.rolling * speed_ / asked;
        creep_[i] = std::max(0.0, way * rolls) + kCreep;
        slips_[i] = wheel.bears && way * (wheel.rate - rolls) > kSpins;
        allSpent = allSpent && (!wheel.bears || slips_[i] || wheel.atLimit);
        anySlips = anySlips || slips_[i];
        if (stage_ == Stage::Rests) {
            if (way * wheel.rate > kTurns) {
                restingBelow_[i] = std::max(kLeastFriction, restingBelow_[i] - kRelease * period_);
            }
        } else if (wheel.bears && wheel.atCap && !slips_[i]) {
            raised_[i] = std::min(raised_[i] + kRaise * period_, kMostFriction);
        }
    }
    if (stage_ == Stage::Rests) {
        return;
    }
    const bool spent = allSpent && anySlips;
    spun_ = spent ? spun_ + period_ : 0.0;
    advance_ = spent ? advance_ + speed_ * period_ : 0.0;
    if (spun_ > kTryTime) {
        if (std::abs(advance_) < kNoWay * std::abs(asked) * kTryTime) {
            stage_ = Stage::Rests;
            std::fill(restingBelow_.begin(), restingBelow_.end(), kMostFriction);
        }
        spun_ = advance_ = 0.0;
    }
}

double StuckWheels::friction(std::size_t wheel, double assumed) const {
    const double trusted =
        assumed > 0.0 ? std::max(assumed, std::min(assumed + raised_[wheel], kMostFriction)) : 0.0;
    if (stage_ != Stage::Rests) {
        return trusted;
    }
    return trusted > 0.0 ? std::min(trusted, restingBelow_[wheel]) : restingBelow_[wheel];
}

}  // namespace simcore::control
