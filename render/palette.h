#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

/// Colours shared by the picture and the plots. Plain numbers: no OpenSceneGraph, no Qt.
namespace render {

/// sRGB, 0..255.
struct Rgb {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Rgb&) const = default;
};

/// Colours that people with any common colour blindness tell apart: Okabe and Ito, "Color Universal
/// Design", 2008. Yellow comes late: it is weak on white.
inline constexpr std::array<Rgb, 8> kOkabeIto = {{
    {0, 114, 178},    // blue
    {213, 94, 0},     // vermilion
    {0, 158, 115},    // bluish green
    {230, 159, 0},    // orange
    {86, 180, 233},   // sky blue
    {204, 121, 167},  // reddish purple
    {240, 228, 66},   // yellow
    {96, 96, 96},     // grey, in place of black: a lighter one is like green and purple to many
}};

/// Colour of the wheel at this index of the mechanism: the same in picture, plots and tables.
constexpr Rgb wheelColor(int wheel) {
    const int n = static_cast<int>(kOkabeIto.size());
    return kOkabeIto[static_cast<std::size_t>(((wheel % n) + n) % n)];
}

/// "#rrggbb" or a palette name (chassis, link, link_dark, accent, solar, metal, tyre, white);
/// nothing when it is neither.
std::optional<Rgb> parseColor(std::string_view text);

}  // namespace render
