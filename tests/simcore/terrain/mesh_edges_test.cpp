// Edges of welded meshes, counted by Euler's formula.
#include "simcore/terrain/mesh_edges.h"

#include <set>

#include <gtest/gtest.h>

#include "tests/support/patches.h"

using namespace simcore;
using namespace simcore::terrain;

namespace {

/// The same triangles, none of which shares a vertex, corners off by 0.1 um.
TriangleMesh shredded(const TriangleMesh& mesh) {
    Random random(1);
    TriangleMesh apart;
    for (const auto& triangle : mesh.triangles) {
        const int first = static_cast<int>(apart.vertices.size());
        for (const int corner : triangle) {
            apart.vertices.push_back(mesh.vertices[static_cast<std::size_t>(corner)] +
                                     Vec3::Constant(random.uniform(-1e-7, 1e-7)));
        }
        apart.triangles.push_back({first, first + 1, first + 2});
    }
    return apart;
}

}  // namespace

// A sheet of n x m cells has 2 (n + m) edges on its border, one for each cell along it, each run
// through as its one triangle is; all others lie between two triangles, which run through them
// opposite ways. V - E + F = 1.
TEST(MeshEdgesTest, SheetHasABorderAndInnerEdges) {
    constexpr int kN = 12;
    constexpr int kM = 6;
    // Vertices on whole multiples of 1 um, so that 0.1 um does not change their place.
    const TriangleMesh mesh = shredded(testsupport::patch(0.05, 0.3, 0.15, [](double x, double) {
                                           return x > 0.1 ? 0.02 : 0.0;
                                       }).mesh());
    const std::vector<int> numbers = weldVertices(mesh.vertices);
    const std::set<int> spots(numbers.begin(), numbers.end());
    EXPECT_EQ(spots.size(), static_cast<std::size_t>((kN + 1) * (kM + 1)));
    EXPECT_EQ(*spots.rbegin() + 1, static_cast<int>(spots.size()));
    int edges = 0;
    int border = 0;
    forEachEdge(sortedEdges(mesh, numbers), [&](std::span<const MeshEdge> same) {
        ++edges;
        ASSERT_LE(same.size(), 2u);
        border += same.size() == 1 ? 1 : 0;
        for (const MeshEdge& edge : same) {
            const int from = numbers[static_cast<std::size_t>(edge.ends[0])];
            const int to = numbers[static_cast<std::size_t>(edge.ends[1])];
            EXPECT_EQ(std::min(from, to), edge.low);
            EXPECT_EQ(std::max(from, to), edge.high);
        }
        if (same.size() == 2) {
            EXPECT_EQ(numbers[static_cast<std::size_t>(same[0].ends[0])],
                      numbers[static_cast<std::size_t>(same[1].ends[1])]);
        }
    });
    EXPECT_EQ(border, 2 * (kN + kM));
    EXPECT_EQ(static_cast<int>(spots.size()) - edges + static_cast<int>(mesh.triangles.size()), 1);
}
