#pragma once

#include "simcore/terrain/fields.h"

namespace simcore::terrain {

/// Adds particle deposition (the paper's type-2 ground): `count` grains of `radius` fall at random
/// places with x in [start, start + length] and roll downhill over the ground and the grains below
/// until they rest. Not the same left and right. Equal seeds give equal ground on any machine.
void depositParticles(HeightField& field, double start, double length, double radius, int count,
                      int seed);

}  // namespace simcore::terrain
