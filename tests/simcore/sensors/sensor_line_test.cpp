// The error model of one sensor against its definition in docs/sensors.md.
#include "simcore/sensors/sensor_line.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

namespace simcore::sensors {
namespace {

using project::SensorErrorValues;

constexpr double kPeriod = 0.01;

std::vector<double> readings(SensorLine& line, int count, double truth = 0.0) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(line.read(i * kPeriod, truth));
    }
    return values;
}

TEST(SensorLine, AnIdealOneHandsOnTheTruthBitForBit) {
    SensorLine line({}, 7);
    for (const double truth : {0.1, -0.0, 5e-324, 1e300}) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(line.read(0.0, truth)),
                  std::bit_cast<std::uint64_t>(truth));
    }
}

TEST(SensorLine, BiasIsAdded) {
    SensorLine line({.bias = -0.25}, 7);
    EXPECT_DOUBLE_EQ(line.read(0.0, 2.0), 1.75);
}

TEST(SensorLine, ReadingsAreMultiplesOfTheResolutionAndNearest) {
    SensorLine line({.resolution = 0.1}, 7);
    for (double truth = -1.0; truth < 1.0; truth += 0.0137) {
        const double reading = line.read(0.0, truth);
        EXPECT_NEAR(std::remainder(reading, 0.1), 0.0, 1e-12);
        EXPECT_LE(std::abs(reading - truth), 0.05 + 1e-12);
    }
}

// Mean and deviation of n readings scatter by sigma/sqrt(n) and sigma/sqrt(2n): five of these are
// allowed; readings of successive looks are independent.
TEST(SensorLine, NoiseHasMeanZeroAndTheDeviationAskedFor) {
    constexpr int kCount = 40000;
    constexpr double kSigma = 0.3;
    SensorLine line({.noise = kSigma}, 7);
    const std::vector<double> values = readings(line, kCount, 2.0);
    double mean = 0.0;
    for (const double v : values) {
        mean += (v - 2.0) / kCount;
    }
    double variance = 0.0;
    double following = 0.0;
    double within = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double d = values[i] - 2.0 - mean;
        variance += d * d / kCount;
        following += i > 0 ? d * (values[i - 1] - 2.0 - mean) / kCount : 0.0;
        within += std::abs(d) < kSigma ? 1.0 / kCount : 0.0;
    }
    EXPECT_NEAR(mean, 0.0, 5.0 * kSigma / std::sqrt(kCount));
    EXPECT_NEAR(std::sqrt(variance), kSigma, 5.0 * kSigma / std::sqrt(2.0 * kCount));
    EXPECT_NEAR(following, 0.0, 5.0 * kSigma * kSigma / std::sqrt(kCount));
    EXPECT_NEAR(within, 0.6827, 0.015);  // of a Gaussian
}

TEST(SensorLine, SeedsGiveOtherNoiseAndResetTheSameAgain) {
    SensorLine line({.noise = 1.0, .delay = 0.015}, 7);
    SensorLine other({.noise = 1.0, .delay = 0.015}, 8);
    const std::vector<double> first = readings(line, 50, 3.0);
    EXPECT_NE(readings(other, 50, 3.0), first);
    line.reset();
    EXPECT_EQ(readings(line, 50, 3.0), first);
}

// Of a truth that grows evenly, a delayed sensor reports what was `delay` ago, whether or not that
// is a whole number of looks; before the start the truth was always the first one.
class DelayTest : public ::testing::TestWithParam<double> {};

TEST_P(DelayTest, ReportsWhatWas) {
    const double delay = GetParam();
    SensorLine line({.delay = delay}, 7);
    for (int i = 0; i < 60; ++i) {
        const double time = i * kPeriod;
        EXPECT_NEAR(line.read(time, 5.0 + 2.0 * time), 5.0 + 2.0 * std::max(0.0, time - delay),
                    1e-12)
            << "at " << time;
    }
}

INSTANTIATE_TEST_SUITE_P(Delays, DelayTest, ::testing::Values(0.001, 0.01, 0.013, 0.03, 0.25));

TEST(SensorLine, LooksNeedNotBeRegular) {
    SensorLine line({.delay = 0.02}, 7);
    for (const double time : {0.0, 0.003, 0.011, 0.019, 0.034, 0.035, 0.08}) {
        EXPECT_NEAR(line.read(time, time), std::max(0.0, time - 0.02), 1e-12);
    }
}

}  // namespace
}  // namespace simcore::sensors
