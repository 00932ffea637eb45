#pragma once

#include <vector>

#include "simcore/terrain/imports.h"
#include "simcore/terrain/profiles.h"

/// Heights on a regular grid and what is added to them: full 3-D ground.
namespace simcore::terrain {

/// heights[ix * ny + iy] [m].
struct HeightField {
    double x0 = 0.0, y0 = 0.0, cell = 0.02;
    int nx = 0, ny = 0;
    std::vector<double> heights;

    double x(int ix) const { return x0 + ix * cell; }

    double y(int iy) const { return y0 + iy * cell; }

    double& at(int ix, int iy) {
        return heights[static_cast<std::size_t>(ix) * static_cast<std::size_t>(ny) +
                       static_cast<std::size_t>(iy)];
    }
};

/// Ground that tilts about x: z = y tan(slope), positive slopes rise to the left. The tilt grows
/// from 0 at `start` to `slope` [rad] after `length`, as 3 s^2 - 2 s^3 of the way s.
void addCrossSlope(HeightField& field, double start, double length, double slope);

/// `count` blocks, waves and caps at random places, sizes and headings, none higher than `height`;
/// where they overlap heights add. Nothing reaches before `start` or beyond start + length.
void addRandomFeatures(HeightField& field, double start, double length, double height, int count,
                       int seed);

/// Hemispherical rocks of random size and place that do not overlap. The share of ground covered
/// by rocks of diameter D and more is k exp(-q D), q = 1.79 + 0.152/k per metre, the law fitted by
/// Golombek and Rapp (1997) to the Viking sites; k is `coverage`. Rocks are between 3 cells and
/// 2 `radius` in diameter.
void addRocks(HeightField& field, double start, double length, double radius, double coverage,
              int seed);

/// The highest point of the profile at every x.
void addProfile(HeightField& field, const Profile& profile, bool left, bool right);

/// A raster's heights between its points, bilinear; nothing outside it and where it has none.
/// The point (0, 0) of the raster lies at x, y; `unit` is its length in m, `cell` as well.
void addRaster(HeightField& field, const Raster& raster, double x, double y, double cell,
               double base, double unit);

/// Makes the right half (y < 0) the mirror image of the left one.
void mirrorLeftHalf(HeightField& field);

}  // namespace simcore::terrain
