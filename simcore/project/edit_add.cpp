// New elements that make sense at once.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "simcore/base/text.h"
#include "simcore/project/edit.h"
#include "simcore/project/element_names.h"
#include "simcore/project/element_walk.h"

namespace simcore::project {
namespace {

// What new elements start with: assumed, of the size of a laboratory rover.
constexpr double kNewMass = 0.5;        // [kg]
constexpr double kNewEdge = 0.1;        // [m]
constexpr double kNewRadius = 0.07;     // [m]
constexpr double kNewWidth = 0.05;      // [m]
constexpr double kNewSection = 0.02;    // of bars and cylinders [m]
constexpr double kNewStiffness = 10.0;  // [N m/rad]

/// "wheel", or "wheel_2" and so on when that is taken.
std::string newName(const Project& project, ElementKind kind, const std::string& name,
                    bool mirrored) {
    const std::set<std::string> bases = namesOf(project, kind);
    const std::set<std::string> sides = namesOnSides(project, kind);
    const bool taken = bases.contains(name) || sides.contains(name) ||
                       (mirrored && (sides.contains(nameOnSide(name, Side::Left)) ||
                                     sides.contains(nameOnSide(name, Side::Right))));
    return taken ? freeName(project, kind, name, mirrored) : name;
}

/// Problems that the project has not yet.
std::size_t newProblems(const Project& before, const Project& after) {
    const Problems known = validate(before);
    const Problems found = validate(after);
    return static_cast<std::size_t>(
        std::count_if(found.begin(), found.end(), [&](const Problem& problem) {
            return problem.severity == Severity::Critical &&
                   std::find(known.begin(), known.end(), problem) == known.end();
        }));
}

/// The first that brings no critical problem; when there is none such, the first.
std::optional<Project> bestOf(const Project& project, const std::vector<Project>& candidates) {
    for (const Project& candidate : candidates) {
        if (newProblems(project, candidate) == 0) {
            return candidate;
        }
    }
    return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

double valueOf(const Project& project, const Quantity& quantity, double otherwise) {
    const auto parameters = evaluateParameters(project.rover);
    const auto value = evaluate(quantity, parameters ? *parameters : ParameterValues{}, "");
    return value ? *value : otherwise;
}

Problem missing(ElementKind kind, std::string reason, std::string remedy) {
    return criticalFor(kind, Text::of("(new)"), std::move(reason), std::move(remedy));
}

/// To whole millimetres: what a person would type.
double rounded(double length) {
    return std::round(1e3 * length) / 1e3;
}

Project withParameter(const Project& project) {
    Project next = project;
    Parameter parameter;
    parameter.name = newName(project, ElementKind::Parameter, "parameter", false);
    parameter.value = 0.1;
    parameter.unit = "mm";
    parameter.source = "assumed";
    next.rover.parameters.push_back(parameter);
    return next;
}

/// As large as a hand, about the body's centre of mass.
Shape newShape(const Project& project, const Body& body, ShapeKind kind) {
    Shape shape;
    shape.kind = kind;
    shape.color = "link";
    switch (kind) {
        case ShapeKind::Box:
            shape.center = body.com;
            shape.size = {kNewEdge, kNewEdge, kNewEdge};
            break;
        case ShapeKind::Sphere:
            shape.center = body.com;
            shape.radius = kNewEdge / 2.0;
            break;
        case ShapeKind::Cylinder:
        case ShapeKind::Bar: {
            // A cylinder lies as an axle does, a bar points forward.
            const std::size_t axis = kind == ShapeKind::Bar ? 0 : 1;
            const double middle = valueOf(project, body.com[axis], 0.0);
            shape.from = shape.to = body.com;
            shape.from[axis] = rounded(middle - kNewEdge / 2.0);
            shape.to[axis] = rounded(middle + kNewEdge / 2.0);
            shape.radius = kind == ShapeKind::Cylinder ? kNewSection : 0.0;
            shape.width = shape.height = kind == ShapeKind::Bar ? kNewSection : 0.0;
        }
    }
    return shape;
}

/// A box above the chassis, welded to it: a body that hangs on nothing is a mistake.
Project withBody(const Project& project) {
    Project next = project;
    Body body;
    body.name = newName(project, ElementKind::Body, "body", false);
    body.mass = kNewMass;
    std::array<double, 3> at{0.0, 0.0, 0.2};
    if (!project.rover.bodies.empty()) {
        for (std::size_t i = 0; i < 3; ++i) {
            at[i] = valueOf(project, project.rover.bodies.front().com[i], at[i]);
        }
        at[2] = std::round(100.0 * at[2] + 15.0) / 100.0;
    }
    body.com = {at[0], at[1], at[2]};
    body.shapes.push_back(newShape(project, body, ShapeKind::Box));
    next.rover.bodies.push_back(body);
    if (!project.rover.bodies.empty()) {
        Joint weld;
        weld.name = newName(project, ElementKind::Joint, body.name + "_joint", false);
        weld.first = project.rover.bodies.front().name;
        weld.second = body.name;
        weld.point = body.com;
        weld.locked = true;
        next.rover.joints.push_back(weld);
    }
    return next;
}

Result<Project> withJoint(const Project& project) {
    const std::vector<Body>& bodies = project.rover.bodies;
    std::vector<Project> candidates;
    const auto propose = [&](const Body& first, const Body& second) {
        Project next = project;
        Joint joint;
        joint.mirror = first.mirror || second.mirror;
        joint.name = newName(project, ElementKind::Joint, "joint", joint.mirror);
        joint.first = first.name;
        joint.second = second.name;
        joint.point = second.com;
        next.rover.joints.push_back(joint);
        candidates.push_back(std::move(next));
    };
    // A body that hangs on nothing wants it most; it is worth a look at the problems.
    std::set<std::string> loose;
    for (const Problem& problem : validate(project)) {
        if (problem.reason == Text::translated(kNotConnected)) {
            const ElementRef body = findElement(project, problem.element);
            if (body.index > 0) {
                loose.insert(nameOf(project, body));
            }
        }
    }
    for (const Body& body : bodies) {
        if (loose.contains(body.name)) {
            propose(bodies.front(), body);
        }
    }
    if (!candidates.empty()) {
        return candidates.front();
    }
    for (std::size_t k = 1; k < bodies.size(); ++k) {
        propose(bodies.front(), bodies[k]);
    }
    auto best = bestOf(project, candidates);
    if (!best) {
        return missing(ElementKind::Joint, Text::of("there are no two bodies to join."),
                       Text::of("Add a body first."));
    }
    return *std::move(best);
}

/// A body at the end of one free pin along y that carries no wheel yet.
std::optional<std::pair<const Body*, const Joint*>> bareHub(const Project& project) {
    const Rover& rover = project.rover;
    for (auto body = rover.bodies.rbegin(); body != rover.bodies.rend(); ++body) {
        const Joint* pin = nullptr;
        int joints = 0;
        for (const Joint& joint : rover.joints) {
            if (joint.first == body->name || joint.second == body->name) {
                ++joints;
                pin = &joint;
            }
        }
        const bool carries =
            std::any_of(rover.wheels.begin(), rover.wheels.end(),
                        [&](const Wheel& wheel) { return wheel.body == body->name; });
        if (&*body != &rover.bodies.front() && joints == 1 && !carries && !pin->locked &&
            pin->mirror == body->mirror && pin->free == std::vector<FreedomText>{"turn axis"} &&
            std::abs(valueOf(project, pin->axis[1], 0.0)) > 0.5) {
            return std::pair{&*body, pin};
        }
    }
    return std::nullopt;
}

/// Radius, width and motor as the last wheel has them.
Wheel likeTheLast(const Project& project) {
    Wheel wheel;
    wheel.radius = kNewRadius;
    wheel.width = kNewWidth;
    if (!project.rover.wheels.empty()) {
        const Wheel& last = project.rover.wheels.back();
        wheel.radius = last.radius;
        wheel.width = last.width;
        wheel.grousers = last.grousers;
        wheel.motor = last.motor;
    }
    return wheel;
}

Result<Project> withWheel(const Project& project) {
    if (project.rover.bodies.empty()) {
        return missing(ElementKind::Wheel, Text::of("there is no body to hang it on."),
                       Text::of("Add a body first."));
    }
    Project next = project;
    Wheel wheel = likeTheLast(project);
    if (const auto hub = bareHub(project)) {
        wheel.mirror = hub->first->mirror;
        wheel.name = newName(project, ElementKind::Wheel, hub->first->name, wheel.mirror);
        wheel.body = hub->first->name;
        wheel.axle = hub->second->name;
        next.rover.wheels.push_back(wheel);
        return next;
    }
    // A pair with bodies and axles of its own on the chassis, behind what is there.
    const double radius = valueOf(project, wheel.radius, kNewRadius);
    double x = 0.0;
    double y = 0.2;
    Quantity mass = kNewMass;
    bool first = true;
    for (const Wheel& known : project.rover.wheels) {
        for (const Joint& joint : project.rover.joints) {
            if (joint.name == known.axle) {
                const double place = valueOf(project, joint.point[0], 0.0) - 2.5 * radius;
                x = first ? place : std::min(x, place);
                y = std::max(y, std::abs(valueOf(project, joint.point[1], 0.0)));
                first = false;
            }
        }
        for (const Body& body : project.rover.bodies) {
            if (body.name == known.body) {
                mass = body.mass;
            }
        }
    }
    x = rounded(x);
    y = rounded(y);
    Body hub;
    hub.mirror = true;
    hub.name = newName(project, ElementKind::Body, "wheel", true);
    hub.mass = mass;
    hub.com = {x, y, wheel.radius};
    Joint axle;
    axle.mirror = true;
    axle.name = newName(project, ElementKind::Joint, "axle", true);
    axle.first = project.rover.bodies.front().name;
    axle.second = hub.name;
    axle.point = hub.com;
    wheel.mirror = true;
    wheel.name = newName(project, ElementKind::Wheel, "wheel", true);
    wheel.body = hub.name;
    wheel.axle = axle.name;
    next.rover.bodies.push_back(hub);
    next.rover.joints.push_back(axle);
    next.rover.wheels.push_back(wheel);
    return next;
}

/// Pins that are no axles, then the axles; none that steers.
std::vector<const Joint*> pinsOf(const Project& project) {
    std::vector<const Joint*> pins;
    std::vector<const Joint*> axles;
    for (const Joint& joint : project.rover.joints) {
        if (joint.locked || joint.free.size() != 1 || !joint.free[0].starts_with("turn")) {
            continue;
        }
        bool axle = false;
        bool steering = false;  // welded where nobody steers
        for (const Wheel& wheel : project.rover.wheels) {
            axle = axle || wheel.axle == joint.name;
            steering = steering || wheel.steering == joint.name;
        }
        if (steering) {
            continue;
        }
        (axle ? axles : pins).push_back(&joint);
    }
    pins.insert(pins.end(), axles.begin(), axles.end());
    return pins;
}

Result<Project> withSpring(const Project& project) {
    std::vector<Project> candidates;
    for (const Joint* pin : pinsOf(project)) {
        Project next = project;
        Spring spring;
        spring.mirror = pin->mirror;
        spring.name = newName(project, ElementKind::Spring, "spring", spring.mirror);
        spring.joint = pin->name;
        spring.stiffness = kNewStiffness;
        next.rover.springs.push_back(spring);
        candidates.push_back(std::move(next));
    }
    if (auto best = bestOf(project, candidates)) {
        return *std::move(best);
    }
    return missing(ElementKind::Spring, Text::of("there is no pin for it to act on."),
                   Text::of("Add a joint with one free turn first."));
}

/// One pin of the resolved rover.
struct Pin {
    std::string name;
    std::set<std::string> bodies;  ///< the two it joins
};

std::vector<Pin> pinsOnSides(const Project& project) {
    const std::set<std::string> known = namesOnSides(project, ElementKind::Body);
    std::vector<Pin> pins;
    for (const Joint* joint : pinsOf(project)) {
        const auto sides =
            joint->mirror ? std::vector{Side::Left, Side::Right} : std::vector{Side::Center};
        for (const Side side : sides) {
            Pin pin{nameOnSide(joint->name, side), {}};
            for (const std::string& body : {joint->first, joint->second}) {
                const std::string own = nameOnSide(body, side);
                pin.bodies.insert(known.contains(own) ? own : body);
            }
            pins.push_back(std::move(pin));
        }
    }
    return pins;
}

/// Between the first two pins that turn in one body and are not geared yet.
Result<Project> withGear(const Project& project) {
    std::set<std::string> geared;
    for (const Gear& gear : project.rover.gears) {
        geared.insert({gear.firstJoint, gear.secondJoint});
    }
    std::vector<Pin> pins = pinsOnSides(project);
    std::erase_if(pins, [&](const Pin& pin) { return geared.contains(pin.name); });
    for (std::size_t a = 0; a < pins.size(); ++a) {
        for (std::size_t b = a + 1; b < pins.size(); ++b) {
            const bool common =
                std::any_of(pins[a].bodies.begin(), pins[a].bodies.end(),
                            [&](const std::string& body) { return pins[b].bodies.contains(body); });
            if (common) {
                Project next = project;
                Gear gear;
                gear.name = newName(project, ElementKind::Gear, "differential", false);
                gear.firstJoint = pins[a].name;
                gear.secondJoint = pins[b].name;
                next.rover.gears.push_back(gear);
                return next;
            }
        }
    }
    return missing(ElementKind::Gear,
                   Text::of("there are no two pins in one body left for it to connect."),
                   Text::of("Add joints with one free turn first."));
}

Result<Project> withPayload(const Project& project) {
    if (project.rover.bodies.empty()) {
        return missing(ElementKind::Payload, Text::of("there is no body to carry it."),
                       Text::of("Add a body first."));
    }
    Project next = project;
    Payload payload;
    payload.name = newName(project, ElementKind::Payload, "payload", false);
    payload.body = project.rover.bodies.front().name;
    payload.mirror = project.rover.bodies.front().mirror;
    payload.mass = kNewMass;
    payload.position = project.rover.bodies.front().com;
    next.rover.payloads.push_back(payload);
    return next;
}

}  // namespace

Result<Project> added(const Project& project, ElementKind kind) {
    Project next = project;
    switch (kind) {
        case ElementKind::Parameter:
            return withParameter(project);
        case ElementKind::Body:
            return withBody(project);
        case ElementKind::Joint:
            return withJoint(project);
        case ElementKind::Wheel:
            return withWheel(project);
        case ElementKind::Spring:
            return withSpring(project);
        case ElementKind::Gear:
            return withGear(project);
        case ElementKind::Payload:
            return withPayload(project);
        case ElementKind::Variant:
            next.variants.emplace_back().name = newName(project, kind, "variant", false);
            return next;
        case ElementKind::Scenario:
            break;
    }
    next.scenarios.emplace_back().name = newName(project, kind, "flat", false);
    return next;
}

Result<Project> withNewShape(const Project& project, int body, ShapeKind kind) {
    if (body < 0 || body >= countOf(project, ElementKind::Body)) {
        return Problem{Severity::Critical, Text::of("shape"),
                       Text::of("no body is selected for it."),
                       Text::of("Select the body that it belongs to first.")};
    }
    Project next = project;
    std::vector<Shape>& shapes = shapesOf(next, body);
    shapes.push_back(newShape(project, next.rover.bodies[static_cast<std::size_t>(body)], kind));
    return next;
}

}  // namespace simcore::project
