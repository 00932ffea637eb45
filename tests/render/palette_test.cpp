#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <Eigen/Dense>

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

namespace {

/// CIELAB of linear sRGB, white point D65 (IEC 61966-2-1; CIE 15).
Eigen::Vector3d lab(const Eigen::Vector3d& linear) {
    Eigen::Matrix3d toXyz;
    toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
    const Eigen::Vector3d white(0.9505, 1.0, 1.089);
    const Eigen::Vector3d f =
        (toXyz * linear.cwiseMax(0.0).cwiseMin(1.0)).cwiseQuotient(white).unaryExpr([](double t) {
            return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
        });
    return {116.0 * f.y() - 16.0, 500.0 * (f.x() - f.y()), 200.0 * (f.y() - f.z())};
}

Eigen::Vector3d linearOf(const Rgb& color) {
    return Eigen::Vector3d(color.r, color.g, color.b).unaryExpr([](double value) {
        const double c = value / 255.0;
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    });
}

/// Least distance of two of the first `count` wheels' colours, seen through `eye`.
double nearest(int count, const Eigen::Matrix3d& eye) {
    double least = 1e9;
    for (int i = 0; i < count; ++i) {
        for (int j = 0; j < i; ++j) {
            least = std::min(least, (lab(eye * linearOf(render::wheelColor(i))) -
                                     lab(eye * linearOf(render::wheelColor(j))))
                                        .norm());
        }
    }
    return least;
}

}  // namespace

// Who sees no red, no green or no blue tells the wheels' colours apart: simulated after Machado,
// Oliveira and Fernandes, "A Physiologically-based Model for Simulation of Color Vision
// Deficiency", 2009, severity 1. A difference of 2.3 is just seen (Mahy et al. 1994); thin lines
// want several times that.
TEST(Palette, WheelsDifferForTheColourBlind) {
    Eigen::Matrix3d protan;
    protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
        1.051998;
    Eigen::Matrix3d deutan;
    deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
        0.968881;
    Eigen::Matrix3d tritan;
    tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367,
        0.303900;
    EXPECT_GT(nearest(8, Eigen::Matrix3d::Identity()), 25.0);
    for (const Eigen::Matrix3d& eye : {protan, deutan, tritan}) {
        EXPECT_GT(nearest(8, eye), 15.0);
    }
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
