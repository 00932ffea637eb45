#include "render/palette.h"

#include <charconv>
#include <utility>

namespace render {

namespace {

constexpr std::array<std::pair<std::string_view, Rgb>, 8> kNamed = {{
    {"chassis", {222, 226, 230}},
    {"link", {176, 186, 196}},
    {"link_dark", {74, 82, 92}},
    {"accent", {226, 142, 32}},
    {"solar", {28, 48, 108}},
    {"metal", {168, 172, 178}},
    {"tyre", {52, 54, 58}},
    {"white", {244, 244, 242}},
}};

}  // namespace

std::optional<Rgb> parseColor(std::string_view text) {
    for (const auto& [name, color] : kNamed) {
        if (text == name) {
            return color;
        }
    }
    if (text.size() != 7 || text.front() != '#') {
        return std::nullopt;
    }
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    if (error != std::errc() || end != text.data() + 7) {
        return std::nullopt;
    }
    return Rgb{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
               static_cast<std::uint8_t>(value)};
}

}  // namespace render
