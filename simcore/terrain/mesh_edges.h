#pragma once

#include <span>

#include "simcore/terrain/terrain.h"

/// Which vertices of a mesh are one, and which triangles meet at which edge.
namespace simcore::terrain {

/// A number for each vertex, the same for vertices at the same place (1 um), counted from 0 in the
/// order of their first appearance.
std::vector<int> weldVertices(const std::vector<Vec3>& vertices);

/// An edge of one triangle.
struct MeshEdge {
    int low, high;            ///< numbers of its ends, low <= high
    std::array<int, 2> ends;  ///< vertices, as it runs counter-clockwise round the triangle
};

/// The edges of all triangles, sorted so that those between the same two numbers follow each other.
/// @param numbers  of the vertices, from weldVertices()
std::vector<MeshEdge> sortedEdges(const TriangleMesh& mesh, const std::vector<int>& numbers);

/// Calls visit(span of MeshEdge) for each edge of the mesh: one entry for each triangle that has
/// it.
template <class Visit>
void forEachEdge(const std::vector<MeshEdge>& sorted, Visit&& visit) {
    for (std::size_t i = 0; i < sorted.size();) {
        std::size_t end = i + 1;
        while (end < sorted.size() && sorted[end].low == sorted[i].low &&
               sorted[end].high == sorted[i].high) {
            ++end;
        }
        visit(std::span(sorted).subspan(i, end - i));
        i = end;
    }
}

}  // namespace simcore::terrain
