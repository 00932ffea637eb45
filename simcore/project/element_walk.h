#pragma once

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "simcore/base/text.h"
#include "simcore/project/edit.h"
#include "simcore/project/fields.h"

/// What the functions that edit projects share: lists by kind, all numbers of an element, all
/// names by which one element refers to another.
namespace simcore::project {

/// Why a body without a joint is a problem; marked.
inline constexpr const char* kNotConnected = Text::mark("no joint connects it to the chassis.");

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

/// Those of the body, which must be there.
inline std::vector<Shape>& shapesOf(Project& project, int body) {
    return project.rover.bodies.at(static_cast<std::size_t>(body)).shapes;
}

/// Walks every Quantity below an element through the field table.
class QuantityWalker {
  public:
    /// `visit` must outlive the walker.
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

/// One name by which an element refers to another.
struct Reference {
    std::string* text;
    ElementKind target;
    ElementRef user;
    bool mirrored;  ///< the user is: the name is read on either side
};

/// All of them; they point into `project`. Never empty texts.
std::vector<Reference> referencesIn(Project& project);

/// "joint fork_a", "body fork, shape 2".
std::string titleOf(const Project& project, ElementRef element);

/// The names that an element has after mirroring: one, or left and right.
std::vector<std::string> namesOnSides(const Project& project, ElementRef element);

/// Base names of all elements of the kind.
std::set<std::string> namesOf(const Project& project, ElementKind kind);
/// Names of all elements of the kind after mirroring.
std::set<std::string> namesOnSides(const Project& project, ElementKind kind);

/// Names of the elements that the reference means, after mirroring: left then right of a mirrored
/// user, who reads it on his own side first and then as it stands. Those that do not exist are
/// "".
std::vector<std::string> meantBy(const Reference& reference, const std::set<std::string>& names);

/// "<name>_2" or the next number that is free for an element like this.
std::string freeName(const Project& project, ElementKind kind, const std::string& name,
                     bool mirrored);

/// "it is used by a, b, c, d and 2 more."
std::string usedBy(const std::vector<std::string>& users);

bool usesName(const Quantity& quantity, const std::string& parameter);

Problem criticalFor(ElementKind kind, const std::string& name, std::string reason,
                    std::string remedy);

/// Whether an element of the kind can be mirrored.
bool canMirror(ElementKind kind);
/// Not of a shape: its body may be.
bool isMirrored(const Project& project, ElementRef element);

}  // namespace simcore::project
