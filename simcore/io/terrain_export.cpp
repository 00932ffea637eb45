// Ground to files that other programs, and this one, read.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/png_grid.h"
#include "simcore/io/terrain_file.h"

namespace simcore::io {
namespace {

static_assert(std::endian::native == std::endian::little, "STL and PLY are written as they lie");

constexpr double kNoData = -9999.0;

using terrain::TriangleMesh;

void append(std::string& bytes, const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

std::string formatObj(const TriangleMesh& mesh) {
    std::string text = "# RoverStudio terrain, metres, x forward, y left, z up\n";
    for (const Vec3& v : mesh.vertices) {
        fmt::format_to(std::back_inserter(text), "v {} {} {}\n", v.x(), v.y(), v.z());
    }
    for (const auto& t : mesh.triangles) {
        fmt::format_to(std::back_inserter(text), "f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
    }
    return text;
}

std::string formatStl(const TriangleMesh& mesh) {
    std::string bytes = "RoverStudio terrain, metres, z up";
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
        const auto at = [&](std::size_t k) {
            return mesh.vertices[static_cast<std::size_t>(t[k])];
        };
        const Vec3 normal = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
        for (const Vec3& v : {normal, at(0), at(1), at(2)}) {
            for (const double number : {v.x(), v.y(), v.z()}) {
                append(bytes, static_cast<float>(number));
            }
        }
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string formatPly(const TriangleMesh& mesh) {
    std::string bytes = fmt::format(
        "ply\nformat binary_little_endian 1.0\ncomment RoverStudio terrain, metres, z up\n"
        "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertices.size(), mesh.triangles.size());
    for (const Vec3& v : mesh.vertices) {
        append(bytes, v.x());
        append(bytes, v.y());
        append(bytes, v.z());
    }
    for (const auto& t : mesh.triangles) {
        bytes += '\3';
        append(bytes, t);
    }
    return bytes;
}

struct Samples {
    RasterScale scale;
    int columns = 0, rows = 0;
    std::vector<double> heights;  ///< row by row, largest y first; NaN where there is no ground
};

/// The highest ground at points `cell` apart; problems when there are none or too many.
Result<Samples> sample(const terrain::Terrain& terrain, double cell, const std::string& name) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : terrain.mesh().vertices) {
        box.extend(v);
    }
    const Vec3 extent = box.sizes();
    // A last point on the border in spite of rounding.
    const double columns = std::floor(extent.x() / cell + 1e-6) + 1.0;
    const double rows = std::floor(extent.y() / cell + 1e-6) + 1.0;
    if (!(cell > 0.0) || columns < 2.0 || rows < 2.0 ||
        columns * rows > static_cast<double>(terrain::kMostRasterPoints)) {
        return Problem{
            Severity::Critical, name,
            Text::of("{:.6g} m between points gives {:.0f} x {:.0f} of them.", cell, columns, rows),
            Text::of("Choose --cell for 2 x 2 to {} points.", terrain::kMostRasterPoints)};
    }
    Samples samples;
    samples.columns = static_cast<int>(columns);
    samples.rows = static_cast<int>(rows);
    samples.scale = {box.min().x(), box.min().y(), cell, box.min().z(), box.max().z()};
    for (int row = samples.rows - 1; row >= 0; --row) {
        for (int column = 0; column < samples.columns; ++column) {
            samples.heights.push_back(
                terrain.heightAt(std::min(box.min().x() + column * cell, box.max().x()),
                                 std::min(box.min().y() + row * cell, box.max().y())));
        }
    }
    return samples;
}

std::string formatAscii(const Samples& samples) {
    std::string text = fmt::format(
        "ncols {}\nnrows {}\nxllcenter {}\nyllcenter {}\ncellsize {}\nNODATA_value {}\n",
        samples.columns, samples.rows, samples.scale.x0, samples.scale.y0, samples.scale.cell,
        kNoData);
    for (std::size_t i = 0; i < samples.heights.size(); ++i) {
        const double height = std::isnan(samples.heights[i]) ? kNoData : samples.heights[i];
        const bool last = (i + 1) % static_cast<std::size_t>(samples.columns) == 0;
        fmt::format_to(std::back_inserter(text), "{:.9g}{}", height, last ? '\n' : ' ');
    }
    return text;
}

Result<std::string> formatImage(const Samples& samples, const std::string& name) {
    const double range = samples.scale.high - samples.scale.low;
    std::vector<std::uint16_t> values;
    for (const double height : samples.heights) {
        if (std::isnan(height)) {
            return Problem{
                Severity::Critical, name,
                Text::of("the ground has holes, which an image written here cannot show."),
                Text::of("Write an ASCII grid (.asc) or a mesh.")};
        }
        const double share = range > 0.0 ? (height - samples.scale.low) / range : 0.0;
        values.push_back(static_cast<std::uint16_t>(std::lround(65535.0 * share)));
    }
    return formatPng(samples.columns, samples.rows, values);
}

Problem unknownEnding(const std::filesystem::path& file) {
    return {Severity::Critical, file.string(),
            Text::of("the ending of the name does not tell the format."),
            Text::of("Use .obj, .stl, .ply, .asc or .png.")};
}

}  // namespace

Result<bool> writeTerrainMesh(const terrain::Terrain& terrain, const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    const TriangleMesh& mesh = terrain.mesh();
    if (ending == ".obj") {
        return writeFileAtomically(file, formatObj(mesh));
    }
    if (ending == ".stl") {
        return writeFileAtomically(file, formatStl(mesh));
    }
    if (ending == ".ply") {
        return writeFileAtomically(file, formatPly(mesh));
    }
    return unknownEnding(file);
}

Result<RasterScale> writeTerrainRaster(const terrain::Terrain& terrain, double cell,
                                       const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending != ".asc" && ending != ".png") {
        return unknownEnding(file);
    }
    const auto samples = sample(terrain, cell, file.string());
    if (!samples) {
        return samples.problems();
    }
    std::string bytes;
    if (ending == ".asc") {
        bytes = formatAscii(*samples);
    } else {
        auto image = formatImage(*samples, file.string());
        if (!image) {
            return image.problems();
        }
        bytes = std::move(image).value();
    }
    const auto written = writeFileAtomically(file, bytes);
    if (!written) {
        return written.problems();
    }
    return samples->scale;
}

}  // namespace simcore::io
