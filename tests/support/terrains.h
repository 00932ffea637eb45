#pragma once

#include <ostream>
#include <stdexcept>

#include "simcore/project/names.h"
#include "simcore/terrain/make_terrain.h"

namespace simcore::project {

/// GoogleTest's name of a terrain.
inline void PrintTo(const Terrain& terrain, std::ostream* out) {  // NOLINT: name given by gtest
    *out << nameOf(terrain.kind);
}

}  // namespace simcore::project

/// Terrains as a scenario describes them.
namespace testsupport {

inline simcore::terrain::Terrain made(const simcore::project::Terrain& spec, double travel = 3.5) {
    auto terrain = simcore::terrain::makeTerrain(spec, {}, travel);
    if (!terrain) {
        throw std::runtime_error(toString(terrain.problems()));
    }
    return std::move(terrain).value();
}

inline simcore::project::Terrain spec(simcore::project::TerrainKind kind, double height = 0.0,
                                      double length = 0.0, double radius = 0.0, int count = 1,
                                      int seed = 1) {
    simcore::project::Terrain terrain;
    terrain.kind = kind;
    terrain.height = height;
    terrain.length = length;
    terrain.radius = radius;
    terrain.count = count;
    terrain.seed = seed;
    return terrain;
}

}  // namespace testsupport
