#include "simcore/experiment/comparison.h"

#include <cmath>

#include <limits>

#include <gtest/gtest.h>

#include "simcore/base/random.h"

using namespace simcore;
using namespace simcore::experiment;
using project::ControllerKind;

namespace {

Plan planOf(TerrainSet set, int seeds) {
    Plan plan;
    plan.set = set;
    plan.lastSeed = seeds;
    plan.frictions = {0.5};
    plan.controllers = {ControllerKind::EqualTorque, ControllerKind::Speed};
    return plan;
}

Outcome outcome(int seed, ControllerKind controller, double slip, double endY = 0.0,
                bool completed = true) {
    Outcome result;
    result.ran = {seed, 0.5, controller};
    result.completed = completed;
    result.slipAbs = slip;
    result.endX = 3.5;
    result.endY = endY;
    return result;
}

/// Of the first controller against the second.
Comparison first(const Plan& plan, const std::vector<Outcome>& outcomes) {
    return compare(plan, outcomes).front();
}

}  // namespace

// Ratios 2 and 8 have the geometric mean 4.
TEST(ComparisonTest, MeanRatioIsGeometric) {
    const Comparison found = first(
        planOf(TerrainSet::Profiles, 2),
        {outcome(1, ControllerKind::EqualTorque, 0.1), outcome(1, ControllerKind::Speed, 0.2),
         outcome(2, ControllerKind::EqualTorque, 0.1), outcome(2, ControllerKind::Speed, 0.8)});
    EXPECT_EQ(found.pairs, 2);
    EXPECT_EQ(found.valid, 2);
    EXPECT_EQ(found.slip.wins, 2);
    EXPECT_NEAR(found.slip.meanRatio, 4.0, 1e-12);
    EXPECT_NEAR(found.slip.low, 2.0, 1e-12);  // of two pairs a sample is often twice the lesser
    EXPECT_NEAR(found.slip.high, 8.0, 1e-12);
}

// What a controller is to its rival, the rival is to it the other way round.
TEST(ComparisonTest, IsMirrored) {
    std::vector<Outcome> outcomes;
    for (int seed = 1; seed <= 9; ++seed) {
        outcomes.push_back(outcome(seed, ControllerKind::EqualTorque, 0.1 + 0.01 * seed));
        outcomes.push_back(outcome(seed, ControllerKind::Speed, 0.3 - 0.02 * seed));
    }
    const std::vector<Comparison> both = compare(planOf(TerrainSet::Profiles, 9), outcomes);
    ASSERT_EQ(both.size(), 3U * 2U);  // on all grounds, passable ones, others
    EXPECT_EQ(both[0].slip.wins + both[1].slip.wins, 9);
    EXPECT_NEAR(both[0].slip.meanRatio * both[1].slip.meanRatio, 1.0, 1e-12);
    EXPECT_LT(both[0].slip.low, both[0].slip.meanRatio);
    EXPECT_GT(both[0].slip.high, both[0].slip.meanRatio);
}

// At 0.5, grounds that ask for up to 0.45 are passable.
TEST(ComparisonTest, GroundsAreSplitByWhatStaticsRequires) {
    std::vector<Outcome> outcomes;
    for (int seed = 1; seed <= 6; ++seed) {
        for (const ControllerKind controller :
             {ControllerKind::EqualTorque, ControllerKind::Speed}) {
            outcomes.push_back(outcome(seed, controller, 0.1 * seed));
            outcomes.back().staticFriction =
                seed == 6 ? std::numeric_limits<double>::infinity() : 0.1 * seed;
        }
    }
    for (const Comparison& found : compare(planOf(TerrainSet::Profiles, 6), outcomes)) {
        const int expected = found.grounds == Grounds::All        ? 6
                             : found.grounds == Grounds::Passable ? 4
                                                                  : 2;
        EXPECT_EQ(found.pairs, expected) << toString(found.grounds);
    }
}

// Nobody slips: no victory.
TEST(ComparisonTest, LessThanAMillimetreIsATie) {
    const Comparison found = first(
        planOf(TerrainSet::Profiles, 1),
        {outcome(1, ControllerKind::EqualTorque, 1e-5), outcome(1, ControllerKind::Speed, 6e-4)});
    EXPECT_EQ(found.slip.wins, 0);
    EXPECT_EQ(found.slip.ties, 1);
    EXPECT_DOUBLE_EQ(found.slip.meanRatio, 1.0);
}

// A run that is stuck has no slip worth comparing.
TEST(ComparisonTest, RunsThatDoNotFinishAreCountedNotCompared) {
    const Comparison found =
        first(planOf(TerrainSet::Profiles, 2),
              {outcome(1, ControllerKind::EqualTorque, 0.0, 0.0, false),
               outcome(1, ControllerKind::Speed, 0.2), outcome(2, ControllerKind::EqualTorque, 0.1),
               outcome(2, ControllerKind::Speed, 0.3)});
    EXPECT_EQ(found.tried, 2);
    EXPECT_EQ(found.pairs, 1);
    EXPECT_EQ(found.onlyOwn, 0);
    EXPECT_EQ(found.onlyRival, 1);
    EXPECT_NEAR(found.slip.meanRatio, 3.0, 1e-12);
    EXPECT_EQ(found.slip.low, 0.0);  // one pair has no interval
}

// On full terrain pairs count whose ends are less than 0.1 m apart; on profiles all do.
TEST(ComparisonTest, EndsApartDoNotCountOnFullTerrain) {
    const std::vector<Outcome> outcomes{outcome(1, ControllerKind::EqualTorque, 0.1, 0.00),
                                        outcome(1, ControllerKind::Speed, 0.2, 0.15),
                                        outcome(2, ControllerKind::EqualTorque, 0.1, 0.00),
                                        outcome(2, ControllerKind::Speed, 0.2, 0.05)};
    EXPECT_EQ(first(planOf(TerrainSet::Terrains, 2), outcomes).valid, 1);
    EXPECT_EQ(first(planOf(TerrainSet::Terrains, 2), outcomes).pairs, 2);
    EXPECT_EQ(first(planOf(TerrainSet::Profiles, 2), outcomes).valid, 2);
}

// Ratios drawn from a log-normal law: the interval covers the true mean in about 95 of 100 trials.
TEST(ComparisonTest, IntervalCoversTheTrueMean) {
    Random random(7);
    constexpr int kTrials = 200;
    constexpr int kSeeds = 40;
    int covered = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<Outcome> outcomes;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            outcomes.push_back(outcome(seed, ControllerKind::EqualTorque, 0.1));
            outcomes.push_back(
                outcome(seed, ControllerKind::Speed, 0.1 * std::exp(0.3 + 0.5 * random.normal())));
        }
        const Comparison found = first(planOf(TerrainSet::Profiles, kSeeds), outcomes);
        covered += found.slip.low < std::exp(0.3) && std::exp(0.3) < found.slip.high ? 1 : 0;
    }
    EXPECT_GT(covered, 0.88 * kTrials);
    EXPECT_LT(covered, 0.99 * kTrials);
}
