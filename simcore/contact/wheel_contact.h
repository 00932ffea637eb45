#pragma once

#include <vector>

#include "simcore/base/pose.h"
#include "simcore/mechanism/mechanism.h"
#include "simcore/terrain/terrain.h"

/// Where wheels touch the ground: geometry only, no forces.
namespace simcore::contact {

/// One contact point of one wheel.
struct Contact {
    int wheel = -1;
    int slice = 0;
    Vec3 point = Vec3::Zero();     ///< on the ground [m], world
    Vec3 normal = Vec3::UnitZ();   ///< unit, ground to wheel, world
    Vec3 forward = Vec3::UnitX();  ///< unit, axle x normal: the rolling direction, world
    double depth = 0.0;            ///< penetration [m], > 0 inside
};

/// Finds the contacts of every wheel. Each wheel is cut into `slices` discs; each disc is
/// intersected exactly with the terrain. A wheel at floor and wall touches twice per slice.
class WheelContactFinder {
  public:
    /// @param margin  contacts are reported from this far before touching [m]
    WheelContactFinder(const mechanism::Mechanism& mechanism, const terrain::Terrain& terrain,
                       int slices = 2, double margin = 0.0);

    /// Contacts at the given body poses X_WB, ordered by wheel and slice. Deterministic.
    const std::vector<Contact>& find(const std::vector<Pose>& bodies);

  private:
    const mechanism::Mechanism& mechanism_;
    const terrain::Terrain& terrain_;
    int slices_;
    double margin_;
    std::vector<terrain::SliceSegment> segments_;
    std::vector<Contact> contacts_;
};

}  // namespace simcore::contact
