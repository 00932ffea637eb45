#pragma once

#include "simcore/project/project.h"

/// The paper's two sets of experiments: controllers compared on many grounds (Lamon et al. 2004,
/// section 5).
namespace simcore::experiment {

enum class TerrainSet {
    Profiles,  ///< the same under left and right wheels: steps, waves and caps (paper, type 1)
    Terrains,  ///< full 3-D: blocks, waves, caps and deposited grains (paper, type 2)
};

/// "profiles" | "terrains".
std::string toString(TerrainSet set);

/// The ground of a seed, for wheels of a radius [m]. Features of profiles are up to R/2 high for
/// odd seeds and up to R for even ones, so that half of the set is mild; those of full terrains up
/// to 0.6 R, with grains of 1.2 R (assumed: steeper ones stop every controller). Equal seeds make
/// equal grounds on any machine.
project::Terrain terrainOf(TerrainSet set, int seed, double wheelRadius);

}  // namespace simcore::experiment
