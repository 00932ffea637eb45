#pragma once

#include <vector>

#include "simcore/base/result.h"
#include "simcore/terrain/terrain.h"

namespace peers {

/// Heights at points of a square grid, for engines that take no triangle mesh of our making.
struct HeightGrid {
    double x0 = 0.0, y0 = 0.0;    ///< of the first point [m], world
    double cell = 0.0;            ///< [m]
    int columns = 0;              ///< along x
    int rows = 0;                 ///< along y
    std::vector<double> heights;  ///< heights[row * columns + column] [m]

    double x1() const { return x0 + (columns - 1) * cell; }

    double y1() const { return y0 + (rows - 1) * cell; }

    double lowest() const;
    double highest() const;
};

/// A rectangle of ground [m], world.
struct GroundBox {
    double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
};

/// Heights of the ground at whole multiples of `cell` in the box, or in what of it the ground
/// covers. Where the ground is a field on the same points these are its own vertices. Problem: a
/// hole, or no ground.
simcore::Result<HeightGrid> sampleGround(const simcore::terrain::Terrain& terrain, double cell,
                                         GroundBox box);

}  // namespace peers
