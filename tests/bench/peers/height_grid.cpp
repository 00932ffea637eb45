#include "tests/bench/peers/height_grid.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace peers {
namespace {

using simcore::Problem;
using simcore::Severity;
using simcore::Vec3;

// Part of a cell that a point may lie outside the box or the ground: rounding.
constexpr double kRounding = 1e-6;

int firstPoint(double low, double cell) {
    return static_cast<int>(std::ceil(low / cell - kRounding));
}

int lastPoint(double high, double cell) {
    return static_cast<int>(std::floor(high / cell + kRounding));
}

/// The part of the box that the mesh spans.
GroundBox covered(const simcore::terrain::TriangleMesh& mesh, GroundBox box) {
    Vec3 low = Vec3::Constant(INFINITY);
    Vec3 high = Vec3::Constant(-INFINITY);
    for (const Vec3& vertex : mesh.vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    return {std::max(box.x0, low.x()), std::max(box.y0, low.y()), std::min(box.x1, high.x()),
            std::min(box.y1, high.y())};
}

}  // namespace

double HeightGrid::lowest() const {
    return *std::min_element(heights.begin(), heights.end());
}

double HeightGrid::highest() const {
    return *std::max_element(heights.begin(), heights.end());
}

simcore::Result<HeightGrid> sampleGround(const simcore::terrain::Terrain& terrain, double cell,
                                         GroundBox box) {
    box = covered(terrain.mesh(), box);
    const int ix = firstPoint(box.x0, cell);
    const int iy = firstPoint(box.y0, cell);
    HeightGrid grid{ix * cell,
                    iy * cell,
                    cell,
                    lastPoint(box.x1, cell) - ix + 1,
                    lastPoint(box.y1, cell) - iy + 1,
                    {}};
    if (grid.columns < 2 || grid.rows < 2) {
        return Problem{Severity::Critical, "terrain", "there is no ground where the rover drives.",
                       "Check the origin of its file."};
    }
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            // Within the ground by a hair, where a point on its rim would be beside it.
            const double x = std::clamp(grid.x0 + column * cell, box.x0, box.x1);
            const double y = std::clamp(grid.y0 + row * cell, box.y0, box.y1);
            grid.heights.push_back(terrain.heightAt(x, y));
            if (std::isnan(grid.heights.back())) {
                return Problem{Severity::Critical, "terrain",
                               fmt::format("it has a hole at x = {:.3f} m, y = {:.3f} m.", x, y),
                               "Height fields of the peers have none: use ground without holes."};
            }
        }
    }
    return grid;
}

}  // namespace peers
