// Meshes. First byte 0 to 6: the rest is a file of that format for assimp, which reads it in a
// process of its own: whatever it does there, an answer must come. Any other first byte: the rest
// is a mesh as assimp might hand it over, eight bits a coordinate or whole doubles, so that
// cleaning it and making ground of it meet every shape.
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <string>

#include "simcore/io/terrain_file.h"
#include "simcore/terrain/make_terrain.h"
#include "tests/fuzz/fuzz.h"

using namespace simcore;
using fuzz::require;

namespace {

constexpr std::array kFormats{"obj", "stl", "ply", "dae", "glb", "off", "3ds"};

void checkGround(const terrain::TriangleMesh& mesh) {
    project::Terrain spec;
    spec.kind = project::TerrainKind::Mesh;
    spec.file = "input";
    terrain::Imports imports;
    imports.meshes["input"] = mesh;
    const auto ground = terrain::makeTerrain(spec, {}, 1.0, imports);
    require(ground || hasCritical(ground.problems()), "no missing ground without a reason");
    if (!ground) {
        return;
    }
    for (const Vec3& vertex : ground->mesh().vertices) {
        require(vertex.allFinite(), "a ground is finite");
    }
    (void)ground->heightAt(0.1, 0.1);
    std::vector<terrain::SliceSegment> segments;
    ground->slice({Vec3(0.1, 0.1, 0.1), Vec3::UnitX(), Vec3::UnitZ()}, 0.2, segments);
}

terrain::TriangleMesh plainMesh(fuzz::Source source) {
    const std::uint64_t shape = source.number(1);
    const bool whole = (shape & 1U) != 0;
    const std::size_t vertices = 3 + (shape >> 1U) % 32;
    terrain::TriangleMesh mesh;
    const auto coordinate = [&] {
        return whole ? std::bit_cast<double>(source.number(8))
                     : (static_cast<double>(source.number(1)) - 128.0) / 64.0;
    };
    for (std::size_t i = 0; i < vertices; ++i) {
        const double x = coordinate();
        const double y = coordinate();
        mesh.vertices.emplace_back(x, y, coordinate());
    }
    while (!source.empty()) {
        std::array<int, 3> triangle{};
        for (int& corner : triangle) {
            corner = static_cast<int>(source.number(1) % vertices);
        }
        mesh.triangles.push_back(triangle);
    }
    return mesh;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) {
        return 0;
    }
    const std::string_view rest = fuzz::textOf(data, size).substr(1);
    if (data[0] >= kFormats.size()) {
        checkGround(plainMesh(fuzz::Source(rest)));
        return 0;
    }
    const auto mesh = io::readMesh(std::as_bytes(std::span(rest)), kFormats[data[0]], "input");
    require(mesh || hasCritical(mesh.problems()), "no refusal without a reason");
    if (mesh) {
        checkGround(*mesh);
    }
    return 0;
}
