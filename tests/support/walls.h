#pragma once

#include <algorithm>
#include <cmath>

#include "simcore/terrain/terrain.h"

/// Ground with a wall along x.
namespace testsupport {

/// Level ground, from y = `wall` on higher by `height`, with a vertical face between that looks to
/// -y. Triangles about as large as `cell`.
inline simcore::terrain::Terrain floorAndWall(double wall, double height, double cell) {
    simcore::terrain::TriangleMesh mesh;
    // A sheet from `corner` along two edges, its free side to the left of them.
    const auto sheet = [&](const simcore::Vec3& corner, const simcore::Vec3& first,
                           const simcore::Vec3& second) {
        const int n1 = std::max(1, static_cast<int>(std::lround(first.norm() / cell)));
        const int n2 = std::max(1, static_cast<int>(std::lround(second.norm() / cell)));
        const int start = static_cast<int>(mesh.vertices.size());
        for (int i = 0; i <= n1; ++i) {
            for (int k = 0; k <= n2; ++k) {
                mesh.vertices.push_back(corner + first * i / n1 + second * k / n2);
            }
        }
        for (int i = 0; i < n1; ++i) {
            for (int k = 0; k < n2; ++k) {
                const int a = start + i * (n2 + 1) + k;
                const int b = a + n2 + 1;
                mesh.triangles.push_back({a, b, b + 1});
                mesh.triangles.push_back({a, b + 1, a + 1});
            }
        }
    };
    constexpr double kHalfLength = 0.6;
    const double length = 2.0 * kHalfLength;
    sheet({-kHalfLength, wall - 0.6, 0.0}, {length, 0.0, 0.0}, {0.0, 0.6, 0.0});
    sheet({-kHalfLength, wall, 0.0}, {length, 0.0, 0.0}, {0.0, 0.0, height});
    sheet({-kHalfLength, wall, height}, {length, 0.0, 0.0}, {0.0, 0.3, 0.0});
    return simcore::terrain::Terrain::fromMesh(std::move(mesh));
}

}  // namespace testsupport
