// Edits that take elements out of their lists, move them or carry them to another project.
#include <algorithm>
#include <set>
#include <stdexcept>

#include "simcore/base/text.h"
#include "simcore/project/edit.h"
#include "simcore/project/element_walk.h"
#include "simcore/project/expression.h"

namespace simcore::project {
namespace {

/// Those that there are, once each, in file order; shapes only where their body is not among them,
/// as they go with it.
std::set<ElementRef> chosen(const Project& project, const std::vector<ElementRef>& elements) {
    std::set<ElementRef> set;
    for (const ElementRef element : elements) {
        nameOf(project, element);  // throws when there is none
        set.insert(element);
    }
    std::erase_if(set, [&](ElementRef element) {
        return element.isShape() && set.contains({element.kind, element.index});
    });
    return set;
}

Problem noBody(std::string remedy) {
    return {Severity::Critical, Text::of("shape"), Text::of("there is no body for it."),
            std::move(remedy)};
}

/// Whether the one that becomes the chassis cannot be it.
bool hasMirroredChassis(const Project& project) {
    return !project.rover.bodies.empty() && project.rover.bodies.front().mirror;
}

/// Adds what the names found so far need to have a value.
void addNeeded(const Rover& rover, std::set<std::string>& names) {
    std::vector<std::string> open(names.begin(), names.end());
    while (!open.empty()) {
        const std::string name = open.back();
        open.pop_back();
        for (const Parameter& parameter : rover.parameters) {
            if (parameter.name == name && !parameter.value.isLiteral()) {
                for (const std::string& used : namesIn(parameter.value.text())) {
                    if (names.insert(used).second) {
                        open.push_back(used);
                    }
                }
            }
        }
    }
}

}  // namespace

Result<Project> removed(const Project& project, const std::vector<ElementRef>& elements) {
    const std::set<ElementRef> set = chosen(project, elements);
    Problems problems;
    for (const ElementRef element : set) {
        std::vector<std::string> others;
        for (const ElementRef user : userElements(project, element)) {
            if (!set.contains(user)) {
                others.push_back(titleOf(project, user));
            }
        }
        if (!others.empty()) {
            problems.push_back(
                criticalFor(element.kind, nameOf(project, element), usedBy(others),
                            Text::of("Delete those first, or make them use something else.")));
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    Project next = project;
    // From behind, so that the places of the others stay.
    for (auto it = set.rbegin(); it != set.rend(); ++it) {
        if (it->isShape()) {
            std::vector<Shape>& shapes = shapesOf(next, it->index);
            shapes.erase(shapes.begin() + it->shape);
            continue;
        }
        withList(next, it->kind, [&](auto& list) { list.erase(list.begin() + it->index); });
    }
    if (hasMirroredChassis(next) && !hasMirroredChassis(project)) {
        const std::string& first = project.rover.bodies.front().name;
        return criticalFor(ElementKind::Body, first,
                           Text::of("it is the chassis, and the next body, '{}', is mirrored.",
                                    next.rover.bodies.front().name),
                           Text::of("Move another body to the second place first."));
    }
    return next;
}

Result<Project> moved(const Project& project, ElementRef element, int newIndex) {
    const std::string& name = nameOf(project, element);
    if (element.isShape()) {
        // Places are counted before it is taken out there.
        return withShapesMoved(project, {element}, element.index,
                               newIndex + (newIndex > element.shape ? 1 : 0));
    }
    if (newIndex < 0 || newIndex >= countOf(project, element.kind)) {
        return criticalFor(element.kind, name, Text::of("there is no such place in the list."),
                           Text::of("Choose another place."));
    }
    Project next = project;
    withList(next, element.kind, [&](auto& list) {
        const auto from = list.begin() + element.index;
        const auto to = list.begin() + newIndex;
        if (from < to) {
            std::rotate(from, from + 1, to + 1);
        } else {
            std::rotate(to, from, from + 1);
        }
    });
    if (element.kind == ElementKind::Body && hasMirroredChassis(next) &&
        !hasMirroredChassis(project)) {
        return criticalFor(element.kind, name,
                           Text::of("the first body is the chassis, and '{}' is mirrored.",
                                    next.rover.bodies.front().name),
                           Text::of("Leave one that is not mirrored in the first place."));
    }
    return next;
}

Result<Project> withShapesMoved(const Project& project, const std::vector<ElementRef>& shapes,
                                int body, int place) {
    if (body < 0 || body >= countOf(project, ElementKind::Body)) {
        return noBody(Text::of("Choose a body."));
    }
    std::vector<Shape> taken;
    int before = 0;
    for (const ElementRef shape : std::set<ElementRef>(shapes.begin(), shapes.end())) {
        if (!shape.isShape()) {
            return Problem{Severity::Critical, titleOf(project, shape), Text::of("it is no shape."),
                           Text::of("Move shapes alone into another body.")};
        }
        taken.push_back(shapeAt(project, shape));
        before += shape.index == body && shape.shape < place ? 1 : 0;
    }
    if (place < 0 || place > shapeCountOf(project, body)) {
        return Problem{Severity::Critical, titleOf(project, {ElementKind::Body, body}),
                       Text::of("there is no such place among its shapes."),
                       Text::of("Choose another place.")};
    }
    auto next = removed(project, shapes);
    if (next) {
        std::vector<Shape>& list = shapesOf(next.value(), body);
        list.insert(list.begin() + place - before, taken.begin(), taken.end());
    }
    return next;
}

Parts partsOf(const Project& project, const std::vector<ElementRef>& elements) {
    Parts parts;
    parts.elements.rover.name = project.rover.name;
    std::set<std::string> names;
    std::set<std::string> own;
    for (const ElementRef element : chosen(project, elements)) {
        if (element.isShape()) {
            parts.shapes.push_back(shapeAt(project, element));
            continue;
        }
        withList(parts.elements, element.kind, [&](auto& list) {
            using List = std::remove_reference_t<decltype(list)>;
            withList(project, element.kind, [&](const auto& from) {
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(from)>, List>) {
                    list.push_back(from[static_cast<std::size_t>(element.index)]);
                }
            });
        });
        if (element.kind == ElementKind::Parameter) {
            own.insert(nameOf(project, element));
        }
    }
    const std::function<void(Quantity&)> note = [&](Quantity& quantity) {
        if (!quantity.isLiteral()) {
            names.merge(namesIn(quantity.text()));
        }
    };
    forEachQuantity(parts.elements, note);
    for (Shape& shape : parts.shapes) {
        QuantityWalker(note).walk(shape);
    }
    for (const Variant& variant : parts.elements.variants) {
        for (const Override& change : variant.set) {
            names.insert(change.parameter);
        }
    }
    addNeeded(project.rover, names);
    for (const Parameter& parameter : project.rover.parameters) {
        if (names.contains(parameter.name) && !own.contains(parameter.name)) {
            parts.needed.push_back(parameter);
        }
    }
    return parts;
}

Result<Project> withParts(const Project& project, const Parts& parts, int body) {
    Project fresh = parts.elements;
    bool any = !parts.shapes.empty();
    if (any && (body < 0 || body >= countOf(project, ElementKind::Body))) {
        return noBody(Text::of("Select the body to put it in first."));
    }
    for (const ElementKind kind : allElementKinds()) {
        for (int i = 0; i < countOf(fresh, kind); ++i) {
            any = true;
            const ElementRef element{kind, i};
            const std::string name = nameOf(fresh, element);
            const std::set<std::string> bases = namesOf(project, kind);
            const std::set<std::string> sides = namesOnSides(project, kind);
            bool taken = bases.contains(name);
            for (const std::string& side : namesOnSides(fresh, element)) {
                taken = taken || bases.contains(side) || sides.contains(side);
            }
            if (!taken) {
                continue;
            }
            // Free in the project and among the parts.
            Project both = project;
            withList(both, kind, [&](auto& list) {
                using List = std::remove_reference_t<decltype(list)>;
                withList(fresh, kind, [&](const auto& more) {
                    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(more)>, List>) {
                        list.insert(list.end(), more.begin(), more.end());
                    }
                });
            });
            auto next =
                renamed(fresh, element, freeName(both, kind, name, isMirrored(fresh, element)));
            if (!next) {
                return next.problems();
            }
            fresh = std::move(next).value();
        }
    }
    if (!any) {
        return Problem{Severity::Critical, Text::of("parts"), Text::of("there are none."),
                       Text::of("Copy some parts first.")};
    }
    Project next = project;
    std::set<std::string> known = namesOf(project, ElementKind::Parameter);
    for (const Parameter& parameter : parts.needed) {
        if (known.insert(parameter.name).second) {
            next.rover.parameters.push_back(parameter);
        }
    }
    for (const ElementKind kind : allElementKinds()) {
        withList(next, kind, [&](auto& list) {
            using List = std::remove_reference_t<decltype(list)>;
            withList(fresh, kind, [&](const auto& more) {
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(more)>, List>) {
                    list.insert(list.end(), more.begin(), more.end());
                }
            });
        });
    }
    if (!parts.shapes.empty()) {
        std::vector<Shape>& shapes = shapesOf(next, body);
        shapes.insert(shapes.end(), parts.shapes.begin(), parts.shapes.end());
    }
    return next;
}

Result<Project> duplicated(const Project& project, const std::vector<ElementRef>& elements) {
    Project next = project;
    std::vector<ElementRef> others;
    for (const ElementRef element : chosen(project, elements)) {
        if (element.isShape()) {
            shapesOf(next, element.index).push_back(shapeAt(project, element));
        } else {
            others.push_back(element);
        }
    }
    return others.empty() ? Result<Project>(std::move(next))
                          : withParts(next, partsOf(next, others));
}

std::vector<ElementRef> appended(const Project& before, const Project& after) {
    std::vector<ElementRef> elements;
    for (const ElementKind kind : allElementKinds()) {
        for (int i = 0; kind == ElementKind::Body && i < countOf(before, kind); ++i) {
            for (int k = shapeCountOf(before, i); k < shapeCountOf(after, i); ++k) {
                elements.push_back({kind, i, k});
            }
        }
        for (int i = countOf(before, kind); i < countOf(after, kind); ++i) {
            elements.push_back({kind, i});
        }
    }
    return elements;
}

}  // namespace simcore::project
