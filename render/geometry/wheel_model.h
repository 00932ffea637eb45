#pragma once

#include "render/geometry/mesh_builder.h"
#include "simcore/mechanism/mechanism.h"

namespace render {

/// Adds a wheel, rover frame at the drawn pose: tyre with grousers out to the wheel's radius, rim,
/// spokes and hub, a ring in `ring` on both sides, and a painted spoke so that turning shows.
void addWheel(MeshBuilder& mesh, const simcore::mechanism::Wheel& wheel, const Rgb& ring);

}  // namespace render
