#include "simcore/contact/disc_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simcore::contact {
namespace {

/// Triangles are looked up for so many steps like the last one, unless that takes the wheel further
/// than this [m]: more triangles are then near than looking them up less often saves.
constexpr double kSteps = 6.0;
constexpr double kFurthest = 0.003;

}  // namespace

DiscSections::DiscSections(std::vector<double> offsets, double radius)
    : offsets_(std::move(offsets)),
      radius_(radius),
      reach_(radius + std::max(std::abs(offsets_.front()), std::abs(offsets_.back()))),
      near_(offsets_.size()) {
    // More than any usual ground asks for, so that a drive takes nothing more from the heap.
    constexpr std::size_t kRoom = 256;
    for (std::vector<int>& triangles : near_) {
        triangles.reserve(kRoom);
    }
}

/// Bound of the way of any of the discs' points [m].
double DiscSections::wayBetween(const Place& a, const Place& b) const {
    return (b.middle - a.middle).norm() + reach_ * (b.axis - a.axis).norm();
}

void DiscSections::cut(const terrain::Terrain& terrain, const terrain::SlicePlane& middle,
                       std::span<std::vector<terrain::SliceSegment>> out) {
    const Place place{middle.origin, middle.v.cross(middle.u)};
    if (slack_ < 0.0 || wayBetween(lookedUpAt_, place) > slack_) {
        const double ahead = last_ ? kSteps * wayBetween(*last_, place) : 0.0;
        slack_ = ahead < kFurthest ? ahead : 0.0;
        lookedUpAt_ = place;
        terrain.findNear(middle, offsets_, radius_, slack_, near_);
    }
    last_ = place;
    for (std::size_t disc = 0; disc < offsets_.size(); ++disc) {
        terrain.slice(middle, offsets_[disc], radius_, near_[disc], out[disc]);
    }
}

}  // namespace simcore::contact
