#include "simcore/terrain/mesh_check.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <fmt/format.h>

#include "simcore/terrain/imports.h"

namespace simcore::terrain {
namespace {

constexpr double kSamePlace = 1e-6;  // [m]
constexpr double kThin = 1e-9;       // triangles less high than this have no area [m]

using Triangle = std::array<int, 3>;

struct PlaceHash {
    std::size_t operator()(const std::array<long, 3>& place) const {
        std::uint64_t hash = 1469598103934665603ULL;
        for (const long n : place) {
            hash = (hash ^ static_cast<std::uint64_t>(n)) * 0x9E3779B97F4A7C15ULL;
            hash ^= hash >> 29;
        }
        return hash;
    }
};

/// An edge and the direction a triangle runs along it.
struct Edge {
    int low, high;
    bool upwards;
};

TriangleMesh weld(const TriangleMesh& mesh) {
    TriangleMesh welded;
    std::vector<int> place(mesh.vertices.size());
    std::unordered_map<std::array<long, 3>, int, PlaceHash> known;
    known.reserve(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vec3 p = mesh.vertices[i] / kSamePlace;
        const std::array<long, 3> key{std::lround(p.x()), std::lround(p.y()), std::lround(p.z())};
        const auto [found, fresh] = known.emplace(key, static_cast<int>(welded.vertices.size()));
        if (fresh) {
            welded.vertices.push_back(mesh.vertices[i]);
        }
        place[i] = found->second;
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

std::vector<Edge> edgesOf(const TriangleMesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = t[k];
            const int b = t[(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    return edges;
}

struct EdgeCounts {
    std::size_t crowded = 0;  ///< of more than two triangles
    std::size_t opposed = 0;  ///< between triangles that face opposite sides
    std::size_t rims = 0;     ///< closed lines of edges with one triangle
};

EdgeCounts countEdges(const TriangleMesh& mesh) {
    EdgeCounts counts;
    const std::vector<Edge> edges = edgesOf(mesh);
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
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        std::size_t upwards = 0;
        while (end < edges.size() && edges[end].low == edges[i].low &&
               edges[end].high == edges[i].high) {
            upwards += edges[end++].upwards ? 1 : 0;
        }
        const std::size_t count = end - i;
        counts.crowded += count > 2 ? 1 : 0;
        counts.opposed += count == 2 && upwards != 1 ? 1 : 0;
        if (count == 1) {
            const int from = root(edges[i].low);
            parent[from] = root(edges[i].high);
        }
        i = end;
    }
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
            return critical("a vertex is not a finite number, or more than 10 km away.",
                            "Check the file and its units, scale and origin.");
        }
    }
    TriangleMesh clean = weld(mesh);
    if (clean.triangles.empty()) {
        return critical("the mesh has no triangles with an area.",
                        "Check the file, its units and scale.");
    }
    Problems problems;
    const auto warn = [&](std::string reason, std::string remedy) {
        problems.push_back({Severity::Warning, element, std::move(reason), std::move(remedy)});
    };
    if (const std::size_t dropped = mesh.triangles.size() - clean.triangles.size(); dropped > 0) {
        warn(fmt::format("{} triangles without area were left out.", dropped),
             "Clean the mesh if it looks wrong.");
    }
    if (areaFromAbove(clean) < 0.0) {
        for (Triangle& t : clean.triangles) {
            std::swap(t[1], t[2]);
        }
        warn("its triangles face down; the mesh was turned over.",
             "Check the up axis, or turn the normals in the file.");
    }
    const EdgeCounts edges = countEdges(clean);
    if (edges.crowded > 0) {
        warn(fmt::format("{} edges have more than two triangles.", edges.crowded),
             "Wheels may touch inner faces there; clean the mesh.");
    }
    if (edges.opposed > 0) {
        warn(fmt::format("{} edges lie between triangles that face opposite sides.", edges.opposed),
             "Wheels pass through a face from behind; make the normals consistent.");
    }
    if (edges.rims > 1) {
        warn(fmt::format("it has {} rims, one outline and holes or several pieces.", edges.rims),
             "Wheels can fall into holes; close them if that is not meant.");
    }
    return Result<TriangleMesh>(std::move(clean), std::move(problems));
}

}  // namespace simcore::terrain
