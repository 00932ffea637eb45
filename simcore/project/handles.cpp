#include "simcore/project/handles.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/project/expression.h"
#include "simcore/project/resolve.h"

namespace simcore::project {
namespace {

constexpr std::array kAxisNames{"x", "y", "z"};
/// A coordinate has arrived when it is this near [m].
constexpr double kNear = 1e-10;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

Problem refusal(const Handle& handle, std::string reason, std::string remedy) {
    return {Severity::Critical, titleFor(handle.element.kind, handle.name), std::move(reason),
            std::move(remedy)};
}

const Parameter* findParameter(const Rover& rover, const std::string& name) {
    const auto found = std::find_if(rover.parameters.begin(), rover.parameters.end(),
                                    [&](const Parameter& p) { return p.name == name; });
    return found == rover.parameters.end() ? nullptr : &*found;
}

bool isFree(const Parameter& parameter) {
    return parameter.value.isLiteral() || namesIn(parameter.value.text()).empty();
}

/// The free parameters below an expression.
void collect(const Rover& rover, const Quantity& quantity, std::set<std::string>& free,
             std::set<std::string>& seen) {
    if (quantity.isLiteral()) {
        return;
    }
    for (const std::string& name : namesIn(quantity.text())) {
        const Parameter* parameter = findParameter(rover, name);
        if (parameter == nullptr || !seen.insert(name).second) {
            continue;
        }
        if (isFree(*parameter)) {
            free.insert(name);
        } else {
            collect(rover, parameter->value, free, seen);
        }
    }
}

std::vector<std::string> freeParametersOf(const Rover& rover, const Quantity& quantity) {
    std::set<std::string> free;
    std::set<std::string> seen;
    collect(rover, quantity, free, seen);
    return {free.begin(), free.end()};
}

/// The joint a wheel turns on.
Joint* axleOf(Rover& rover, const Wheel& wheel) {
    for (Joint& joint : rover.joints) {
        if (joint.name == wheel.axle) {
            return &joint;
        }
    }
    return nullptr;
}

Body* bodyOf(Rover& rover, const std::string& name) {
    const auto found = std::find_if(rover.bodies.begin(), rover.bodies.end(),
                                    [&](const Body& b) { return b.name == name; });
    return found == rover.bodies.end() ? nullptr : &*found;
}

/// The coordinates that a handle is at; null when the element is not there.
Quantity3* coordinatesOf(Rover& rover, HandleKind kind, int index) {
    switch (kind) {
        case HandleKind::CenterOfMass:
        case HandleKind::Body:
            return &rover.bodies.at(at(index)).com;
        case HandleKind::Joint:
            return &rover.joints.at(at(index)).point;
        case HandleKind::Payload:
            return &rover.payloads.at(at(index)).position;
        case HandleKind::Wheel:
            break;
    }
    Joint* axle = axleOf(rover, rover.wheels.at(at(index)));
    return axle == nullptr ? nullptr : &axle->point;
}

std::optional<Vec3> valueOf(const Quantity3& coordinates, const ParameterValues& parameters) {
    Vec3 value;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = evaluate(coordinates[axis], parameters, "handle");
        if (!number) {
            return std::nullopt;
        }
        value[static_cast<Eigen::Index>(axis)] = *number;
    }
    return value;
}

template <class Element>
void addHandles(Rover& rover, HandleKind kind, ElementKind element,
                const std::vector<Element>& elements, const ParameterValues& parameters,
                std::vector<Handle>& handles) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const int index = static_cast<int>(i);
        const Quantity3* coordinates = coordinatesOf(rover, kind, index);
        const auto position =
            coordinates == nullptr ? std::nullopt : valueOf(*coordinates, parameters);
        if (!position) {
            continue;
        }
        const auto add = [&](Side side) {
            Handle handle{
                kind, {element, index}, side, nameOnSide(elements[i].name, side), *position};
            handle.position.y() *= side == Side::Right ? -1.0 : 1.0;
            handles.push_back(handle);
        };
        if (elements[i].mirror) {
            add(Side::Left);
            add(Side::Right);
        } else {
            add(Side::Center);
        }
    }
}

/// A coordinate as a function of one parameter.
class Dependence {
  public:
    Dependence(const Rover& rover, const Quantity& quantity, const std::string& parameter)
        : rover_(rover),
          quantity_(quantity) {
        for (Parameter& p : rover_.parameters) {
            // A trial may leave the range; the answer does not.
            p.minimum.reset();
            p.maximum.reset();
            if (p.name == parameter) {
                parameter_ = &p;
            }
        }
    }

    std::optional<double> operator()(double value) {
        parameter_->value = value;
        const auto parameters = evaluateParameters(rover_);
        if (!parameters) {
            return std::nullopt;
        }
        const auto number = evaluate(quantity_, *parameters, "handle");
        return number ? std::optional(*number) : std::nullopt;
    }

    /// The parameter's value that makes the coordinate `target`, by the secant method from `start`.
    std::optional<double> solve(double start, double target) {
        constexpr int kMost = 20;
        constexpr double kFirstStep = 1e-4;
        double before = start;
        auto errorBefore = (*this)(before);
        double now = start + kFirstStep * std::max(1.0, std::abs(start));
        for (int k = 0; k < kMost; ++k) {
            const auto error = (*this)(now);
            if (!error || !errorBefore) {
                return std::nullopt;
            }
            if (std::abs(*error - target) < kNear) {
                return now;
            }
            const double slope = (*error - *errorBefore) / (now - before);
            if (!(std::abs(slope) > 1e-9)) {
                return std::nullopt;
            }
            before = now;
            errorBefore = error;
            now += (target - *error) / slope;
        }
        return std::nullopt;
    }

  private:
    Rover rover_;
    Quantity quantity_;
    Parameter* parameter_ = nullptr;
};

/// Changes one coordinate; tells which parameter was changed, if one was.
Result<std::string> setCoordinate(Project& project, const Handle& handle, int axis, double target,
                                  const DragRequest& request) {
    Quantity& coordinate =
        (*coordinatesOf(project.rover, handle.kind, handle.element.index))[at(axis)];
    const std::vector<std::string> free = freeParametersOf(project.rover, coordinate);
    if (free.empty() || request.replace) {
        coordinate = target;
        return std::string();
    }
    std::string name = free.front();
    if (free.size() > 1) {
        const auto chosen = request.choice.find(axis);
        if (chosen == request.choice.end() ||
            std::find(free.begin(), free.end(), chosen->second) == free.end()) {
            return refusal(handle,
                           Text::of("{} = {} depends on {}.", kAxisNames.at(at(axis)),
                                    coordinate.text(), fmt::join(free, ", ")),
                           Text::of("Choose the parameter to change, or replace the expression."));
        }
        name = chosen->second;
    }
    const auto parameters = evaluateParameters(project.rover);
    if (!parameters) {
        return parameters.problems();
    }
    const auto solved =
        Dependence(project.rover, coordinate, name).solve(parameters->at(name), target);
    if (!solved) {
        return refusal(handle,
                       Text::of("no value of {} brings {} = {} there.", name,
                                kAxisNames.at(at(axis)), coordinate.text()),
                       Text::of("Choose another parameter, or replace the expression."));
    }
    for (Parameter& parameter : project.rover.parameters) {
        if (parameter.name == name) {
            parameter.value = std::clamp(*solved, parameter.minimum.value_or(*solved),
                                         parameter.maximum.value_or(*solved));
        }
    }
    return name;
}

/// Moves the fixed numbers of a wheel's body along with its axle.
void moveAlong(Rover& rover, const Wheel& wheel, int axis, double way) {
    Body* body = bodyOf(rover, wheel.body);
    if (body == nullptr) {
        return;
    }
    const auto move = [&](Quantity3& point) {
        Quantity& coordinate = point[at(axis)];
        if (coordinate.isLiteral()) {
            coordinate = coordinate.literal() + way;
        }
    };
    move(body->com);
    for (Shape& shape : body->shapes) {
        const bool hasCenter = shape.kind == ShapeKind::Box || shape.kind == ShapeKind::Sphere;
        for (Quantity3* point : hasCenter ? std::vector<Quantity3*>{&shape.center}
                                          : std::vector<Quantity3*>{&shape.from, &shape.to}) {
            move(*point);
        }
    }
}

/// Where the chassis' centre of mass has to be so that the rover's is at `to`.
Result<Vec3> chassisTarget(const Project& project, const Handle& handle, const Vec3& to) {
    const auto parameters = evaluateParameters(project.rover);
    if (!parameters) {
        return parameters.problems();
    }
    const auto mechanism = resolve(project.rover, *parameters);
    if (!mechanism) {
        return mechanism.problems();
    }
    const Body& chassis = project.rover.bodies.at(at(handle.element.index));
    const auto mass = evaluate(chassis.mass, *parameters, Text::of("body {}", chassis.name));
    const auto now = valueOf(chassis.com, *parameters);
    if (chassis.mirror || !mass || !(*mass > 0.0) || !now) {
        return refusal(
            handle,
            Text::of("the centre of mass is moved by moving this body's, and it is mirrored or "
                     "has no mass."),
            Text::of("Make the chassis the first body."));
    }
    return Vec3(*now + (to - mechanism->centerOfMass()) * (mechanism->mass() / *mass));
}

}  // namespace

std::vector<Handle> handlesOf(const Project& project) {
    std::vector<Handle> handles;
    const auto parameters = evaluateParameters(project.rover);
    if (!parameters) {
        return handles;
    }
    Rover rover = project.rover;
    if (const auto mechanism = resolve(rover, *parameters)) {
        handles.push_back({HandleKind::CenterOfMass,
                           {ElementKind::Body, 0},
                           Side::Center,
                           rover.bodies.front().name,
                           mechanism->centerOfMass()});
    }
    addHandles(rover, HandleKind::Body, ElementKind::Body, rover.bodies, *parameters, handles);
    addHandles(rover, HandleKind::Joint, ElementKind::Joint, rover.joints, *parameters, handles);
    addHandles(rover, HandleKind::Payload, ElementKind::Payload, rover.payloads, *parameters,
               handles);
    addHandles(rover, HandleKind::Wheel, ElementKind::Wheel, rover.wheels, *parameters, handles);
    // A wheel stands for its axle and its body.
    const auto isOfWheel = [&](const Handle& handle) {
        const auto& name = nameOf(project, handle.element);
        return std::any_of(rover.wheels.begin(), rover.wheels.end(), [&](const Wheel& wheel) {
            return (handle.kind == HandleKind::Joint && wheel.axle == name) ||
                   (handle.kind == HandleKind::Body && wheel.body == name);
        });
    };
    handles.erase(std::remove_if(handles.begin(), handles.end(), isOfWheel), handles.end());
    return handles;
}

std::array<std::vector<std::string>, 3> parametersOf(const Project& project, const Handle& handle) {
    Rover rover = project.rover;
    std::array<std::vector<std::string>, 3> names;
    if (const Quantity3* coordinates = coordinatesOf(rover, handle.kind, handle.element.index)) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            names.at(axis) = freeParametersOf(rover, (*coordinates)[axis]);
        }
    }
    return names;
}

Result<Dragged> dragged(const Project& project, const Handle& handle, const DragRequest& request) {
    Vec3 target = request.to;
    if (handle.kind == HandleKind::CenterOfMass) {
        const auto chassis = chassisTarget(project, handle, request.to);
        if (!chassis) {
            return chassis.problems();
        }
        target = *chassis;
    }
    if (handle.side == Side::Right) {
        target.y() = -target.y();
    }
    Dragged result{project, handle.position, {}};
    for (int axis = 0; axis < 3; ++axis) {
        if (!request.axes.at(at(axis))) {
            continue;
        }
        const auto place = [&]() -> Result<double> {
            const auto parameters = evaluateParameters(result.project.rover);
            if (!parameters) {
                return parameters.problems();
            }
            const Quantity3* coordinates =
                coordinatesOf(result.project.rover, handle.kind, handle.element.index);
            return evaluate((*coordinates)[at(axis)], *parameters, handle.name);
        };
        const auto before = place();
        if (!before) {
            return before.problems();
        }
        const auto changed = setCoordinate(result.project, handle, axis, target[axis], request);
        if (!changed) {
            return changed.problems();
        }
        if (!changed->empty()) {
            result.parameters.push_back(*changed);
        }
        const auto after = place();
        if (!after) {
            return after.problems();
        }
        if (handle.kind == HandleKind::Wheel) {
            moveAlong(result.project.rover, project.rover.wheels.at(at(handle.element.index)), axis,
                      *after - *before);
        }
    }
    for (const Handle& moved : handlesOf(result.project)) {
        if (moved.kind == handle.kind && moved.element == handle.element &&
            moved.side == handle.side) {
            result.reached = moved.position;
        }
    }
    return result;
}

}  // namespace simcore::project
