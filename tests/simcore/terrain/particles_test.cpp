#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gtest/gtest.h>

#include "simcore/terrain/particles.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::terrain;
using namespace testsupport;
using project::TerrainKind;

namespace {

constexpr double kStart = 0.7;
constexpr double kLength = 3.2;
constexpr double kRadius = 0.11;

HeightField deposited(int seed, int count = 150) {
    HeightField field;
    field.x0 = -2.5;
    field.y0 = -1.5;
    field.nx = 450;
    field.ny = 151;
    field.heights.assign(static_cast<std::size_t>(field.nx * field.ny), 0.0);
    depositParticles(field, kStart, kLength, kRadius, count, seed);
    return field;
}

double at(const HeightField& field, int ix, int iy) {
    return field.heights[static_cast<std::size_t>(ix * field.ny + iy)];
}

double xOf(const HeightField& field, int ix) {
    return field.x0 + ix * field.cell;
}

}  // namespace

TEST(ParticlesTest, SameSeedSameGround) {
    EXPECT_EQ(deposited(3).heights, deposited(3).heights);
    EXPECT_NE(deposited(3).heights, deposited(4).heights);
    EXPECT_NE(deposited(0).heights, deposited(-1).heights);
    const auto mesh = [](int seed) {
        return made(spec(TerrainKind::Particles, 0.0, kLength, kRadius, 150, seed)).mesh().vertices;
    };
    EXPECT_EQ(mesh(3), mesh(3));
    EXPECT_NE(mesh(3), mesh(4));
}

class ParticleSeedTest : public testing::TestWithParam<int> {};

TEST_P(ParticleSeedTest, GroundIsRoughWithoutSpikesOrHoles) {
    const HeightField field = deposited(GetParam());
    double top = 0.0;
    double steepest = 0.0;
    std::vector<double> bed;
    for (int ix = 1; ix + 1 < field.nx; ++ix) {
        for (int iy = 1; iy + 1 < field.ny; ++iy) {
            const double h = at(field, ix, iy);
            const double x = xOf(field, ix);
            ASSERT_TRUE(std::isfinite(h));
            ASSERT_GE(h, 0.0) << "a hole";
            top = std::max(top, h);
            const double gx = (at(field, ix + 1, iy) - at(field, ix - 1, iy)) / (2.0 * field.cell);
            const double gy = (at(field, ix, iy + 1) - at(field, ix, iy - 1)) / (2.0 * field.cell);
            steepest = std::max(steepest, std::hypot(gx, gy));
            // A spike: one cell far above the mean of its neighbours. The sharpest mound's top
            // stands 2 cell^2 / (3 R) = 4 mm above them, two such on each other 8 mm.
            const double around = 0.25 * (at(field, ix - 1, iy) + at(field, ix + 1, iy) +
                                          at(field, ix, iy - 1) + at(field, ix, iy + 1));
            ASSERT_LT(std::abs(h - around), 0.009) << "a spike at " << x;
            if (x > kStart + 2.0 * kRadius && x < kStart + kLength - 2.0 * kRadius) {
                bed.push_back(h);
            }
        }
    }
    const double mean =
        std::accumulate(bed.begin(), bed.end(), 0.0) / static_cast<double>(bed.size());
    double variance = 0.0;
    for (const double h : bed) {
        variance += (h - mean) * (h - mean) / static_cast<double>(bed.size());
    }
    // Rough for wheels of 0.07-0.1 m radius, but not a wall nor a heap.
    EXPECT_GT(std::sqrt(variance), 0.01);
    EXPECT_LT(std::sqrt(variance), 0.06);
    EXPECT_GT(top, 0.05);
    EXPECT_LT(top, 0.25);
    EXPECT_LT(steepest, 2.5) << "steeper than 68 degrees";
}

// The volume of all mounds together: pi R^2 h / 3 each, whose heights are R/3; what rolls over the
// field's edge is lost. E[R^3] of R = r (0.6..1.4) is r^3 (1.4^4 - 0.6^4) / 3.2.
TEST_P(ParticleSeedTest, VolumeIsThatOfTheGrains) {
    const HeightField field = deposited(GetParam());
    const double volume =
        std::accumulate(field.heights.begin(), field.heights.end(), 0.0) * field.cell * field.cell;
    const double cubed = std::pow(kRadius, 3) * (std::pow(1.4, 4) - std::pow(0.6, 4)) / 3.2;
    const double wanted = 150.0 * std::numbers::pi / 9.0 * cubed;
    EXPECT_NEAR(volume, wanted, 0.2 * wanted);
}

TEST_P(ParticleSeedTest, StartStaysFlatAndTheEdgesAreLow) {
    const HeightField field = deposited(GetParam());
    double beyond = 0.0;
    for (int ix = 0; ix < field.nx; ++ix) {
        for (int iy = 0; iy < field.ny; ++iy) {
            if (xOf(field, ix) < kStart - 1e-9) {
                ASSERT_EQ(at(field, ix, iy), 0.0) << "x = " << xOf(field, ix);
            }
            if (xOf(field, ix) > kStart + kLength + kRadius) {
                beyond = std::max(beyond, at(field, ix, iy));
            }
        }
    }
    EXPECT_LT(beyond, kRadius) << "a heap beyond the end";
}

TEST_P(ParticleSeedTest, LeftAndRightDifferAndBothAreRough) {
    const HeightField field = deposited(GetParam());
    double sums[2] = {0.0, 0.0};
    double difference = 0.0;
    for (int ix = 0; ix < field.nx; ++ix) {
        for (int iy = 0; iy < field.ny / 2; ++iy) {
            const double right = at(field, ix, iy);
            const double left = at(field, ix, field.ny - 1 - iy);
            sums[0] += right;
            sums[1] += left;
            difference = std::max(difference, std::abs(left - right));
        }
    }
    EXPECT_GT(difference, 0.03);
    EXPECT_GT(std::min(sums[0], sums[1]), 0.6 * std::max(sums[0], sums[1]));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ParticleSeedTest, testing::Values(1, 2, 3, 4, 5, 17, 99, 2026));
