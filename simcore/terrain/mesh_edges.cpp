#include "simcore/terrain/mesh_edges.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace simcore::terrain {
namespace {

constexpr double kSamePlace = 1e-6;  // [m]

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

}  // namespace

std::vector<int> weldVertices(const std::vector<Vec3>& vertices) {
    std::unordered_map<std::array<long, 3>, int, PlaceHash> known;
    known.reserve(vertices.size());
    std::vector<int> numbers;
    numbers.reserve(vertices.size());
    for (const Vec3& vertex : vertices) {
        const Vec3 p = vertex / kSamePlace;
        const std::array<long, 3> key{std::lround(p.x()), std::lround(p.y()), std::lround(p.z())};
        numbers.push_back(known.emplace(key, static_cast<int>(known.size())).first->second);
    }
    return numbers;
}

std::vector<MeshEdge> sortedEdges(const TriangleMesh& mesh, const std::vector<int>& numbers) {
    std::vector<MeshEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::array<int, 2> ends{triangle[k], triangle[(k + 1) % 3]};
            const int a = numbers[static_cast<std::size_t>(ends[0])];
            const int b = numbers[static_cast<std::size_t>(ends[1])];
            edges.push_back({std::min(a, b), std::max(a, b), ends});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const MeshEdge& a, const MeshEdge& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    });
    return edges;
}

}  // namespace simcore::terrain
