#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "render/palette.h"

using render::Rgb;

// The wheels of every shipped rover get different colours, and any index has one.
TEST(Palette, EightWheelsDifferAndIndicesWrap) {
    std::set<std::tuple<int, int, int>> colors;
    for (int wheel = 0; wheel < 8; ++wheel) {
        const Rgb color = render::wheelColor(wheel);
        colors.insert({color.r, color.g, color.b});
        EXPECT_EQ(render::wheelColor(wheel + 8), color);
        EXPECT_EQ(render::wheelColor(wheel - 8), color);
    }
    EXPECT_EQ(colors.size(), 8U);
}

// Colours of a project file are read as written, in either case.
TEST(Palette, HexColoursAreRead) {
    EXPECT_EQ(render::parseColor("#0a80FF"), (Rgb{10, 128, 255}));
    EXPECT_EQ(render::parseColor("#000000"), (Rgb{0, 0, 0}));
}

// What is neither a name nor a colour is nothing, not some colour.
TEST(Palette, NonsenseIsNoColour) {
    for (const char* text : {"", "#", "#12345", "#1234567", "#12345g", "#-12345", "blue-ish"}) {
        EXPECT_FALSE(render::parseColor(text).has_value()) << text;
    }
    EXPECT_TRUE(render::parseColor("chassis").has_value());
}
