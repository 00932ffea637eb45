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

    /// At a place of the wheel.
    /// @param middle  plane of its middle, with v x u along its axis
    /// @param out     for each disc
    void cut(const terrain::Terrain& terrain, const terrain::SlicePlane& middle,
             std::span<std::vector<terrain::SliceSegment>> out);

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
    std::vector<std::vector<int>> near_;
    std::optional<Place> last_;
    Place lookedUpAt_{Vec3::Zero(), Vec3::Zero()};
    double slack_ = -1.0;  ///< that they were looked up with [m]; < 0: not yet
};

}  // namespace simcore::contact
