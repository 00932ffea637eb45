#pragma once

#include <cmath>
#include <string>

#include "simcore/terrain/make_terrain.h"
#include "tests/fuzz/fuzz.h"

namespace fuzz {

/// What readers of heights promise, and the ground that is made of them.
inline void checkRaster(const simcore::Result<simcore::terrain::Raster>& read,
                        simcore::project::TerrainKind kind) {
    using namespace simcore;
    require(read || hasCritical(read.problems()), "no refusal without a reason");
    if (!read) {
        return;
    }
    const terrain::Raster& raster = *read;
    require(raster.columns >= 2 && raster.rows >= 2, "a raster is at least 2 x 2");
    require(raster.values.size() ==
                static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows),
            "a value a point");
    for (const double value : raster.values) {
        require(std::isnan(value) || std::isfinite(value), "a height is finite or missing");
    }
    constexpr std::size_t kMostPoints = 2500;  // larger grounds are only slower
    if (raster.values.size() > kMostPoints) {
        return;
    }
    project::Terrain spec;
    spec.kind = kind;
    spec.file = "input";
    spec.height = 0.5;
    spec.cell = 0.05;
    terrain::Imports imports;
    imports.rasters["input"] = raster;
    const auto ground = terrain::makeTerrain(spec, {}, 1.0, imports);
    require(ground || hasCritical(ground.problems()), "no missing ground without a reason");
    if (ground) {
        require(!ground->mesh().triangles.empty(), "a ground has triangles");
        (void)ground->heightAt(0.1, 0.1);
    }
}

}  // namespace fuzz
