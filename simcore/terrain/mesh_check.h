#pragma once

#include "simcore/terrain/terrain.h"

namespace simcore::terrain {

/// A mesh from a file made fit for wheels. Vertices at the same place (1 um) become one, triangles
/// without area are dropped, a mesh that is upside down is turned over. Critical: nothing left,
/// numbers that are not finite or beyond 10 km. Warnings: dropped triangles, turned over, holes,
/// edges of more than two triangles, neighbours that face opposite sides, sheets that overlap.
///
/// @param mesh     in the world [m]
/// @param element  what problems call it
Result<TriangleMesh> cleanMesh(const TriangleMesh& mesh, const std::string& element);

}  // namespace simcore::terrain
