#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "simcore/base/pose.h"

namespace simcore::terrain {

struct TriangleMesh;

/// A piece of the ground cut by a wheel's plane, in that plane's coordinates.
struct SliceSegment {
    Eigen::Vector2d a;  ///< start [m]
    Eigen::Vector2d b;  ///< end [m]; the free side is to the left of a -> b
    Vec3 normal;        ///< unit, of the triangle, world
    /// Point of the line a-b that is nearest to the origin, as a share of the way from a to b. 0 of
    /// a segment without length.
    double nearest = 0.0;

    /// Of the segment itself [m].
    Eigen::Vector2d nearestPoint() const { return a + std::clamp(nearest, 0.0, 1.0) * (b - a); }
};

/// A plane through a wheel: origin at the wheel slice's centre, u forward, v up, in the world.
struct SlicePlane {
    Vec3 origin;
    Vec3 u;
    Vec3 v;
};

/// Triangles of the ground that planes beside each other may cut near their origins, copied by
/// Terrain::findNear to be cut again and again while a wheel rolls on a little.
///
/// Triangles share their corners, planes beside each other share their directions: corners are
/// looked at once for all, and a triangle only when the wheel has come far enough to reach it.
class GroundPatch {
  public:
    GroundPatch();

    /// Empties it, for so many planes.
    void reset(std::size_t planes);
    /// @param reach  no point of the triangle comes within the radius of a plane's origin before
    ///               that origin's surroundings have gone so far [m]
    void add(std::size_t plane, int triangle, double reach);
    /// Copies what was added, each triangle once and in the order of the mesh.
    void take(const TriangleMesh& mesh, std::span<const Vec3> normals);

    /// Looks at the corners from where the planes are now.
    /// @param middle  that the planes' offsets are from
    void see(const SlicePlane& middle);
    /// Exact section with one plane: pieces that come within `radius` of its origin, after see().
    /// No allocation once `out` has grown.
    /// @param offset  of the plane's origin from the middle's, along v x u [m]
    /// @param way     no point within the radius has gone further since findNear() [m]
    /// @param out     in the order of the mesh, cleared first
    void slice(std::size_t plane, double offset, double radius, double way,
               std::vector<SliceSegment>& out) const;

  private:
    /// A triangle that one of the planes may cut.
    struct Candidate {
        int triangle;
        float reach;  ///< [m]
    };

    /// The same with what cutting it asks for.
    struct Piece {
        std::array<int, 3> corners;
        float reach;
        Vec3 normal;
    };

    int cornerOf(int vertex, const Vec3& place);
    std::size_t slotOf(int vertex) const;
    void growTable();

    std::vector<std::vector<Candidate>> candidates_;  ///< of every plane
    std::vector<std::vector<Piece>> pieces_;          ///< of every plane
    // Of every corner.
    std::vector<int> vertices_;            ///< of the mesh, by index
    std::vector<double> x_, y_, z_;        ///< world [m]
    std::vector<double> distances_;        ///< from the middle plane, along v x u [m]
    std::vector<double> alongU_, alongV_;  ///< [m]
    std::vector<int> table_;               ///< of corners by vertex, -1: none; open addressing
};

}  // namespace simcore::terrain
