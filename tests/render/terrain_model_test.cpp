#include <cmath>

#include <gtest/gtest.h>

#include "render/geometry/terrain_model.h"
#include "tests/support/scene_graph.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace testsupport;
using project::TerrainKind;
using terrain::Terrain;

namespace {

// Pictures hold single precision: 1e-6 m is a good deal more than it rounds off a few metres away.
constexpr double kRounding = 1e-6;

/// Terrains of every way the mesh is made: extruded, with vertical walls, on a grid.
std::vector<project::Terrain> kinds() {
    return {spec(TerrainKind::Flat), spec(TerrainKind::Step, 0.1, 1.2),
            spec(TerrainKind::RandomProfile, 0.08, 2.4, 0.0, 6, 4),
            spec(TerrainKind::Particles, 0.0, 1.0, 0.11, 20, 3)};
}

class GroundTest : public testing::TestWithParam<project::Terrain> {
  protected:
    const Terrain terrain = made(GetParam());
    render::Ground ground = render::makeGround(&terrain);
    const std::vector<DrawnVertex> drawn = verticesBelow(*ground.measured);
};

INSTANTIATE_TEST_SUITE_P(Kinds, GroundTest, testing::ValuesIn(kinds()), [](const auto& tested) {
    std::string name(nameOf(tested.param.kind));
    std::erase(name, '-');
    return name;
});

Vec3 cornerOf(const Terrain& terrain, std::size_t drawnIndex) {
    const auto& triangle = terrain.mesh().triangles[drawnIndex / 3];
    return terrain.mesh().vertices[static_cast<std::size_t>(triangle[drawnIndex % 3])];
}

}  // namespace

// The picture shows the simulation's triangles: all of them, none besides, corner for corner.
TEST_P(GroundTest, DrawsExactlyTheTrianglesOfTheSimulation) {
    ASSERT_EQ(drawn.size(), 3 * terrain.mesh().triangles.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        ASSERT_LT((drawn[i].place - cornerOf(terrain, i)).norm(), kRounding) << "corner " << i;
    }
}

// Light falls on the side that wheels touch: no normal points into the ground, none is bent off its
// triangle by more than the smoothing allows.
TEST_P(GroundTest, NormalsLookToTheFreeSide) {
    for (std::size_t i = 0; i < drawn.size(); i += 3) {
        const Vec3 face = (cornerOf(terrain, i + 1) - cornerOf(terrain, i))
                              .cross(cornerOf(terrain, i + 2) - cornerOf(terrain, i))
                              .normalized();
        for (std::size_t corner = i; corner < i + 3; ++corner) {
            ASSERT_NEAR(drawn[corner].normal.norm(), 1.0, 1e-5);
            ASSERT_GT(drawn[corner].normal.dot(face), 0.8) << "corner " << corner;
        }
    }
}

// The plain around the terrain neither covers it nor leaves a gap, and reaches to the fog.
TEST_P(GroundTest, SurroundingKeepsOffTheTerrain) {
    Eigen::AlignedBox2d box, horizon;
    for (const Vec3& p : terrain.mesh().vertices) {
        box.extend(Eigen::Vector2d(p.head<2>()));
    }
    double area = 0.0;
    for (unsigned child = 0; child < ground.root->getNumChildren(); ++child) {
        osg::Node& node = *ground.root->getChild(child);
        if (&node == ground.measured) {
            continue;
        }
        const auto around = verticesBelow(node);
        for (std::size_t i = 0; i < around.size(); i += 3) {
            const Vec3 a = around[i].place, b = around[i + 1].place, c = around[i + 2].place;
            const Eigen::Vector2d middle = ((a + b + c) / 3.0).head<2>();
            const double flat = 0.5 * (b - a).cross(c - a).z();
            EXPECT_GE(flat, -1e-9);
            if (flat > 1e-6) {
                EXPECT_GT(box.exteriorDistance(middle), 0.0);
                EXPECT_NEAR(a.z(), 0.0, kRounding);
            }
            area += flat;
            for (const Vec3& p : {a, b, c}) {
                horizon.extend(Eigen::Vector2d(p.head<2>()));
            }
        }
    }
    EXPECT_NEAR(area + box.volume(), horizon.volume(), 1e-4 * horizon.volume());
    EXPECT_GT(horizon.sizes().minCoeff(), 100.0);
}

// A step keeps its edge: its wall is lit as a wall, its top as a floor.
TEST(Ground, WallOfAStepIsNotSmoothedAway) {
    const Terrain terrain = made(spec(TerrainKind::Step, 0.1, 1.2));
    const auto drawn = verticesBelow(*render::makeGround(&terrain).measured);
    int upright = 0;
    for (const DrawnVertex& vertex : drawn) {
        const double z = std::abs(vertex.normal.z());
        EXPECT_TRUE(z < 1e-6 || z > 1.0 - 1e-6);
        upright += z < 0.5 ? 1 : 0;
    }
    EXPECT_EQ(upright, 12);  // two walls of two triangles
}

// Gentle ground is lit as the smooth thing it stands for: neighbours share their normals.
TEST(Ground, GentleWavesAreSmooth) {
    auto waves = spec(TerrainKind::Sinus, 0.04, 1.0);
    waves.count = 2;
    const Terrain terrain = made(waves);
    const auto drawn = verticesBelow(*render::makeGround(&terrain).measured);
    std::map<std::pair<long, long>, Vec3> seen;
    double largest = 0.0;
    for (const DrawnVertex& vertex : drawn) {
        const auto key =
            std::pair(std::lround(1e6 * vertex.place.x()), std::lround(1e6 * vertex.place.y()));
        const auto [at, added] = seen.emplace(key, vertex.normal);
        largest = std::max(largest, (at->second - vertex.normal).norm());
    }
    EXPECT_GT(seen.size(), 20U);
    EXPECT_LT(largest, 1e-5);
}

// Without a terrain there is still ground to stand on, at z = 0, with the grid on it.
TEST(Ground, NoTerrainIsAPlain) {
    const render::Ground ground = render::makeGround(nullptr);
    const auto drawn = verticesBelow(*ground.root);
    ASSERT_FALSE(drawn.empty());
    for (const DrawnVertex& vertex : drawn) {
        EXPECT_EQ(vertex.place.z(), 0.0);
    }
    EXPECT_EQ(verticesBelow(*ground.measured).size(), drawn.size());
}
