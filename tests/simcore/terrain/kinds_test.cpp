#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::terrain;
using namespace testsupport;
using project::Sides;
using project::TerrainKind;
using std::numbers::pi;

namespace {

project::Terrain sumOf(std::vector<project::Terrain> parts) {
    project::Terrain sum;
    sum.kind = TerrainKind::Sum;
    sum.terrains = std::move(parts);
    return sum;
}

project::Terrain at(double start, project::Terrain terrain) {
    terrain.start = start;
    return terrain;
}

double slopeAcross(const Terrain& terrain, double x) {
    return std::atan2(terrain.heightAt(x, 0.5) - terrain.heightAt(x, -0.5), 1.0);
}

}  // namespace

TEST(KindsTest, TrenchHasVerticalFaces) {
    const Terrain trench = made(spec(TerrainKind::Trench, 0.1, 0.3));
    EXPECT_EQ(trench.heightAt(0.9999, 0.0), 0.0);
    EXPECT_NEAR(trench.heightAt(1.0001, 0.0), -0.1, 1e-12);
    EXPECT_NEAR(trench.heightAt(1.2999, 0.0), -0.1, 1e-12);
    EXPECT_EQ(trench.heightAt(1.3001, 0.0), 0.0);
}

TEST(KindsTest, CrossSlopeTiltsAboutXAfterALevelStart) {
    project::Terrain cross = spec(TerrainKind::CrossSlope, 0.0, 0.8);
    cross.slope = 0.3;
    const Terrain ground = made(cross);
    EXPECT_NEAR(slopeAcross(ground, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(slopeAcross(ground, 0.99), 0.0, 1e-12);
    EXPECT_NEAR(slopeAcross(ground, 1.4), 0.15, 1e-6) << "half way, half the angle";
    EXPECT_NEAR(slopeAcross(ground, 3.0), 0.3, 1e-9);
    EXPECT_GT(ground.heightAt(3.0, 0.5), 0.0) << "rises to the left";
    EXPECT_NEAR(ground.heightAt(3.0, 0.0), 0.0, 1e-9);
    // No kink anywhere along the way: the rise over one cell changes little.
    for (double x = 0.5; x < 3.0; x += 0.02) {
        const double bend = ground.heightAt(x + 0.02, 1.0) - 2.0 * ground.heightAt(x, 1.0) +
                            ground.heightAt(x - 0.02, 1.0);
        EXPECT_LT(std::abs(bend), 3e-3) << x;
    }
}

// Heights add, vertical faces stay vertical, and the ground stays a profile.
TEST(KindsTest, SumOfProfilesIsAProfile) {
    const Terrain sum = made(sumOf({at(1.0, spec(TerrainKind::Step, 0.1, 0.0)),
                                    at(1.0, spec(TerrainKind::Step, 0.05, 0.5)),
                                    at(1.2, spec(TerrainKind::Sinus, 0.04, 0.4, 0.0, 2))}));
    ASSERT_FALSE(sum.profile().empty());
    const auto wave = [](double x) {
        return x < 1.2 || x > 2.0 ? 0.0 : 0.02 * (1.0 - std::cos(2.0 * pi * (x - 1.2) / 0.4));
    };
    for (double x = 0.9031; x < 2.3; x += 0.0137) {
        const double steps = (x > 1.0 ? 0.1 : 0.0) + (x > 1.0 && x < 1.5 ? 0.05 : 0.0);
        EXPECT_NEAR(sum.heightAt(x, 0.7), steps + wave(x), 1e-4) << x;
    }
    int faces = 0;
    for (std::size_t i = 0; i + 1 < sum.profile().size(); ++i) {
        faces += sum.profile()[i].x() == sum.profile()[i + 1].x() ? 1 : 0;
    }
    EXPECT_EQ(faces, 2) << "up by 0.15 at once, down by 0.05";
}

TEST(KindsTest, SumWithAFieldIsAField) {
    const auto grains = spec(TerrainKind::Particles, 0.0, 2.0, 0.1, 60, 4);
    project::Terrain ramp = spec(TerrainKind::Ramp, 0.0, 2.0);
    ramp.slope = 0.1;
    const Terrain alone = made(grains);
    const Terrain sum = made(sumOf({ramp, grains}));
    EXPECT_TRUE(sum.profile().empty());
    for (const double x : {0.5, 1.3, 1.9, 2.7}) {
        const double rise = x < 1.0 ? 0.0 : std::tan(0.1) * (x - 1.0);
        for (const double y : {-0.7, 0.0, 0.4}) {
            EXPECT_NEAR(sum.heightAt(x, y), alone.heightAt(x, y) + rise, 1e-9);
        }
    }
}

TEST(KindsTest, OneSideHasTheStepAndAWallToTheOther) {
    project::Terrain step = spec(TerrainKind::Step, 0.1, 0.4);
    step.sides = Sides::Left;
    const Terrain ground = made(step);
    EXPECT_NEAR(ground.heightAt(1.2, 0.5), 0.1, 1e-12);
    EXPECT_NEAR(ground.heightAt(1.2, -0.5), 0.0, 1e-12);
    EXPECT_NEAR(ground.heightAt(0.8, 0.5), 0.0, 1e-12);
    // A cut across: floor, wall at y = 0 and top meet without gaps.
    std::vector<SliceSegment> slice;
    ground.slice({{1.2, 0.0, 0.05}, -Vec3::UnitY(), Vec3::UnitZ()}, 0.3, slice);
    ASSERT_GE(slice.size(), 3u);
    double wall = 0.0;
    for (const SliceSegment& piece : slice) {
        if (std::abs(piece.normal.y() + 1.0) < 1e-12) {
            EXPECT_NEAR(piece.a.x(), 0.0, 1e-12);
            wall += (piece.b - piece.a).norm();
        }
    }
    EXPECT_NEAR(wall, 0.1, 1e-12) << "the wall looks to the lower side, the right";
}

// Profiles that cross: the wall changes sides where they do, and covers what lies between them.
TEST(KindsTest, WallBetweenCrossingSides) {
    project::Terrain up = spec(TerrainKind::Ramp, 0.0, 1.0);
    up.slope = 0.2;
    up.sides = Sides::Left;
    project::Terrain bump = spec(TerrainKind::Step, 0.1, 3.0);
    bump.sides = Sides::Right;
    const Terrain ground = made(sumOf({up, bump}));
    double right = 0.0;
    double left = 0.0;
    for (const auto& t : ground.mesh().triangles) {
        const auto v = [&](std::size_t k) {
            return ground.mesh().vertices[static_cast<std::size_t>(t[k])];
        };
        const Vec3 area = 0.5 * (v(1) - v(0)).cross(v(2) - v(0));
        (area.y() < 0.0 ? right : left) += std::abs(area.y());
    }
    // Left is higher once tan(0.2) (x - 1) > 0.1, and where the block on the right has ended.
    const double slope = std::tan(0.2);
    const double crossing = 0.1 / slope;
    const double above =
        0.5 * slope * std::pow(1.0 - crossing, 2) + 2.0 * (slope - 0.1) + slope * 3.0;
    EXPECT_NEAR(left, 0.5 * 0.1 * crossing, 1e-9);
    EXPECT_NEAR(right, above, 1e-9);
}

TEST(KindsTest, SymmetricFieldIsItsMirrorImage) {
    for (auto terrain : {spec(TerrainKind::Particles, 0.0, 2.0, 0.1, 60, 4),
                         spec(TerrainKind::Random3d, 0.1, 3.0, 0.0, 20, 4),
                         spec(TerrainKind::RockField, 0.0, 3.0, 0.15, 1, 4)}) {
        const Terrain wild = made(terrain);
        terrain.symmetric = true;
        const Terrain mirrored = made(terrain);
        double difference = 0.0;
        for (double x = 0.9; x < 3.0; x += 0.053) {
            for (double y = 0.03; y < 1.4; y += 0.047) {
                ASSERT_NEAR(mirrored.heightAt(x, y), mirrored.heightAt(x, -y), 1e-9);
                difference += std::abs(wild.heightAt(x, y) - wild.heightAt(x, -y));
            }
        }
        EXPECT_GT(difference, 1.0) << nameOf(terrain.kind);
    }
}

TEST(KindsTest, RandomFeaturesStayWithinTheirHeightAndPlace) {
    const Terrain one = made(spec(TerrainKind::Random3d, 0.2, 3.0, 0.0, 1, 7));
    double top = 0.0;
    for (const Vec3& v : one.mesh().vertices) {
        EXPECT_GE(v.z(), 0.0);
        top = std::max(top, v.z());
        if (v.z() > 0.0) {
            EXPECT_GE(v.x(), 1.0);
            EXPECT_LE(v.x(), 4.0);
        }
    }
    EXPECT_GT(top, 0.05);
    EXPECT_LE(top, 0.2);
    EXPECT_EQ(one.mesh().vertices,
              made(spec(TerrainKind::Random3d, 0.2, 3.0, 0.0, 1, 7)).mesh().vertices);
    EXPECT_NE(one.mesh().vertices,
              made(spec(TerrainKind::Random3d, 0.2, 3.0, 0.0, 1, 8)).mesh().vertices);
}

// The share of ground under rocks of 3 cells to 2 radius in diameter is the law's, within the
// scatter of a random draw; averaged over seeds.
TEST(KindsTest, RocksCoverTheShareOfTheLaw) {
    const double k = 0.15;
    project::Terrain rocks = spec(TerrainKind::RockField, 0.0, 8.0, 0.25);
    rocks.coverage = k;
    const double q = 1.79 + 0.152 / k;
    const double wanted = k * (std::exp(-q * 0.06) - std::exp(-q * 0.5));
    double covered = 0.0;
    double top = 0.0;
    constexpr int kSeeds = 6;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        rocks.seed = seed;
        const Terrain ground = made(rocks);
        double points = 0.0;
        for (const Vec3& v : ground.mesh().vertices) {
            points += v.z() > 0.0 ? 1.0 : 0.0;
            top = std::max(top, v.z());
            if (v.z() > 0.0) {
                ASSERT_GE(v.x(), 1.0);
                ASSERT_LE(v.x(), 9.0);
            }
        }
        covered += points * 0.02 * 0.02 / (8.0 * 3.0) / kSeeds;
    }
    EXPECT_NEAR(covered, wanted, 0.12 * wanted);
    EXPECT_LE(top, 0.25) << "hemispheres, none larger than asked for";
    EXPECT_GT(top, 0.1);
}

TEST(KindsTest, WhatCannotBeMadeIsExplained) {
    const auto problems = [](const project::Terrain& terrain) {
        return toString(makeTerrain(terrain, {}, 3.5).problems());
    };
    EXPECT_THAT(problems(sumOf({})), testing::HasSubstr("0 terrains are added"));
    EXPECT_THAT(problems(sumOf({sumOf({spec(TerrainKind::Flat)})})),
                testing::HasSubstr("cannot be added"));
    EXPECT_THAT(problems(sumOf({spec(TerrainKind::Step, 0.0, 0.0)})),
                testing::HasSubstr("terrain sum, 1 step, height"));
    project::Terrain fine = spec(TerrainKind::Particles, 0.0, 20.0, 0.1, 10);
    fine.cell = 0.001;
    EXPECT_THAT(problems(fine), testing::HasSubstr("Choose larger cells"));
    project::Terrain unit;
    unit.kind = TerrainKind::Mesh;
    unit.units = "kg";
    EXPECT_THAT(problems(unit), testing::HasSubstr("no unit of length"));
}

// Heights of a file, placed: rows count down from the largest y.
TEST(KindsTest, RastersArePlacedAndKeepTheirHoles) {
    Raster raster{3, 3, {0.0, 0.5, 1.0, 0.0, 0.25, 1.0, std::nan(""), 0.0, 0.0}, 0.0, 0.0, 0.0};
    Imports imports;
    imports.rasters["a.png"] = raster;
    project::Terrain image;
    image.kind = TerrainKind::Image;
    image.file = "a.png";
    image.cell = 0.5;
    image.height = 0.2;
    image.origin = {-0.5, -0.5, 0.01};
    const auto ground = makeTerrain(image, {}, 3.5, imports);
    ASSERT_TRUE(ground) << toString(ground.problems());
    EXPECT_NEAR(ground->heightAt(0.0, 0.0), 0.01 + 0.05, 1e-12) << "the middle";
    EXPECT_NEAR(ground->heightAt(0.0, 0.5), 0.01 + 0.1, 1e-12) << "first row: largest y";
    EXPECT_NEAR(ground->heightAt(0.5, 0.25), 0.01 + 0.2, 1e-12);
    EXPECT_TRUE(std::isnan(ground->heightAt(-0.4, -0.4))) << "no height, no ground";

    imports.rasters["a.asc"] = {
        3, 3, {0.0, 500.0, 1000.0, 0.0, 250.0, 1000.0, 0.0, 0.0, 0.0}, 1000.0, 2000.0, 500.0};
    project::Terrain grid;
    grid.kind = TerrainKind::AsciiGrid;
    grid.file = "a.asc";
    grid.units = "mm";
    grid.scale = 2.0;
    grid.origin = {-3.0, -5.0, 0.1};
    const auto placed = makeTerrain(grid, {}, 3.5, imports);
    ASSERT_TRUE(placed) << toString(placed.problems());
    // Scale 2: the lower left point lies at 2 - 3, 4 - 5, points are 1 m apart.
    EXPECT_NEAR(placed->heightAt(0.0, 0.0), 0.5 + 0.1, 1e-12);
    EXPECT_NEAR(placed->heightAt(1.0, 1.0), 2.0 + 0.1, 1e-12);
}

TEST(KindsTest, MeshesArePlacedAndCleaned) {
    // Y up, in mm, wound from below, with a doubled vertex, a triangle without area and a hole.
    TriangleMesh mesh;
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 4; ++k) {
            mesh.vertices.emplace_back(1000.0 * i, 100.0, 1000.0 * k);
        }
    }
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            if (i != 1 || k != 1) {
                const int a = 4 * i + k;
                mesh.triangles.push_back({a, a + 4, a + 5});
                mesh.triangles.push_back({a, a + 5, a + 1});
            }
        }
    }
    mesh.vertices.push_back(mesh.vertices[0]);
    mesh.triangles.push_back({0, 16, 5});
    Imports imports;
    imports.meshes["a.obj"] = mesh;
    project::Terrain terrain;
    terrain.kind = TerrainKind::Mesh;
    terrain.file = "a.obj";
    terrain.units = "mm";
    terrain.up = project::UpAxis::Y;
    terrain.origin = {-1.5, 1.5, -0.05};
    const auto ground = makeTerrain(terrain, {}, 3.5, imports);
    ASSERT_TRUE(ground) << toString(ground.problems());
    const std::string warnings = toString(ground.problems());
    EXPECT_THAT(warnings, testing::HasSubstr("1 triangles without area"));
    EXPECT_THAT(warnings, testing::HasSubstr("turned over"));
    EXPECT_THAT(warnings, testing::HasSubstr("2 rims"));
    EXPECT_NEAR(ground->heightAt(1.0, 0.0), 0.05, 1e-12);
    EXPECT_TRUE(std::isnan(ground->heightAt(0.0, 0.0)));
    EXPECT_EQ(ground->mesh().vertices.size(), 16u);

    imports.meshes["a.obj"].vertices[3].x() = std::nan("");
    EXPECT_THAT(toString(makeTerrain(terrain, {}, 3.5, imports).problems()),
                testing::HasSubstr("not a finite number"));
    imports.meshes["a.obj"] = {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)}, {{0, 1, 2}}};
    EXPECT_THAT(toString(makeTerrain(terrain, {}, 3.5, imports).problems()),
                testing::HasSubstr("no triangles with an area"));
}

TEST(RasterTest, PointsThatNoRoverReachesAreRefused) {
    Imports imports;
    imports.rasters["a.asc"] = {2, 2, {0.0, 1.0, 2.0, 3.0}, 0.0, 0.0, 1.0};
    project::Terrain terrain;
    terrain.kind = TerrainKind::AsciiGrid;
    terrain.file = "a.asc";
    const auto refusal = [&](const Raster& raster) {
        imports.rasters["a.asc"] = raster;
        return toString(makeTerrain(terrain, {}, 3.5, imports).problems());
    };
    EXPECT_EQ(refusal({2, 2, {0.0, 1.0, 2.0, 3.0}, -9000.0, 9000.0, 1.0}), "");
    for (const Raster& raster : {Raster{2, 2, {0.0, 1.0, 2.0, 3.0}, 1e300, 0.0, 1.0},
                                 Raster{2, 2, {0.0, 1.0, 2.0, 3.0}, 0.0, 0.0, 20'000.0},
                                 Raster{2, 2, {0.0, 1.0, 2.0, 1e308}, 0.0, 0.0, 1.0}}) {
        EXPECT_THAT(refusal(raster), testing::HasSubstr("m away"));
    }
    EXPECT_THAT(refusal({2, 2, {0.0, 1.0, 2.0, 3.0}, 0.0, 0.0, 1e-300}),
                testing::HasSubstr("1e-300 m apart"));
    imports.rasters["a.asc"] = {2, 2, {0.0, 1.0, 2.0, 3.0}, 0.0, 0.0, 1.0};
    const auto ground = makeTerrain(terrain, {}, 3.5, imports);
    ASSERT_TRUE(ground);
    EXPECT_TRUE(std::isnan(ground->heightAt(-1e300, 1e300)));
    EXPECT_TRUE(std::isnan(ground->heightAt(std::nan(""), 0.0)));
}
