#include "simcore/mobility/loops.h"

#include <algorithm>
#include <queue>
#include <set>

#include "simcore/mobility/constraint_system.h"
#include "simcore/mobility/factorisation.h"

namespace simcore::mobility {
namespace {

using Eigen::Index;
using EdgeSet = std::vector<bool>;

/// A joint or contact between two nodes.
struct Edge {
    int first;
    int second;
    std::string name;
    std::vector<Index> rows;  ///< of the Jacobian
};

struct Graph {
    int world = 0;  ///< node of ground and fixed bodies; bodies are nodes of their own index
    std::vector<Edge> edges;

    int nodes() const { return world + 1; }
};

Graph makeGraph(const mechanism::Mechanism& mechanism, const ConstraintJacobian& jacobian,
                const Stance& stance) {
    Graph graph;
    graph.world = static_cast<int>(mechanism.bodies.size());
    const auto node = [&](int body) {
        return mechanism.bodies[static_cast<std::size_t>(body)].fixed ? graph.world : body;
    };
    for (const mechanism::Joint& joint : mechanism.joints) {
        graph.edges.push_back({node(joint.first), node(joint.second), joint.name, {}});
    }
    std::vector<std::size_t> contact(mechanism.wheels.size());
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        if (stance.wheels[i].touching) {
            contact[i] = graph.edges.size();
            graph.edges.push_back({graph.world,
                                   node(mechanism.wheels[i].body),
                                   contactOf(mechanism.wheels[i].name),
                                   {}});
        }
    }
    for (std::size_t i = 0; i < jacobian.names.size(); ++i) {
        const ConstraintName& name = jacobian.names[i];
        if (name.kind != "gear") {
            const std::size_t edge = name.wheel >= 0 ? contact[static_cast<std::size_t>(name.wheel)]
                                                     : static_cast<std::size_t>(name.joint);
            graph.edges[edge].rows.push_back(static_cast<Index>(i));
        }
    }
    return graph;
}

/// Edge by which a breadth-first search from `root` reaches every node; -1 for those it does not.
std::vector<int> shortestPaths(const Graph& graph, int root) {
    std::vector<int> by(static_cast<std::size_t>(graph.nodes()), -1);
    std::vector<bool> seen(by.size(), false);
    std::queue<int> open;
    open.push(root);
    seen[static_cast<std::size_t>(root)] = true;
    while (!open.empty()) {
        const int node = open.front();
        open.pop();
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            const Edge& edge = graph.edges[e];
            if (edge.first != node && edge.second != node) {
                continue;
            }
            const int other = edge.first == node ? edge.second : edge.first;
            if (!seen[static_cast<std::size_t>(other)]) {
                seen[static_cast<std::size_t>(other)] = true;
                by[static_cast<std::size_t>(other)] = static_cast<int>(e);
                open.push(other);
            }
        }
    }
    return by;
}

/// Toggles the edges of the path from `node` back to the root.
void addPath(const Graph& graph, const std::vector<int>& by, int node, EdgeSet& cycle) {
    while (by[static_cast<std::size_t>(node)] >= 0) {
        const auto e = static_cast<std::size_t>(by[static_cast<std::size_t>(node)]);
        cycle[e] = !cycle[e];
        node = graph.edges[e].first == node ? graph.edges[e].second : graph.edges[e].first;
    }
}

/// A shortest basis of the cycles (Horton 1987): of all cycles made of an edge and the shortest
/// paths from its ends to one node, the shortest that are independent modulo 2.
std::vector<EdgeSet> shortestCycles(const Graph& graph) {
    std::vector<EdgeSet> candidates;
    for (int root = 0; root < graph.nodes(); ++root) {
        const std::vector<int> by = shortestPaths(graph, root);
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            EdgeSet cycle(graph.edges.size(), false);
            cycle[e] = true;
            addPath(graph, by, graph.edges[e].first, cycle);
            addPath(graph, by, graph.edges[e].second, cycle);
            const bool reached = by[static_cast<std::size_t>(graph.edges[e].first)] >= 0 ||
                                 graph.edges[e].first == root;
            if (reached && std::count(cycle.begin(), cycle.end(), true) > 0) {
                candidates.push_back(std::move(cycle));
            }
        }
    }
    std::stable_sort(candidates.begin(), candidates.end(), [](const EdgeSet& a, const EdgeSet& b) {
        return std::count(a.begin(), a.end(), true) < std::count(b.begin(), b.end(), true);
    });
    std::vector<EdgeSet> basis;
    std::vector<std::pair<std::size_t, EdgeSet>> reduced;  // first edge of each, and the rest
    for (const EdgeSet& candidate : candidates) {
        EdgeSet rest = candidate;
        for (const auto& [pivot, row] : reduced) {
            if (rest[pivot]) {
                std::transform(rest.begin(), rest.end(), row.begin(), rest.begin(),
                               [](bool a, bool b) { return a != b; });
            }
        }
        const auto pivot = std::find(rest.begin(), rest.end(), true);
        if (pivot != rest.end()) {
            reduced.emplace_back(pivot - rest.begin(), rest);
            basis.push_back(candidate);
        }
    }
    return basis;
}

/// Edges of a cycle in the order in which one meets them going round.
std::vector<std::size_t> goRound(const Graph& graph, const EdgeSet& cycle) {
    std::vector<std::size_t> left;
    for (std::size_t e = 0; e < cycle.size(); ++e) {
        if (cycle[e]) {
            left.push_back(e);
        }
    }
    std::vector<std::size_t> order{left.front()};
    int node = graph.edges[left.front()].second;
    left.erase(left.begin());
    while (!left.empty()) {
        const auto next = std::find_if(left.begin(), left.end(), [&](std::size_t e) {
            return graph.edges[e].first == node || graph.edges[e].second == node;
        });
        const Edge& edge = graph.edges[*next];
        node = edge.first == node ? edge.second : edge.first;
        order.push_back(*next);
        left.erase(next);
    }
    return order;
}

/// Counts of the given rows alone; the world, or else the first of `nodes`, is held.
void countAlone(const mechanism::Mechanism& mechanism, const ConstraintJacobian& jacobian,
                const Graph& graph, const std::set<int>& nodes, const std::vector<Index>& rows,
                Loop& loop) {
    loop.throughWorld = nodes.count(graph.world) > 0;
    const int held = loop.throughWorld ? graph.world : *nodes.begin();
    std::vector<Index> columns;
    for (const int node : nodes) {
        if (node != graph.world) {
            loop.bodies.push_back(mechanism.bodies[static_cast<std::size_t>(node)].name);
        }
        for (Index k = 0; k < 6 && node != held; ++k) {
            columns.push_back(jacobian.firstColumn[static_cast<std::size_t>(node)] + k);
        }
    }
    loop.rows = static_cast<int>(rows.size());
    loop.columns = static_cast<int>(columns.size());
    loop.gruebler = loop.columns - loop.rows;
    loop.rank = static_cast<int>(Factorisation(jacobian.matrix(rows, columns)).rank);
    loop.mobility = loop.columns - loop.rank;
    loop.redundant = loop.rows - loop.rank;
}

}  // namespace

std::vector<Loop> findLoops(const mechanism::Mechanism& mechanism, Model model,
                            const Stance& stance) {
    const ConstraintJacobian jacobian = constraintJacobian(mechanism, model, stance);
    const Graph graph = makeGraph(mechanism, jacobian, stance);
    std::vector<Loop> loops;
    for (const EdgeSet& cycle : shortestCycles(graph)) {
        Loop loop;
        std::set<int> nodes;
        std::vector<Index> rows;
        for (const std::size_t e : goRound(graph, cycle)) {
            const Edge& edge = graph.edges[e];
            nodes.insert({edge.first, edge.second});
            rows.insert(rows.end(), edge.rows.begin(), edge.rows.end());
            loop.joints.push_back(edge.name);
        }
        countAlone(mechanism, jacobian, graph, nodes, rows, loop);
        loops.push_back(std::move(loop));
    }
    Index gearRow = jacobian.matrix.rows() - static_cast<Index>(mechanism.gears.size());
    for (const mechanism::Gear& gear : mechanism.gears) {
        Loop loop;
        loop.gear = true;
        std::set<int> nodes;
        std::vector<Index> rows;
        for (const int joint : {gear.firstJoint, gear.secondJoint}) {
            const Edge& edge = graph.edges[static_cast<std::size_t>(joint)];
            nodes.insert({edge.first, edge.second});
            rows.insert(rows.end(), edge.rows.begin(), edge.rows.end());
            loop.joints.push_back(edge.name);
        }
        rows.push_back(gearRow++);
        loop.joints.push_back(gear.name);
        countAlone(mechanism, jacobian, graph, nodes, rows, loop);
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace simcore::mobility
