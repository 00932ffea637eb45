#include "simcore/terrain/ground_patch.h"

#include <algorithm>
#include <cstdint>

#include "simcore/base/planar.h"
#include "simcore/terrain/terrain.h"

namespace simcore::terrain {
namespace {

// More than any usual ground asks for, so that a drive takes nothing more from the heap.
constexpr std::size_t kRoom = 256;
constexpr std::size_t kFirstTable = 1024;
constexpr int kNoCorner = -1;

/// How a plane passes through a triangle: one corner is alone on its side of it.
struct Passage {
    std::uint8_t alone;
    std::uint8_t begins;  ///< corner at the other end of the edge where the section begins
    std::uint8_t ends;
};

/// By which corners are above the plane, corner k as bit k. Round the triangle, its free side in
/// view, the section begins where the way goes down.
constexpr std::array<Passage, 8> kPassages{
    {{}, {0, 1, 2}, {1, 2, 0}, {2, 1, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {}}};

/// Place in a table of a power of two to begin looking at.
std::size_t hashOf(int vertex, std::size_t size) {
    constexpr std::size_t kGolden = 0x9E3779B97F4A7C15ULL;
    return (static_cast<std::size_t>(vertex) * kGolden >> 32U) & (size - 1);
}

}  // namespace

GroundPatch::GroundPatch() : table_(kFirstTable, kNoCorner) {
    vertices_.reserve(kRoom);
    for (std::vector<double>* numbers : {&x_, &y_, &z_, &distances_, &alongU_, &alongV_}) {
        numbers->reserve(kRoom);
    }
}

void GroundPatch::reset(std::size_t planes) {
    candidates_.resize(planes);
    pieces_.resize(planes);
    for (std::size_t plane = 0; plane < planes; ++plane) {
        candidates_[plane].clear();
        candidates_[plane].reserve(kRoom);
        pieces_[plane].clear();
        pieces_[plane].reserve(kRoom);
    }
}

void GroundPatch::add(std::size_t plane, int triangle, double reach) {
    candidates_[plane].push_back({triangle, static_cast<float>(reach)});
}

void GroundPatch::take(const TriangleMesh& mesh, std::span<const Vec3> normals) {
    if (8 * vertices_.size() > table_.size()) {
        std::fill(table_.begin(), table_.end(), kNoCorner);
    } else {
        while (
            !vertices_.empty()) {  // the last come first out: their slots were found past others'
            table_[slotOf(vertices_.back())] = kNoCorner;
            vertices_.pop_back();
        }
    }
    vertices_.clear();
    for (std::vector<double>* numbers : {&x_, &y_, &z_}) {
        numbers->clear();
    }
    for (std::size_t plane = 0; plane < pieces_.size(); ++plane) {
        std::vector<Candidate>& found = candidates_[plane];
        // A triangle that lies in several cells is found in each, as near as in any.
        std::sort(found.begin(), found.end(),
                  [](const Candidate& a, const Candidate& b) { return a.triangle < b.triangle; });
        int last = kNoCorner;
        for (const Candidate& candidate : found) {
            if (candidate.triangle == last) {
                continue;
            }
            last = candidate.triangle;
            const auto triangle = static_cast<std::size_t>(candidate.triangle);
            Piece& piece = pieces_[plane].emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const int vertex = mesh.triangles[triangle][k];
                piece.corners[k] =
                    cornerOf(vertex, mesh.vertices[static_cast<std::size_t>(vertex)]);
            }
            piece.reach = candidate.reach;
            piece.normal = normals[triangle];
        }
    }
    for (std::vector<double>* numbers : {&distances_, &alongU_, &alongV_}) {
        numbers->resize(vertices_.size());
    }
}

/// Of the table: where the vertex is, or belongs.
std::size_t GroundPatch::slotOf(int vertex) const {
    std::size_t slot = hashOf(vertex, table_.size());
    while (table_[slot] != kNoCorner &&
           vertices_[static_cast<std::size_t>(table_[slot])] != vertex) {
        slot = (slot + 1) & (table_.size() - 1);
    }
    return slot;
}

int GroundPatch::cornerOf(int vertex, const Vec3& place) {
    const std::size_t slot = slotOf(vertex);
    if (table_[slot] != kNoCorner) {
        return table_[slot];
    }
    const int corner = static_cast<int>(vertices_.size());
    table_[slot] = corner;
    vertices_.push_back(vertex);
    x_.push_back(place.x());
    y_.push_back(place.y());
    z_.push_back(place.z());
    if (2 * vertices_.size() > table_.size()) {
        growTable();
    }
    return corner;
}

void GroundPatch::growTable() {
    table_.assign(2 * table_.size(), kNoCorner);
    for (std::size_t corner = 0; corner < vertices_.size(); ++corner) {
        table_[slotOf(vertices_[corner])] = static_cast<int>(corner);
    }
}

void GroundPatch::see(const SlicePlane& middle) {
    const Vec3 w = middle.v.cross(middle.u);
    const auto look = [&](const Vec3& along, std::vector<double>& seen) {
        const double* const x = x_.data();
        const double* const y = y_.data();
        const double* const z = z_.data();
        double* const to = seen.data();
        const Vec3 origin = middle.origin;
        const std::size_t count = x_.size();
        for (std::size_t i = 0; i < count; ++i) {
            to[i] = along.x() * (x[i] - origin.x()) + along.y() * (y[i] - origin.y()) +
                    along.z() * (z[i] - origin.z());
        }
    };
    look(w, distances_);
    look(middle.u, alongU_);
    look(middle.v, alongV_);
}

void GroundPatch::slice(std::size_t plane, double offset, double radius, double way,
                        std::vector<SliceSegment>& out) const {
    out.clear();
    const double radius2 = radius * radius;
    const double* const distances = distances_.data();
    const double* const alongU = alongU_.data();
    const double* const alongV = alongV_.data();
    // Where the plane cuts an edge: neighbours, which come from its other end, cut it in the very
    // same point.
    const auto cutEdge = [&](int p, double pAbove, int q) {
        const double qAbove = distances[q] - offset;
        const double share = 1.0 / (qAbove - pAbove);
        return Eigen::Vector2d((qAbove * alongU[p] - pAbove * alongU[q]) * share,
                               (qAbove * alongV[p] - pAbove * alongV[q]) * share);
    };
    for (const Piece& piece : pieces_[plane]) {
        if (static_cast<double>(piece.reach) > way) {
            continue;
        }
        const int* const corners = piece.corners.data();
        // On the plane counts as above it: a triangle is cut or not, never twice on an edge.
        const unsigned above = (distances[corners[0]] >= offset ? 1U : 0U) |
                               (distances[corners[1]] >= offset ? 2U : 0U) |
                               (distances[corners[2]] >= offset ? 4U : 0U);
        const Passage& passage = kPassages[above];
        if (passage.alone == passage.begins) {
            continue;
        }
        const int alone = corners[passage.alone];
        const double aloneAbove = distances[alone] - offset;
        SliceSegment segment{cutEdge(alone, aloneAbove, corners[passage.begins]),
                             cutEdge(alone, aloneAbove, corners[passage.ends]), piece.normal};
        const Eigen::Vector2d along = segment.b - segment.a;
        const double length2 = along.squaredNorm();
        segment.nearest = length2 > 0.0 ? -segment.a.dot(along) / length2 : 0.0;
        if (segment.nearestPoint().squaredNorm() <= radius2) {
            out.push_back(segment);
        }
    }
}

}  // namespace simcore::terrain
