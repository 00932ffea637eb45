#pragma once

#include <vector>

#include "simcore/mechanism/mechanism.h"

namespace simcore::mechanism {

/// Mass, centre of mass and inertia of something rigid.
struct MassProperties {
    double mass = 0.0;            ///< [kg]
    Vec3 com = Vec3::Zero();      ///< [m]
    Mat3 inertia = Mat3::Zero();  ///< about com [kg m^2]
};

/// The two rigidly joined: Huygens-Steiner about the common centre of mass.
MassProperties merged(const MassProperties& a, const MassProperties& b);

/// Inertia about the shapes' common centroid of solid shapes of equal density that weigh `mass`
/// together [kg m^2]; zero for no shapes.
Mat3 inertiaOfShapes(const std::vector<Shape>& shapes, double mass);

/// Solid cylinder about its centre; `axis` unit [kg m^2].
Mat3 inertiaOfCylinder(double mass, double radius, double length, const Vec3& axis);

/// Empty when the tensor can belong to a body (positive semi-definite, triangle inequality of the
/// principal moments), else the reason.
std::string whyNotInertia(const Mat3& inertia);

}  // namespace simcore::mechanism
