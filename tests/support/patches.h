#pragma once

#include <cmath>
#include <functional>

#include "simcore/base/random.h"
#include "simcore/terrain/terrain.h"

/// Ground of small triangles.
namespace testsupport {

using Height = std::function<double(double x, double y)>;

/// A patch of ground on a grid whose inner points are moved by up to `jitter` cells, each cell cut
/// along a diagonal drawn by lot. Up to 0.2 cells no triangle turns over.
inline simcore::terrain::Terrain patch(double cell, double halfX, double halfY,
                                       const Height& height, double jitter = 0.0) {
    const int nx = static_cast<int>(std::lround(2.0 * halfX / cell)) + 1;
    const int ny = static_cast<int>(std::lround(2.0 * halfY / cell)) + 1;
    simcore::Random random(17);
    simcore::terrain::TriangleMesh mesh;
    for (int ix = 0; ix < nx; ++ix) {
        for (int iy = 0; iy < ny; ++iy) {
            const double dx = jitter > 0.0 ? random.uniform(-jitter, jitter) * cell : 0.0;
            const double dy = jitter > 0.0 ? random.uniform(-jitter, jitter) * cell : 0.0;
            const double x = -halfX + ix * cell + dx;
            const double y = -halfY + iy * cell + dy;
            mesh.vertices.emplace_back(x, y, height(x, y));
        }
    }
    for (int ix = 0; ix + 1 < nx; ++ix) {
        for (int iy = 0; iy + 1 < ny; ++iy) {
            const int a = ix * ny + iy;
            const int b = a + ny;
            if (random.next() % 2 == 0) {
                mesh.triangles.push_back({a, b, b + 1});
                mesh.triangles.push_back({a, b + 1, a + 1});
            } else {
                mesh.triangles.push_back({a, b, a + 1});
                mesh.triangles.push_back({b, b + 1, a + 1});
            }
        }
    }
    return simcore::terrain::Terrain::fromMesh(std::move(mesh));
}

}  // namespace testsupport
