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

/// One element of the file, by its place in its list; or one shape of a body, by its place in that.
struct ElementRef {
    ElementKind kind = ElementKind::Body;
    int index = -1;
    int shape = -1;  ///< of the body; -1 = the element itself

    bool isShape() const { return shape >= 0; }

    bool operator==(const ElementRef&) const = default;
    auto operator<=>(const ElementRef&) const = default;
};

/// All kinds, in the order of the file.
std::vector<ElementKind> allElementKinds();
/// "parameter", "body", "gear", ...: the same in every language, as the command line takes it.
std::string wordFor(ElementKind kind);
/// The same word for people.
std::string nounFor(ElementKind kind);
/// "joint fork_a": what problems call an element.
std::string titleFor(ElementKind kind, const std::string& name);
int countOf(const Project& project, ElementKind kind);
/// Shapes of the body at this place of its list; 0 when there is none.
int shapeCountOf(const Project& project, int body);
/// The shape; std::invalid_argument when there is none at this place.
const Shape& shapeAt(const Project& project, ElementRef shape);
/// Name of the element, of a shape that of its body: shapes have none. std::invalid_argument when
/// there is none at this place.
const std::string& nameOf(const Project& project, ElementRef element);
/// The element of this name; also finds mirrored elements by the name of one side. Index -1: none.
ElementRef findElement(const Project& project, ElementKind kind, const std::string& name);
/// The element that a problem's text such as "joint fork_a", "wheel front, radius" or "body fork,
/// shape 2" means, in the program's language; mirrored ones as above. Index -1: none.
ElementRef findElement(const Project& project, const std::string& problemElement);

/// Calls `visit` with every number of the project.
void forEachQuantity(Project& project, const std::function<void(Quantity&)>& visit);

/// The element with another name; references and expressions follow. Problems: the name is empty,
/// taken, or (for a parameter) not usable in expressions; a mirrored element refers to this one on
/// one side only; it is a shape.
Result<Project> renamed(const Project& project, ElementRef element, const std::string& name);

/// Names of what refers to the element, as problems call them: "joint fork_a".
std::vector<std::string> usersOf(const Project& project, ElementRef element);

/// What refers to the element.
std::vector<ElementRef> userElements(const Project& project, ElementRef element);

/// Without the element. Problem: something still refers to it.
Result<Project> removed(const Project& project, ElementRef element);
/// Without all of them at once; they may refer to each other. Problems: for every one that
/// something outside the set refers to.
Result<Project> removed(const Project& project, const std::vector<ElementRef>& elements);

/// With a copy of the element behind it, named "<name>_2" or the next free number. A shape's copy
/// is like it.
Result<Project> duplicated(const Project& project, ElementRef element);

/// With a new element at the end of its list, valid at once where that can be: a joint between two
/// bodies, a wheel with its body and axle, a body welded to the chassis by a joint, and so on; what
/// comes with it is added, too. Problem: what it needs is not there.
Result<Project> added(const Project& project, ElementKind kind);

/// With another shape of the kind at the end of the body's list, where the body's centre of mass
/// is. Problem: there is no such body.
Result<Project> withNewShape(const Project& project, int body, ShapeKind kind);

/// With the element at another place of its list; the places behind it close up first. Problems: no
/// such place, or a mirrored body would be the first one, the chassis.
Result<Project> moved(const Project& project, ElementRef element, int newIndex);

/// With the shapes, of whatever bodies, together before the one at `place` of the body's list; at
/// its end when there is none. They keep their coordinates. Problem: there is no such body or
/// place, or one of the elements is no shape.
Result<Project> withShapesMoved(const Project& project, const std::vector<ElementRef>& shapes,
                                int body, int place);

/// Makes every one of the elements a mirrored pair, or what was a pair the left one of it; those
/// that are so already stay. References follow. A left one whose split other half is still there
/// takes it back. Problems: the kind cannot be mirrored (a shape is with its body), something still
/// refers to a right one that would go, a name is taken.
Result<Project> mirrored(const Project& project, const std::vector<ElementRef>& elements,
                         bool mirror);

/// Every mirrored pair among the elements as two elements of their own, left and right, one behind
/// the other: the same mechanism, except that the order of its parts may change. Problem: none of
/// them is mirrored.
Result<Project> split(const Project& project, const std::vector<ElementRef>& elements);

/// Elements and what it takes to put them into another project.
struct Parts {
    Project elements;               ///< those chosen, in the order of the file
    std::vector<Shape> shapes;      ///< chosen without their bodies
    std::vector<Parameter> needed;  ///< parameters that their expressions use, and those of these
    bool operator==(const Parts&) const = default;
};

/// The elements alone.
Parts partsOf(const Project& project, const std::vector<ElementRef>& elements);

/// With the parts at the ends of their lists. A name that is taken becomes "<name>_2" or the next
/// free one, and the parts' references to it follow; needed parameters come along where the project
/// has none of the name. Shapes go to the end of the list of `body`. Problems: there are no parts,
/// a reference cannot follow, or there are shapes and no such body.
Result<Project> withParts(const Project& project, const Parts& parts, int body = -1);

/// With copies of all of them at the ends of their lists, which refer to each other as the
/// originals do; shapes at the ends of their own bodies. Problem: a reference cannot follow.
Result<Project> duplicated(const Project& project, const std::vector<ElementRef>& elements);

/// The elements and shapes of `after` that `before`, of which it is an extension, has not. In file
/// order.
std::vector<ElementRef> appended(const Project& before, const Project& after);

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
