#pragma once

#include <functional>
#include <string>
#include <vector>

#include "simcore/base/pose.h"
#include "simcore/base/result.h"
#include "simcore/project/project.h"
#include "simcore/project/resolve.h"

/// Changes to a project that touch more than one value: every editor and script goes through these.
/// They work on copies; nothing is changed when they fail.
namespace simcore::project {

enum class ElementKind { Parameter, Body, Joint, Wheel, Spring, Gear, Payload, Variant, Scenario };

/// One element of the file, by its place in its list.
struct ElementRef {
    ElementKind kind = ElementKind::Body;
    int index = -1;
    bool operator==(const ElementRef&) const = default;
    auto operator<=>(const ElementRef&) const = default;
};

/// All kinds, in the order of the file.
std::vector<ElementKind> allElementKinds();
/// "parameter", "body", "gear", ...: as problems call them.
std::string wordFor(ElementKind kind);
int countOf(const Project& project, ElementKind kind);
/// Name of the element; std::invalid_argument when there is none at this place.
const std::string& nameOf(const Project& project, ElementRef element);
/// The element that a problem's text such as "joint fork_a" or "wheel front, radius" means; also
/// finds mirrored elements by the name of one side. Index -1: none.
ElementRef findElement(const Project& project, const std::string& problemElement);

/// Calls `visit` with every number of the project.
void forEachQuantity(Project& project, const std::function<void(Quantity&)>& visit);

/// The element with another name; references and expressions follow. Problems: the name is empty,
/// taken, or (for a parameter) not usable in expressions.
Result<Project> renamed(const Project& project, ElementRef element, const std::string& name);

/// Names of what refers to the element, as problems call them: "joint fork_a".
std::vector<std::string> usersOf(const Project& project, ElementRef element);

/// Without the element. Problem: something still refers to it.
Result<Project> removed(const Project& project, ElementRef element);

/// With a copy of the element behind it, named "<name>_2" or the next free number.
Result<Project> duplicated(const Project& project, ElementRef element);

/// Gives `quantity`, a number inside `project`, a value [SI]: the parameter when it is the name of
/// one that is not derived, else the number itself.
void setValue(Project& project, Quantity& quantity, double value);

/// Moves the centre of mass of the whole rover at the drawn pose to `com` [m] by moving that of the
/// first body (the chassis), as a designer moves batteries and payload about. Problems: the rover
/// cannot be resolved, or the first body is mirrored or has no mass.
Result<Project> withCenterOfMass(const Project& project, const Vec3& com);

/// A number as typed into a field that shows `unit`: "70" is in that unit, "12 cm" in its own,
/// anything else an expression. Problems, for `element`: no value, or a unit of another dimension.
Result<Quantity> quantityFromText(const std::string& text, const std::string& unit,
                                  const ParameterValues& parameters, const std::string& element);

/// The number as a field shows it: in `unit` without the unit's name, or the expression's text.
std::string textOf(const Quantity& quantity, const std::string& unit);

}  // namespace simcore::project
