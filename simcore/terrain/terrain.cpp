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
/// Cells of the look-up grid are a triangle large, within these bounds [m], so that a slice
/// tests few triangles whether they measure a millimetre or a metre.
constexpr double kSmallestCell = 0.002;
constexpr double kLargestCell = 0.05;
/// Larger cells are taken rather than more cells, or more entries for each triangle, than these.
constexpr double kMostCells = 4e6;
constexpr double kMostEntries = 16e6;
constexpr double kMostEntriesPerTriangle = 4.0;
/// A triangle reaches into a cell when it does so by more than this share of it.
constexpr double kIntoCell = 1e-6;
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

/// Bound of a triangle's height over a rectangle of half sides `reach` [m]: that of its plane there
/// or that of its corners, whichever is less.
double highestOver(const TriangleMesh& mesh, const std::array<int, 3>& t, const Vec3& normal,
                   const Eigen::Vector2d& middle, const Eigen::Vector2d& reach) {
    const double top = highCorner(mesh, t).z();
    if (std::abs(normal.z()) < 1e-6) {
        return top;  // steeper than any height field
    }
    const Eigen::Vector2d slope = -normal.head<2>() / normal.z();
    const Vec3& a = corner(mesh, t, 0);
    return std::min(top,
                    a.z() + slope.dot(middle - a.head<2>()) + reach.dot(slope.cwiseAbs()) + kSlack);
}

/// In single precision, but not below `value`.
float roundedUp(double value) {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) < value
               ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
               : nearest;
}

/// In single precision, below `value` by a slack at least.
float roundedDown(double value) {
    constexpr double kSingle = 1e-7;  // twice its rounding, relative
    return static_cast<float>(value - kSlack - kSingle * std::abs(value));
}

/// A vertex of the ground as planes beside each other see it.
struct SeenVertex {
    double distance = 0.0;                            ///< from the first plane, along v x u [m]
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  ///< along u and v [m]
};

/// Bound of the distance from the planes' origins to any piece that a plane cuts from these
/// vertices' hull, by the line across the way to their middle that has them all behind it [m].
template <class... Seen>
double leastDistance(const Seen&... seen) {
    const Eigen::Vector2d sum = (seen.place + ...);
    const double least = std::min({seen.place.dot(sum)...});
    return least > 0.0 ? least / sum.norm() : 0.0;
}

/// Cells that suit a mesh within the box [m].
double cellSizeFor(const TriangleMesh& mesh, const Vec3& low, const Vec3& high) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
        sum += (highCorner(mesh, t) - lowCorner(mesh, t)).head<2>().maxCoeff();
    }
    const auto count = static_cast<double>(mesh.triangles.size());
    double size = std::clamp(sum / count, kSmallestCell, kLargestCell);
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
    terrain.sameAcross_ = true;
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
    terrain.sameAcross_ = true;  // unless a height differs from its neighbour's, or is none
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const std::size_t inRow = i % static_cast<std::size_t>(ny);
        terrain.sameAcross_ = terrain.sameAcross_ && heights[i] == heights[inRow == 0 ? i : i - 1];
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
    return static_cast<int>(std::clamp((x - gridX0_) / cellX_, 0.0, gridNx_ - 1.0));
}

int Terrain::row(double y) const {
    return static_cast<int>(std::clamp((y - gridY0_) / cellY_, 0.0, gridNy_ - 1.0));
}

Terrain::CellRange Terrain::cellsOf(const std::array<int, 3>& triangle) const {
    const Vec3 low = lowCorner(mesh_, triangle);
    const Vec3 high = highCorner(mesh_, triangle);
    const double intoX = kIntoCell * cellX_;
    const double intoY = kIntoCell * cellY_;
    CellRange cells{column(low.x() + intoX), column(high.x() - intoX), row(low.y() + intoY),
                    row(high.y() - intoY)};
    // One that is thinner than that.
    cells.lastX = std::max(cells.firstX, cells.lastX);
    cells.lastY = std::max(cells.firstY, cells.lastY);
    return cells;
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
    cellX_ = cellY_ = cellSizeFor(mesh_, low, high);
    if (!profile_.empty()) {
        // The same at every y: one row of cells, as narrow as the profile's pieces.
        const double piece = (high.x() - low.x()) / static_cast<double>(profile_.size() - 1);
        cellX_ = std::clamp(piece, kSmallestCell, kLargestCell);
        cellY_ = high.y() - low.y();
    }
    gridX0_ = low.x();
    gridY0_ = low.y();
    const auto cellsAcross = [](double extent, double size) {
        return std::max(1, static_cast<int>(std::ceil(extent / size - kIntoCell)));
    };
    gridNx_ = cellsAcross(high.x() - low.x(), cellX_);
    gridNy_ = cellsAcross(high.y() - low.y(), cellY_);

    const auto visitCellsOf = [&](const std::array<int, 3>& t, auto&& visit) {
        const CellRange cells = cellsOf(t);
        for (int ix = cells.firstX; ix <= cells.lastX; ++ix) {
            for (int iy = cells.firstY; iy <= cells.lastY; ++iy) {
                visit(cellAt(ix, iy));
            }
        }
    };
    obstacleRange_ = {std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()};
    cellStart_.assign(static_cast<std::size_t>(gridNx_) * static_cast<std::size_t>(gridNy_) + 1, 0);
    for (const auto& t : mesh_.triangles) {
        visitCellsOf(t, [&](std::size_t cell) { ++cellStart_[cell + 1]; });
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
    normals_.reserve(mesh_.triangles.size());
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
        normals_.push_back(normalOf(mesh_, mesh_.triangles[i]));
        const CellRange cells = cellsOf(mesh_.triangles[i]);
        spread_.push_back(cells.firstX < cells.lastX || cells.firstY < cells.lastY ? 1 : 0);
        const auto slope = static_cast<float>(leanOf(normals_[i]));
        steepest_ = std::max(steepest_, slope);
        visitCellsOf(mesh_.triangles[i], [&](std::size_t cell) {
            cellTriangles_[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(i);
            cellSteepest_[cell] = std::max(cellSteepest_[cell], slope);
        });
    }
    indexQuads();
    indexHeights();
}

void Terrain::indexQuads() {
    quads_.assign(cellStart_.size() - 1, {});
    std::size_t found = 0;
    for (std::size_t cell = 0; cell < quads_.size(); ++cell) {
        if (cellStart_[cell + 1] - cellStart_[cell] != 2) {
            continue;
        }
        const int* const triangles = cellTriangles_.data() + cellStart_[cell];
        const auto& first = mesh_.triangles[static_cast<std::size_t>(triangles[0])];
        const auto& second = mesh_.triangles[static_cast<std::size_t>(triangles[1])];
        if (spread_[static_cast<std::size_t>(triangles[0])] != 0 ||
            spread_[static_cast<std::size_t>(triangles[1])] != 0) {
            continue;
        }
        // Of the edge that they have in common one sees it the other way round.
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (first[i] == second[k] && first[(i + 2) % 3] == second[(k + 1) % 3]) {
                    quads_[cell] = {
                        {first[i], first[(i + 1) % 3], first[(i + 2) % 3], second[(k + 2) % 3]},
                        {triangles[0], triangles[1]}};
                    ++found;
                }
            }
        }
    }
    if (found == 0) {
        quads_ = {};
    }
}

void Terrain::indexHeights() {
    constexpr float kNone = -std::numeric_limits<float>::infinity();
    const Eigen::Vector2d reach(0.5 * cellX_ + kSlack, 0.5 * cellY_ + kSlack);
    cellHighest_.assign(cellStart_.size() - 1, kNone);
    for (int ix = 0; ix < gridNx_; ++ix) {
        for (int iy = 0; iy < gridNy_; ++iy) {
            const std::size_t cell = cellAt(ix, iy);
            const Eigen::Vector2d middle(gridX0_ + (ix + 0.5) * cellX_,
                                         gridY0_ + (iy + 0.5) * cellY_);
            for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
                const auto triangle =
                    static_cast<std::size_t>(cellTriangles_[static_cast<std::size_t>(i)]);
                const double top = highestOver(mesh_, mesh_.triangles[triangle], normals_[triangle],
                                               middle, reach);
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

double Terrain::coarselyHighest(const Vec3& low, const Vec3& high, int fineness) const {
    int firstX = column(low.x());
    int firstY = row(low.y());
    int lastX = column(high.x());
    int lastY = row(high.y());
    const auto span = static_cast<unsigned>(std::max(lastX - firstX, lastY - firstY));
    const int level = std::clamp(static_cast<int>(std::bit_width(span)) - fineness, 0,
                                 static_cast<int>(coarse_.size()));
    firstX >>= level;
    firstY >>= level;
    lastX >>= level;
    lastY >>= level;
    float best = -std::numeric_limits<float>::infinity();
    for (int ix = firstX; ix <= lastX; ++ix) {
        for (int iy = firstY; iy <= lastY; ++iy) {
            best = std::max(best, highestIn(static_cast<std::size_t>(level), ix, iy));
        }
    }
    return static_cast<double>(best);
}

double Terrain::heightAt(double x, double y) const {
    double height = std::numeric_limits<double>::quiet_NaN();
    const double cellX = (x - gridX0_) / cellX_;
    const double cellY = (y - gridY0_) / cellY_;
    // Up to the very border, which rounding may put beyond the last cell.
    if (!(cellX >= -kIntoCell && cellY >= -kIntoCell && cellX <= gridNx_ + kIntoCell &&
          cellY <= gridNy_ + kIntoCell)) {
        return height;  // a place too far away for an int among them
    }
    // On a border, triangles of both sides count.
    const double intoX = 2.0 * kIntoCell * cellX_;
    const double intoY = 2.0 * kIntoCell * cellY_;
    for (int ix = column(x - intoX); ix <= column(x + intoX); ++ix) {
        for (int iy = row(y - intoY); iy <= row(y + intoY); ++iy) {
            const std::size_t cell = cellAt(ix, iy);
            for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
                const double z = heightOn(
                    static_cast<std::size_t>(cellTriangles_[static_cast<std::size_t>(i)]), x, y);
                if (!std::isnan(z)) {
                    height = std::isnan(height) ? z : std::max(height, z);
                }
            }
        }
    }
    return height;
}

double Terrain::heightOn(std::size_t triangle, double x, double y) const {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Vec3& a = cornerOf(triangle, 0);
    const Vec3& b = cornerOf(triangle, 1);
    const Vec3& c = cornerOf(triangle, 2);
    const double det = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
    if (std::abs(det) < 1e-14) {
        return kNone;  // vertical face
    }
    const double u = ((x - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (y - a.y())) / det;
    const double v = ((b.x() - a.x()) * (y - a.y()) - (x - a.x()) * (b.y() - a.y())) / det;
    constexpr double kEdge = 1e-9;
    if (u < -kEdge || v < -kEdge || u + v > 1.0 + kEdge) {
        return kNone;
    }
    return a.z() + u * (b.z() - a.z()) + v * (c.z() - a.z());
}

template <class Visit>
void Terrain::visitRuns(const Vec3& center, const Vec3& axis, double halfLength, const Vec3& reach,
                        Visit&& visit) const {
    // Strips of cells across the larger horizontal extent; in each only those cells that the
    // cylinder passes over.
    const bool strips = std::max(std::abs(axis.x()), std::abs(axis.y())) > 0.1;
    const bool alongX = std::abs(axis.y()) >= std::abs(axis.x());
    const int main = alongX ? 0 : 1;
    const int other = 1 - main;
    const double mainOrigin = alongX ? gridX0_ : gridY0_;
    const double mainSize = alongX ? cellX_ : cellY_;
    const auto mainCell = [&](double value) { return alongX ? column(value) : row(value); };
    const auto otherCell = [&](double value) { return alongX ? row(value) : column(value); };
    const double slope = strips ? -axis[main] / axis[other] : 0.0;
    const double lean =
        strips ? (std::abs(axis.z()) * reach.z() + halfLength) / std::abs(axis[other]) + kSlack
               : 0.0;
    const int last = mainCell(center[main] + reach[main]);
    for (int i = mainCell(center[main] - reach[main]); i <= last; ++i) {
        double low = -reach[other];
        double high = reach[other];
        if (strips) {
            const double a =
                std::max(mainOrigin + i * mainSize - kSlack - center[main], -reach[main]);
            const double b =
                std::min(mainOrigin + (i + 1) * mainSize + kSlack - center[main], reach[main]);
            if (a > b) {
                continue;
            }
            low = std::max(low, std::min(slope * a, slope * b) - lean);
            high = std::min(high, std::max(slope * a, slope * b) + lean);
        }
        const int from = otherCell(center[other] + low);
        const int to = otherCell(center[other] + high);
        if (alongX) {
            visit(CellRange{i, i, from, to});
        } else {
            visit(CellRange{from, to, i, i});
        }
    }
}

void Terrain::slice(const SlicePlane& plane, double radius, std::vector<SliceSegment>& out) const {
    constexpr double kNoOffset = 0.0;
    GroundPatch patch;
    findNear(plane, {&kNoOffset, 1}, radius, 0.0, patch);
    patch.see(plane);
    patch.slice(0, kNoOffset, radius, 0.0, out);
}

void Terrain::findNear(const SlicePlane& plane, std::span<const double> offsets, double radius,
                       double slack, GroundPatch& out) const {
    out.reset(offsets.size());
    if (offsets.empty()) {
        return;
    }
    const Vec3 w = plane.v.cross(plane.u);
    // Rounding loses none.
    const double most = slack + kSlack;
    const double within = radius + most;
    std::array<SeenVertex, 4> seen;
    const auto see = [&](std::size_t k, int vertex) {
        const Vec3 arm = mesh_.vertices[static_cast<std::size_t>(vertex)] - plane.origin;
        seen[k] = {w.dot(arm), {plane.u.dot(arm), plane.v.dot(arm)}};
    };
    const auto take = [&](int triangle, std::size_t a, std::size_t b, std::size_t c) {
        const auto [low, high] =
            std::minmax({seen[a].distance, seen[b].distance, seen[c].distance});
        if (low - most > offsets.back() || high + most < offsets.front()) {
            return;
        }
        const double beyond = leastDistance(seen[a], seen[b], seen[c]) - radius;
        for (std::size_t k = 0; k < offsets.size(); ++k) {
            const double reach = std::max({beyond, low - offsets[k], offsets[k] - high});
            if (reach <= most) {
                out.add(k, triangle, reach - kSlack);
            }
        }
    };
    const auto look = [&](std::size_t cell) {
        if (!quads_.empty() && quads_[cell].isQuad()) {
            const Quad& quad = quads_[cell];
            for (std::size_t k = 0; k < 4; ++k) {
                see(k, quad.corners[k]);
            }
            if (leastDistance(seen[0], seen[1], seen[2], seen[3]) <= within) {
                take(quad.triangles[0], 0, 1, 2);
                take(quad.triangles[1], 0, 2, 3);
            }
            return;
        }
        for (int i = cellStart_[cell]; i < cellStart_[cell + 1]; ++i) {
            const int triangle = cellTriangles_[static_cast<std::size_t>(i)];
            const auto& corners = mesh_.triangles[static_cast<std::size_t>(triangle)];
            for (std::size_t k = 0; k < 3; ++k) {
                see(k, corners[k]);
            }
            take(triangle, 0, 1, 2);
        }
    };
    visitCells(plane, offsets.front() - most, offsets.back() + most, within, look);
    out.take(mesh_, normals_);
}

template <class Visit>
void Terrain::visitCells(const SlicePlane& plane, double from, double to, double radius,
                         Visit&& visit) const {
    const Vec3 w = plane.v.cross(plane.u);
    const double halfLength = 0.5 * (to - from);
    const Vec3 center = plane.origin + 0.5 * (to + from) * w;
    const double radius2 = radius * radius;
    // Where u is level, no point of the discs is below their rims at its place along u. Nor, unless
    // the axle is steep, below the cylinder that the rims lie on, which rises along the axle.
    constexpr double kLevel = 1e-9;
    constexpr double kSteep = 0.1;
    constexpr double kNowhere = -std::numeric_limits<double>::infinity();
    const bool level = std::abs(plane.u.z()) < kLevel;
    const double upright = std::abs(plane.v.z());
    const bool rises = level && upright > kSteep;
    const double middle = center.z() - halfLength * std::abs(w.z());
    const Eigen::Vector2d half(0.5 * cellX_, 0.5 * cellY_);
    const Eigen::Vector2d forward = plane.u.head<2>();
    // The rise per way across u, as a slope in x and y.
    const Eigen::Vector2d slope = rises
                                      ? Eigen::Vector2d(w.head<2>() * (w.z() / (upright * upright)))
                                      : Eigen::Vector2d(Eigen::Vector2d::Zero());
    const double slopeReach = half.dot(slope.cwiseAbs()) + kSlack;
    const Eigen::Vector2d corner(gridX0_ - center.x(), gridY0_ - center.y());
    // Only as far ahead and back as some part of the discs is no higher than the ground's top
    // there.
    const Vec3 along = halfLength * w.cwiseAbs() + Vec3::Constant(kSlack);
    const Vec3 all = radius * (plane.u.cwiseAbs2() + plane.v.cwiseAbs2()).cwiseSqrt() + along;
    Vec3 reach = all;
    for (const int fineness : {2, 3}) {
        if (!rises) {
            break;
        }
        const double top = coarselyHighest(center - reach, center + reach, fineness);
        const double above = (middle - kSlack - top) / upright;
        if (above > radius) {
            return;
        }
        const double deepest = std::max(0.0, above);
        const double ahead = std::sqrt(radius2 - deepest * deepest) + kSlack;
        reach = all.cwiseMin(ahead * plane.u.cwiseAbs() + radius * plane.v.cwiseAbs() + along);
    }
    visitRuns(center, w, halfLength, reach, [&](const CellRange& run) {
        float limit = -std::numeric_limits<float>::infinity();
        double cylinder = kNowhere;
        if (level) {
            // Of the cells' middle.
            const Eigen::Vector2d place =
                corner + half.cwiseProduct(Eigen::Vector2d(run.firstX + run.lastX + 1,
                                                           run.firstY + run.lastY + 1));
            const Eigen::Vector2d span = half.cwiseProduct(
                Eigen::Vector2d(run.lastX - run.firstX + 1, run.lastY - run.firstY + 1));
            const double s =
                std::max(0.0, std::abs(forward.dot(place)) - span.dot(forward.cwiseAbs()) - kSlack);
            if (s > radius) {
                return;
            }
            const double deep = std::sqrt(radius2 - s * s);
            limit = roundedDown(middle - upright * deep);
            if (rises) {
                // At the middle of cell 0, 0.
                cylinder = center.z() - deep / upright + slope.dot(corner + half) - slopeReach;
            }
        }
        for (int ix = run.firstX; ix <= run.lastX; ++ix) {
            std::size_t cell = cellAt(ix, run.firstY);
            const double start = cylinder + ix * cellX_ * slope.x();
            for (int iy = run.firstY; iy <= run.lastY; ++iy, ++cell) {
                if (cellHighest_[cell] >= limit &&
                    static_cast<double>(cellHighest_[cell]) >= start + iy * cellY_ * slope.y()) {
                    visit(cell);
                }
            }
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
                const auto triangle =
                    static_cast<std::size_t>(cellTriangles_[static_cast<std::size_t>(i)]);
                const auto& t = mesh_.triangles[triangle];
                const CellRange cells = cellsOf(t);
                // A triangle that lies in several cells is taken in the first of them.
                if (ix != std::max(firstX, cells.firstX) || iy != std::max(firstY, cells.firstY) ||
                    (lowCorner(mesh_, t).array() > high.array()).any() ||
                    (highCorner(mesh_, t).array() < low.array()).any()) {
                    continue;
                }
                const Vec3& normal = normals_[triangle];
                if (std::abs(normal.dot(axis)) >= cosine) {
                    out.push_back(
                        {{corner(mesh_, t, 0), corner(mesh_, t, 1), corner(mesh_, t, 2)}, normal});
                }
            }
        }
    }
}

}  // namespace simcore::terrain
