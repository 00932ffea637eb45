#include "simcore/project/edit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include "simcore/base/text.h"
#include "simcore/project/element_names.h"
#include "simcore/project/element_walk.h"
#include "simcore/project/expression.h"
#include "simcore/project/units.h"

namespace simcore::project {
namespace {

bool isNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// The expression with one identifier replaced by another.
std::string withIdentifier(const std::string& text, const std::string& from,
                           const std::string& to) {
    std::string result;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t hit = text.find(from, at);
        if (hit == std::string::npos) {
            break;
        }
        const std::size_t end = hit + from.size();
        const bool whole = (hit == 0 || !isNameCharacter(text[hit - 1])) &&
                           (end == text.size() || !isNameCharacter(text[end]));
        result += text.substr(at, hit - at) + (whole ? to : from);
        at = end;
    }
    return result + text.substr(at);
}

/// Gives a reference the new name when it means the renamed element. True when it cannot have it:
/// a mirrored user's one text that means this element on one side and another one on the other.
bool follow(const Reference& reference, ElementKind kind, const std::set<std::string>& known,
            const std::vector<std::string>& from, const std::vector<std::string>& to,
            const std::string& base) {
    if (reference.target != kind) {
        return false;
    }
    std::size_t hits = 0;
    const std::vector<std::string> meant = meantBy(reference, known);
    std::string text;
    for (const std::string& name : meant) {
        const auto found = std::find(from.begin(), from.end(), name);
        if (found != from.end()) {
            ++hits;
            text = to[static_cast<std::size_t>(found - from.begin())];
        }
    }
    if (hits == 0) {
        return false;
    }
    if (hits < meant.size()) {
        return true;
    }
    const bool bothSides = meant.size() == 2 && meant[0] != meant[1];
    *reference.text = bothSides ? base : text;
    return false;
}

/// Whether a problem's text means the element with this title or something of it.
bool isOf(const std::string& text, const std::string& title) {
    return text.starts_with(title) && (text.size() == title.size() || text[title.size()] == ',');
}

const char* markedWordFor(ElementKind kind) {
    switch (kind) {
        case ElementKind::Parameter:
            return Text::mark("parameter");
        case ElementKind::Body:
            return Text::mark("body");
        case ElementKind::Joint:
            return Text::mark("joint");
        case ElementKind::Wheel:
            return Text::mark("wheel");
        case ElementKind::Spring:
            return Text::mark("spring");
        case ElementKind::Gear:
            return Text::mark("gear");
        case ElementKind::Payload:
            return Text::mark("payload");
        case ElementKind::Variant:
            return Text::mark("variant");
        case ElementKind::Scenario:
            break;
    }
    return Text::mark("scenario");
}

}  // namespace

std::vector<ElementKind> allElementKinds() {
    return {ElementKind::Parameter, ElementKind::Body,    ElementKind::Joint,
            ElementKind::Wheel,     ElementKind::Spring,  ElementKind::Gear,
            ElementKind::Payload,   ElementKind::Variant, ElementKind::Scenario};
}

std::string wordFor(ElementKind kind) {
    return markedWordFor(kind);
}

std::string nounFor(ElementKind kind) {
    return Text::translated(markedWordFor(kind));
}

std::string titleFor(ElementKind kind, const std::string& name) {
    return nounFor(kind) + " " + name;
}

int countOf(const Project& project, ElementKind kind) {
    return withList(project, kind, [](const auto& list) { return static_cast<int>(list.size()); });
}

int shapeCountOf(const Project& project, int body) {
    return body < 0 || body >= countOf(project, ElementKind::Body)
               ? 0
               : static_cast<int>(
                     project.rover.bodies[static_cast<std::size_t>(body)].shapes.size());
}

const Shape& shapeAt(const Project& project, ElementRef shape) {
    if (shape.kind != ElementKind::Body || !shape.isShape() ||
        shape.shape >= shapeCountOf(project, shape.index)) {
        throw std::invalid_argument("no shape at this place");
    }
    return project.rover.bodies[static_cast<std::size_t>(shape.index)]
        .shapes[static_cast<std::size_t>(shape.shape)];
}

const std::string& nameOf(const Project& project, ElementRef element) {
    if (element.index < 0 || element.index >= countOf(project, element.kind)) {
        throw std::invalid_argument("no " + wordFor(element.kind) + " at this place");
    }
    if (element.isShape()) {
        shapeAt(project, element);  // throws when there is none
    }
    return withList(project, element.kind, [&](const auto& list) -> const std::string& {
        return list[static_cast<std::size_t>(element.index)].name;
    });
}

ElementRef findElement(const Project& project, ElementKind kind, const std::string& name) {
    for (int i = 0; i < countOf(project, kind); ++i) {
        const std::vector<std::string> sides = namesOnSides(project, ElementRef{kind, i});
        if (nameOf(project, {kind, i}) == name ||
            std::find(sides.begin(), sides.end(), name) != sides.end()) {
            return {kind, i};
        }
    }
    return {};
}

// The titles are made again and compared, so that it works in any language.
ElementRef findElement(const Project& project, const std::string& problemElement) {
    for (const ElementKind kind : allElementKinds()) {
        for (int i = 0; i < countOf(project, kind); ++i) {
            std::vector<std::string> names = namesOnSides(project, ElementRef{kind, i});
            names.push_back(nameOf(project, {kind, i}));
            for (const std::string& name : names) {
                const std::string title = titleFor(kind, name);
                if (!isOf(problemElement, title)) {
                    continue;
                }
                ElementRef found{kind, i};
                const int shapes = kind == ElementKind::Body ? shapeCountOf(project, i) : 0;
                for (int k = 0; k < shapes; ++k) {
                    if (isOf(problemElement, Text::of("{}, shape {}", title, k + 1))) {
                        found.shape = k;
                    }
                }
                return found;
            }
        }
    }
    return {};
}

void forEachQuantity(Project& project, const std::function<void(Quantity&)>& visit) {
    QuantityWalker(visit).walk(project);
}

Result<Project> renamed(const Project& project, ElementRef element, const std::string& name) {
    const std::string old = nameOf(project, element);
    if (element.isShape()) {
        return Problem{Severity::Critical, titleOf(project, element),
                       Text::of("a shape has no name."), Text::of("Rename its body.")};
    }
    if (name == old) {
        return project;
    }
    if (name.find_first_not_of(' ') == std::string::npos) {
        return criticalFor(element.kind, old, Text::of("its new name is empty."),
                           Text::of("Type a name."));
    }
    if (namesOf(project, element.kind).contains(name)) {
        return criticalFor(element.kind, old,
                           Text::of("there is already a {} '{}'.", nounFor(element.kind), name),
                           Text::of("Choose another name."));
    }
    if (element.kind == ElementKind::Parameter && !isParameterName(name)) {
        return criticalFor(element.kind, old, Text::of("'{}' cannot be used in expressions.", name),
                           Text::of("Use up to 100 letters, digits and underscores, not starting "
                                    "with a digit and not the name of a function."));
    }
    Project next = project;
    const std::set<std::string> known = namesOnSides(project, element.kind);
    const std::vector<std::string> from = namesOnSides(project, element);
    withList(next, element.kind,
             [&](auto& list) { list[static_cast<std::size_t>(element.index)].name = name; });
    const std::vector<std::string> to = namesOnSides(next, element);
    for (const Reference& reference : referencesIn(next)) {
        const auto refused = follow(reference, element.kind, known, from, to, name);
        if (refused) {
            return criticalFor(element.kind, old,
                               Text::of("{} is mirrored and means it by the name '{}' together "
                                        "with one on the other side.",
                                        titleOf(project, reference.user), *reference.text),
                               Text::of("Split that first."));
        }
    }
    if (element.kind == ElementKind::Parameter) {
        forEachQuantity(next, [&](Quantity& quantity) {
            if (usesName(quantity, old)) {
                quantity = Quantity::expression(withIdentifier(quantity.text(), old, name));
            }
        });
    }
    return next;
}

std::vector<ElementRef> userElements(const Project& project, ElementRef element) {
    if (element.isShape()) {
        return {};
    }
    const std::vector<std::string> names = namesOnSides(project, element);
    const std::set<std::string> known = namesOnSides(project, element.kind);
    std::set<ElementRef> users;
    Project copy = project;
    for (const Reference& reference : referencesIn(copy)) {
        if (reference.target != element.kind) {
            continue;
        }
        for (const std::string& meant : meantBy(reference, known)) {
            if (std::find(names.begin(), names.end(), meant) != names.end()) {
                users.insert(reference.user);
            }
        }
    }
    if (element.kind == ElementKind::Parameter) {
        const std::string& name = nameOf(project, element);
        for (const ElementKind kind : allElementKinds()) {
            withList(copy, kind, [&](auto& list) {
                for (std::size_t i = 0; i < list.size(); ++i) {
                    const std::function<void(Quantity&)> look = [&](Quantity& quantity) {
                        if (usesName(quantity, name)) {
                            users.insert({kind, static_cast<int>(i)});
                        }
                    };
                    QuantityWalker(look).walk(list[i]);
                }
            });
        }
    }
    return {users.begin(), users.end()};
}

std::vector<std::string> usersOf(const Project& project, ElementRef element) {
    std::vector<std::string> users;
    for (const ElementRef user : userElements(project, element)) {
        users.push_back(titleOf(project, user));
    }
    return users;
}

Result<Project> removed(const Project& project, ElementRef element) {
    return removed(project, std::vector{element});
}

Result<Project> duplicated(const Project& project, ElementRef element) {
    if (element.isShape()) {
        const Shape copy = shapeAt(project, element);
        Project next = project;
        std::vector<Shape>& shapes = shapesOf(next, element.index);
        shapes.insert(shapes.begin() + element.shape + 1, copy);
        return next;
    }
    const std::string name =
        freeName(project, element.kind, nameOf(project, element), isMirrored(project, element));
    Project next = project;
    withList(next, element.kind, [&](auto& list) {
        auto copy = list[static_cast<std::size_t>(element.index)];
        copy.name = name;
        list.insert(list.begin() + element.index + 1, copy);
    });
    return next;
}

void setValue(Project& project, Quantity& quantity, double value) {
    if (!quantity.isLiteral()) {
        for (Parameter& parameter : project.rover.parameters) {
            const bool derived =
                !parameter.value.isLiteral() && !namesIn(parameter.value.text()).empty();
            if (parameter.name == quantity.text() && !derived) {
                parameter.value = value;
                return;
            }
        }
    }
    quantity = value;
}

Result<Project> withCenterOfMass(const Project& project, const Vec3& com) {
    const auto parameters = evaluateParameters(project.rover);
    if (!parameters) {
        return parameters.problems();
    }
    const auto mechanism = resolve(project.rover, *parameters);
    if (!mechanism) {
        return mechanism.problems();
    }
    Project next = project;
    Body& body = next.rover.bodies.front();
    const auto mass = evaluate(body.mass, *parameters, Text::of("body {}", body.name));
    if (body.mirror || !mass || !(*mass > 0.0)) {
        return criticalFor(
            ElementKind::Body, body.name,
            Text::of("the centre of mass is moved by moving this body's, and it is mirrored or "
                     "has no mass."),
            Text::of("Make the chassis the first body."));
    }
    const Vec3 shift = (com - mechanism->centerOfMass()) * (mechanism->mass() / *mass);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double move = shift[static_cast<Eigen::Index>(axis)];
        // Leaves a coordinate that stays as it is written.
        if (std::abs(move) > 1e-12) {
            const auto old = evaluate(body.com[axis], *parameters, Text::of("body {}", body.name));
            if (!old) {
                return old.problems();
            }
            setValue(next, body.com[axis], *old + move);
        }
    }
    const auto checked = evaluateParameters(next.rover);
    if (!checked) {
        return checked.problems();
    }
    return next;
}

Result<Quantity> quantityFromText(const std::string& text, const std::string& unit,
                                  const ParameterValues& parameters, const std::string& element) {
    const Unit* shown = findUnit(unit);
    const std::size_t first = text.find_first_not_of(' ');
    if (first == std::string::npos) {
        return Problem{Severity::Critical, element, Text::of("there is no number."),
                       Text::of("Type a number or an expression.")};
    }
    const std::string trimmed = text.substr(first, text.find_last_not_of(' ') - first + 1);
    const auto number = [](const std::string& digits) -> std::optional<double> {
        double value = 0.0;
        const auto [stop, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        const bool whole = error == std::errc() && stop == digits.data() + digits.size();
        return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
    };
    if (const auto plain = number(trimmed)) {
        return Quantity(shown ? *plain * shown->factor : *plain);
    }
    const auto written = splitUnit(trimmed);
    if (written && shown && std::string_view(written->unit->dimension) != shown->dimension) {
        return Problem{Severity::Critical, element,
                       Text::of("'{}' is a {}, but this is a {}.", trimmed,
                                Text::translated(written->unit->dimension),
                                Text::translated(shown->dimension)),
                       Text::of("Write it in {} or another unit of {}.", shown->symbol,
                                Text::translated(shown->dimension))};
    }
    if (written) {
        if (const auto plain = number(written->value)) {
            return Quantity(*plain * written->unit->factor);
        }
    }
    const Quantity quantity = Quantity::expression(trimmed);
    const auto value = evaluate(quantity, parameters, element);
    if (!value) {
        return value.problems();
    }
    return quantity;
}

std::string textOf(const Quantity& quantity, const std::string& unit) {
    return quantity.isLiteral() ? formatIn(quantity.literal(), unit) : quantity.text();
}

}  // namespace simcore::project
