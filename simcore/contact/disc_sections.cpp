#include "simcore/contact/disc_sections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simcore::contact {
namespace {

/// Triangles are looked up for so many steps like the last one, unless that takes the wheel further
/// than this [m]: more triangles are then near than looking them up less often saves.
constexpr double kSteps = 8.0;
constexpr double kFurthest = 0.004;

}  // namespace

DiscSections::DiscSections(std::vector<double> offsets, double radius)
    : offsets_(std::move(offsets)),
      radius_(radius),
      reach_(radius + std::max(std::abs(offsets_.front()), std::abs(offsets_.back()))) {
    near_.reset(offsets_.size());
}

/// Bound of the way of any of the discs' points [m].
double DiscSections::wayBetween(const Place& a, const Place& b) const {
    return (b.middle - a.middle).norm() + reach_ * (b.axis - a.axis).norm();
}

void DiscSections::move(const terrain::Terrain& terrain, const terrain::SlicePlane& middle) {
    const Place place{middle.origin, middle.v.cross(middle.u)};
    way_ = wayBetween(lookedUpAt_, place);
    if (slack_ < 0.0 || way_ > slack_) {
        const double ahead = last_ ? kSteps * wayBetween(*last_, place) : 0.0;
        slack_ = ahead < kFurthest ? ahead : 0.0;
        lookedUpAt_ = place;
        way_ = 0.0;
        terrain.findNear(middle, offsets_, radius_, slack_, near_);
    }
    last_ = place;
    near_.see(middle);
}

void DiscSections::cut(std::size_t disc, std::vector<terrain::SliceSegment>& out) const {
    near_.slice(disc, offsets_[disc], radius_, way_, out);
}

}  // namespace simcore::contact
