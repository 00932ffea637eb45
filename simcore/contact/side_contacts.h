#pragma once

#include <array>
#include <vector>

#include "simcore/terrain/terrain.h"

/// Where the flat sides of a wheel touch walls that run along it.
namespace simcore::contact {

/// A touching point of a side.
struct SideContact {
    Vec3 point = Vec3::Zero();   ///< on the ground, world [m]
    Vec3 normal = Vec3::Zero();  ///< unit, ground to wheel, world
    double depth = 0.0;          ///< penetration along the normal [m], > 0 inside
    bool onAxisSide = true;      ///< of the two sides, that to which the axis points
};

/// The solid that the sides bound: a cylinder about an axle.
struct Cylinder {
    Vec3 center;       ///< world [m]
    Vec3 axis;         ///< unit, world
    Vec3 forward;      ///< unit, square to the axis, does not turn with the wheel
    double radius;     ///< [m]
    double halfWidth;  ///< from the middle to each side [m]
};

/// Finds the deepest points of faces that reach through a side into a wheel. Only faces that look
/// along the axle, within 45 deg, are a side's; others meet the rim first. Keeps its work space.
class SideContactFinder {
  public:
    SideContactFinder();

    /// Contacts deeper than -margin, the deepest of each quarter of each side. Left out is what the
    /// wheel leaves on a shorter way by its rim, as the edge of a ledge that it stands on, and what
    /// is deeper than 5 mm or beyond the wheel's middle: a wheel is not thrown out of a wall that
    /// it did not drive into.
    const std::vector<SideContact>& find(const terrain::Terrain& terrain, const Cylinder& wheel,
                                         double margin);

  private:
    void touch(const terrain::Facet& facet, const Cylinder& wheel, double margin);

    /// A quarter of a side.
    struct Quarter {
        bool touches = false;
        double rank = 0.0;  ///< by which the deepest is chosen
        SideContact deepest;
    };

    /// The faces that reach into one side.
    struct Side {
        std::array<Quarter, 4> quarters;
        double reach = 0.0;  ///< from the rim towards the axle [m]
    };

    std::vector<terrain::Facet> facets_;
    std::array<Side, 2> sides_;  ///< the axis' first
    std::vector<SideContact> contacts_;
};

}  // namespace simcore::contact
