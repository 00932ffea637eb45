#include "simcore/project/element_walk.h"

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/project/element_names.h"
#include "simcore/project/expression.h"

namespace simcore::project {

Problem criticalFor(ElementKind kind, const std::string& name, std::string reason,
                    std::string remedy) {
    return {Severity::Critical, titleFor(kind, name), std::move(reason), std::move(remedy)};
}

std::vector<Reference> referencesIn(Project& project) {
    std::vector<Reference> all;
    Rover& rover = project.rover;
    const auto walk = [&](auto& list, ElementKind kind, auto&& namesOfOne) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            bool mirrored = false;
            if constexpr (requires { list[i].mirror; }) {
                mirrored = list[i].mirror;
            }
            const auto add = [&](std::string& text, ElementKind target) {
                if (!text.empty()) {
                    all.push_back({&text, target, {kind, static_cast<int>(i)}, mirrored});
                }
            };
            namesOfOne(list[i], add);
        }
    };
    walk(rover.joints, ElementKind::Joint, [](Joint& joint, const auto& add) {
        add(joint.first, ElementKind::Body);
        add(joint.second, ElementKind::Body);
    });
    walk(rover.wheels, ElementKind::Wheel, [](Wheel& wheel, const auto& add) {
        add(wheel.body, ElementKind::Body);
        add(wheel.axle, ElementKind::Joint);
        add(wheel.steering, ElementKind::Joint);
    });
    walk(rover.springs, ElementKind::Spring, [](Spring& spring, const auto& add) {
        add(spring.first, ElementKind::Body);
        add(spring.second, ElementKind::Body);
        add(spring.joint, ElementKind::Joint);
    });
    walk(rover.gears, ElementKind::Gear, [](Gear& gear, const auto& add) {
        add(gear.firstJoint, ElementKind::Joint);
        add(gear.secondJoint, ElementKind::Joint);
    });
    walk(rover.payloads, ElementKind::Payload,
         [](Payload& payload, const auto& add) { add(payload.body, ElementKind::Body); });
    walk(project.variants, ElementKind::Variant, [](Variant& variant, const auto& add) {
        for (Override& change : variant.set) {
            add(change.parameter, ElementKind::Parameter);
        }
    });
    walk(project.scenarios, ElementKind::Scenario,
         [](Scenario& scenario, const auto& add) { add(scenario.variant, ElementKind::Variant); });
    return all;
}

std::string titleOf(const Project& project, ElementRef element) {
    const std::string title = titleFor(element.kind, nameOf(project, element));
    return element.isShape() ? Text::of("{}, shape {}", title, element.shape + 1) : title;
}

bool canMirror(ElementKind kind) {
    return kind == ElementKind::Body || kind == ElementKind::Joint || kind == ElementKind::Wheel ||
           kind == ElementKind::Spring || kind == ElementKind::Payload;
}

bool isMirrored(const Project& project, ElementRef element) {
    if (element.isShape()) {
        return false;
    }
    return withList(project, element.kind, [&](const auto& list) {
        const auto& one = list[static_cast<std::size_t>(element.index)];
        if constexpr (requires { one.mirror; }) {
            return one.mirror;
        } else {
            return false;
        }
    });
}

std::vector<std::string> namesOnSides(const Project& project, ElementRef element) {
    const std::string& name = nameOf(project, element);
    return isMirrored(project, element)
               ? std::vector{nameOnSide(name, Side::Left), nameOnSide(name, Side::Right)}
               : std::vector{name};
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

std::set<std::string> namesOnSides(const Project& project, ElementKind kind) {
    std::set<std::string> names;
    for (int i = 0; i < countOf(project, kind); ++i) {
        for (std::string& name : namesOnSides(project, ElementRef{kind, i})) {
            names.insert(std::move(name));
        }
    }
    return names;
}

std::vector<std::string> meantBy(const Reference& reference, const std::set<std::string>& names) {
    const auto found = [&](Side side) {
        const std::string own = nameOnSide(*reference.text, side);
        return names.contains(own)               ? own
               : names.contains(*reference.text) ? *reference.text
                                                 : std::string();
    };
    return reference.mirrored ? std::vector{found(Side::Left), found(Side::Right)}
                              : std::vector{found(Side::Center)};
}

std::string freeName(const Project& project, ElementKind kind, const std::string& name,
                     bool mirrored) {
    const std::set<std::string> bases = namesOf(project, kind);
    const std::set<std::string> sides = namesOnSides(project, kind);
    for (int number = 2;; ++number) {
        std::string next = fmt::format("{}_{}", name, number);
        const bool taken = bases.contains(next) || sides.contains(next) ||
                           (mirrored && (sides.contains(nameOnSide(next, Side::Left)) ||
                                         sides.contains(nameOnSide(next, Side::Right))));
        if (!taken) {
            return next;
        }
    }
}

std::string usedBy(const std::vector<std::string>& users) {
    constexpr std::size_t kShown = 4;
    std::string list;
    for (std::size_t i = 0; i < std::min(users.size(), kShown); ++i) {
        list += (i == 0 ? "" : ", ") + users[i];
    }
    if (users.size() > kShown) {
        list = Text::of("{} and {} more", list, users.size() - kShown);
    }
    return Text::of("it is used by {}.", list);
}

bool usesName(const Quantity& quantity, const std::string& parameter) {
    return !quantity.isLiteral() && namesIn(quantity.text()).contains(parameter);
}

}  // namespace simcore::project
