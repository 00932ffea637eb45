#include "simcore/base/text.h"

#include <atomic>

#include <fmt/format.h>

namespace simcore {
namespace {

std::atomic<Text::LookUp> installedLookUp{nullptr};

}  // namespace

void Text::setLookUp(LookUp lookUp) {
    installedLookUp = lookUp;
}

std::string Text::translated(const char* marked) {
    const LookUp lookUp = installedLookUp;
    std::string found = lookUp == nullptr ? std::string() : lookUp(marked);
    return found.empty() ? marked : found;
}

std::string Text::format(fmt::string_view pattern, fmt::format_args args) {
    const LookUp lookUp = installedLookUp;
    // Patterns are literals, and so end with a zero.
    const std::string found = lookUp == nullptr ? std::string() : lookUp(pattern.data());
    if (!found.empty()) {
        try {
            return fmt::vformat(found, args);
        } catch (const fmt::format_error&) {
            // A mistake in the translation; its test finds it before a user does.
        }
    }
    return fmt::vformat(pattern, args);
}

}  // namespace simcore
