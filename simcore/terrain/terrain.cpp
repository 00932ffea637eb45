#include "simcore/terrain/terrain.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace simcore::terrain {
namespace {

/// Ground within this height of z = 0 counts as flat [m].
constexpr double kFlat = 1e-9;
/// Cells of the look-up grid are about this large [m]; long strips get larger ones.
constexpr double kCell = 0.05;
constexpr int kMostCells = 4'000'000;

Vec3 normalOf(const TriangleMesh& mesh, const std::array<int, 3>& t) {
    const Vec3& a = mesh.vertices[static_cast<std::size_t>(t[0])];
    const Vec3& b = mesh.vertices[static_cast<std::size_t>(t[1])];
    const Vec3& c = mesh.vertices[static_cast<std::size_t>(t[2])];
    return (b - a).cross(c - a).normalized();
}

}  // namespace

Terrain Terrain::extruded(const std::vector<Eigen::Vector2d>& profile, double yMin, double yMax) {
    if (profile.size() < 2 || !(yMin < yMax)) {
        throw std::invalid_argument("a profile needs two points and a width");
    }
    Terrain terrain;
    terrain.profile_ = profile;
    TriangleMesh& mesh = terrain.mesh_;
    for (const Eigen::Vector2d& p : profile) {
        mesh.vertices.emplace_back(p.x(), yMin, p.y());
        mesh.vertices.emplace_back(p.x(), yMax, p.y());
    }
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        if (profile[i + 1].x() < profile[i].x() || profile[i + 1] == profile[i]) {
            throw std::invalid_argument("a profile must not turn back or repeat a point");
        }
        const int k = static_cast<int>(2 * i);
        mesh.triangles.push_back({k, k + 2, k + 1});
        mesh.triangles.push_back({k + 1, k + 2, k + 3});
    }
    terrain.index();
    return terrain;
}

Terrain Terrain::grid(double x0, double y0, double cell, int nx, int ny,
                      const std::vector<double>& heights) {
    if (nx < 2 || ny < 2 || !(cell > 0.0) ||
        heights.size() != static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny)) {
        throw std::invalid_argument("a height field needs two points each way");
    }
    Terrain terrain;
    TriangleMesh& mesh = terrain.mesh_;
    for (int ix = 0; ix < nx; ++ix) {
        for (int iy = 0; iy < ny; ++iy) {
            mesh.vertices.emplace_back(x0 + ix * cell, y0 + iy * cell,
                                       heights[static_cast<std::size_t>(ix * ny + iy)]);
        }
    }
    for (int ix = 0; ix + 1 < nx; ++ix) {
        for (int iy = 0; iy + 1 < ny; ++iy) {
            const int a = ix * ny + iy;  // near, right
            const int b = a + ny;        // far, right
            const int c = b + 1;         // far, left
            const int d = a + 1;         // near, left
            // Diagonals lean the other way on the other side, so that mirrored ground is drawn by
            // mirrored triangles.
            if (y0 + (iy + 0.5) * cell < 0.0) {
                mesh.triangles.push_back({a, b, c});
                mesh.triangles.push_back({a, c, d});
            } else {
                mesh.triangles.push_back({a, b, d});
                mesh.triangles.push_back({b, c, d});
            }
        }
    }
    terrain.index();
    return terrain;
}

void Terrain::index() {
    const std::size_t count = mesh_.triangles.size();
    normals_.reserve(count);
    Vec3 low = mesh_.vertices.front();
    Vec3 high = low;
    for (const Vec3& v : mesh_.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    const double area = (high.x() - low.x()) * (high.y() - low.y());
    cellSize_ = std::max(kCell, std::sqrt(area / kMostCells));
    gridX0_ = low.x();
    gridY0_ = low.y();
    gridNx_ = static_cast<int>((high.x() - low.x()) / cellSize_) + 1;
    gridNy_ = static_cast<int>((high.y() - low.y()) / cellSize_) + 1;

    obstacleRange_ = {std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()};
    const auto cellsOf = [&](const std::array<int, 3>& t, auto&& visit) {
        Vec3 a = mesh_.vertices[static_cast<std::size_t>(t[0])];
        Vec3 b = a;
        for (const int k : t) {
            a = a.cwiseMin(mesh_.vertices[static_cast<std::size_t>(k)]);
            b = b.cwiseMax(mesh_.vertices[static_cast<std::size_t>(k)]);
        }
        const auto clampCell = [&](double value, double origin, int n) {
            return std::clamp(static_cast<int>((value - origin) / cellSize_), 0, n - 1);
        };
        for (int ix = clampCell(a.x(), gridX0_, gridNx_); ix <= clampCell(b.x(), gridX0_, gridNx_);
             ++ix) {
            for (int iy = clampCell(a.y(), gridY0_, gridNy_);
                 iy <= clampCell(b.y(), gridY0_, gridNy_); ++iy) {
                visit(static_cast<std::size_t>(ix) * static_cast<std::size_t>(gridNy_) +
                      static_cast<std::size_t>(iy));
            }
        }
    };
    cellStart_.assign(static_cast<std::size_t>(gridNx_) * static_cast<std::size_t>(gridNy_) + 1, 0);
    for (const auto& t : mesh_.triangles) {
        normals_.push_back(normalOf(mesh_, t));
        cellsOf(t, [&](std::size_t cell) { ++cellStart_[cell + 1]; });
        for (const int k : t) {
            const auto& others = mesh_.vertices;
            if (std::abs(others[static_cast<std::size_t>(k)].z()) > kFlat) {
                for (const int m : t) {
                    const double x = others[static_cast<std::size_t>(m)].x();
                    obstacleRange_.first = std::min(obstacleRange_.first, x);
                    obstacleRange_.second = std::max(obstacleRange_.second, x);
                }
                break;
            }
        }
    }
    for (std::size_t i = 1; i < cellStart_.size(); ++i) {
        cellStart_[i] += cellStart_[i - 1];
    }
    cellTriangles_.resize(static_cast<std::size_t>(cellStart_.back()));
    std::vector<int> next(cellStart_.begin(), cellStart_.end() - 1);
    for (std::size_t i = 0; i < count; ++i) {
        cellsOf(mesh_.triangles[i], [&](std::size_t cell) {
            cellTriangles_[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(i);
        });
    }
}

double Terrain::heightAt(double x, double y) const {
    const int ix = static_cast<int>(std::floor((x - gridX0_) / cellSize_));
    const int iy = static_cast<int>(std::floor((y - gridY0_) / cellSize_));
    double height = std::numeric_limits<double>::quiet_NaN();
    if (ix < 0 || iy < 0 || ix >= gridNx_ || iy >= gridNy_) {
        return height;
    }
    const auto cell = static_cast<std::size_t>(ix) * static_cast<std::size_t>(gridNy_) +
                      static_cast<std::size_t>(iy);
    for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
        const auto& t =
            mesh_.triangles[static_cast<std::size_t>(cellTriangles_[static_cast<std::size_t>(i)])];
        const Vec3& a = mesh_.vertices[static_cast<std::size_t>(t[0])];
        const Vec3& b = mesh_.vertices[static_cast<std::size_t>(t[1])];
        const Vec3& c = mesh_.vertices[static_cast<std::size_t>(t[2])];
        const double det = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
        if (std::abs(det) < 1e-14) {
            continue;  // vertical face
        }
        const double u = ((x - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (y - a.y())) / det;
        const double v = ((b.x() - a.x()) * (y - a.y()) - (x - a.x()) * (b.y() - a.y())) / det;
        constexpr double kEdge = 1e-9;
        if (u < -kEdge || v < -kEdge || u + v > 1.0 + kEdge) {
            continue;
        }
        const double z = a.z() + u * (b.z() - a.z()) + v * (c.z() - a.z());
        height = std::isnan(height) ? z : std::max(height, z);
    }
    return height;
}

void Terrain::slice(const SlicePlane& plane, double radius, std::vector<SliceSegment>& out) const {
    out.clear();
    const Vec3 w = plane.u.cross(plane.v);  // plane normal
    // Extent of the disc in x and y.
    const double reachX = radius * std::sqrt(std::max(0.0, 1.0 - w.x() * w.x()));
    const double reachY = radius * std::sqrt(std::max(0.0, 1.0 - w.y() * w.y())) + 1e-9;
    const auto cellOf = [&](double value, double origin, int n) {
        return std::clamp(static_cast<int>(std::floor((value - origin) / cellSize_)), 0, n - 1);
    };
    const int x0 = cellOf(plane.origin.x() - reachX, gridX0_, gridNx_);
    const int x1 = cellOf(plane.origin.x() + reachX, gridX0_, gridNx_);
    const int y0 = cellOf(plane.origin.y() - reachY, gridY0_, gridNy_);
    const int y1 = cellOf(plane.origin.y() + reachY, gridY0_, gridNy_);
    const double lowest = plane.origin.z() - radius;
    const double highest = plane.origin.z() + radius;
    for (int ix = x0; ix <= x1; ++ix) {
        for (int iy = y0; iy <= y1; ++iy) {
            const auto cell = static_cast<std::size_t>(ix) * static_cast<std::size_t>(gridNy_) +
                              static_cast<std::size_t>(iy);
            for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
                const auto index =
                    static_cast<std::size_t>(cellTriangles_[static_cast<std::size_t>(i)]);
                const auto& t = mesh_.triangles[index];
                const Vec3& a = mesh_.vertices[static_cast<std::size_t>(t[0])];
                const Vec3& b = mesh_.vertices[static_cast<std::size_t>(t[1])];
                const Vec3& c = mesh_.vertices[static_cast<std::size_t>(t[2])];
                const double da = w.dot(a - plane.origin);
                const double db = w.dot(b - plane.origin);
                const double dc = w.dot(c - plane.origin);
                // On the plane counts as above it: a triangle is cut or not, never twice on an
                // edge.
                const bool above[3] = {da >= 0.0, db >= 0.0, dc >= 0.0};
                if (above[0] == above[1] && above[1] == above[2]) {
                    continue;
                }
                if (std::max({a.z(), b.z(), c.z()}) < lowest ||
                    std::min({a.z(), b.z(), c.z()}) > highest) {
                    continue;
                }
                // A triangle that lies in several cells is taken in the first of the searched ones.
                const double tx = std::min({a.x(), b.x(), c.x()});
                const double ty = std::min({a.y(), b.y(), c.y()});
                if (ix != std::max(x0, cellOf(tx, gridX0_, gridNx_)) ||
                    iy != std::max(y0, cellOf(ty, gridY0_, gridNy_))) {
                    continue;
                }
                const Vec3* corner[3] = {&a, &b, &c};
                const double distance[3] = {da, db, dc};
                Vec3 ends[2];
                int found = 0;
                for (int k = 0; k < 3 && found < 2; ++k) {
                    const int m = (k + 1) % 3;
                    if (above[k] != above[m]) {
                        // From the lower index's side always, so that neighbours cut their common
                        // edge in the very same point.
                        const bool forward =
                            t[static_cast<std::size_t>(k)] < t[static_cast<std::size_t>(m)];
                        const int p = forward ? k : m;
                        const int q = forward ? m : k;
                        const double s = distance[p] / (distance[p] - distance[q]);
                        ends[found++] = *corner[p] + s * (*corner[q] - *corner[p]);
                    }
                }
                SliceSegment segment;
                segment.normal = normals_[index];
                const auto inPlane = [&](const Vec3& p) {
                    return Eigen::Vector2d(plane.u.dot(p - plane.origin),
                                           plane.v.dot(p - plane.origin));
                };
                segment.a = inPlane(ends[0]);
                segment.b = inPlane(ends[1]);
                // The free side is to the left.
                const Eigen::Vector2d along = segment.b - segment.a;
                const double left = -along.y() * segment.normal.dot(plane.u) +
                                    along.x() * segment.normal.dot(plane.v);
                if (left < 0.0) {
                    std::swap(segment.a, segment.b);
                }
                out.push_back(segment);
            }
        }
    }
}

}  // namespace simcore::terrain
