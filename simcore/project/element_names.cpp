#include "simcore/project/element_names.h"

#include "simcore/base/text.h"

namespace simcore::project {

std::string nameOnSide(const std::string& name, Side side) {
    if (side == Side::Center) {
        return name;
    }
    const std::string word = side == Side::Left ? "left" : "right";
    static const std::string mark = "{side}";
    const std::size_t at = name.find(mark);
    if (at == std::string::npos) {
        return name + "_" + word;
    }
    return name.substr(0, at) + word + name.substr(at + mark.size());
}

int NameIndex::find(const std::string& reference, Side side) const {
    if (side != Side::Center) {
        if (const auto own = index_.find(nameOnSide(reference, side)); own != index_.end()) {
            return own->second;
        }
    }
    const auto found = index_.find(reference);
    return found == index_.end() ? -1 : found->second;
}

std::string NameIndex::list() const {
    constexpr std::size_t kShown = 12;
    std::string text;
    std::size_t count = 0;
    for (const auto& [name, index] : index_) {
        if (++count > kShown) {
            return text + ", ...";
        }
        text += (text.empty() ? "" : ", ") + name;
    }
    return text.empty() ? Text::of("none") : text;
}

}  // namespace simcore::project
