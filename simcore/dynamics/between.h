#pragma once

#include <span>
#include <vector>

#include "simcore/dynamics/loop_closures.h"
#include "simcore/dynamics/spanning_tree.h"

/// What acts between two bodies, seen from the rates of a mechanism.
namespace simcore::dynamics {

/// Two bodies of the mechanism, and the rates that move the second against the first.
struct Between {
    int first = -1;
    int second = -1;
    std::vector<SignedRate> rates;
};

Between between(const SpanningTree& tree, int first, int second);

/// About a joint's axis, in world axes: unit torque on its second body.
Vec6 axisOf(const mechanism::Joint& joint, const TreeMotion& motion);

/// Rate of the second body against the first along a wrench [rad/s] or [m/s].
/// @param screws  of the pose
/// @param rates   all of the tree's
double rateAlong(const Between& between, const Vec6& wrench, const std::vector<Vec6>& screws,
                 std::span<const double> rates);

/// How a wrench on the second body pushes the independent rates: factors[i] at indices[i].
void pushOf(const Between& between, const Vec6& wrench, const TreeMotion& motion,
            const LoopClosures& loops, std::vector<int>& indices, std::vector<double>& factors);

}  // namespace simcore::dynamics
