#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "simcore/mechanism/mechanism.h"

/// Where to draw the graph of a mechanism: bodies as nodes, joints and wheel contacts as edges.
namespace simcore::mobility {

/// A place in the drawing: x in widths of a node, to the right; y in layers, downwards.
using GraphPoint = Eigen::Vector2d;

struct GraphEdge {
    int joint = -1;                ///< mechanism joint index; -1 for contacts
    int wheel = -1;                ///< wheel index for contacts, else -1
    std::vector<GraphPoint> path;  ///< from the first body to the second, or from wheel to ground
};

/// In layers: the chassis on top, every body as many layers below as there are joints to it, wheels
/// lowest but for the ground. What is on the rover's left stands on the left, its right side is the
/// mirror image. Deterministic; no two nodes share a place.
struct JointGraph {
    std::vector<GraphPoint> bodies;  ///< in the order of the mechanism's bodies
    bool hasGround = false;          ///< wheels stand on it
    GraphPoint ground = GraphPoint::Zero();
    std::vector<GraphEdge> edges;  ///< joints in their order, then wheels
};

JointGraph jointGraph(const mechanism::Mechanism& mechanism);

}  // namespace simcore::mobility
