#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/mechanism/freedoms.h"

/// Other engines ("peers") set beside ours on the same rover and ground.
namespace peers {

using simcore::Mat3;
using simcore::Problems;
using simcore::Result;
using simcore::Vec3;

/// A body and the pin that it hangs on. Geometry is in rover axes at the drawn pose.
struct Link {
    int body = -1;    ///< of the mechanism
    int parent = -1;  ///< position in the tree; -1 = floats
    int joint = -1;   ///< of the mechanism; -1 = floats
    Vec3 point = Vec3::Zero();
    Vec3 axis = Vec3::UnitY();  ///< unit; of a wheel, the wheel's own: + rolls forward
    /// Torque on the link about the axis: preload - stiffness turn - damping rate [N m].
    double preload = 0.0, stiffness = 0.0, damping = 0.0;
    std::optional<std::pair<double, double>> stops;  ///< of the turn [rad]
    int wheel = -1;                                  ///< of the mechanism; -1 = none
};

/// A pin that closes a loop, as a point that two links share.
struct Closure {
    int joint = -1;   ///< of the mechanism
    int first = -1;   ///< position in the tree
    int second = -1;  ///< position in the tree
    Vec3 point = Vec3::Zero();
};

/// A mechanism as these engines want it: a floating chassis, links on pins, and points that close
/// loops.
struct PeerTree {
    std::vector<Link> links;  ///< each after its parent; the first one is the chassis
    std::vector<Closure> closures;
};

/// The spanning tree of our own engine in these terms. A loop may be closed by a point where the
/// rest of the pin follows from it: all axes of the loop parallel; or by a ball. Problems: whatever
/// a peer could not be given without changing the rover.
Result<PeerTree> peerTreeOf(const simcore::mechanism::Mechanism& mechanism,
                            simcore::mechanism::Model model = simcore::mechanism::Model::Built);

}  // namespace peers
