#pragma once

#include <vector>

#include "simcore/base/pose.h"
#include "simcore/contact/disc_sections.h"
#include "simcore/contact/side_contacts.h"
#include "simcore/contact/slice_contacts.h"
#include "simcore/mechanism/mechanism.h"
#include "simcore/terrain/terrain.h"

/// Where wheels touch the ground: geometry only, no forces.
namespace simcore::contact {

/// `Contact::slice` of contacts on a wheel's sides.
inline constexpr int kSide = -1;

/// One contact point of one wheel, or of a body that is no wheel.
struct Contact {
    int wheel = -1;  ///< -1: of `body`
    /// Outer ones first, then inner ones, each from right to left; kSide for the flat sides.
    int slice = 0;
    Vec3 point = Vec3::Zero();     ///< on the ground [m], world
    Vec3 normal = Vec3::UnitZ();   ///< unit, ground to wheel, world
    Vec3 forward = Vec3::UnitX();  ///< unit, the rolling direction, square to the normal, world
    double depth = 0.0;            ///< penetration [m], > 0 inside
    int body = -1;                 ///< where no wheel touches: the body that does
    /// Of a wheel's rim on an edge: cosine of the angle by which the ground turns there.
    double turnCosine = 1.0;
};

/// The body that touches.
inline int bodyOf(const Contact& contact, const mechanism::Mechanism& mechanism) {
    return contact.wheel >= 0 ? mechanism.wheels[static_cast<std::size_t>(contact.wheel)].body
                              : contact.body;
}

/// Whether two contacts are on one wheel, or on one body that is no wheel.
inline bool onSamePart(const Contact& a, const Contact& b) {
    return a.wheel == b.wheel && (a.wheel >= 0 || a.body == b.body);
}

/// Finds the contacts of every wheel. Each wheel is cut into `slices` discs; each disc is
/// intersected exactly with the terrain. A wheel at floor and wall touches twice per slice. On
/// ground that differs across the rover, inner discs find what stands between the slices. Walls
/// that run along a wheel touch its flat sides, where the outer slices are.
class WheelContactFinder {
  public:
    /// @param margin  contacts are reported from this far before touching [m]
    WheelContactFinder(const mechanism::Mechanism& mechanism, const terrain::Terrain& terrain,
                       int slices = 2, double margin = 0.0);

    /// Contacts at the given body poses X_WB, ordered by wheel and slice. Deterministic.
    const std::vector<Contact>& find(const std::vector<Pose>& bodies);

  private:
    /// A wheel cut into discs.
    struct Discs {
        DiscSections sections;
        std::size_t perGap;  ///< discs from one outer one to the next

        const std::vector<double>& offsets() const { return sections.offsets(); }

        bool isOuter(std::size_t disc) const { return disc % perGap == 0; }
    };

    /// A disc whose centre is under ground.
    struct Buried {
        int slice;
        terrain::SlicePlane plane;
        SliceContact contact;
    };

    Discs discsOf(const mechanism::Wheel& wheel) const;
    const std::vector<SliceContact>& touch(std::size_t wheel, const terrain::SlicePlane& plane);
    bool isOutdone(std::size_t wheel, const terrain::SlicePlane& plane, const Contact& by) const;
    void add(int wheel, int slice, const terrain::SlicePlane& plane, const Vec3& axis,
             const SliceContact& contact);
    void findOuter(std::size_t wheel, const terrain::SlicePlane& middle, const Vec3& axis);
    void findInner(std::size_t wheel, const terrain::SlicePlane& middle, const Vec3& axis,
                   std::size_t first);
    void findSides(std::size_t wheel, const terrain::SlicePlane& middle, const Vec3& axis,
                   std::size_t first);
    void dropOvertopped(const std::vector<SideContact>& sides, std::size_t first);

    const mechanism::Mechanism& mechanism_;
    const terrain::Terrain& terrain_;
    int slices_;
    double margin_;
    std::vector<Discs> discs_;  ///< of every wheel
    SliceContactFinder slice_;
    SideContactFinder side_;
    std::vector<Buried> buried_;
    std::vector<terrain::SliceSegment> segments_;  ///< of a disc
    std::vector<Contact> contacts_;
    std::vector<Contact> kept_;
};

}  // namespace simcore::contact
