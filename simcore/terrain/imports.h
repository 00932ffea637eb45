#pragma once

#include <map>
#include <string>
#include <vector>

#include "simcore/terrain/terrain.h"

/// What terrain files hold, as read; makeTerrain() places it in the world.
namespace simcore::terrain {

/// Larger files are refused: a million points take about 150 MB once they are a ground.
inline constexpr std::size_t kMostRasterPoints = 4'000'000;
inline constexpr std::size_t kMostMeshTriangles = 2'000'000;
/// Ground from a file lies within this [m], so that places are exact to 1 um.
inline constexpr double kFarthestGround = 10'000.0;

/// Heights on a regular grid.
struct Raster {
    int columns = 0;             ///< along x
    int rows = 0;                ///< along y
    std::vector<double> values;  ///< row by row, that of the largest y first; NaN = no ground.
                                 ///< Image: 0 (black) to 1 (white); ASCII grid: in file units
    double x0 = 0.0, y0 = 0.0;   ///< of the lower left point, file units; image: 0
    double cell = 0.0;           ///< between points, file units; image: 0, not known

    double at(int column, int row) const {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
};

/// The files of a terrain, by the text of its `file`.
struct Imports {
    std::map<std::string, Raster> rasters;
    std::map<std::string, TriangleMesh> meshes;  ///< file coordinates
};

}  // namespace simcore::terrain
