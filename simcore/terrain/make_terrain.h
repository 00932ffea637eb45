#pragma once

#include "simcore/project/resolve.h"
#include "simcore/terrain/imports.h"

/// From a scenario's description to the ground.
namespace simcore::terrain {

/// Makes the terrain a scenario describes. `travel` [m] is how far the rover is to drive, negative
/// when backwards; generated ground reaches 2.5 m behind the start and 3 m beyond the way at least.
/// `imports` holds every file the terrain names (io::readTerrainFiles(); std::out_of_range when one
/// is missing).
Result<Terrain> makeTerrain(const project::Terrain& spec,
                            const project::ParameterValues& parameters, double travel,
                            const Imports& imports = {});

/// What is wrong with the numbers of a terrain: makeTerrain()'s problems, without making it.
Problems whyNoTerrain(const project::Terrain& spec, const project::ParameterValues& parameters);

}  // namespace simcore::terrain
