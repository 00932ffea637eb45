#pragma once

#include <map>
#include <string>
#include <vector>

#include "simcore/project/project.h"

/// Names of mirrored elements and how references find them.
namespace simcore::project {

/// Which of its two copies a mirrored element is; Center = not mirrored.
enum class Side { Center, Left, Right };

/// "bogie_{side}_front" -> "bogie_left_front"; "rocker" -> "rocker_left"; unchanged for Center.
std::string nameOnSide(const std::string& name, Side side);

/// One copy of an element of the file.
template <class Element>
struct Copy {
    const Element* element;
    Side side;
    std::string name;
};

/// All copies in the order of the file; a run of consecutive mirrored elements comes as all its
/// left copies, then all its right ones, so that one bogie's parts stay together.
template <class Element>
std::vector<Copy<Element>> expandMirrored(const std::vector<Element>& elements) {
    std::vector<Copy<Element>> copies;
    for (std::size_t i = 0; i < elements.size();) {
        if (!elements[i].mirror) {
            copies.push_back({&elements[i], Side::Center, elements[i].name});
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < elements.size() && elements[end].mirror) {
            ++end;
        }
        for (const Side side : {Side::Left, Side::Right}) {
            for (std::size_t k = i; k < end; ++k) {
                copies.push_back({&elements[k], side, nameOnSide(elements[k].name, side)});
            }
        }
        i = end;
    }
    return copies;
}

/// Names of the resolved elements of one kind.
class NameIndex {
  public:
    /// False when the name is taken.
    bool add(const std::string& name, int index) { return index_.emplace(name, index).second; }

    /// Index of the element that `reference` means, seen from `side`; -1 when there is none. A
    /// mirrored element is found by its own base name (own side) or by a full name (any side).
    int find(const std::string& reference, Side side) const;

    /// The known names, for messages.
    std::string list() const;

  private:
    std::map<std::string, int> index_;
};

}  // namespace simcore::project
