#include "simcore/mobility/joint_graph.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace simcore::mobility {
namespace {

constexpr double kOnTheMiddle = 1e-6;  // [m]

/// A body, or where an edge that goes over several layers passes one between.
struct Node {
    int body = -1;  ///< of a passage: the lower body of its edge
    int layer = 0;
    std::vector<std::size_t> above;  ///< nodes of the layer above that it is joined to
    double x = 0.0;
};

class Layout {
  public:
    explicit Layout(const mechanism::Mechanism& mechanism) : mechanism_(mechanism) {}

    JointGraph make() {
        placeInLayers();
        for (const mechanism::Joint& joint : mechanism_.joints) {
            paths_.push_back(pathOf(joint));
        }
        for (int layer = 0; layer <= lowest_; ++layer) {
            spread(layer);
        }
        return drawn();
    }

  private:
    /// 1: left, -1: right, 0: in the middle.
    int sideOf(int body) const {
        const double y = mechanism_.bodies[static_cast<std::size_t>(body)].com.y();
        return std::abs(y) < kOnTheMiddle ? 0 : (y > 0.0 ? 1 : -1);
    }

    void placeInLayers() {
        const std::size_t count = mechanism_.bodies.size();
        std::vector<int> depth(count, -1);
        std::queue<int> next;
        if (count > 0) {
            depth[static_cast<std::size_t>(mechanism_.chassis)] = 0;
            next.push(mechanism_.chassis);
        }
        while (!next.empty()) {
            const int body = next.front();
            next.pop();
            for (const mechanism::Joint& joint : mechanism_.joints) {
                if (joint.first == body || joint.second == body) {
                    const int other = joint.first == body ? joint.second : joint.first;
                    int& there = depth[static_cast<std::size_t>(other)];
                    if (there < 0) {
                        there = depth[static_cast<std::size_t>(body)] + 1;
                        next.push(other);
                    }
                }
            }
        }
        for (int& one : depth) {
            one = one < 0 ? 1 : one;  // what nothing holds
        }
        std::vector<bool> isWheel(count, false);
        for (const mechanism::Wheel& wheel : mechanism_.wheels) {
            isWheel[static_cast<std::size_t>(wheel.body)] = true;
        }
        for (std::size_t b = 0; b < count; ++b) {
            lowest_ = std::max(lowest_, depth[b] + (isWheel[b] ? 0 : 1));
        }
        if (mechanism_.wheels.empty()) {
            --lowest_;
        }
        for (std::size_t b = 0; b < count; ++b) {
            nodes_.push_back({static_cast<int>(b), isWheel[b] ? lowest_ : depth[b], {}, 0.0});
        }
    }

    /// Nodes from the first body to the second, with passages through the layers between.
    std::vector<std::size_t> pathOf(const mechanism::Joint& joint) {
        auto upper = static_cast<std::size_t>(joint.first);
        auto lower = static_cast<std::size_t>(joint.second);
        const bool turned = nodes_[upper].layer > nodes_[lower].layer;
        if (turned) {
            std::swap(upper, lower);
        }
        std::vector<std::size_t> path{upper};
        for (int layer = nodes_[upper].layer + 1; layer < nodes_[lower].layer; ++layer) {
            nodes_.push_back({nodes_[lower].body, layer, {path.back()}, 0.0});
            path.push_back(nodes_.size() - 1);
        }
        if (nodes_[lower].layer > nodes_[upper].layer) {
            nodes_[lower].above.push_back(path.back());
        }
        path.push_back(lower);
        if (turned) {
            std::reverse(path.begin(), path.end());
        }
        return path;
    }

    /// Mean place of what is above, mirrored to the left.
    double wantedPlace(const Node& node) const {
        double sum = 0.0;
        for (const std::size_t above : node.above) {
            sum += nodes_[above].x * (sideOf(node.body) < 0 ? -1.0 : 1.0);
        }
        return node.above.empty() ? 0.0 : sum / static_cast<double>(node.above.size());
    }

    void spread(int layer) {
        std::array<std::vector<std::size_t>, 3> groups;  // right, middle, left
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (nodes_[i].layer == layer) {
                groups.at(static_cast<std::size_t>(sideOf(nodes_[i].body) + 1)).push_back(i);
            }
        }
        for (std::vector<std::size_t>& group : groups) {
            std::stable_sort(group.begin(), group.end(), [&](std::size_t a, std::size_t b) {
                const double placeA = wantedPlace(nodes_[a]);
                const double placeB = wantedPlace(nodes_[b]);
                if (std::abs(placeA - placeB) > 1e-9) {
                    return placeA < placeB;
                }
                return comX(nodes_[a]) > comX(nodes_[b]) + kOnTheMiddle;
            });
        }
        // The outer ones of a side come first in its order: left ends are small.
        const double half = 0.5 * static_cast<double>(groups[1].size());
        for (std::size_t k = 0; k < groups[1].size(); ++k) {
            nodes_[groups[1][k]].x = static_cast<double>(k) + 0.5 - half;
        }
        for (const std::size_t side : {0U, 2U}) {
            const std::vector<std::size_t>& group = groups.at(side);
            for (std::size_t k = 0; k < group.size(); ++k) {
                const double outwards = half + static_cast<double>(group.size() - k) - 0.5;
                nodes_[group[k]].x = side == 2 ? -outwards : outwards;
            }
        }
    }

    double comX(const Node& node) const {
        return mechanism_.bodies[static_cast<std::size_t>(node.body)].com.x();
    }

    JointGraph drawn() const {
        JointGraph graph;
        const auto placeOf = [&](std::size_t node) {
            return GraphPoint(nodes_[node].x, nodes_[node].layer);
        };
        for (std::size_t b = 0; b < mechanism_.bodies.size(); ++b) {
            graph.bodies.push_back(placeOf(b));
        }
        for (std::size_t j = 0; j < paths_.size(); ++j) {
            GraphEdge edge;
            edge.joint = static_cast<int>(j);
            for (const std::size_t node : paths_[j]) {
                edge.path.push_back(placeOf(node));
            }
            graph.edges.push_back(std::move(edge));
        }
        graph.hasGround = !mechanism_.wheels.empty();
        graph.ground = GraphPoint(0.0, lowest_ + 1);
        for (std::size_t w = 0; w < mechanism_.wheels.size(); ++w) {
            GraphEdge edge;
            edge.wheel = static_cast<int>(w);
            const GraphPoint wheel = placeOf(static_cast<std::size_t>(mechanism_.wheels[w].body));
            // The ground is as wide as the rover.
            edge.path = {wheel, {wheel.x(), graph.ground.y()}};
            graph.edges.push_back(std::move(edge));
        }
        return graph;
    }

    const mechanism::Mechanism& mechanism_;
    std::vector<Node> nodes_;  ///< bodies first
    std::vector<std::vector<std::size_t>> paths_;
    int lowest_ = 0;
};

}  // namespace

JointGraph jointGraph(const mechanism::Mechanism& mechanism) {
    return Layout(mechanism).make();
}

}  // namespace simcore::mobility
