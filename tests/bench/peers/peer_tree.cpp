#include "tests/bench/peers/peer_tree.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "simcore/dynamics/spanning_tree.h"

namespace peers {
namespace {

using simcore::Problem;
using simcore::Severity;
using simcore::dynamics::SpanningTree;
using simcore::dynamics::TreeBody;
using simcore::dynamics::TreeElement;
using simcore::mechanism::FreedomKind;
using simcore::mechanism::Joint;
using simcore::mechanism::Mechanism;
using simcore::mechanism::Model;
using simcore::mechanism::Spring;
using simcore::mechanism::Wheel;

// Sine of the angle up to which axes count as parallel: rounding of what a project file says.
constexpr double kParallel = 1e-9;

bool parallel(const Vec3& a, const Vec3& b) {
    return a.cross(b).norm() < kParallel;
}

class TreeMaker {
  public:
    TreeMaker(const Mechanism& mechanism, Model model)
        : mechanism_(mechanism),
          model_(model),
          spanning_(mechanism, model) {}

    Result<PeerTree> make() {
        refuseWhatIsOutside();
        for (const TreeBody& at : spanning_.bodies()) {
            tree_.links.push_back(at.joint < 0 ? root(at) : hanging(at));
        }
        for (const Wheel& wheel : mechanism_.wheels) {
            placeWheel(wheel);
        }
        for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
            takeStopsAndDamping(static_cast<int>(i));
        }
        for (const Spring& spring : mechanism_.springs) {
            takeSpring(spring);
        }
        for (const int joint : spanning_.closures()) {
            close(joint);
        }
        if (!problems_.empty()) {
            return problems_;
        }
        return tree_;
    }

  private:
    void refuse(const std::string& element, const std::string& reason) {
        problems_.push_back(
            {Severity::Critical, element, reason, "Compare the engines on a rover without it."});
    }

    const Joint& jointAt(int joint) const {
        return mechanism_.joints[static_cast<std::size_t>(joint)];
    }

    void refuseWhatIsOutside() {
        for (const auto& body : mechanism_.bodies) {
            if (body.fixed) {
                refuse("body " + body.name,
                       "the peers' rovers float, nothing is held in the world.");
            }
        }
        for (const auto& gear : mechanism_.gears) {
            refuse("gear " + gear.name, "gears are not given to the peers.");
        }
    }

    Link root(const TreeBody& at) {
        if (at.body != mechanism_.chassis) {
            refuse("body " + mechanism_.bodies[static_cast<std::size_t>(at.body)].name,
                   "it does not hang on the chassis.");
        }
        Link link;
        link.body = at.body;
        return link;
    }

    Link hanging(const TreeBody& at) {
        const Joint& joint = jointAt(at.joint);
        Link link;
        link.body = at.body;
        link.parent = at.parent;
        link.joint = at.joint;
        link.point = joint.point;
        const bool pin =
            at.elements.size() == 1 && at.elements.front().kind == TreeElement::Kind::Turn;
        if (!pin) {
            refuse("joint " + joint.name,
                   "it is no pin: slides, balls and joints of several "
                   "freedoms are not given to the peers.");
            return link;
        }
        link.axis = at.elements.front().axis;
        return link;
    }

    void placeWheel(const Wheel& wheel) {
        const int position = spanning_.positionOf(wheel.body);
        if (position < 0 || linkAt(position).joint != wheel.axle ||
            !parallel(linkAt(position).axis, wheel.axis)) {
            refuse("wheel " + wheel.name, "it does not hang on its axle.");
            return;
        }
        linkAt(position).axis = wheel.axis;
        linkAt(position).wheel = static_cast<int>(&wheel - mechanism_.wheels.data());
    }

    /// The link that hangs on a joint; null for one that closes a loop.
    Link* linkOn(int joint) {
        const auto found = std::find_if(tree_.links.begin(), tree_.links.end(),
                                        [&](const Link& link) { return link.joint == joint; });
        return found == tree_.links.end() ? nullptr : &*found;
    }

    /// Turn of the joint's second body about the joint's axis per turn of the link: 1 or -1; 0 when
    /// the axis is not the pin's.
    double turnOf(const Link& link) const {
        const Joint& joint = jointAt(link.joint);
        if (!parallel(link.axis, joint.axis)) {
            return 0.0;
        }
        const double sign = link.axis.dot(joint.axis) > 0.0 ? 1.0 : -1.0;
        return joint.second == link.body ? sign : -sign;
    }

    void takeStopsAndDamping(int index) {
        const Joint& joint = jointAt(index);
        if (!joint.stops && joint.damping == 0.0) {
            return;
        }
        Link* link = linkOn(index);
        const double turn = link != nullptr ? turnOf(*link) : 0.0;
        if (turn == 0.0) {
            refuse("joint " + joint.name,
                   "stops and damping are given to the peers only about pins of the tree.");
            return;
        }
        link->damping += joint.damping;
        if (joint.stops) {
            const auto [low, high] = *joint.stops;
            link->stops = turn > 0.0 ? std::pair(low, high) : std::pair(-high, -low);
        }
    }

    void takeSpring(const Spring& spring) {
        Link* link = spring.joint >= 0 ? linkOn(spring.joint) : nullptr;
        const double turn = link != nullptr ? turnOf(*link) : 0.0;
        if (turn == 0.0) {
            refuse("spring " + spring.name,
                   "only torsion springs about pins of the tree are given to the peers.");
            return;
        }
        if (spring.preload != 0.0 && spring.stiffness <= 0.0) {
            refuse("spring " + spring.name, "a torque without stiffness has no angle of rest.");
            return;
        }
        link->preload += turn * spring.preload;
        link->stiffness += spring.stiffness;
        link->damping += spring.damping;
    }

    Link& linkAt(int position) { return tree_.links[static_cast<std::size_t>(position)]; }

    /// Links that move one end of a loop against the other: those on the way from just one of them.
    std::vector<int> around(int first, int second) {
        const auto way = [this](int position) {
            std::set<int> links;
            for (; position >= 0; position = linkAt(position).parent) {
                links.insert(position);
            }
            return links;
        };
        const std::set<int> a = way(first);
        const std::set<int> b = way(second);
        std::vector<int> links;
        std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                      std::back_inserter(links));
        return links;
    }

    void close(int index) {
        const Joint& joint = jointAt(index);
        const Closure closure{index, spanning_.positionOf(joint.first),
                              spanning_.positionOf(joint.second), joint.point};
        const auto& freedoms = freedomsOf(joint, model_);
        const std::vector<Vec3> turns = directionsOf(freedoms, FreedomKind::Turn);
        const bool slides = turns.size() != freedoms.size();
        if (slides || (turns.size() != 1 && turns.size() != 3) ||
            std::min(closure.first, closure.second) < 0) {
            refuse("joint " + joint.name, "it closes a loop and is neither a pin nor a ball.");
            return;
        }
        const std::vector<int> loop = around(closure.first, closure.second);
        const bool planar = std::all_of(loop.begin(), loop.end(), [&](int position) {
            return parallel(linkAt(position).axis, turns.front());
        });
        if (turns.size() == 1 && !planar) {
            refuse("joint " + joint.name,
                   "it closes a loop that is not planar, which a point alone does not.");
            return;
        }
        tree_.closures.push_back(closure);
    }

    const Mechanism& mechanism_;
    Model model_;
    SpanningTree spanning_;
    PeerTree tree_;
    Problems problems_;
};

}  // namespace

Result<PeerTree> peerTreeOf(const Mechanism& mechanism, Model model) {
    return TreeMaker(mechanism, model).make();
}

}  // namespace peers
