#include "simcore/contact/wheel_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace simcore::contact {
namespace {

using terrain::SlicePlane;

// Outer slices stand at this share of the width from the middle.
constexpr double kOuterSlice = 0.45;
// Inner slices stand no further apart than this, the cell of generated fields [m].
constexpr double kInnerSpacing = 0.02;
constexpr int kMostInner = 7;
// An inner contact counts when it is deeper than outer ones of like normal by this [m]: more than
// rounding. On even ground, however tilted, an outer one is as deep.
constexpr double kBulge = 1e-6;
constexpr double kLikeNormal = 0.9;  // cosine of 26 deg, assumed

SlicePlane planeOf(const Vec3& center, const Vec3& axis) {
    // Forward is level unless the axle stands upright.
    const Vec3 level = std::abs(axis.z()) < 0.99 ? Vec3::UnitZ() : Vec3::UnitX();
    const Vec3 u = axis.cross(level).normalized();
    return {center, u, u.cross(axis)};
}

/// Offset of disc `index` of `count` from the wheel's middle along its axis, as a share of its
/// width.
double offsetOf(int index, int count) {
    return count == 1 ? 0.0 : kOuterSlice * (2.0 * index / (count - 1) - 1.0);
}

}  // namespace

WheelContactFinder::WheelContactFinder(const mechanism::Mechanism& mechanism,
                                       const terrain::Terrain& terrain, int slices, double margin)
    : mechanism_(mechanism),
      terrain_(terrain),
      slices_(slices),
      margin_(margin) {
    for (const mechanism::Wheel& wheel : mechanism.wheels) {
        discs_.push_back(discsOf(wheel));
    }
    // More than any usual ground asks for, so that a drive takes nothing more from the heap.
    constexpr std::size_t kRoom = 256;
    segments_.reserve(kRoom);
    for (std::vector<Contact>* contacts : {&contacts_, &kept_}) {
        contacts->reserve(kRoom);
    }
    buried_.reserve(static_cast<std::size_t>(std::max(0, slices)));
}

WheelContactFinder::Discs WheelContactFinder::discsOf(const mechanism::Wheel& wheel) const {
    const int gaps = slices_ - 1;
    int inner = 0;  // in each gap
    // What is the same at every y cannot stand between two slices.
    if (!terrain_.sameAcross() && gaps > 0) {
        const double gap = 2.0 * kOuterSlice * wheel.width / gaps;
        inner = std::clamp(static_cast<int>(std::ceil(gap / kInnerSpacing)) - 1, 0, kMostInner);
    }
    std::vector<double> offsets;
    const int count = slices_ + gaps * inner;
    offsets.reserve(static_cast<std::size_t>(count));
    for (int disc = 0; disc < count; ++disc) {
        offsets.push_back(offsetOf(disc, count) * wheel.width);
    }
    // A little more than the radius, so that every corner comes with both its segments.
    constexpr double kMore = 1e-5;
    return {DiscSections(std::move(offsets), wheel.radius + margin_ + kMore),
            static_cast<std::size_t>(inner) + 1};
}

/// Of the section there is.
/// @param plane  its disc's
const std::vector<SliceContact>& WheelContactFinder::touch(std::size_t wheel,
                                                           const SlicePlane& plane) {
    return slice_.find(segments_, plane, mechanism_.wheels[wheel].radius, margin_);
}

/// Whether nothing in a disc's section can be as deep as a contact and unlike it: most inner discs
/// are left at that.
bool WheelContactFinder::isOutdone(std::size_t wheel, const SlicePlane& plane,
                                   const Contact& by) const {
    const double depth = by.depth + kBulge;
    const double beyond = mechanism_.wheels[wheel].radius - depth;
    const Eigen::Vector2d down(-by.normal.dot(plane.u), -by.normal.dot(plane.v));
    return depth > 0.0 &&
           std::all_of(segments_.begin(), segments_.end(), [&](const terrain::SliceSegment& s) {
               const Eigen::Vector2d nearest = s.nearestPoint();
               const double distance = nearest.norm();
               // At the ground's border a contact points from there to the disc's centre.
               return distance > beyond && s.normal.dot(by.normal) > kLikeNormal &&
                      nearest.dot(down) > kLikeNormal * distance;
           });
}

void WheelContactFinder::add(int wheel, int slice, const SlicePlane& plane, const Vec3& axis,
                             const SliceContact& contact) {
    const Vec3 point = plane.origin + contact.point.x() * plane.u + contact.point.y() * plane.v;
    contacts_.push_back({wheel, slice, point, contact.normal,
                         axis.cross(contact.normal).normalized(), contact.depth, -1,
                         contact.turnCosine});
}

void WheelContactFinder::findOuter(std::size_t wheel, const SlicePlane& middle, const Vec3& axis) {
    const Discs& discs = discs_[wheel];
    const std::size_t first = contacts_.size();
    buried_.clear();
    for (int slice = 0; slice < slices_; ++slice) {
        const std::size_t disc = static_cast<std::size_t>(slice) * discs.perGap;
        const SlicePlane plane{middle.origin + discs.offsets()[disc] * axis, middle.u, middle.v};
        discs.sections.cut(disc, segments_);
        for (const SliceContact& contact : touch(wheel, plane)) {
            add(static_cast<int>(wheel), slice, plane, axis, contact);
        }
        if (slice_.behind()) {
            buried_.push_back({slice, plane, *slice_.behind()});
        }
    }
    // Pushed up and out only when the whole wheel is under ground: a disc that has slid into the
    // side of a block is not thrown onto it.
    if (contacts_.size() == first && buried_.size() == static_cast<std::size_t>(slices_)) {
        for (const Buried& b : buried_) {
            add(static_cast<int>(wheel), b.slice, b.plane, axis, b.contact);
        }
    }
}

void WheelContactFinder::findInner(std::size_t wheel, const SlicePlane& middle, const Vec3& axis,
                                   std::size_t first) {
    const Discs& discs = discs_[wheel];
    const std::size_t outerEnd = contacts_.size();
    const auto begin = contacts_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto deepest = static_cast<std::size_t>(
        std::max_element(begin, contacts_.end(),
                         [](const Contact& a, const Contact& b) { return a.depth < b.depth; }) -
        contacts_.begin());
    int slice = slices_ - 1;
    for (std::size_t disc = 0; disc < discs.offsets().size(); ++disc) {
        if (discs.isOuter(disc)) {
            continue;
        }
        ++slice;
        const SlicePlane plane{middle.origin + discs.offsets()[disc] * axis, middle.u, middle.v};
        discs.sections.cut(disc, segments_);
        if (outerEnd > first && isOutdone(wheel, plane, contacts_[deepest])) {
            continue;
        }
        for (const SliceContact& contact : touch(wheel, plane)) {
            const bool bulge = std::none_of(
                contacts_.begin() + static_cast<std::ptrdiff_t>(first),
                contacts_.begin() + static_cast<std::ptrdiff_t>(outerEnd), [&](const Contact& c) {
                    return c.normal.dot(contact.normal) > kLikeNormal &&
                           c.depth > contact.depth - kBulge;
                });
            if (bulge) {
                add(static_cast<int>(wheel), slice, plane, axis, contact);
            }
        }
    }
}

// A face that leans in touches side and rim at one and the same point: the rim has it already.
void WheelContactFinder::findSides(std::size_t index, const SlicePlane& middle, const Vec3& axis,
                                   std::size_t first) {
    if (slices_ < 2) {
        return;
    }
    constexpr double kRimHasIt = 1e-3;  // [m], assumed
    const mechanism::Wheel& wheel = mechanism_.wheels[index];
    const Vec3& forward = middle.u;
    const Cylinder cylinder{middle.origin, axis, forward, wheel.radius, kOuterSlice * wheel.width};
    const std::vector<SideContact>& sides = side_.find(terrain_, cylinder, margin_);
    if (sides.empty()) {
        return;
    }
    dropOvertopped(sides, first);
    const std::size_t rimEnd = contacts_.size();
    for (const SideContact& contact : sides) {
        const bool known = std::any_of(contacts_.begin() + static_cast<std::ptrdiff_t>(first),
                                       contacts_.begin() + static_cast<std::ptrdiff_t>(rimEnd),
                                       [&](const Contact& c) {
                                           return c.normal.dot(contact.normal) > kLikeNormal &&
                                                  (c.point - contact.point).norm() < kRimHasIt;
                                       });
        if (!known) {
            const Vec3 along = forward - forward.dot(contact.normal) * contact.normal;
            contacts_.push_back({static_cast<int>(index), kSide, contact.point, contact.normal,
                                 along.normalized(), contact.depth});
        }
    }
}

// A wheel that slides sideways against a kerb has its outer slice a little inside the kerb, and
// deep below the kerb's top. It is to be held by its side, not thrown onto the kerb.
void WheelContactFinder::dropOvertopped(const std::vector<SideContact>& sides, std::size_t first) {
    constexpr double kDeep = 1e-3;  // [m], assumed: wheels that stand on something are less deep
    std::array<double, 2> sideDepth{-1.0, -1.0};  // of the slice against and along the axis
    for (const SideContact& side : sides) {
        double& depth = sideDepth[side.onAxisSide ? 1 : 0];
        depth = std::max(depth, side.depth);
    }
    kept_.clear();
    const auto begin = contacts_.begin() + static_cast<std::ptrdiff_t>(first);
    std::copy_if(begin, contacts_.end(), std::back_inserter(kept_), [&](const Contact& c) {
        const double depth = c.slice == 0             ? sideDepth[0]
                             : c.slice == slices_ - 1 ? sideDepth[1]
                                                      : -1.0;
        return depth <= 0.0 || c.depth <= std::max(depth, kDeep) ||
               std::any_of(begin, contacts_.end(), [&](const Contact& other) {
                   return other.slice != c.slice && other.depth > 0.5 * c.depth &&
                          other.normal.dot(c.normal) > kLikeNormal;
               });
    });
    contacts_.resize(first);
    contacts_.insert(contacts_.end(), kept_.begin(), kept_.end());
}

const std::vector<Contact>& WheelContactFinder::find(const std::vector<Pose>& bodies) {
    contacts_.clear();
    for (std::size_t i = 0; i < mechanism_.wheels.size(); ++i) {
        const mechanism::Wheel& wheel = mechanism_.wheels[i];
        const Pose& pose = bodies[static_cast<std::size_t>(wheel.body)];
        const Vec3 axis = pose.rotation * wheel.axis;
        const SlicePlane middle = planeOf(pose * wheel.center, axis);
        discs_[i].sections.move(terrain_, middle);
        const std::size_t first = contacts_.size();
        findOuter(i, middle, axis);
        findInner(i, middle, axis, first);
        findSides(i, middle, axis, first);
    }
    return contacts_;
}

}  // namespace simcore::contact
