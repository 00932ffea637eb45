#include "simcore/terrain/mesh_check.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "simcore/base/text.h"
#include "simcore/terrain/imports.h"
#include "simcore/terrain/mesh_edges.h"

namespace simcore::terrain {
namespace {

constexpr double kThin = 1e-9;  // triangles less high than this have no area [m]

using Triangle = std::array<int, 3>;

TriangleMesh weld(const TriangleMesh& mesh) {
    TriangleMesh welded;
    const std::vector<int> place = weldVertices(mesh.vertices);
    for (std::size_t i = 0; i < place.size(); ++i) {
        if (place[i] == static_cast<int>(welded.vertices.size())) {
            welded.vertices.push_back(mesh.vertices[i]);
        }
    }
    welded.triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const Triangle w{place[static_cast<std::size_t>(t[0])],
                         place[static_cast<std::size_t>(t[1])],
                         place[static_cast<std::size_t>(t[2])]};
        const Vec3& a = welded.vertices[static_cast<std::size_t>(w[0])];
        const Vec3 ab = welded.vertices[static_cast<std::size_t>(w[1])] - a;
        const Vec3 ac = welded.vertices[static_cast<std::size_t>(w[2])] - a;
        const double longest = std::max({ab.norm(), ac.norm(), (ac - ab).norm()});
        if (ab.cross(ac).norm() > kThin * longest) {
            welded.triangles.push_back(w);
        }
    }
    return welded;
}

/// Twice the area seen from above, negative where the underside shows.
double areaFromAbove(const TriangleMesh& mesh) {
    double area = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
        const Vec3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
        const Vec3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
        area += (b - a).cross(c - a).z();
    }
    return area;
}

struct EdgeCounts {
    std::size_t crowded = 0;  ///< of more than two triangles
    std::size_t opposed = 0;  ///< between triangles that face opposite sides
    std::size_t rims = 0;     ///< closed lines of edges with one triangle
};

/// Of a welded mesh.
EdgeCounts countEdges(const TriangleMesh& mesh) {
    EdgeCounts counts;
    std::vector<int> numbers(mesh.vertices.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    // Rims: open edges joined at their ends, each with the root of its line.
    std::unordered_map<int, int> parent;
    const auto root = [&parent](int v) {
        parent.try_emplace(v, v);
        while (parent[v] != v) {
            parent[v] = parent[parent[v]];
            v = parent[v];
        }
        return v;
    };
    forEachEdge(sortedEdges(mesh, numbers), [&](std::span<const MeshEdge> same) {
        counts.crowded += same.size() > 2 ? 1 : 0;
        counts.opposed += same.size() == 2 && same[0].ends == same[1].ends ? 1 : 0;
        if (same.size() == 1) {
            const int from = root(same[0].low);
            parent[from] = root(same[0].high);
        }
    });
    for (const auto& [vertex, above] : parent) {
        counts.rims += vertex == above ? 1 : 0;
    }
    return counts;
}

}  // namespace

Result<TriangleMesh> cleanMesh(const TriangleMesh& mesh, const std::string& element) {
    const auto critical = [&](std::string reason, std::string remedy) {
        return Problem{Severity::Critical, element, std::move(reason), std::move(remedy)};
    };
    for (const Vec3& v : mesh.vertices) {
        if (!(v.cwiseAbs().maxCoeff() <= kFarthestGround)) {
            return critical(Text::of("a vertex is not a finite number, or more than 10 km away."),
                            Text::of("Check the file and its units, scale and origin."));
        }
    }
    TriangleMesh clean = weld(mesh);
    if (clean.triangles.empty()) {
        return critical(Text::of("the mesh has no triangles with an area."),
                        Text::of("Check the file, its units and scale."));
    }
    Problems problems;
    const auto warn = [&](std::string reason, std::string remedy) {
        problems.push_back({Severity::Warning, element, std::move(reason), std::move(remedy)});
    };
    if (const std::size_t dropped = mesh.triangles.size() - clean.triangles.size(); dropped > 0) {
        warn(Text::of("{} triangles without area were left out.", dropped),
             Text::of("Clean the mesh if it looks wrong."));
    }
    if (areaFromAbove(clean) < 0.0) {
        for (Triangle& t : clean.triangles) {
            std::swap(t[1], t[2]);
        }
        warn(Text::of("its triangles face down; the mesh was turned over."),
             Text::of("Check the up axis, or turn the normals in the file."));
    }
    const EdgeCounts edges = countEdges(clean);
    if (edges.crowded > 0) {
        warn(Text::of("{} edges have more than two triangles.", edges.crowded),
             Text::of("Wheels may touch inner faces there; clean the mesh."));
    }
    if (edges.opposed > 0) {
        warn(Text::of("{} edges lie between triangles that face opposite sides.", edges.opposed),
             Text::of("Wheels pass through a face from behind; make the normals consistent."));
    }
    if (edges.rims > 1) {
        warn(Text::of("it has {} rims, one outline and holes or several pieces.", edges.rims),
             Text::of("Wheels can fall into holes; close them if that is not meant."));
    }
    return Result<TriangleMesh>(std::move(clean), std::move(problems));
}

}  // namespace simcore::terrain
