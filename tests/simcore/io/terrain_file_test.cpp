#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/stat.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "simcore/io/png_grid.h"
#include "simcore/io/terrain_file.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::io;
using namespace testsupport;
using project::TerrainKind;
using testing::HasSubstr;

namespace {

Result<terrain::Raster> grid(const std::string& text) {
    std::istringstream stream(text);
    return readAsciiGrid(stream, "a.asc");
}

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text.data(), text.size()));
}

class TerrainFileTest : public testing::Test {
  protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            std::filesystem::temp_directory_path() / (std::string("rover-terrain-") + info->name());
        std::filesystem::create_directories(folder_);
    }

    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// The ground that a written file is read back as.
    terrain::Terrain readBack(const project::Terrain& spec) {
        const auto imports = readTerrainFiles(spec, folder_);
        EXPECT_TRUE(imports) << toString(imports.problems());
        auto ground = terrain::makeTerrain(spec, {}, 3.5, imports.value());
        EXPECT_TRUE(ground) << toString(ground.problems());
        return std::move(ground).value();
    }

    std::filesystem::path folder_;
};

}  // namespace

TEST(AsciiGridTest, ReadsHeaderAndRows) {
    const auto raster = grid(
        "NCOLS 3\r\nnrows 2\nxllcorner 10\nyllcorner -4\ncellsize 2\nNODATA_value -1\n"
        "1 2 3\n4 -1 6.5e0\n");
    ASSERT_TRUE(raster) << toString(raster.problems());
    EXPECT_EQ(raster->columns, 3);
    EXPECT_EQ(raster->rows, 2);
    EXPECT_EQ(raster->x0, 11.0) << "heights hold at the middle of a cell";
    EXPECT_EQ(raster->y0, -3.0);
    EXPECT_EQ(raster->at(2, 0), 3.0);
    EXPECT_EQ(raster->at(2, 1), 6.5);
    EXPECT_TRUE(std::isnan(raster->at(1, 1)));
    EXPECT_EQ(grid("ncols 2 nrows 2 xllcenter 10 yllcenter 1 cellsize 2 1 2 3 4")->x0, 10.0);
}

TEST(AsciiGridTest, SaysWhatIsWrongAndWhere) {
    const auto why = [](const std::string& text) { return toString(grid(text).problems()); };
    EXPECT_THAT(why(""), HasSubstr("the header lacks"));
    EXPECT_THAT(why("ncols 2 nrows x"), HasSubstr("'nrows' is not followed by a number"));
    EXPECT_THAT(why("ncols 2 nrows 2 cellsize 0 1 2 3 4"), HasSubstr("cellsize"));
    EXPECT_THAT(why("ncols 2 nrows 2 cellsize 1 1 2 3"), HasSubstr("ends after 3 of 4"));
    EXPECT_THAT(why("ncols 2\nnrows 2\ncellsize 1\n1 2\n3 b"), HasSubstr("line 5"));
    EXPECT_THAT(why("ncols 2 nrows 2 cellsize 1 1 2 3 4 5"), HasSubstr("more than the 4"));
    EXPECT_THAT(why("ncols 100000 nrows 100000 cellsize 1 0"), HasSubstr("more than 4000000"));
    EXPECT_THAT(why("ncols 1e300 nrows nan cellsize 1"), HasSubstr("not followed by a number"));
}

TEST(PngTest, SixteenBitsRoundTrip) {
    std::vector<std::uint16_t> values;
    for (int i = 0; i < 6; ++i) {
        values.push_back(static_cast<std::uint16_t>(i * 13107));
    }
    const std::string bytes = formatPng(3, 2, values);
    const auto raster = readPng(bytesOf(bytes), "a.png");
    ASSERT_TRUE(raster) << toString(raster.problems());
    EXPECT_EQ(raster->columns, 3);
    for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(raster->values[i], values[i] / 65535.0, 1e-12);
    }
    EXPECT_THAT(toString(readPng(bytesOf(bytes.substr(0, 60)), "a.png").problems()),
                HasSubstr("not a readable PNG"));
    EXPECT_FALSE(readPng({}, "a.png"));
}

// Whatever the bytes, the readers return.
TEST(BrokenFilesTest, NoBytesHarmTheReaders) {
    Random random(23);
    const auto spoilt = [&random](std::string text) {
        for (int n = 0; n < 3; ++n) {
            text[random.next() % text.size()] = static_cast<char>(random.next());
        }
        return text;
    };
    for (int i = 0; i < 200; ++i) {
        const std::string png = formatPng(4, 4, std::vector<std::uint16_t>(16, 500));
        (void)readPng(bytesOf(spoilt(png)), "x");
        (void)grid(spoilt("ncols 2 nrows 2 cellsize 1 1 2 3 4"));
    }
    for (int i = 0; i < 20; ++i) {
        (void)readMesh(bytesOf(spoilt("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), "obj", "x");
    }
}

TEST(MeshFileTest, BrokenAndEmptyMeshesAreRefused) {
    EXPECT_THAT(toString(readMesh(bytesOf("nonsense"), "stl", "a.stl").problems()),
                HasSubstr("mesh"));
    EXPECT_THAT(toString(readMesh({}, "obj", "a.obj").problems()), HasSubstr("mesh"));
    // A count that no memory holds.
    const std::string greedy =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty double x\n"
        "property double y\nproperty double z\nelement face 4000000000\n"
        "property list uchar int vertex_indices\nend_header\n";
    EXPECT_FALSE(readMesh(bytesOf(greedy), "ply", "a.ply"));
}

TEST(MeshFileTest, OtherFormatsOfAssimpAreRefused) {
    EXPECT_THAT(toString(readMesh(bytesOf("BLENDER"), "blend", "a.blend").problems()),
                HasSubstr("'blend' is not a kind of mesh"));
}

// Reading from this pipe would wait for somebody to write into it.
TEST_F(TerrainFileTest, FilesThatAMeshNamesAreNotOpened) {
    const std::filesystem::path pipe = folder_ / "pipe.mtl";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::string text = "mtllib " + pipe.string() + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto mesh = readMesh(bytesOf(text), "OBJ", "a.obj");
    ASSERT_TRUE(mesh) << toString(mesh.problems());
    EXPECT_EQ(mesh->triangles.size(), 1U);
}

TEST_F(TerrainFileTest, MeshesRoundTrip) {
    const terrain::Terrain stairs = made(spec(TerrainKind::Stairs, 0.1, 0.2, 0.0, 3));
    for (const char* name : {"a.obj", "a.stl", "a.ply"}) {
        const auto written = writeTerrainMesh(stairs, folder_ / name);
        ASSERT_TRUE(written) << toString(written.problems());
        project::Terrain mesh;
        mesh.kind = TerrainKind::Mesh;
        mesh.file = name;
        const terrain::Terrain back = readBack(mesh);
        EXPECT_EQ(back.mesh().triangles.size(), stairs.mesh().triangles.size()) << name;
        EXPECT_EQ(back.mesh().vertices.size(), stairs.mesh().vertices.size()) << name;
        for (double x = 0.503; x < 2.0; x += 0.0119) {
            EXPECT_NEAR(back.heightAt(x, 0.4), stairs.heightAt(x, 0.4), 1e-6) << name;
        }
    }
    EXPECT_THAT(toString(writeTerrainMesh(stairs, folder_ / "a.xyz").problems()),
                HasSubstr("does not tell the format"));
}

TEST_F(TerrainFileTest, RastersRoundTrip) {
    const terrain::Terrain grains = made(spec(TerrainKind::Particles, 0.0, 2.0, 0.1, 60, 4));
    const auto asc = writeTerrainRaster(grains, 0.02, folder_ / "a.asc");
    const auto png = writeTerrainRaster(grains, 0.02, folder_ / "a.png");
    ASSERT_TRUE(asc && png);
    project::Terrain grid;
    grid.kind = TerrainKind::AsciiGrid;
    grid.file = "a.asc";
    project::Terrain image;
    image.kind = TerrainKind::Image;
    image.file = "a.png";
    image.cell = png->cell;
    image.height = png->high - png->low;
    image.origin = {png->x0, png->y0, png->low};
    const terrain::Terrain fromGrid = readBack(grid);
    const terrain::Terrain fromImage = readBack(image);
    const double level = (png->high - png->low) / 65535.0;
    for (double x = 0.5; x < 3.0; x += 0.0371) {
        for (const double y : {-0.63, 0.0, 0.41}) {
            EXPECT_NEAR(fromGrid.heightAt(x, y), grains.heightAt(x, y), 1e-8);
            EXPECT_NEAR(fromImage.heightAt(x, y), grains.heightAt(x, y), level);
        }
    }
    EXPECT_THAT(toString(writeTerrainRaster(grains, 1e-4, folder_ / "b.asc").problems()),
                HasSubstr("Choose --cell"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.asc"));
}

// Nor are they read: each of these would be too large for it.
TEST_F(TerrainFileTest, MoreThanARecordingCarriesIsRefused) {
    project::Terrain sum;
    sum.kind = TerrainKind::Sum;
    for (const char* name : {"a.png", "b.png", "a.png"}) {
        std::ofstream(folder_ / name) << "no image";
        std::filesystem::resize_file(folder_ / name, kLargestTerrainFile + 1);
        sum.terrains.emplace_back().kind = TerrainKind::Image;
        sum.terrains.back().file = name;
    }
    const std::string said = toString(carryTerrainFiles(sum, folder_).problems());
    EXPECT_THAT(said, HasSubstr("512 MiB together"));
    EXPECT_THAT(said, testing::Not(HasSubstr("larger than 256")));
    sum.terrains.pop_back();
    std::filesystem::resize_file(folder_ / "a.png", 10);
    std::filesystem::resize_file(folder_ / "b.png", 20);
    const auto carried = carryTerrainFiles(sum, folder_);
    ASSERT_TRUE(carried) << toString(carried.problems());
    EXPECT_EQ((*carried)->at("b.png").size(), 20U);
}

TEST_F(TerrainFileTest, MissingFilesAreNamed) {
    project::Terrain mesh;
    mesh.kind = TerrainKind::Mesh;
    EXPECT_THAT(toString(readTerrainFiles(mesh, folder_).problems()),
                HasSubstr("no file is given"));
    mesh.file = "gone.obj";
    EXPECT_THAT(toString(whyNoTerrainFiles(mesh, folder_)),
                HasSubstr("there is no file 'gone.obj' in '" + folder_.string()));
    project::Terrain sum;
    sum.kind = TerrainKind::Sum;
    sum.terrains = {mesh};
    EXPECT_FALSE(readTerrainFiles(sum, folder_));
    EXPECT_FALSE(whyNoTerrainFiles(sum, folder_).empty());
}
