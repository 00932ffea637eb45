#pragma once

#include <string>

#include "tests/bench/peers/height_grid.h"
#include "tests/bench/peers/peer_tree.h"

namespace peers {

/// Shape of a wheel in the peers: a solid of the wheel's radius and width; a sphere of its radius.
enum class WheelShape { Ellipsoid, Cylinder, Sphere };

std::string toString(WheelShape shape);

struct MjcfSettings {
    double step = 0.002;    ///< [s]
    double gravity = 9.81;  ///< along -z [m/s^2]
    double friction = 0.7;  ///< wheel-ground [-]
    WheelShape wheel = WheelShape::Ellipsoid;
};

/// MuJoCo's model of a rover and its ground: the text of an MJCF file without the heights, which go
/// into the field named "terrain" once the model is loaded, as shares of its elevation.
///
/// Every body's frame is ours, the rover frame carried along with the body, so poses need no
/// translation. Bodies, joints and wheels' geoms have our names; actuator `i` drives wheel `i`.
/// Inertias are explicit, a motor's rotor is `armature`. Loops are closed by `connect`.
///
/// Solver and contacts are set for grip without creep, as MuJoCo's documentation advises: Newton,
/// elliptic cones, a large impratio, and the shortest time constant that it allows, two steps. The
/// integrator is the implicit one.
std::string mjcfOf(const simcore::mechanism::Mechanism& mechanism, const PeerTree& tree,
                   const HeightGrid& ground, const MjcfSettings& settings);

/// Elevation of that field [m], over the ground's lowest point.
double elevation(const HeightGrid& ground);

/// Name of the ground's geom.
inline constexpr const char* kMjcfGround = "ground";

}  // namespace peers
