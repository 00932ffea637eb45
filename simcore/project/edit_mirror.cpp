// Mirrored pairs: made of one element, and taken apart.
#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/project/edit.h"
#include "simcore/project/element_names.h"
#include "simcore/project/element_walk.h"
#include "simcore/project/units.h"

namespace simcore::project {
namespace {

constexpr const char* kSideMark = "{side}";

/// One term of names and numbers: a minus before it needs no brackets.
bool isOneFactor(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
               c == '*' || c == '/';
    });
}

std::string negatedText(const std::string& text) {
    if (text.starts_with('-') && isOneFactor(text.substr(1))) {
        return text.substr(1);
    }
    if (text.starts_with("-(") && text.ends_with(')') &&
        text.find_first_of("()", 2) == text.size() - 1) {
        return text.substr(2, text.size() - 3);
    }
    return isOneFactor(text) ? "-" + text : "-(" + text + ")";
}

void negate(Quantity& quantity) {
    if (quantity.isLiteral()) {
        quantity = quantity.literal() == 0.0 ? 0.0 : -quantity.literal();
    } else if (const auto written = splitUnit(quantity.text())) {
        quantity = Quantity::expression(negatedText(written->value) + " " + written->unit->symbol);
    } else {
        quantity = Quantity::expression(negatedText(quantity.text()));
    }
}

/// A free direction as the right side has it. Its letters are kept where only the sense changes and
/// several directions are free: a freedom is a line.
FreedomText rightFreedom(const FreedomText& text, bool alone) {
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    std::string kind;
    std::string direction;
    words >> kind >> direction;
    const bool turn = kind == "turn";
    if (direction == "axis" || direction == (turn ? "y" : "x") || (!turn && direction == "z")) {
        return text;
    }
    if (direction == "x" || direction == "y" || direction == "z") {
        const char* const opposite = direction == "x"   ? "-1 0 0"
                                     : direction == "y" ? "0 -1 0"
                                                        : "0 0 -1";
        return alone ? kind + " " + opposite : text;
    }
    std::istringstream numbers(text.substr(std::min(text.size(), kind.size() + 1)));
    numbers.imbue(std::locale::classic());
    std::array<double, 3> v{};
    if (!(numbers >> v[0] >> v[1] >> v[2])) {
        return text;  // not understood: reported with the joint
    }
    const auto flip = [](double value) { return value == 0.0 ? 0.0 : -value; };
    return turn ? fmt::format("turn {} {} {}", flip(v[0]), v[1], flip(v[2]))
                : fmt::format("slide {} {} {}", v[0], flip(v[1]), v[2]);
}

void makeRight(Body& body) {
    negate(body.com[1]);
    if (body.inertia) {
        negate((*body.inertia)[3]);
        negate((*body.inertia)[5]);
    }
    for (Shape& shape : body.shapes) {
        negate(shape.center[1]);
        negate(shape.from[1]);
        negate(shape.to[1]);
    }
}

void makeRight(Joint& joint) {
    negate(joint.point[1]);
    negate(joint.axis[0]);
    negate(joint.axis[2]);
    for (std::vector<FreedomText>* freedoms : {&joint.free, &joint.relaxed}) {
        for (FreedomText& freedom : *freedoms) {
            freedom = rightFreedom(freedom, freedoms->size() == 1);
        }
    }
}

void makeRight(Wheel& /*wheel*/) {}

void makeRight(Spring& spring) {
    negate(spring.firstPoint[1]);
    negate(spring.secondPoint[1]);
}

void makeRight(Payload& payload) {
    negate(payload.position[1]);
}

/// Calls `f` with the list of the kind when its elements can be mirrored.
template <class P, class F>
void withPairs(P& project, ElementKind kind, F&& f) {
    withList(project, kind, [&](auto& list) {
        if constexpr (requires { list[0].mirror; }) {
            f(list);
        }
    });
}

/// In place of the pair at `element` its left or right half, with references to its own side.
void takeSide(Project& project, ElementRef element, Side side) {
    for (const Reference& reference : referencesIn(project)) {
        if (reference.user == element) {
            const auto meant = meantBy(reference, namesOnSides(project, reference.target));
            const std::string& own = side == Side::Right ? meant.back() : meant.front();
            // What is not there stays as written, and is reported.
            *reference.text = own.empty() ? *reference.text : own;
        }
    }
    withPairs(project, element.kind, [&](auto& list) {
        auto& one = list[static_cast<std::size_t>(element.index)];
        one.name = nameOnSide(one.name, side);
        one.mirror = false;
        if (side == Side::Right) {
            makeRight(one);
        }
    });
}

void splitOne(Project& project, ElementRef element) {
    Project left = project;
    Project right = project;
    takeSide(left, element, Side::Left);
    takeSide(right, element, Side::Right);
    withPairs(project, element.kind, [&](auto& list) {
        using List = std::remove_reference_t<decltype(list)>;
        const auto at = static_cast<std::size_t>(element.index);
        const auto half = [&](const Project& from) {
            const List* found = nullptr;
            withPairs(from, element.kind, [&](const auto& other) {
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(other)>, List>) {
                    found = &other;
                }
            });
            return (*found)[at];
        };
        list[at] = half(left);
        list.insert(list.begin() + element.index + 1, half(right));
    });
}

/// "rocker_left" -> "rocker", "left_wheel" -> "{side}_wheel", "fork" -> "fork".
std::string nameOfPair(const std::string& name) {
    static const std::string kLeft = "left";
    const auto isBoundary = [&](std::size_t at) {
        return at >= name.size() || std::isalnum(static_cast<unsigned char>(name[at])) == 0;
    };
    for (std::size_t at = name.find(kLeft); at != std::string::npos;
         at = name.find(kLeft, at + 1)) {
        const std::size_t end = at + kLeft.size();
        if ((at > 0 && !isBoundary(at - 1)) || !isBoundary(end)) {
            continue;
        }
        if (end == name.size() && at > 1 && name[at - 1] == '_') {
            return name.substr(0, at - 1);
        }
        return name.substr(0, at) + kSideMark + name.substr(end);
    }
    return name;
}

Problem cannotMirror(const Project& project, ElementRef element) {
    return criticalFor(element.kind, nameOf(project, element),
                       Text::of("a {} cannot be mirrored.", nounFor(element.kind)),
                       Text::of("Mirror bodies, joints, wheels, springs and payloads."));
}

/// Gives `texts` that meant the old name of an element its new one.
void replaceMeant(Project& next, const Project& before, ElementRef element,
                  const std::vector<std::string>& from, const std::string& full,
                  const std::string& base) {
    Project old = before;
    const auto now = referencesIn(next);
    const auto then = referencesIn(old);
    const std::set<std::string> known = namesOnSides(before, element.kind);
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (then[i].target != element.kind) {
            continue;
        }
        for (const std::string& meant : meantBy(then[i], known)) {
            if (std::find(from.begin(), from.end(), meant) != from.end()) {
                *now[i].text = then[i].mirrored ? base : full;
            }
        }
    }
}

/// Lets a new pair refer to the pairs whose left halves it named.
void useOwnSides(Project& project, ElementRef element) {
    for (const Reference& reference : referencesIn(project)) {
        const std::string base = nameOfPair(*reference.text);
        if (reference.user == element && nameOnSide(base, Side::Left) == *reference.text &&
            namesOnSides(project, reference.target).contains(nameOnSide(base, Side::Right))) {
            *reference.text = base;
        }
    }
}

Result<Project> pairOf(const Project& project, ElementRef element) {
    const std::string old = nameOf(project, element);
    const std::string base = nameOfPair(old);
    const std::string left = nameOnSide(base, Side::Left);
    const std::string right = nameOnSide(base, Side::Right);
    Project next = project;
    withPairs(next, element.kind, [&](auto& list) {
        auto& one = list[static_cast<std::size_t>(element.index)];
        one.name = base;
        one.mirror = true;
    });
    replaceMeant(next, project, element, {old}, left, base);
    useOwnSides(next, element);
    // The right half of a pair that was split comes home.
    int other = -1;
    for (int i = 0; i < countOf(project, element.kind); ++i) {
        if (i != element.index && nameOf(project, {element.kind, i}) == right) {
            other = i;
        }
    }
    if (other >= 0) {
        Project whole = next;
        withPairs(whole, element.kind, [&](auto& list) { list.erase(list.begin() + other); });
        const int at = element.index - (other < element.index ? 1 : 0);
        Project again = whole;
        splitOne(again, {element.kind, at});
        bool same = false;
        withPairs(again, element.kind, [&](auto& list) {
            using List = std::remove_reference_t<decltype(list)>;
            withPairs(project, element.kind, [&](const auto& was) {
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(was)>, List>) {
                    same = list[static_cast<std::size_t>(at)] ==
                               was[static_cast<std::size_t>(element.index)] &&
                           list[static_cast<std::size_t>(at) + 1] ==
                               was[static_cast<std::size_t>(other)];
                }
            });
        });
        if (same) {
            return whole;
        }
    }
    for (int i = 0; i < countOf(project, element.kind); ++i) {
        const ElementRef one{element.kind, i};
        if (one == element) {
            continue;
        }
        for (const std::string& name : namesOnSides(project, one)) {
            if (name == right || name == left) {
                return criticalFor(
                    element.kind, old,
                    Text::of("there is already a {} '{}'.", nounFor(element.kind), name),
                    Text::of("Delete or rename that first."));
            }
        }
    }
    return next;
}

Result<Project> leftOf(const Project& project, ElementRef element) {
    const std::string base = nameOf(project, element);
    const std::string right = nameOnSide(base, Side::Right);
    Project copy = project;
    std::vector<std::string> users;
    const std::set<std::string> known = namesOnSides(project, element.kind);
    for (const Reference& reference : referencesIn(copy)) {
        const auto meant = meantBy(reference, known);
        if (reference.target == element.kind && meant.front() == right) {
            users.push_back(titleOf(project, reference.user));
        }
    }
    if (!users.empty()) {
        return criticalFor(element.kind, right, usedBy(users),
                           Text::of("Delete those first, or make them use something else."));
    }
    const std::size_t mark = base.find(kSideMark);
    const std::string name = mark == std::string::npos ? base : nameOnSide(base, Side::Left);
    Project next = project;
    withPairs(next, element.kind, [&](auto& list) {
        auto& one = list[static_cast<std::size_t>(element.index)];
        one.name = name;
        one.mirror = false;
    });
    replaceMeant(next, project, element, {nameOnSide(base, Side::Left), right}, name, name);
    return next;
}

}  // namespace

Result<Project> mirrored(const Project& project, const std::vector<ElementRef>& elements,
                         bool mirror) {
    // By name: a half that comes home moves those behind it.
    std::vector<std::pair<ElementKind, std::string>> all;
    for (const ElementRef element : std::set<ElementRef>(elements.begin(), elements.end())) {
        if (!canMirror(element.kind)) {
            return cannotMirror(project, element);
        }
        if (element.isShape()) {
            return Problem{Severity::Critical, titleOf(project, element),
                           Text::of("a shape is mirrored with its body."),
                           Text::of("Mirror the body.")};
        }
        all.emplace_back(element.kind, nameOf(project, element));
    }
    Project next = project;
    for (const auto& [kind, name] : all) {
        for (int i = 0; i < countOf(next, kind); ++i) {
            const ElementRef element{kind, i};
            if (nameOf(next, element) != name || isMirrored(next, element) == mirror) {
                continue;
            }
            auto changed = mirror ? pairOf(next, element) : leftOf(next, element);
            if (!changed) {
                return changed.problems();
            }
            next = std::move(changed).value();
            break;
        }
    }
    return next;
}

Result<Project> split(const Project& project, const std::vector<ElementRef>& elements) {
    const std::set<ElementRef> set(elements.begin(), elements.end());
    Project next = project;
    bool any = false;
    for (auto it = set.rbegin(); it != set.rend(); ++it) {
        nameOf(project, *it);  // throws when there is none
        if (isMirrored(project, *it)) {
            splitOne(next, *it);
            any = true;
        }
    }
    if (!any) {
        return Problem{
            Severity::Critical, set.empty() ? Text::of("parts") : titleOf(project, *set.begin()),
            Text::of("it is not a mirrored pair."), Text::of("Choose one that is mirrored.")};
    }
    return next;
}

}  // namespace simcore::project
