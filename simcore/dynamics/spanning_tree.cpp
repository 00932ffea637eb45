#include "simcore/dynamics/spanning_tree.h"

#include <algorithm>
#include <cmath>

namespace simcore::dynamics {
namespace {

using mechanism::FreedomKind;

/// A joint's freedoms from its first body to its second, or back: slides are carried by the first
/// body; of two turns the first body carries one axis and the second body the other.
std::vector<TreeElement> elementsOf(const mechanism::Joint& joint, mechanism::Model model,
                                    bool forwards) {
    const auto& freedoms = freedomsOf(joint, model);
    const double sign = forwards ? 1.0 : -1.0;
    std::vector<TreeElement> elements;
    elements.reserve(freedoms.size());
    for (const Vec3& direction : directionsOf(freedoms, FreedomKind::Slide)) {
        elements.push_back({TreeElement::Kind::Slide, sign * direction});
    }
    const std::vector<Vec3> turns = directionsOf(freedoms, FreedomKind::Turn);
    if (turns.size() == 3) {
        elements.push_back({TreeElement::Kind::Ball, Vec3::UnitY(), joint.point});
    } else {
        for (const Vec3& axis : turns) {
            elements.push_back({TreeElement::Kind::Turn, sign * axis, joint.point});
        }
    }
    if (!forwards) {
        std::reverse(elements.begin(), elements.end());
    }
    return elements;
}

/// Free in the world; turns are about the centre of mass, which keeps the mass matrix well made.
std::vector<TreeElement> floating(const mechanism::Body& body) {
    std::vector<TreeElement> elements;
    elements.reserve(4);
    for (int axis = 0; axis < 3; ++axis) {
        elements.push_back({TreeElement::Kind::Slide, Vec3::Unit(axis)});
    }
    elements.push_back({TreeElement::Kind::Ball, Vec3::UnitY(), body.com});
    return elements;
}

Eigen::Quaterniond turned(const Vec3& vector) {
    const double angle = vector.norm();
    if (angle < 1e-12) {
        return Eigen::Quaterniond(1.0, 0.5 * vector.x(), 0.5 * vector.y(), 0.5 * vector.z())
            .normalized();
    }
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace

SpanningTree::SpanningTree(const mechanism::Mechanism& mechanism, mechanism::Model model)
    : positions_(mechanism.bodies.size(), -1),
      reached_(mechanism.bodies.size(), false),
      jointUsed_(mechanism.joints.size(), false) {
    std::vector<int> starts;
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        reached_[i] = mechanism.bodies[i].fixed;
        starts.push_back(static_cast<int>(i));
    }
    std::swap(starts.front(), starts[static_cast<std::size_t>(mechanism.chassis)]);
    grow(-1, mechanism, model);
    for (int body : starts) {
        if (!reached_[static_cast<std::size_t>(body)]) {
            const int position = static_cast<int>(bodies_.size());
            add(body, -1, -1, floating(mechanism.bodies[static_cast<std::size_t>(body)]));
            grow(position, mechanism, model);
        }
    }
    for (std::size_t i = 0; i < jointUsed_.size(); ++i) {
        if (!jointUsed_[i]) {
            closures_.push_back(static_cast<int>(i));
        }
    }
}

// Breadth first keeps the ways to the world, and so the loops, short.
void SpanningTree::grow(int position, const mechanism::Mechanism& mechanism,
                        mechanism::Model model) {
    for (int at = position; at < static_cast<int>(bodies_.size()); ++at) {
        for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
            const mechanism::Joint& joint = mechanism.joints[i];
            for (const bool forwards : {true, false}) {
                const int from = forwards ? joint.first : joint.second;
                const int to = forwards ? joint.second : joint.first;
                const bool hangsHere = at >= 0
                                           ? bodies_[static_cast<std::size_t>(at)].body == from
                                           : mechanism.bodies[static_cast<std::size_t>(from)].fixed;
                if (hangsHere && !jointUsed_[i] && !reached_[static_cast<std::size_t>(to)]) {
                    jointUsed_[i] = true;
                    add(to, at, static_cast<int>(i), elementsOf(joint, model, forwards));
                }
            }
        }
    }
}

void SpanningTree::add(int body, int parent, int joint, std::vector<TreeElement> elements) {
    int last = parent < 0 ? -1 : bodies_[static_cast<std::size_t>(parent)].lastRate;
    for (TreeElement& element : elements) {
        element.rate = rateCount();
        if (element.kind == TreeElement::Kind::Ball) {
            element.ball = ballCount_++;
        }
        for (int k = 0; k < element.rateCount(); ++k) {
            rateParents_.push_back(last);
            last = rateCount() - 1;
        }
    }
    reached_[static_cast<std::size_t>(body)] = true;
    positions_[static_cast<std::size_t>(body)] = static_cast<int>(bodies_.size());
    bodies_.push_back({body, parent, joint, std::move(elements), last});
}

TreeState SpanningTree::drawnState() const {
    const auto n = static_cast<std::size_t>(rateCount());
    return {std::vector<double>(n, 0.0),
            std::vector<Eigen::Quaterniond>(static_cast<std::size_t>(ballCount_),
                                            Eigen::Quaterniond::Identity()),
            std::vector<double>(n, 0.0)};
}

std::vector<SignedRate> relativeRates(const SpanningTree& tree, int first, int second) {
    const auto way = [&tree](int body) {
        std::vector<int> rates;
        const int position = tree.positionOf(body);
        int rate = position < 0 ? -1 : tree.bodies()[static_cast<std::size_t>(position)].lastRate;
        for (; rate >= 0; rate = tree.rateBefore(rate)) {
            rates.push_back(rate);
        }
        return rates;
    };
    const std::vector<int> toFirst = way(first);
    const std::vector<int> toSecond = way(second);
    std::vector<SignedRate> relative;
    const auto addMissing = [&relative](const std::vector<int>& of, const std::vector<int>& in,
                                        double sign) {
        for (int rate : of) {
            if (std::find(in.begin(), in.end(), rate) == in.end()) {
                relative.push_back({rate, sign});
            }
        }
    };
    addMissing(toSecond, toFirst, 1.0);
    addMissing(toFirst, toSecond, -1.0);
    return relative;
}

void pushBetween(const SpanningTree& tree, int first, int second, const Vec6& wrench,
                 std::vector<Vec6>& wrenches) {
    if (const int at = tree.positionOf(second); at >= 0) {
        wrenches[static_cast<std::size_t>(at)] += wrench;
    }
    if (const int at = tree.positionOf(first); at >= 0) {
        wrenches[static_cast<std::size_t>(at)] -= wrench;
    }
}

void advance(const SpanningTree& tree, TreeState& state, std::span<const double> change) {
    for (const TreeBody& at : tree.bodies()) {
        for (const TreeElement& element : at.elements) {
            const auto rate = static_cast<std::size_t>(element.rate);
            if (element.kind == TreeElement::Kind::Ball) {
                const Vec3 turn(change[rate], change[rate + 1], change[rate + 2]);
                if (!turn.isZero(0.0)) {
                    Eigen::Quaterniond& ball = state.balls[static_cast<std::size_t>(element.ball)];
                    ball = (turned(turn) * ball).normalized();
                }
            } else {
                state.coordinates[rate] += change[rate];
            }
        }
    }
}

TreeMotion::TreeMotion(const mechanism::Mechanism& mechanism, const SpanningTree& tree)
    : mechanism_(mechanism),
      tree_(tree),
      poses_(mechanism.bodies.size()),
      turns_(tree.bodies().size(), Mat3::Identity()),
      origins_(tree.bodies().size(), Vec3::Zero()),
      moved_(tree.bodies().size(), false),
      screws_(static_cast<std::size_t>(tree.rateCount()), Vec6::Zero()),
      inertias_(tree.bodies().size()),
      composites_(tree.bodies().size()),
      twists_(tree.bodies().size(), Vec6::Zero()),
      accelerations_(tree.bodies().size(), Vec6::Zero()),
      forces_(tree.bodies().size(), Vec6::Zero()) {
    for (const TreeBody& at : tree.bodies()) {
        inertiasAtCom_.push_back(mechanism.inertiaWithRotor(static_cast<std::size_t>(at.body)));
    }
}

void TreeMotion::place(const TreeState& state) {
    for (std::size_t k = 0; k < tree_.bodies().size(); ++k) {
        placeBody(k, state);
    }
}

void TreeMotion::placeChanged(const TreeState& state, std::span<const double> change) {
    for (std::size_t k = 0; k < tree_.bodies().size(); ++k) {
        const TreeBody& at = tree_.bodies()[k];
        bool moved = at.parent >= 0 && moved_[static_cast<std::size_t>(at.parent)];
        for (const TreeElement& element : at.elements) {
            for (int i = 0; i < element.rateCount(); ++i) {
                moved = moved || change[static_cast<std::size_t>(element.rate + i)] != 0.0;
            }
        }
        moved_[k] = moved;
        if (moved) {
            placeBody(k, state);
        }
    }
}

/// All that it hangs from is in place.
void TreeMotion::placeBody(std::size_t position, const TreeState& state) {
    const TreeBody& at = tree_.bodies()[position];
    Pose pose;
    Mat3 turn = Mat3::Identity();
    if (at.parent >= 0) {
        const auto parent = static_cast<std::size_t>(at.parent);
        pose = poses_[static_cast<std::size_t>(tree_.bodies()[parent].body)];
        turn = turns_[parent];
    }
    for (const TreeElement& element : at.elements) {
        const auto rate = static_cast<std::size_t>(element.rate);
        switch (element.kind) {
            case TreeElement::Kind::Slide: {
                const Vec3 axis = turn * element.axis;
                screws_[rate] = slideAlong(axis);
                pose.position += state.coordinates[rate] * axis;
                break;
            }
            case TreeElement::Kind::Turn: {
                const Vec3 point = turn * element.point + pose.position;
                screws_[rate] = turnAt(turn * element.axis, point);
                pose.rotation = pose.rotation * Eigen::Quaterniond(Eigen::AngleAxisd(
                                                    state.coordinates[rate], element.axis));
                turn = pose.rotation.toRotationMatrix();
                pose.position = point - turn * element.point;
                break;
            }
            case TreeElement::Kind::Ball: {
                const Vec3 point = turn * element.point + pose.position;
                for (int i = 0; i < 3; ++i) {
                    screws_[rate + static_cast<std::size_t>(i)] = turnAt(turn.col(i), point);
                }
                pose.rotation = pose.rotation * state.balls[static_cast<std::size_t>(element.ball)];
                turn = pose.rotation.toRotationMatrix();
                pose.position = point - turn * element.point;
                break;
            }
        }
    }
    const auto body = static_cast<std::size_t>(at.body);
    poses_[body] = pose;
    turns_[position] = turn;
    Vec3& origin = origins_[position];
    if (at.parent >= 0) {
        origin = origins_[static_cast<std::size_t>(at.parent)];
    } else if (at.joint < 0) {
        origin = turn * mechanism_.bodies[body].com + pose.position;
    }
    for (const TreeElement& element : at.elements) {
        for (int i = 0; i < element.rateCount(); ++i) {
            Vec6& screw = screws_[static_cast<std::size_t>(element.rate + i)];
            screw.tail<3>() -= origin.cross(screw.head<3>());
        }
    }
}

void TreeMotion::weigh() {
    for (std::size_t k = 0; k < inertias_.size(); ++k) {
        const auto index = static_cast<std::size_t>(tree_.bodies()[k].body);
        const mechanism::Body& body = mechanism_.bodies[index];
        const Mat3& R = turns_[k];
        inertias_[k] =
            SpatialInertia::of(body.mass, R * body.com + poses_[index].position - origins_[k],
                               R * inertiasAtCom_[k] * R.transpose());
    }
}

void TreeMotion::twists(std::span<const double> rates, std::vector<Vec6>& twists) const {
    for (std::size_t k = 0; k < tree_.bodies().size(); ++k) {
        const TreeBody& at = tree_.bodies()[k];
        Vec6 twist = Vec6::Zero();
        if (at.parent >= 0) {
            twist = twists[static_cast<std::size_t>(at.parent)];
        }
        for (const TreeElement& element : at.elements) {
            for (int i = 0; i < element.rateCount(); ++i) {
                const auto rate = static_cast<std::size_t>(element.rate + i);
                twist += rates[rate] * screws_[rate];
            }
        }
        twists[k] = twist;
    }
}

void TreeMotion::inverseDynamics(std::span<const double> rates,
                                 std::span<const double> accelerations, double gravity,
                                 const std::vector<Vec6>& wrenches, std::vector<double>& forces,
                                 std::vector<Vec6>* transmitted) {
    const auto& bodies = tree_.bodies();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const TreeBody& at = bodies[k];
        Vec6 twist = Vec6::Zero();
        // The world is lifted instead of pulling everything down.
        Vec6 acceleration = slideAlong({0.0, 0.0, gravity});
        if (at.parent >= 0) {
            twist = twists_[static_cast<std::size_t>(at.parent)];
            acceleration = accelerations_[static_cast<std::size_t>(at.parent)];
        }
        for (const TreeElement& element : at.elements) {
            // A ball's three axes are all carried by what comes before it.
            const Vec6 carrier = twist;
            for (int i = 0; i < element.rateCount(); ++i) {
                const auto rate = static_cast<std::size_t>(element.rate + i);
                acceleration += crossMotion(carrier, screws_[rate]) * rates[rate] +
                                screws_[rate] * accelerations[rate];
                twist += screws_[rate] * rates[rate];
            }
        }
        twists_[k] = twist;
        accelerations_[k] = acceleration;
        forces_[k] =
            inertias_[k] * acceleration + crossForce(twist, inertias_[k] * twist) - wrenches[k];
    }
    for (std::size_t k = bodies.size(); k-- > 0;) {
        const TreeBody& at = bodies[k];
        for (const TreeElement& element : at.elements) {
            for (int i = 0; i < element.rateCount(); ++i) {
                const auto rate = static_cast<std::size_t>(element.rate + i);
                forces[rate] = screws_[rate].dot(forces_[k]);
            }
        }
        if (at.parent >= 0) {
            forces_[static_cast<std::size_t>(at.parent)] += forces_[k];
        }
    }
    if (transmitted != nullptr) {
        *transmitted = forces_;
    }
}

}  // namespace simcore::dynamics
