#include "simcore/contact/wheel_contact.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace simcore::contact {
namespace {

using terrain::SlicePlane;
using terrain::SliceSegment;

// Outer slices stand at this share of the width from the middle.
constexpr double kOuterSlice = 0.45;
// Ends of neighbouring segments, and contacts, nearer than this are one [m].
constexpr double kSamePoint = 1e-6;
constexpr std::size_t kMostPerSlice = 4;

struct Candidate {
    Eigen::Vector2d point;
    Vec3 normal;
    double depth;
};

/// Offsets of the slices from the wheel's middle along its axis, as shares of its width.
double sliceOffset(int slice, int slices) {
    return slices == 1 ? 0.0 : kOuterSlice * (2.0 * slice / (slices - 1) - 1.0);
}

SlicePlane planeOf(const Vec3& center, const Vec3& axis) {
    // Forward is level unless the axle stands upright.
    const Vec3 level = std::abs(axis.z()) < 0.99 ? Vec3::UnitZ() : Vec3::UnitX();
    const Vec3 u = axis.cross(level).normalized();
    return {center, u, u.cross(axis)};
}

/// Collects candidates, deepest kept, near duplicates merged.
class CandidateList {
  public:
    void add(const Candidate& candidate) {
        for (std::size_t i = 0; i < size_; ++i) {
            if ((items_[i].point - candidate.point).norm() < kSamePoint) {
                if (candidate.depth > items_[i].depth) {
                    items_[i] = candidate;
                }
                return;
            }
        }
        if (size_ < kMostPerSlice) {
            items_[size_++] = candidate;
            return;
        }
        auto shallowest = std::min_element(
            items_.begin(), items_.end(),
            [](const Candidate& a, const Candidate& b) { return a.depth < b.depth; });
        if (candidate.depth > shallowest->depth) {
            *shallowest = candidate;
        }
    }

    const Candidate* begin() const { return items_.data(); }

    const Candidate* end() const { return items_.data() + size_; }

  private:
    std::array<Candidate, kMostPerSlice> items_;
    std::size_t size_ = 0;
};

/// Contact at the shared corner `point` of two segments, when both are nearest to the centre there.
void addCorner(const std::vector<SliceSegment>& segments, std::size_t index,
               const Eigen::Vector2d& point, const SlicePlane& plane, double radius, double margin,
               CandidateList& found) {
    const SliceSegment& own = segments[index];
    for (std::size_t k = 0; k < segments.size(); ++k) {
        if (k == index) {
            continue;
        }
        const SliceSegment& other = segments[k];
        const bool atStart = (other.a - point).norm() < kSamePoint;
        const bool atEnd = (other.b - point).norm() < kSamePoint;
        if (!atStart && !atEnd) {
            continue;
        }
        const Eigen::Vector2d away = atStart ? other.b - other.a : other.a - other.b;
        if (away.dot(-point) > 0.0) {
            return;  // the neighbour comes nearer: not a corner contact
        }
        // The edge of the ground that both faces share; across it the normal has no part along it.
        Vec3 edge = own.normal.cross(other.normal);
        const Vec3 out = -(point.x() * plane.u + point.y() * plane.v);
        Vec3 normal = out;
        if (edge.norm() > 1e-6) {
            edge.normalize();
            normal -= normal.dot(edge) * edge;
        }
        const double distance = point.norm();
        if (normal.norm() < 1e-9 || distance < 1e-9) {
            return;
        }
        const double tilt = normal.norm() / distance;  // cosine between disc and contact normal
        normal.normalize();
        const double depth = (radius - distance) * tilt;
        if (depth > -margin) {
            found.add({point, normal, depth});
        }
        return;
    }
}

void findInSlice(const std::vector<SliceSegment>& segments, const SlicePlane& plane, double radius,
                 double margin, CandidateList& found) {
    // Faces seen from behind count only when the disc's centre is under ground altogether.
    CandidateList behind;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const SliceSegment& segment = segments[i];
        const Eigen::Vector2d along = segment.b - segment.a;
        const double length2 = along.squaredNorm();
        if (length2 < 1e-24) {
            continue;
        }
        const double s = -segment.a.dot(along) / length2;
        const Eigen::Vector2d left(-along.y(), along.x());
        if (s <= 0.0 || s >= 1.0) {
            const Eigen::Vector2d& corner = s <= 0.0 ? segment.a : segment.b;
            // Only from the free side: -corner points from the corner to the centre.
            if (corner.norm() < radius + margin && left.dot(-corner) > 0.0) {
                addCorner(segments, i, corner, plane, radius, margin, found);
            }
            continue;
        }
        const Eigen::Vector2d nearest = segment.a + s * along;
        // Height of the centre over the face, negative when it is inside the ground.
        const double height = left.dot(-nearest) / std::sqrt(length2);
        const double inPlane = std::hypot(segment.normal.dot(plane.u), segment.normal.dot(plane.v));
        const double depth = (radius - height) * inPlane;
        if (height > 0.0 && depth > -margin) {
            found.add({nearest, segment.normal, depth});
        } else if (height <= 0.0 && height > -radius) {
            behind.add({nearest, segment.normal, depth});
        }
    }
    if (found.begin() == found.end()) {
        for (const Candidate& candidate : behind) {
            found.add(candidate);
        }
    }
}

}  // namespace

WheelContactFinder::WheelContactFinder(const mechanism::Mechanism& mechanism,
                                       const terrain::Terrain& terrain, int slices, double margin)
    : mechanism_(mechanism),
      terrain_(terrain),
      slices_(slices),
      margin_(margin) {}

const std::vector<Contact>& WheelContactFinder::find(const std::vector<Pose>& bodies) {
    contacts_.clear();
    for (std::size_t i = 0; i < mechanism_.wheels.size(); ++i) {
        const mechanism::Wheel& wheel = mechanism_.wheels[i];
        const Pose& pose = bodies[static_cast<std::size_t>(wheel.body)];
        const Vec3 axis = pose.rotation * wheel.axis;
        const Vec3 center = pose * wheel.center;
        for (int slice = 0; slice < slices_; ++slice) {
            const SlicePlane plane =
                planeOf(center + sliceOffset(slice, slices_) * wheel.width * axis, axis);
            terrain_.slice(plane, wheel.radius + margin_, segments_);
            CandidateList found;
            findInSlice(segments_, plane, wheel.radius, margin_, found);
            for (const Candidate& candidate : found) {
                const Vec3 point =
                    plane.origin + candidate.point.x() * plane.u + candidate.point.y() * plane.v;
                contacts_.push_back({static_cast<int>(i), slice, point, candidate.normal,
                                     axis.cross(candidate.normal).normalized(), candidate.depth});
            }
        }
    }
    return contacts_;
}

}  // namespace simcore::contact
