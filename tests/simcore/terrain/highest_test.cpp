#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "tests/support/carts.h"
#include "tests/support/terrains.h"
#include "tests/support/walls.h"

using namespace simcore;
using namespace simcore::terrain;
using namespace testsupport;
using project::TerrainKind;

namespace {

/// The highest vertex in the box: all that is higher in a box's middle lies beside it.
double highestVertex(const Terrain& terrain, const Vec3& low, const Vec3& high) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& v : terrain.mesh().vertices) {
        if ((v.head<2>().array() >= low.head<2>().array()).all() &&
            (v.head<2>().array() <= high.head<2>().array()).all()) {
            highest = std::max(highest, v.z());
        }
    }
    return highest;
}

}  // namespace

TEST(HighestGroundTest, IsAnUpperBoundAndTightWithinACell) {
    constexpr double kCell = 0.02;
    project::Terrain field = spec(TerrainKind::Random3d, 0.3, 3.0, 0.0, 60, 7);
    field.start = -1.0;
    const Terrain terrain = made(field);
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const Vec3 low(random.uniform(-1.0, 1.5), random.uniform(-1.4, 1.0), 0.0);
        const Vec3 high = low + Vec3(random.uniform(0.0, 0.6), random.uniform(0.0, 0.4), 0.0);
        const double bound = terrain.highest(low, high);
        for (int k = 0; k < 40; ++k) {
            const double height = terrain.heightAt(random.uniform(low.x(), high.x()),
                                                   random.uniform(low.y(), high.y()));
            EXPECT_FALSE(height > bound);
        }
        // Look-up cells are two triangles large, and triangles reach one beyond them.
        const Vec3 more(3.0 * kCell, 3.0 * kCell, 0.0);
        EXPECT_LE(bound, highestVertex(terrain, low - more, high + more) + 1e-5);
    }
}

// Triangles far larger than a look-up cell: the bound is that of the plane over the cells.
TEST(HighestGroundTest, FollowsALongRamp) {
    const double slope = 0.3;
    const Terrain terrain = slopeThroughOrigin(slope);
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        const double x = random.uniform(-4.0, 4.0);
        const double bound = terrain.highest({x, -0.2, 0.0}, {x + 0.3, 0.2, 0.0});
        const double top = (x + 0.3) * std::tan(slope);
        EXPECT_GE(bound, top - 1e-6);
        EXPECT_LE(bound, top + 0.051 * std::tan(slope)) << "a cell of at most 50 mm further";
    }
}

TEST(HighestGroundTest, KnowsWallsAndEdges) {
    const Terrain terrain = floorAndWall(0.2, 0.3, 0.05);
    EXPECT_NEAR(terrain.highest({-0.1, -0.2, 0.0}, {0.1, 0.0, 0.0}), 0.0, 1e-5);
    EXPECT_NEAR(terrain.highest({-0.1, -0.2, 0.0}, {0.1, 0.2, 0.0}), 0.3, 1e-5);
    EXPECT_NEAR(terrain.highest({-0.1, 0.3, 0.0}, {0.1, 0.4, 0.0}), 0.3, 1e-5);
    // Everything, and a point.
    EXPECT_NEAR(terrain.highest({-9.0, -9.0, 0.0}, {9.0, 9.0, 0.0}), 0.3, 1e-5);
    EXPECT_NEAR(terrain.highest({0.0, -0.2, 0.0}, {0.0, -0.2, 0.0}), 0.0, 1e-5);
}

TEST(HighestGroundTest, IsNothingOverAHole) {
    std::vector<double> heights(101 * 101, 0.1);
    for (std::size_t ix = 20; ix < 80; ++ix) {
        for (std::size_t iy = 20; iy < 80; ++iy) {
            heights[ix * 101 + iy] = std::numeric_limits<double>::quiet_NaN();
        }
    }
    const Terrain terrain = Terrain::grid(-1.0, -1.0, 0.02, 101, 101, heights);
    EXPECT_EQ(terrain.highest({-0.3, -0.3, 0.0}, {0.3, 0.3, 0.0}),
              -std::numeric_limits<double>::infinity());
    EXPECT_NEAR(terrain.highest({-0.3, -0.3, 0.0}, {0.9, 0.3, 0.0}), 0.1, 1e-5);
}
