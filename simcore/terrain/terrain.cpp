#include "simcore/terrain/terrain.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "simcore/base/planar.h"

namespace simcore::terrain {
namespace {

/// Ground within this height of z = 0 counts as flat [m].
constexpr double kFlat = 1e-9;
/// Cells of the look-up grid are two triangles large, within these bounds [m], so that a slice
/// tests few triangles whether they measure a millimetre or a metre.
constexpr double kSmallestCell = 0.002;
constexpr double kLargestCell = 0.05;
/// Larger cells are taken rather than more cells, or more entries for each triangle, than these.
constexpr double kMostCells = 4e6;
constexpr double kMostEntries = 16e6;
constexpr double kMostEntriesPerTriangle = 4.0;
/// Cells this near to a disc are searched, so that rounding loses none [m].
constexpr double kSlack = 1e-6;

const Vec3& corner(const TriangleMesh& mesh, const std::array<int, 3>& triangle, std::size_t k) {
    return mesh.vertices[static_cast<std::size_t>(triangle[k])];
}

Vec3 lowCorner(const TriangleMesh& mesh, const std::array<int, 3>& t) {
    return corner(mesh, t, 0).cwiseMin(corner(mesh, t, 1)).cwiseMin(corner(mesh, t, 2));
}

Vec3 highCorner(const TriangleMesh& mesh, const std::array<int, 3>& t) {
    return corner(mesh, t, 0).cwiseMax(corner(mesh, t, 1)).cwiseMax(corner(mesh, t, 2));
}

Vec3 normalOf(const TriangleMesh& mesh, const std::array<int, 3>& t) {
    return (corner(mesh, t, 1) - corner(mesh, t, 0))
        .cross(corner(mesh, t, 2) - corner(mesh, t, 0))
        .normalized();
}

/// Angle between a line and the vertical, 0 to pi/2 [rad].
double leanOf(const Vec3& direction) {
    return std::acos(std::min(1.0, std::abs(direction.z())));
}

/// Bound of a triangle's height over a square of half side `reach` [m]: that of its plane there or
/// that of its corners, whichever is less.
double highestOver(const TriangleMesh& mesh, const std::array<int, 3>& t,
                   const Eigen::Vector2d& middle, double reach) {
    const double top = highCorner(mesh, t).z();
    const Vec3 normal = normalOf(mesh, t);
    if (std::abs(normal.z()) < 1e-6) {
        return top;  // steeper than any height field
    }
    const Eigen::Vector2d slope = -normal.head<2>() / normal.z();
    const Vec3& a = corner(mesh, t, 0);
    return std::min(top,
                    a.z() + slope.dot(middle - a.head<2>()) + reach * slope.lpNorm<1>() + kSlack);
}

/// In single precision, but not below `value`.
float roundedUp(double value) {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) < value
               ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
               : nearest;
}

/// Cells that suit a mesh within the box [m].
double cellSizeFor(const TriangleMesh& mesh, const Vec3& low, const Vec3& high) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        sum += (highCorner(mesh, t) - lowCorner(mesh, t)).head<2>().maxCoeff();
    }
    const auto count = static_cast<double>(mesh.triangles.size());
    double size = std::clamp(2.0 * sum / count, kSmallestCell, kLargestCell);
    const Vec3 extent = high - low;
    size = std::max(size, std::sqrt(extent.x() * extent.y() / kMostCells));
    // A mesh as thin as a line still has a row of cells.
    size = std::max(size, std::max(extent.x(), extent.y()) / kMostCells);
    const auto entries = [&] {
        double total = 0.0;
        for (const auto& t : mesh.triangles) {
            const Vec3 reach = (highCorner(mesh, t) - lowCorner(mesh, t)) / size;
            total += (reach.x() + 1.0) * (reach.y() + 1.0);
        }
        return total;
    };
    while (entries() > kMostEntries + kMostEntriesPerTriangle * count) {
        size *= 1.5;
    }
    return size;
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
    mesh.vertices.reserve(heights.size());
    mesh.triangles.reserve(2 * heights.size());
    std::vector<int> vertexOf(heights.size(), -1);  // those without ground have none
    const auto indexOf = [ny](int ix, int iy) {
        return static_cast<std::size_t>(ix) * static_cast<std::size_t>(ny) +
               static_cast<std::size_t>(iy);
    };
    for (int ix = 0; ix < nx; ++ix) {
        for (int iy = 0; iy < ny; ++iy) {
            const double height = heights[indexOf(ix, iy)];
            if (!std::isnan(height)) {
                vertexOf[indexOf(ix, iy)] = static_cast<int>(mesh.vertices.size());
                mesh.vertices.emplace_back(x0 + ix * cell, y0 + iy * cell, height);
            }
        }
    }
    const auto add = [&mesh](int a, int b, int c) {
        if (std::min({a, b, c}) >= 0) {
            mesh.triangles.push_back({a, b, c});
        }
    };
    for (int ix = 0; ix + 1 < nx; ++ix) {
        for (int iy = 0; iy + 1 < ny; ++iy) {
            const int a = vertexOf[indexOf(ix, iy)];          // near, right
            const int b = vertexOf[indexOf(ix + 1, iy)];      // far, right
            const int c = vertexOf[indexOf(ix + 1, iy + 1)];  // far, left
            const int d = vertexOf[indexOf(ix, iy + 1)];      // near, left
            // Diagonals lean the other way on the other side, so that mirrored ground is drawn by
            // mirrored triangles.
            if (y0 + (iy + 0.5) * cell < 0.0) {
                add(a, b, c);
                add(a, c, d);
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    }
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("a height field needs a triangle with three heights");
    }
    terrain.index();
    return terrain;
}

Terrain Terrain::fromMesh(TriangleMesh mesh) {
    if (mesh.triangles.empty()) {
        throw std::invalid_argument("a ground needs triangles");
    }
    for (const Vec3& v : mesh.vertices) {
        if (!v.allFinite()) {
            throw std::invalid_argument("a vertex of the ground is not finite");
        }
    }
    for (const auto& t : mesh.triangles) {
        for (const int k : t) {
            if (k < 0 || k >= static_cast<int>(mesh.vertices.size())) {
                throw std::invalid_argument("a triangle has a corner that is no vertex");
            }
        }
        const Vec3 a = corner(mesh, t, 1) - corner(mesh, t, 0);
        if (!(a.cross(corner(mesh, t, 2) - corner(mesh, t, 0)).norm() > 0.0)) {
            throw std::invalid_argument("a triangle has no area");
        }
    }
    Terrain terrain;
    terrain.mesh_ = std::move(mesh);
    terrain.index();
    return terrain;
}

int Terrain::column(double x) const {
    return static_cast<int>(std::clamp((x - gridX0_) / cellSize_, 0.0, gridNx_ - 1.0));
}

int Terrain::row(double y) const {
    return static_cast<int>(std::clamp((y - gridY0_) / cellSize_, 0.0, gridNy_ - 1.0));
}

std::size_t Terrain::cellAt(int ix, int iy) const {
    return static_cast<std::size_t>(ix) * static_cast<std::size_t>(gridNy_) +
           static_cast<std::size_t>(iy);
}

void Terrain::index() {
    Vec3 low = mesh_.vertices.front();
    Vec3 high = low;
    for (const Vec3& v : mesh_.vertices) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    cellSize_ = cellSizeFor(mesh_, low, high);
    gridX0_ = low.x();
    gridY0_ = low.y();
    gridNx_ = static_cast<int>((high.x() - low.x()) / cellSize_) + 1;
    gridNy_ = static_cast<int>((high.y() - low.y()) / cellSize_) + 1;

    const auto cellsOf = [&](const std::array<int, 3>& t, auto&& visit) {
        const Vec3 a = lowCorner(mesh_, t);
        const Vec3 b = highCorner(mesh_, t);
        for (int ix = column(a.x()); ix <= column(b.x()); ++ix) {
            for (int iy = row(a.y()); iy <= row(b.y()); ++iy) {
                visit(cellAt(ix, iy));
            }
        }
    };
    obstacleRange_ = {std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()};
    cellStart_.assign(static_cast<std::size_t>(gridNx_) * static_cast<std::size_t>(gridNy_) + 1, 0);
    for (const auto& t : mesh_.triangles) {
        cellsOf(t, [&](std::size_t cell) { ++cellStart_[cell + 1]; });
        const Vec3 a = lowCorner(mesh_, t);
        const Vec3 b = highCorner(mesh_, t);
        if (std::max(-a.z(), b.z()) > kFlat) {
            obstacleRange_.first = std::min(obstacleRange_.first, a.x());
            obstacleRange_.second = std::max(obstacleRange_.second, b.x());
        }
    }
    for (std::size_t i = 1; i < cellStart_.size(); ++i) {
        cellStart_[i] += cellStart_[i - 1];
    }
    cellTriangles_.resize(static_cast<std::size_t>(cellStart_.back()));
    std::vector<int> next(cellStart_.begin(), cellStart_.end() - 1);
    cellSteepest_.assign(cellStart_.size() - 1, 0.0F);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
        const auto slope = static_cast<float>(leanOf(normalOf(mesh_, mesh_.triangles[i])));
        steepest_ = std::max(steepest_, slope);
        cellsOf(mesh_.triangles[i], [&](std::size_t cell) {
            cellTriangles_[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(i);
            cellSteepest_[cell] = std::max(cellSteepest_[cell], slope);
        });
    }
    indexHeights();
}

void Terrain::indexHeights() {
    constexpr float kNone = -std::numeric_limits<float>::infinity();
    cellHighest_.assign(cellStart_.size() - 1, kNone);
    for (int ix = 0; ix < gridNx_; ++ix) {
        for (int iy = 0; iy < gridNy_; ++iy) {
            const std::size_t cell = cellAt(ix, iy);
            const Eigen::Vector2d middle(gridX0_ + (ix + 0.5) * cellSize_,
                                         gridY0_ + (iy + 0.5) * cellSize_);
            for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
                const auto& t = mesh_.triangles[static_cast<std::size_t>(
                    cellTriangles_[static_cast<std::size_t>(i)])];
                const double top = highestOver(mesh_, t, middle, 0.5 * cellSize_ + kSlack);
                cellHighest_[cell] = std::max(cellHighest_[cell], roundedUp(top));
            }
        }
    }
    coarse_.clear();
    int nx = gridNx_;
    int ny = gridNy_;
    while (nx > 1 || ny > 1) {
        const int finerNx = std::exchange(nx, (nx + 1) / 2);
        const int finerNy = std::exchange(ny, (ny + 1) / 2);
        Coarse level{ny, std::vector<float>(
                             static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), kNone)};
        for (int ix = 0; ix < finerNx; ++ix) {
            for (int iy = 0; iy < finerNy; ++iy) {
                float& most =
                    level.highest[static_cast<std::size_t>(ix / 2) * static_cast<std::size_t>(ny) +
                                  static_cast<std::size_t>(iy / 2)];
                most = std::max(most, highestIn(coarse_.size(), ix, iy));
            }
        }
        coarse_.push_back(std::move(level));
    }
}

float Terrain::highestIn(std::size_t level, int ix, int iy) const {
    if (level == 0) {
        return cellHighest_[cellAt(ix, iy)];
    }
    const Coarse& coarse = coarse_[level - 1];
    return coarse.highest[static_cast<std::size_t>(ix) * static_cast<std::size_t>(coarse.ny) +
                          static_cast<std::size_t>(iy)];
}

double Terrain::highest(const Vec3& low, const Vec3& high) const {
    const int firstX = column(low.x() - kSlack);
    const int firstY = row(low.y() - kSlack);
    const int lastX = column(high.x() + kSlack);
    const int lastY = row(high.y() + kSlack);
    float best = -std::numeric_limits<float>::infinity();
    // Coarse cells that are no higher than what was found are not looked into.
    const auto visit = [&](const auto& self, int level, int ix, int iy) -> void {
        const int left = ix << level;
        const int right = ((ix + 1) << level) - 1;
        const int near = iy << level;
        const int far = ((iy + 1) << level) - 1;
        if (left > lastX || right < firstX || near > lastY || far < firstY || left >= gridNx_ ||
            near >= gridNy_) {
            return;
        }
        const float value = highestIn(static_cast<std::size_t>(level), ix, iy);
        if (value <= best) {
            return;
        }
        if (level == 0 || (left >= firstX && right <= lastX && near >= firstY && far <= lastY)) {
            best = value;
            return;
        }
        for (const int dx : {0, 1}) {
            for (const int dy : {0, 1}) {
                self(self, level - 1, 2 * ix + dx, 2 * iy + dy);
            }
        }
    };
    const auto span = static_cast<unsigned>(std::max(lastX - firstX, lastY - firstY));
    const int level =
        std::min(static_cast<int>(std::bit_width(span)), static_cast<int>(coarse_.size()));
    for (int ix = firstX >> level; ix <= lastX >> level; ++ix) {
        for (int iy = firstY >> level; iy <= lastY >> level; ++iy) {
            visit(visit, level, ix, iy);
        }
    }
    return static_cast<double>(best);
}

double Terrain::heightAt(double x, double y) const {
    const double cellX = std::floor((x - gridX0_) / cellSize_);
    const double cellY = std::floor((y - gridY0_) / cellSize_);
    double height = std::numeric_limits<double>::quiet_NaN();
    if (!(cellX >= 0.0 && cellY >= 0.0 && cellX < gridNx_ && cellY < gridNy_)) {
        return height;  // a place too far away for an int among them
    }
    const std::size_t cell = cellAt(static_cast<int>(cellX), static_cast<int>(cellY));
    for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
        const auto& t =
            mesh_.triangles[static_cast<std::size_t>(cellTriangles_[static_cast<std::size_t>(i)])];
        const Vec3& a = corner(mesh_, t, 0);
        const Vec3& b = corner(mesh_, t, 1);
        const Vec3& c = corner(mesh_, t, 2);
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

template <class Visit>
void Terrain::visitCells(const SlicePlane& plane, const Vec3& w, double radius,
                         Visit&& visit) const {
    const Vec3 reach = radius * (Vec3::Ones() - w.cwiseProduct(w)).cwiseMax(0.0).cwiseSqrt() +
                       Vec3::Constant(kSlack);
    const Vec3& o = plane.origin;
    // Strips of cells across the plane's larger horizontal part; in each only those cells that the
    // disc passes over.
    const bool strips = std::max(std::abs(w.x()), std::abs(w.y())) > 0.1;
    const bool alongX = std::abs(w.y()) >= std::abs(w.x());
    const int main = alongX ? 0 : 1;
    const int other = 1 - main;
    const double mainOrigin = alongX ? gridX0_ : gridY0_;
    const auto mainCell = [&](double value) { return alongX ? column(value) : row(value); };
    const auto otherCell = [&](double value) { return alongX ? row(value) : column(value); };
    const int last = mainCell(o[main] + reach[main]);
    for (int i = mainCell(o[main] - reach[main]); i <= last; ++i) {
        double low = -reach[other];
        double high = reach[other];
        if (strips) {
            const double a = std::max(mainOrigin + i * cellSize_ - kSlack - o[main], -reach[main]);
            const double b =
                std::min(mainOrigin + (i + 1) * cellSize_ + kSlack - o[main], reach[main]);
            if (a > b) {
                continue;
            }
            const double slope = -w[main] / w[other];
            const double lean = std::abs(w.z() / w[other]) * reach.z() + kSlack;
            low = std::max(low, std::min(slope * a, slope * b) - lean);
            high = std::min(high, std::max(slope * a, slope * b) + lean);
        }
        const int end = otherCell(o[other] + high);
        for (int k = otherCell(o[other] + low); k <= end; ++k) {
            alongX ? visit(i, k) : visit(k, i);
        }
    }
}

bool Terrain::cut(const std::array<int, 3>& t, const SlicePlane& plane, const Vec3& w,
                  std::array<Vec3, 2>& ends) const {
    std::array<double, 3> distance{};
    std::array<bool, 3> above{};
    for (std::size_t k = 0; k < 3; ++k) {
        distance[k] = w.dot(corner(mesh_, t, k) - plane.origin);
        // On the plane counts as above it: a triangle is cut or not, never twice on an edge.
        above[k] = distance[k] >= 0.0;
    }
    if (above[0] == above[1] && above[1] == above[2]) {
        return false;
    }
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
        const std::size_t m = (k + 1) % 3;
        if (above[k] != above[m]) {
            // From the lower index's side always, so that neighbours cut their common edge in the
            // very same point.
            const std::size_t p = t[k] < t[m] ? k : m;
            const std::size_t q = t[k] < t[m] ? m : k;
            const double s = distance[p] / (distance[p] - distance[q]);
            ends[found++] = corner(mesh_, t, p) + s * (corner(mesh_, t, q) - corner(mesh_, t, p));
        }
    }
    return true;
}

void Terrain::slice(const SlicePlane& plane, double radius, std::vector<SliceSegment>& out) const {
    out.clear();
    const Vec3 w = plane.u.cross(plane.v);  // plane normal
    std::array<Vec3, 2> ends;
    const auto inPlane = [&](const Vec3& p) {
        return Eigen::Vector2d(plane.u.dot(p - plane.origin), plane.v.dot(p - plane.origin));
    };
    visitCells(plane, w, radius, [&](int ix, int iy) {
        const std::size_t cell = cellAt(ix, iy);
        for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
            const auto& t = mesh_.triangles[static_cast<std::size_t>(
                cellTriangles_[static_cast<std::size_t>(i)])];
            if (!cut(t, plane, w, ends)) {
                continue;
            }
            SliceSegment segment{inPlane(ends[0]), inPlane(ends[1]), Vec3::Zero()};
            const double s = nearestShare(segment.a, segment.b);
            if ((segment.a + s * (segment.b - segment.a)).norm() > radius) {
                continue;
            }
            // A triangle that lies in several cells is taken in that of its nearest point, which
            // is one of those searched.
            const Vec3 nearest = (ends[0] + s * (ends[1] - ends[0]))
                                     .cwiseMax(lowCorner(mesh_, t))
                                     .cwiseMin(highCorner(mesh_, t));
            if (column(nearest.x()) != ix || row(nearest.y()) != iy) {
                continue;
            }
            segment.normal = normalOf(mesh_, t);
            // The free side is to the left.
            const Eigen::Vector2d along = segment.b - segment.a;
            const double left =
                -along.y() * segment.normal.dot(plane.u) + along.x() * segment.normal.dot(plane.v);
            if (left < 0.0) {
                std::swap(segment.a, segment.b);
            }
            out.push_back(segment);
        }
    });
}

void Terrain::facing(const Vec3& low, const Vec3& high, const Vec3& axis, double angle,
                     std::vector<Facet>& out) const {
    out.clear();
    // Faces less steep than this are further than the angle from the axis; a little less, as slopes
    // are kept in single precision.
    constexpr double kRounding = 1e-4;
    const auto slope = static_cast<float>(leanOf(axis) - angle - kRounding);
    if (steepest_ < slope) {
        return;
    }
    const double cosine = std::cos(angle);
    const int firstX = column(low.x());
    const int firstY = row(low.y());
    const int lastX = column(high.x());
    const int lastY = row(high.y());
    for (int ix = firstX; ix <= lastX; ++ix) {
        for (int iy = firstY; iy <= lastY; ++iy) {
            const std::size_t cell = cellAt(ix, iy);
            if (cellSteepest_[cell] < slope) {
                continue;
            }
            for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
                const auto& t = mesh_.triangles[static_cast<std::size_t>(
                    cellTriangles_[static_cast<std::size_t>(i)])];
                const Vec3 least = lowCorner(mesh_, t);
                // A triangle that lies in several cells is taken in the first of them.
                if (ix != std::max(firstX, column(least.x())) ||
                    iy != std::max(firstY, row(least.y())) ||
                    (least.array() > high.array()).any() ||
                    (highCorner(mesh_, t).array() < low.array()).any()) {
                    continue;
                }
                const Vec3 normal = normalOf(mesh_, t);
                if (std::abs(normal.dot(axis)) >= cosine) {
                    out.push_back(
                        {{corner(mesh_, t, 0), corner(mesh_, t, 1), corner(mesh_, t, 2)}, normal});
                }
            }
        }
    }
}

}  // namespace simcore::terrain
