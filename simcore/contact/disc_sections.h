#pragma once

#include <optional>
#include <span>
#include <vector>

#include "simcore/terrain/terrain.h"

namespace simcore::contact {

/// Sections of the ground with a wheel's discs. The triangles near them are kept until the wheel
/// has left the place where they were looked up; what is found does not depend on that place.
class DiscSections {
  public:
    /// @param offsets  of the discs from the wheel's middle along its axis, ascending [m]
    /// @param radius   that sections come within [m]
    DiscSections(std::vector<double> offsets, double radius);

    /// Moves the wheel to a place.
    /// @param middle  plane of its middle, with v x u along its axis
    void move(const terrain::Terrain& terrain, const terrain::SlicePlane& middle);
    /// Section with a disc, there.
    void cut(std::size_t disc, std::vector<terrain::SliceSegment>& out) const;

    const std::vector<double>& offsets() const { return offsets_; }

  private:
    /// A place of the wheel.
    struct Place {
        Vec3 middle;
        Vec3 axis;
    };

    double wayBetween(const Place& a, const Place& b) const;

    std::vector<double> offsets_;
    double radius_;
    double reach_;  ///< of the discs from the wheel's middle [m]
    terrain::GroundPatch near_;
    std::optional<Place> last_;
    Place lookedUpAt_{Vec3::Zero(), Vec3::Zero()};
    double slack_ = -1.0;  ///< that they were looked up with [m]; < 0: not yet
    double way_ = 0.0;     ///< bound of that from there [m]
};

}  // namespace simcore::contact
