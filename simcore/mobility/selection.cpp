#include "simcore/mobility/selection.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "simcore/base/groups.h"
#include "simcore/base/text.h"
#include "simcore/project/element_names.h"

namespace simcore::mobility {
namespace {

using project::ElementKind;
using project::ElementRef;
using project::Side;

/// All bodies that the selection means, ascending.
std::set<int> bodiesOf(const mechanism::Mechanism& mechanism, const Selection& selection) {
    std::set<int> bodies(selection.bodies.begin(), selection.bodies.end());
    for (const int joint : selection.joints) {
        const mechanism::Joint& one = mechanism.joints.at(static_cast<std::size_t>(joint));
        bodies.insert({one.first, one.second});
    }
    for (const int wheel : selection.wheels) {
        bodies.insert(mechanism.wheels.at(static_cast<std::size_t>(wheel)).body);
    }
    if (!bodies.empty() &&
        (*bodies.begin() < 0 || *bodies.rbegin() >= static_cast<int>(mechanism.bodies.size()))) {
        throw std::invalid_argument("partOf: no such body");
    }
    return bodies;
}

void holdEveryPiece(Part& part) {
    const auto count = static_cast<int>(part.mechanism.bodies.size());
    const int world = count;
    Groups tied(part.mechanism.bodies.size() + 1);  // the world ties
    Groups joined(part.mechanism.bodies.size());    // it does not
    for (const mechanism::Joint& joint : part.mechanism.joints) {
        tied.join(joint.first, joint.second);
        joined.join(joint.first, joint.second);
    }
    for (int b = 0; b < count; ++b) {
        if (part.mechanism.bodies[static_cast<std::size_t>(b)].fixed) {
            tied.join(b, world);
        }
    }
    for (std::size_t i = 0; i < part.mechanism.wheels.size(); ++i) {
        if (part.stance.wheels[i].touching) {
            tied.join(part.mechanism.wheels[i].body, world);
        }
    }
    std::set<int> pieces;
    const auto hold = [&](int body) {
        pieces.insert(joined.of(body));
        if (tied.of(body) != tied.of(world)) {
            part.mechanism.bodies[static_cast<std::size_t>(body)].fixed = true;
            tied.join(body, world);
        }
    };
    hold(part.mechanism.chassis);
    for (int b = 0; b < count; ++b) {
        hold(b);
    }
    part.pieces = static_cast<int>(pieces.size());
}

/// Index of the element's copy in the mechanism, -1: there is none.
int indexOf(const mechanism::Mechanism& mechanism, ElementKind kind, const std::string& name) {
    switch (kind) {
        case ElementKind::Body:
            return mechanism.findBody(name);
        case ElementKind::Joint:
            return mechanism.findJoint(name);
        case ElementKind::Wheel:
            return mechanism.findWheel(name);
        default:
            return -1;
    }
}

void add(std::vector<int>& list, int index) {
    if (index >= 0 && std::find(list.begin(), list.end(), index) == list.end()) {
        list.push_back(index);
    }
}

void add(Selection& selection, ElementKind kind, int index) {
    add(kind == ElementKind::Body    ? selection.bodies
        : kind == ElementKind::Joint ? selection.joints
                                     : selection.wheels,
        index);
}

/// Both, each thing once.
Selection united(Selection a, const Selection& b) {
    for (auto list : {&Selection::bodies, &Selection::joints, &Selection::wheels}) {
        for (const int index : b.*list) {
            add(a.*list, index);
        }
    }
    return a;
}

bool isMirrored(const project::Project& project, ElementRef element) {
    const auto at = static_cast<std::size_t>(element.index);
    switch (element.kind) {
        case ElementKind::Body:
            return project.rover.bodies[at].mirror;
        case ElementKind::Joint:
            return project.rover.joints[at].mirror;
        case ElementKind::Wheel:
            return project.rover.wheels[at].mirror;
        default:
            return false;
    }
}

/// Whether a piece of what is selected has bodies of both sides.
bool joinsSides(const mechanism::Mechanism& mechanism, const Selection& all, const Selection& left,
                const Selection& right) {
    const Part part = partOf(mechanism, drawnStance(mechanism), all);
    Groups joined(mechanism.bodies.size());
    for (const int joint : part.joints) {
        const mechanism::Joint& one = mechanism.joints[static_cast<std::size_t>(joint)];
        joined.join(one.first, one.second);
    }
    std::set<int> lefts;
    for (const int body : bodiesOf(mechanism, left)) {
        lefts.insert(joined.of(body));
    }
    const auto rights = bodiesOf(mechanism, right);
    return std::any_of(rights.begin(), rights.end(),
                       [&](int body) { return lefts.contains(joined.of(body)); });
}

}  // namespace

std::vector<std::string> Part::heldBodies() const {
    std::vector<std::string> names;
    for (const mechanism::Body& body : mechanism.bodies) {
        if (body.fixed) {
            names.push_back(body.name);
        }
    }
    return names;
}

Part partOf(const mechanism::Mechanism& mechanism, const Stance& stance,
            const Selection& selection) {
    if (stance.bodies.size() != mechanism.bodies.size() ||
        stance.wheels.size() != mechanism.wheels.size()) {
        throw std::invalid_argument("partOf: the stance does not fit the mechanism");
    }
    Part part;
    part.mechanism.name = mechanism.name;
    std::vector<int> placeOf(mechanism.bodies.size(), -1);
    for (const int body : bodiesOf(mechanism, selection)) {
        const auto at = static_cast<std::size_t>(body);
        placeOf[at] = static_cast<int>(part.bodies.size());
        part.bodies.push_back(body);
        part.mechanism.bodies.push_back(mechanism.bodies[at]);
        part.stance.bodies.push_back(stance.bodies[at]);
    }
    const auto place = [&](int body) {
        return body < 0 ? -1 : placeOf[static_cast<std::size_t>(body)];
    };
    std::map<int, int> jointPlace;
    for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
        mechanism::Joint joint = mechanism.joints[i];
        joint.first = place(joint.first);
        joint.second = place(joint.second);
        if (joint.first >= 0 && joint.second >= 0) {
            jointPlace[static_cast<int>(i)] = static_cast<int>(part.joints.size());
            part.joints.push_back(static_cast<int>(i));
            part.mechanism.joints.push_back(std::move(joint));
        }
    }
    const auto jointAt = [&](int joint) {
        const auto found = jointPlace.find(joint);
        return found == jointPlace.end() ? -1 : found->second;
    };
    part.constraints = static_cast<int>(part.joints.size());
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        mechanism::Wheel wheel = mechanism.wheels[i];
        wheel.body = place(wheel.body);
        if (wheel.body < 0) {
            continue;
        }
        wheel.axle = jointAt(wheel.axle);
        wheel.carrier = place(wheel.carrier);
        wheel.steering = jointAt(wheel.steering);
        part.mechanism.wheels.push_back(std::move(wheel));
        part.wheels.push_back(static_cast<int>(i));
        part.stance.wheels.push_back(stance.wheels[i]);
        WheelStand& stand = part.stance.wheels.back();
        stand.touching =
            stand.touching && std::find(selection.wheels.begin(), selection.wheels.end(),
                                        static_cast<int>(i)) != selection.wheels.end();
        part.constraints += stand.touching ? 1 : 0;
    }
    for (mechanism::Gear gear : mechanism.gears) {
        gear.firstJoint = jointAt(gear.firstJoint);
        gear.secondJoint = jointAt(gear.secondJoint);
        if (gear.firstJoint >= 0 && gear.secondJoint >= 0) {
            part.mechanism.gears.push_back(std::move(gear));
        }
    }
    part.mechanism.chassis = std::max(0, place(mechanism.chassis));
    if (!part.bodies.empty()) {
        holdEveryPiece(part);
    }
    return part;
}

Selection selectionOf(const project::Project& project, const mechanism::Mechanism& mechanism,
                      const std::vector<ElementRef>& elements) {
    Selection center, left, right;
    for (const ElementRef element : elements) {
        if (element.isShape() ||
            (element.kind != ElementKind::Body && element.kind != ElementKind::Joint &&
             element.kind != ElementKind::Wheel)) {
            continue;
        }
        const std::string& name = nameOf(project, element);
        if (isMirrored(project, element)) {
            for (auto [side, list] :
                 {std::pair(Side::Left, &left), std::pair(Side::Right, &right)}) {
                add(*list, element.kind, indexOf(mechanism, element.kind, nameOnSide(name, side)));
            }
        } else {
            add(center, element.kind, indexOf(mechanism, element.kind, name));
        }
    }
    const Selection oneSide = united(center, left);
    const Selection all = united(oneSide, right);
    return joinsSides(mechanism, all, left, right) ? all : oneSide;
}

Result<Selection> selectionOf(const project::Project& project,
                              const mechanism::Mechanism& mechanism,
                              const std::vector<std::string>& names) {
    Selection selection;
    std::vector<ElementRef> elements;
    Problems problems;
    for (const std::string& name : names) {
        bool found = false;
        for (const ElementKind kind : {ElementKind::Body, ElementKind::Joint, ElementKind::Wheel}) {
            const std::string word = wordFor(kind) + " ";
            const bool named = name.starts_with(word);
            const std::string bare = named ? name.substr(word.size()) : name;
            for (int i = 0; i < countOf(project, kind) && !found; ++i) {
                if (nameOf(project, {kind, i}) == bare) {
                    elements.push_back({kind, i});
                    found = true;
                }
            }
            if (!found) {  // one copy of a mirrored pair, by its full name
                const int index = indexOf(mechanism, kind, bare);
                add(selection, kind, index);
                found = index >= 0;
            }
            if (found) {
                break;
            }
        }
        if (!found) {
            problems.push_back({Severity::Critical, name,
                                Text::of("there is no body, joint or wheel of this name"),
                                Text::of("roversim mobility FILE lists them.")});
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    return united(selection, selectionOf(project, mechanism, elements));
}

std::vector<ElementShare> shareByElement(const Report& report) {
    std::vector<ElementShare> shares;
    for (const ConstraintName& row : report.removable) {
        auto found = std::find_if(shares.begin(), shares.end(), [&](const ElementShare& share) {
            return share.element == row.element;
        });
        if (found == shares.end()) {
            shares.push_back({row.element, row.joint, row.wheel, 0.0, 0.0});
            found = std::prev(shares.end());
        }
        found->share += row.share;
    }
    for (ElementShare& share : shares) {
        share.part = share.share / std::max(1, report.redundant);
    }
    std::stable_sort(
        shares.begin(), shares.end(),
        [](const ElementShare& a, const ElementShare& b) { return a.share > b.share + 1e-9; });
    return shares;
}

std::string describe(const Part& part, const Report& report) {
    std::string text = part.pieces > 1
                           ? Text::of("{} pieces that no joint connects.", part.pieces) + " "
                           : std::string();
    if (const auto held = part.heldBodies(); !held.empty()) {
        text += Text::of("With {} held:", fmt::join(held, ", ")) + " ";
    }
    text += report.mobility == 0   ? Text::of("nothing in it moves.")
            : report.mobility == 1 ? Text::of("1 freedom within it.")
                                   : Text::of("{} freedoms within it.", report.mobility);
    if (report.redundant > 0) {
        text += " " + (report.redundant == 1
                           ? Text::of("1 of its constraints repeats what its others already hold.")
                           : Text::of("{} of its constraints repeat what its others already hold.",
                                      report.redundant));
    } else {
        text += " " + Text::of("Nothing in it is redundant.");
    }
    return text;
}

}  // namespace simcore::mobility
