#pragma once

#include <vector>

namespace simcore::terrain {

/// A height field on a regular grid: heights[ix * ny + iy] [m].
struct HeightField {
    double x0 = 0.0, y0 = 0.0, cell = 0.02;
    int nx = 0, ny = 0;
    std::vector<double> heights;
};

/// Adds particle deposition (the paper's type-2 ground): `count` grains of `radius` fall at random
/// places with x in [start, start + length] and roll downhill over the ground and the grains below
/// until they rest. Not the same left and right. Equal seeds give equal ground on any machine.
void depositParticles(HeightField& field, double start, double length, double radius, int count,
                      int seed);

}  // namespace simcore::terrain
