#include "simcore/project/edit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "simcore/project/element_names.h"
#include "simcore/project/expression.h"
#include "simcore/project/fields.h"
#include "simcore/project/units.h"

namespace simcore::project {
namespace {

/// Calls `f` with the list of the kind.
template <class P, class F>
decltype(auto) withList(P& project, ElementKind kind, F&& f) {
    switch (kind) {
        case ElementKind::Parameter:
            return f(project.rover.parameters);
        case ElementKind::Body:
            return f(project.rover.bodies);
        case ElementKind::Joint:
            return f(project.rover.joints);
        case ElementKind::Wheel:
            return f(project.rover.wheels);
        case ElementKind::Spring:
            return f(project.rover.springs);
        case ElementKind::Gear:
            return f(project.rover.gears);
        case ElementKind::Payload:
            return f(project.rover.payloads);
        case ElementKind::Variant:
            return f(project.variants);
        case ElementKind::Scenario:
            break;
    }
    return f(project.scenarios);
}

/// Walks every Quantity below an element through the field table.
class QuantityWalker {
  public:
    explicit QuantityWalker(const std::function<void(Quantity&)>& visit) : visit_(visit) {}

    template <class Element>
    void walk(Element& element) {
        Fields<Element> fields{*this, element};
        describe(fields, static_cast<const Element*>(nullptr));
    }

  private:
    template <class Element>
    struct Fields {
        QuantityWalker& walker;
        Element& element;

        template <class Member>
        void required(const char* /*key*/, Member Element::*member) {
            walker.value(element.*member);
        }

        template <class Member>
        void optional(const char* /*key*/, Member Element::*member) {
            walker.value(element.*member);
        }
    };

    void value(Quantity& quantity) { visit_(quantity); }

    void value(std::string& /*text*/) {}

    template <class T>
    void value(std::optional<T>& maybe) {
        if (maybe) {
            value(*maybe);
        }
    }

    template <class T, std::size_t N>
    void value(std::array<T, N>& values) {
        for (T& one : values) {
            value(one);
        }
    }

    template <class T>
    void value(std::vector<T>& values) {
        for (T& one : values) {
            value(one);
        }
    }

    template <class T>
    void value(T& other) {
        if constexpr (std::is_class_v<T>) {
            walk(other);
        }
    }

    const std::function<void(Quantity&)>& visit_;
};

Problem critical(ElementKind kind, const std::string& name, std::string reason,
                 std::string remedy) {
    return {Severity::Critical, wordFor(kind) + " " + name, std::move(reason), std::move(remedy)};
}

struct Reference {
    std::string* text;
    ElementKind target;
    std::string user;
};

/// Every name by which one element refers to another.
std::vector<Reference> referencesIn(Project& project) {
    std::vector<Reference> all;
    Rover& rover = project.rover;
    const auto add = [&](std::string& text, ElementKind target, std::string user) {
        if (!text.empty()) {
            all.push_back({&text, target, std::move(user)});
        }
    };
    for (Joint& joint : rover.joints) {
        add(joint.first, ElementKind::Body, "joint " + joint.name);
        add(joint.second, ElementKind::Body, "joint " + joint.name);
    }
    for (Wheel& wheel : rover.wheels) {
        add(wheel.body, ElementKind::Body, "wheel " + wheel.name);
        add(wheel.axle, ElementKind::Joint, "wheel " + wheel.name);
        add(wheel.steering, ElementKind::Joint, "wheel " + wheel.name);
    }
    for (Spring& spring : rover.springs) {
        add(spring.first, ElementKind::Body, "spring " + spring.name);
        add(spring.second, ElementKind::Body, "spring " + spring.name);
        add(spring.joint, ElementKind::Joint, "spring " + spring.name);
    }
    for (Gear& gear : rover.gears) {
        add(gear.firstJoint, ElementKind::Joint, "gear " + gear.name);
        add(gear.secondJoint, ElementKind::Joint, "gear " + gear.name);
    }
    for (Payload& payload : rover.payloads) {
        add(payload.body, ElementKind::Body, "payload " + payload.name);
    }
    for (Variant& variant : project.variants) {
        for (Override& change : variant.set) {
            add(change.parameter, ElementKind::Parameter, "variant " + variant.name);
        }
    }
    for (Scenario& scenario : project.scenarios) {
        add(scenario.variant, ElementKind::Variant, "scenario " + scenario.name);
    }
    return all;
}

/// The names a reference may use for an element: its base name and those of its sides.
std::vector<std::string> namesFor(const std::string& name) {
    return {name, nameOnSide(name, Side::Left), nameOnSide(name, Side::Right)};
}

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

bool usesName(const Quantity& quantity, const std::string& name) {
    return !quantity.isLiteral() && namesIn(quantity.text()).contains(name);
}

/// "joint a" for whatever holds an expression with the parameter.
std::vector<std::string> expressionUsers(const Project& project, const std::string& parameter) {
    std::vector<std::string> users;
    Project copy = project;
    for (const ElementKind kind : allElementKinds()) {
        withList(copy, kind, [&](auto& list) {
            for (auto& element : list) {
                bool used = false;
                const std::function<void(Quantity&)> look = [&](Quantity& quantity) {
                    used = used || usesName(quantity, parameter);
                };
                QuantityWalker(look).walk(element);
                if (used) {
                    users.push_back(wordFor(kind) + " " + element.name);
                }
            }
        });
    }
    return users;
}

std::set<std::string> namesOf(const Project& project, ElementKind kind) {
    std::set<std::string> names;
    withList(project, kind, [&](const auto& list) {
        for (const auto& element : list) {
            names.insert(element.name);
        }
    });
    return names;
}

}  // namespace

std::vector<ElementKind> allElementKinds() {
    return {ElementKind::Parameter, ElementKind::Body,    ElementKind::Joint,
            ElementKind::Wheel,     ElementKind::Spring,  ElementKind::Gear,
            ElementKind::Payload,   ElementKind::Variant, ElementKind::Scenario};
}

std::string wordFor(ElementKind kind) {
    switch (kind) {
        case ElementKind::Parameter:
            return "parameter";
        case ElementKind::Body:
            return "body";
        case ElementKind::Joint:
            return "joint";
        case ElementKind::Wheel:
            return "wheel";
        case ElementKind::Spring:
            return "spring";
        case ElementKind::Gear:
            return "gear";
        case ElementKind::Payload:
            return "payload";
        case ElementKind::Variant:
            return "variant";
        case ElementKind::Scenario:
            break;
    }
    return "scenario";
}

int countOf(const Project& project, ElementKind kind) {
    return withList(project, kind, [](const auto& list) { return static_cast<int>(list.size()); });
}

const std::string& nameOf(const Project& project, ElementRef element) {
    if (element.index < 0 || element.index >= countOf(project, element.kind)) {
        throw std::invalid_argument("no " + wordFor(element.kind) + " at this place");
    }
    return withList(project, element.kind, [&](const auto& list) -> const std::string& {
        return list[static_cast<std::size_t>(element.index)].name;
    });
}

ElementRef findElement(const Project& project, const std::string& problemElement) {
    for (const ElementKind kind : allElementKinds()) {
        const std::string word = wordFor(kind) + " ";
        if (!problemElement.starts_with(word)) {
            continue;
        }
        const std::string rest = problemElement.substr(word.size());
        const std::string name = rest.substr(0, rest.find(','));
        for (int i = 0; i < countOf(project, kind); ++i) {
            const auto names = namesFor(nameOf(project, {kind, i}));
            if (std::find(names.begin(), names.end(), name) != names.end()) {
                return {kind, i};
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
    if (name == old) {
        return project;
    }
    if (name.find_first_not_of(' ') == std::string::npos) {
        return critical(element.kind, old, "its new name is empty.", "Type a name.");
    }
    if (namesOf(project, element.kind).contains(name)) {
        return critical(element.kind, old,
                        fmt::format("there is already a {} '{}'.", wordFor(element.kind), name),
                        "Choose another name.");
    }
    if (element.kind == ElementKind::Parameter && !isParameterName(name)) {
        return critical(
            element.kind, old, fmt::format("'{}' cannot be used in expressions.", name),
            "Use up to 100 letters, digits and underscores, not starting with a digit and not "
            "the name of a function.");
    }
    Project next = project;
    withList(next, element.kind,
             [&](auto& list) { list[static_cast<std::size_t>(element.index)].name = name; });
    const std::vector<std::string> from = namesFor(old);
    const std::vector<std::string> to = namesFor(name);
    for (const Reference& reference : referencesIn(next)) {
        const auto found = std::find(from.begin(), from.end(), *reference.text);
        if (reference.target == element.kind && found != from.end()) {
            *reference.text = to[static_cast<std::size_t>(found - from.begin())];
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

std::vector<std::string> usersOf(const Project& project, ElementRef element) {
    const std::string& name = nameOf(project, element);
    const std::vector<std::string> names = namesFor(name);
    std::vector<std::string> users;
    Project copy = project;
    for (const Reference& reference : referencesIn(copy)) {
        if (reference.target == element.kind &&
            std::find(names.begin(), names.end(), *reference.text) != names.end()) {
            users.push_back(reference.user);
        }
    }
    if (element.kind == ElementKind::Parameter) {
        const auto more = expressionUsers(project, name);
        users.insert(users.end(), more.begin(), more.end());
    }
    std::vector<std::string> unique;
    for (const std::string& user : users) {
        if (std::find(unique.begin(), unique.end(), user) == unique.end()) {
            unique.push_back(user);
        }
    }
    return unique;
}

Result<Project> removed(const Project& project, ElementRef element) {
    const std::vector<std::string> users = usersOf(project, element);
    if (!users.empty()) {
        constexpr std::size_t kShown = 4;
        std::string list;
        for (std::size_t i = 0; i < std::min(users.size(), kShown); ++i) {
            list += (i == 0 ? "" : ", ") + users[i];
        }
        if (users.size() > kShown) {
            list += fmt::format(" and {} more", users.size() - kShown);
        }
        return critical(element.kind, nameOf(project, element),
                        fmt::format("it is used by {}.", list),
                        "Delete those first, or make them use something else.");
    }
    Project next = project;
    withList(next, element.kind, [&](auto& list) { list.erase(list.begin() + element.index); });
    return next;
}

Result<Project> duplicated(const Project& project, ElementRef element) {
    const std::set<std::string> taken = namesOf(project, element.kind);
    const std::string& name = nameOf(project, element);
    int number = 2;
    while (taken.contains(fmt::format("{}_{}", name, number))) {
        ++number;
    }
    Project next = project;
    withList(next, element.kind, [&](auto& list) {
        auto copy = list[static_cast<std::size_t>(element.index)];
        copy.name = fmt::format("{}_{}", name, number);
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
    const auto mass = evaluate(body.mass, *parameters, "body " + body.name);
    if (body.mirror || !mass || !(*mass > 0.0)) {
        return critical(ElementKind::Body, body.name,
                        "the centre of mass is moved by moving this body's, and it is mirrored or "
                        "has no mass.",
                        "Make the chassis the first body.");
    }
    const Vec3 shift = (com - mechanism->centerOfMass()) * (mechanism->mass() / *mass);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double move = shift[static_cast<Eigen::Index>(axis)];
        // Leaves a coordinate that stays as it is written.
        if (std::abs(move) > 1e-12) {
            const auto old = evaluate(body.com[axis], *parameters, "body " + body.name);
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
        return Problem{Severity::Critical, element, "there is no number.",
                       "Type a number or an expression."};
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
        return Problem{
            Severity::Critical, element,
            fmt::format("'{}' is a {}, but this is a {}.", trimmed, written->unit->dimension,
                        shown->dimension),
            fmt::format("Write it in {} or another unit of {}.", shown->symbol, shown->dimension)};
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
