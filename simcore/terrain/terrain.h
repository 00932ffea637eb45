#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "simcore/base/pose.h"
#include "simcore/base/result.h"
#include "simcore/terrain/ground_patch.h"

/// The ground: one triangle mesh that statics, engines and the picture share.
namespace simcore::terrain {

struct TriangleMesh {
    std::vector<Vec3> vertices;                 ///< world [m]
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise seen from the free side
};

/// A triangle of the ground.
struct Facet {
    std::array<Vec3, 3> corners;  ///< world [m]
    Vec3 normal;                  ///< unit, to the free side
};

/// An immutable ground with fast look-up around a wheel.
class Terrain {
  public:
    /// A polyline in x-z (x not decreasing, vertical faces allowed), extruded over y.
    static Terrain extruded(const std::vector<Eigen::Vector2d>& profile, double yMin, double yMax);

    /// A height field on a regular grid; diagonals mirror about y = 0. heights[ix * ny + iy] [m];
    /// NaN where there is no ground.
    static Terrain grid(double x0, double y0, double cell, int nx, int ny,
                        const std::vector<double>& heights);

    /// Any triangles: overhangs, holes and several sheets are possible. Throws invalid_argument on
    /// no triangles, an index out of range, a number that is not finite or a triangle without area.
    static Terrain fromMesh(TriangleMesh mesh);

    const TriangleMesh& mesh() const { return mesh_; }

    /// Height of the highest ground at (x, y) [m]; NaN outside the mesh.
    double heightAt(double x, double y) const;

    /// Upper bound of heightAt() over the box's x and y [m]: exceeds it by what the ground changes
    /// within about a look-up cell. -infinity where there is no ground; a box beyond the ground has
    /// the bound of the nearest cells. A handful of look-ups.
    double highest(const Vec3& low, const Vec3& high) const;

    /// Exact section of the ground with a plane: the pieces that come within `radius` of its
    /// origin.
    void slice(const SlicePlane& plane, double radius, std::vector<SliceSegment>& out) const;

    /// Triangles that slices with planes beside each other may find, also when every point within
    /// `radius` of a plane's origin goes up to `slack` away. No allocation once `out` has grown.
    /// @param offsets  of the planes' origins from that plane's, along v x u, ascending [m]
    void findNear(const SlicePlane& plane, std::span<const double> offsets, double radius,
                  double slack, GroundPatch& out) const;

    /// Triangles that may reach into the box from `low` to `high` and whose normals are within
    /// `angle` [rad] of +axis or -axis (unit). Appends to `out` (cleared first).
    void facing(const Vec3& low, const Vec3& high, const Vec3& axis, double angle,
                std::vector<Facet>& out) const;

    /// Range of x in which the ground is not flat at z = 0 [m]; empty (min > max) when it is flat.
    std::pair<double, double> obstacleRange() const { return obstacleRange_; }

    /// Whether the ground is the same at every y.
    bool sameAcross() const { return sameAcross_; }

    /// The polyline when the ground is an extruded profile, else empty.
    const std::vector<Eigen::Vector2d>& profile() const { return profile_; }

  private:
    void index();
    void indexQuads();
    void indexHeights();
    float highestIn(std::size_t level, int ix, int iy) const;
    /// highest(), looser and quicker: of at most 2^fineness + 1 coarse cells each way.
    double coarselyHighest(const Vec3& low, const Vec3& high, int fineness) const;

    /// Cells of the look-up grid, from first to last.
    struct CellRange {
        int firstX, lastX, firstY, lastY;
    };

    int column(double x) const;  ///< of the look-up grid, the nearest one outside it
    int row(double y) const;
    /// That a triangle is listed in: one when it fills a cell, as a triangle of a grid does.
    CellRange cellsOf(const std::array<int, 3>& triangle) const;
    std::size_t cellAt(int ix, int iy) const;
    /// Calls visit(cell) for the cells whose ground may come within `radius` of a plane's origin.
    /// @param from, to  offsets of the first plane and the last one [m]
    template <class Visit>
    void visitCells(const SlicePlane& plane, double from, double to, double radius,
                    Visit&& visit) const;
    /// Calls visit(CellRange) for all cells that a cylinder passes over, a row of them at a time.
    /// @param reach  from the centre, of the part that is looked at [m]
    template <class Visit>
    void visitRuns(const Vec3& center, const Vec3& axis, double halfLength, const Vec3& reach,
                   Visit&& visit) const;
    /// Of a triangle's plane at (x, y) [m]; NaN where the triangle is not, or is vertical.
    double heightOn(std::size_t triangle, double x, double y) const;

    const Vec3& cornerOf(std::size_t triangle, std::size_t k) const {
        return mesh_.vertices[static_cast<std::size_t>(mesh_.triangles[triangle][k])];
    }

    TriangleMesh mesh_;
    std::vector<Vec3> normals_;         ///< unit, of every triangle
    std::vector<std::uint8_t> spread_;  ///< of every triangle: 1 when it lies in several cells
    std::vector<Eigen::Vector2d> profile_;
    std::pair<double, double> obstacleRange_{1.0, -1.0};
    bool sameAcross_ = false;
    // Uniform grid over x-y: the triangles in each cell, in CSR layout.
    double cellX_ = 0.05, cellY_ = 0.05;  ///< size of a cell [m]
    double gridX0_ = 0.0, gridY0_ = 0.0;
    int gridNx_ = 0, gridNy_ = 0;
    std::vector<int> cellStart_;
    std::vector<int> cellTriangles_;

    /// Two triangles that fill a cell, as those of a height field do: of corners 0, 1, 2 and 0,
    /// 2, 3.
    struct Quad {
        std::array<int, 4> corners{-1, -1, -1, -1};
        std::array<int, 2> triangles{-1, -1};

        bool isQuad() const { return corners[0] >= 0; }
    };

    std::vector<Quad> quads_;          ///< of every cell; empty where the ground has none
    std::vector<float> cellSteepest_;  ///< steepest slope of the triangles in each cell [rad]
    float steepest_ = 0.0F;
    std::vector<float> cellHighest_;  ///< no ground in the cell is above it [m], world

    /// The same of 2 x 2 cells, 4 x 4 cells, ... up to one for all.
    struct Coarse {
        int ny = 0;
        std::vector<float> highest;
    };

    std::vector<Coarse> coarse_;
};

}  // namespace simcore::terrain
