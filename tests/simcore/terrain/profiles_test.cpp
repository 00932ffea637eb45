#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/terrain/profiles.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::terrain;
using namespace testsupport;
using project::TerrainKind;
using std::numbers::pi;

namespace {

constexpr double kExact = 1e-12;
/// The height may be off by the sagitta of a chord, seen along z on the steepest slope tested.
constexpr double kCurve = 2.0 * kChordError;

/// Largest difference of the terrain's height to `height(x)` on [from, to], across the whole width.
template <class Height>
double worst(const Terrain& terrain, double from, double to, Height height) {
    double largest = 0.0;
    for (int i = 0; i <= 2000; ++i) {
        const double x = from + (to - from) * i / 2000.0;
        for (const double y : {-1.4, -0.3, 0.0, 0.777, 1.4}) {
            const double error = std::abs(terrain.heightAt(x, y) - height(x));
            largest = std::isnan(error) ? 1e300 : std::max(largest, error);
        }
    }
    return largest;
}

}  // namespace

TEST(ProfilesTest, FlatIsFlatEverywhere) {
    const Terrain terrain = made(spec(TerrainKind::Flat));
    EXPECT_EQ(worst(terrain, -2.0, 5.5, [](double) { return 0.0; }), 0.0);
    EXPECT_GT(terrain.obstacleRange().first, terrain.obstacleRange().second);
    EXPECT_TRUE(std::isnan(terrain.heightAt(-50.0, 0.0)));
    EXPECT_TRUE(std::isnan(terrain.heightAt(0.0, 50.0)));
}

TEST(ProfilesTest, StepUpAndDown) {
    const Terrain terrain = made(spec(TerrainKind::Step, 0.15, 0.8));
    EXPECT_LT(worst(terrain, -2.0, 0.9999, [](double) { return 0.0; }), kExact);
    EXPECT_LT(worst(terrain, 1.0001, 1.7999, [](double) { return 0.15; }), kExact);
    EXPECT_LT(worst(terrain, 1.8001, 5.0, [](double) { return 0.0; }), kExact);
    EXPECT_DOUBLE_EQ(terrain.heightAt(1.0, 0.0), 0.15);  // the highest ground counts
    EXPECT_DOUBLE_EQ(terrain.obstacleRange().first, 1.0);
    EXPECT_DOUBLE_EQ(terrain.obstacleRange().second, 1.8);
    const Terrain endless = made(spec(TerrainKind::Step, -0.1, 0.0));
    EXPECT_LT(worst(endless, 1.0001, 6.0, [](double) { return -0.1; }), kExact);
}

TEST(ProfilesTest, Stairs) {
    const Terrain terrain = made(spec(TerrainKind::Stairs, 0.1, 0.3, 0.0, 4));
    for (int i = 0; i < 4; ++i) {
        EXPECT_LT(worst(terrain, 1.0 + 0.3 * i + 1e-6, 1.3 + 0.3 * i - 1e-6,
                        [&](double) { return 0.1 * (i + 1); }),
                  kExact);
    }
    EXPECT_NEAR(terrain.heightAt(4.0, 0.0), 0.4, kExact);
}

TEST(ProfilesTest, Ramp) {
    project::Terrain ramp = spec(TerrainKind::Ramp, 0.0, 1.5);
    ramp.slope = project::Quantity::expression("20 deg");
    const double slope = std::tan(20.0 * pi / 180.0);
    EXPECT_LT(worst(made(ramp), -1.0, 5.0,
                    [&](double x) { return slope * std::clamp(x - 1.0, 0.0, 1.5); }),
              kExact);
}

TEST(ProfilesTest, SinusStartsAndEndsLevel) {
    const double height = 0.12;
    const double wave = 0.6;
    const Terrain terrain = made(spec(TerrainKind::Sinus, height, wave, 0.0, 3));
    EXPECT_LT(worst(terrain, 1.0, 1.0 + 3.0 * wave,
                    [&](double x) {
                        return 0.5 * height * (1.0 - std::cos(2.0 * pi * (x - 1.0) / wave));
                    }),
              kCurve);
    EXPECT_NEAR(terrain.heightAt(1.0 + 2.5 * wave, 0.0), height, kCurve);
    EXPECT_LT(worst(terrain, 2.8001, 5.0, [](double) { return 0.0; }), 1e-9);
}

TEST(ProfilesTest, CircleIsAHalfCylinder) {
    const double radius = 0.2;
    const Terrain terrain = made(spec(TerrainKind::Circle, 0.0, 0.0, radius));
    // Away from the feet, where the circle is vertical.
    EXPECT_LT(worst(terrain, 1.2 - 0.9 * radius, 1.2 + 0.9 * radius,
                    [&](double x) { return std::sqrt(radius * radius - (x - 1.2) * (x - 1.2)); }),
              3.0 * kChordError);
    EXPECT_NEAR(terrain.heightAt(1.2, 0.0), radius, kChordError);
}

TEST(ProfilesTest, CircleCapsStandApart) {
    const double radius = 0.5;
    const double cap = 0.1;
    const double half = std::sqrt(radius * radius - (radius - cap) * (radius - cap));
    const Terrain terrain = made(spec(TerrainKind::Circle, cap, 1.0, radius, 2));
    for (const double middle : {1.0 + half, 2.0 + half}) {
        EXPECT_LT(worst(terrain, middle - half, middle + half,
                        [&](double x) {
                            return std::sqrt(radius * radius - (x - middle) * (x - middle)) -
                                   radius + cap;
                        }),
                  kCurve);
    }
    EXPECT_LT(worst(terrain, 1.0 + 2.0 * half + 1e-6, 2.0 - 1e-6, [](double) { return 0.0; }),
              1e-9);
}

TEST(ProfilesTest, RandomProfileFollowsItsSeedAndBounds) {
    const auto random = [](int seed) {
        return made(spec(TerrainKind::RandomProfile, 0.15, 3.0, 0.0, 8, seed));
    };
    for (int seed = 1; seed <= 40; ++seed) {
        const Terrain terrain = random(seed);
        double top = 0.0;
        double lowest = 0.0;
        for (const Eigen::Vector2d& p : terrain.profile()) {
            top = std::max(top, p.y());
            lowest = std::min(lowest, p.y());
        }
        EXPECT_LE(top, 0.15 + kExact) << seed;
        EXPECT_GE(top, 0.4 * 0.15 - kCurve) << seed;
        EXPECT_GE(lowest, -kExact) << seed;
        EXPECT_LE(terrain.obstacleRange().second, 4.0 + 1e-9);
        EXPECT_GE(terrain.obstacleRange().first, 1.0);
    }
    EXPECT_EQ(random(7).profile(), random(7).profile());
    EXPECT_NE(random(7).profile(), random(8).profile());
}

TEST(ProfilesTest, NonsenseIsAProblemThatNamesTheNumber) {
    const auto problemsOf = [](const project::Terrain& terrain) {
        const auto result = makeTerrain(terrain, {}, 3.5);
        EXPECT_FALSE(result);
        return toString(result.problems());
    };
    using testing::HasSubstr;
    EXPECT_THAT(problemsOf(spec(TerrainKind::Step, std::nan(""), 1.0)), HasSubstr("height"));
    EXPECT_THAT(problemsOf(spec(TerrainKind::Step, 0.0, 1.0)), HasSubstr("height"));
    EXPECT_THAT(problemsOf(spec(TerrainKind::Step, 0.1, -1.0)), HasSubstr("length"));
    EXPECT_THAT(problemsOf(spec(TerrainKind::Sinus, 0.1, 0.0)), HasSubstr("length"));
    EXPECT_THAT(problemsOf(spec(TerrainKind::Circle, 0.3, 0.0, 0.2)), HasSubstr("height"));
    EXPECT_THAT(problemsOf(spec(TerrainKind::Stairs, 0.1, 0.3, 0.0, 0)), HasSubstr("count"));
    EXPECT_THAT(problemsOf(spec(TerrainKind::Particles, 0.0, 2.0, 0.001, 10)), HasSubstr("radius"));
    project::Terrain wrongUnit = spec(TerrainKind::Ramp, 0.0, 1.0);
    wrongUnit.slope = project::Quantity::expression("20 cm");
    EXPECT_THAT(problemsOf(wrongUnit), HasSubstr("slope"));
}
