#include "simcore/contact/slice_contacts.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/planar.h"

namespace simcore::contact {
namespace {

using terrain::SlicePlane;
using terrain::SliceSegment;

// Shorter segments are left out: a plane that passes by a vertex cuts slivers of its triangles [m].
constexpr double kShortest = 1e-6;
// Ends of segments, and contacts, nearer than this are one; a few slivers may lie between [m].
constexpr double kSamePoint = 4e-6;
// A neighbour comes nearer to the centre only when it does so by more than rounding (cosine).
constexpr double kStraight = 1e-9;
// Neighbouring contacts belong to one patch when they are this near round the disc [rad] and their
// normals this alike (cosine of 18 deg); both assumed.
constexpr double kPatchGap = 0.1;
constexpr double kPatchCosine = 0.95;

Eigen::Vector2d inPlane(const Vec3& v, const SlicePlane& plane) {
    return {v.dot(plane.u), v.dot(plane.v)};
}

/// Square to the edge between two faces and to the disc's rim: that mean of the faces' normals
/// which, seen in the plane, points to the centre. `out` is the unit vector to the centre.
Vec3 cornerNormal(const Vec3& first, const Vec3& second, const Eigen::Vector2d& out,
                  const SlicePlane& plane) {
    const double a = cross(inPlane(first, plane), out);
    const double b = cross(inPlane(second, plane), out);
    const double share = a == b ? 0.5 : std::clamp(a / (a - b), 0.0, 1.0);
    const Vec3 normal = (1.0 - share) * first + share * second;
    const Vec3 towards = out.x() * plane.u + out.y() * plane.v;
    // Faces back to back, the edge of a sheet: no mean between them.
    constexpr double kBackToBack = 1e-3;
    return normal.dot(towards) > kBackToBack ? Vec3(normal.normalized()) : towards;
}

double turnCosine(const SliceSegment& first, const SliceSegment& second) {
    const Eigen::Vector2d a = first.b - first.a;
    const Eigen::Vector2d b = second.b - second.a;
    return a.dot(b) / std::sqrt(a.squaredNorm() * b.squaredNorm());
}

/// Round the disc from straight below, + ahead [rad].
double angleOf(const SliceContact& contact) {
    return std::atan2(contact.point.x(), -contact.point.y());
}

bool deeper(const SliceContact& a, const SliceContact& b) {
    return a.depth > b.depth;
}

}  // namespace

SliceContactFinder::SliceContactFinder() {
    constexpr std::size_t kRoom = 64;
    contacts_.reserve(kRoom);
    kept_.reserve(kRoom);
}

const std::vector<SliceContact>& SliceContactFinder::find(std::vector<SliceSegment>& segments,
                                                          const SlicePlane& plane, double radius,
                                                          double margin) {
    std::erase_if(segments, [](const SliceSegment& s) {
        return (s.b - s.a).squaredNorm() < kShortest * kShortest;
    });
    segments_ = &segments;
    plane_ = &plane;
    radius_ = radius;
    margin_ = margin;
    contacts_.clear();
    behind_.reset();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const SliceSegment& segment = segments[i];
        if (segment.nearest > 0.0 && segment.nearest < 1.0) {
            addFace(segment);
            continue;
        }
        const bool atStart = segment.nearest <= 0.0;
        const Eigen::Vector2d& corner = atStart ? segment.a : segment.b;
        // Only from the free side, which is to the left.
        if (corner.norm() < radius + margin && cross(segment.b - segment.a, -corner) > 0.0) {
            addCorner(i, atStart);
        }
    }
    if (contacts_.size() > kMostPerSlice) {
        thinOut();
    }
    // In an order that does not depend on that of the mesh's triangles.
    std::sort(contacts_.begin(), contacts_.end(), [](const SliceContact& a, const SliceContact& b) {
        return std::pair(a.point.x(), a.point.y()) < std::pair(b.point.x(), b.point.y());
    });
    return contacts_;
}

void SliceContactFinder::addFace(const SliceSegment& segment) {
    const Eigen::Vector2d along = segment.b - segment.a;
    const Eigen::Vector2d foot = segment.a + segment.nearest * along;
    // Height of the centre over the face, negative when it is inside the ground.
    const double height = cross(along, -foot) / along.norm();
    const double depth = (radius_ - height) * inPlane(segment.normal, *plane_).norm();
    if (height > 0.0) {
        if (depth > -margin_) {
            add({foot, segment.normal, depth});
        }
    } else if (height > -radius_ && (!behind_ || height > behindHeight_)) {
        behind_ = SliceContact{foot, segment.normal, depth};
        behindHeight_ = height;
    }
}

void SliceContactFinder::addCorner(std::size_t index, bool atStart) {
    const SliceSegment& own = (*segments_)[index];
    const Eigen::Vector2d& point = atStart ? own.a : own.b;
    const SliceSegment* neighbour = nullptr;
    bool runsOn = false;  // the neighbour begins where this one ends, as faces of one surface do
    for (const SliceSegment& other : *segments_) {
        for (const bool otherAtStart : {true, false}) {
            const Eigen::Vector2d& end = otherAtStart ? other.a : other.b;
            if (&other == &own || std::abs(end.x() - point.x()) > kSamePoint ||
                (end - point).squaredNorm() > kSamePoint * kSamePoint) {
                continue;
            }
            const Eigen::Vector2d away = otherAtStart ? other.b - other.a : other.a - other.b;
            const double nearer = away.dot(-end);
            if (nearer > 0.0 && nearer > kStraight * end.norm() * away.norm()) {
                return;  // it comes nearer: no corner contact
            }
            if (neighbour == nullptr || (!runsOn && otherAtStart != atStart)) {
                neighbour = &other;
                runsOn = otherAtStart != atStart;
            }
        }
    }
    const double distance = point.norm();
    constexpr double kCentre = 1e-9;
    if (distance < kCentre) {
        return;
    }
    const Eigen::Vector2d out = -point / distance;
    // Where the ground ends, at a hole or its border, nothing but the way to the centre is known.
    const Vec3 normal = neighbour != nullptr
                            ? cornerNormal(own.normal, neighbour->normal, out, *plane_)
                            : Vec3(out.x() * plane_->u + out.y() * plane_->v);
    const double depth = (radius_ - distance) * inPlane(normal, *plane_).norm();
    if (depth > -margin_) {
        add({point, normal, depth, neighbour != nullptr ? turnCosine(own, *neighbour) : -1.0});
    }
}

void SliceContactFinder::add(const SliceContact& contact) {
    for (SliceContact& there : contacts_) {
        if ((there.point - contact.point).squaredNorm() < kSamePoint * kSamePoint) {
            if (contact.depth > there.depth) {
                there = contact;
            }
            return;
        }
    }
    contacts_.push_back(contact);
}

void SliceContactFinder::thinOut() {
    std::sort(contacts_.begin(), contacts_.end(),
              [](const SliceContact& a, const SliceContact& b) { return angleOf(a) < angleOf(b); });
    // The deepest of every patch to the front, so that a bumpy floor cannot crowd out a wall.
    kept_.clear();
    for (std::size_t begin = 0; begin < contacts_.size();) {
        std::size_t end = begin + 1;
        while (end < contacts_.size() &&
               angleOf(contacts_[end]) - angleOf(contacts_[end - 1]) < kPatchGap &&
               contacts_[end].normal.dot(contacts_[end - 1].normal) > kPatchCosine) {
            ++end;
        }
        const auto first = contacts_.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = contacts_.begin() + static_cast<std::ptrdiff_t>(end);
        const auto deepest = std::min_element(first, last, deeper);
        kept_.push_back(*deepest);
        std::iter_swap(first, deepest);
        first->depth = -1.0;  // taken
        begin = end;
    }
    std::sort(kept_.begin(), kept_.end(), deeper);
    std::sort(contacts_.begin(), contacts_.end(), deeper);
    for (const SliceContact& contact : contacts_) {
        if (kept_.size() >= kMostPerSlice) {
            break;
        }
        kept_.push_back(contact);
    }
    kept_.resize(std::min(kept_.size(), kMostPerSlice));
    std::swap(kept_, contacts_);
}

}  // namespace simcore::contact
