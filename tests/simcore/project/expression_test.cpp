#include <clocale>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/project/expression.h"
#include "simcore/project/resolve.h"
#include "simcore/project/units.h"

using namespace simcore;
using namespace simcore::project;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

const ParameterValues kParameters{{"wheel_radius", 0.1}, {"link2m", 3.0}, {"m", 7.0}};

double valueOf(const std::string& text) {
    const auto value = evaluate(Quantity::expression(text), kParameters, "test");
    EXPECT_TRUE(value) << text << ": " << toString(value.problems());
    return value ? *value : std::nan("");
}

bool fails(const std::string& text) {
    const auto value = evaluate(Quantity::expression(text), kParameters, "joint x");
    if (value) {
        return false;
    }
    EXPECT_EQ(value.problems().size(), 1u);
    EXPECT_EQ(value.problems()[0].element, "joint x");
    EXPECT_THAT(value.problems()[0].reason, Not(IsEmpty()));
    EXPECT_THAT(value.problems()[0].remedy, Not(IsEmpty()));
    return true;
}

}  // namespace

TEST(ExpressionTest, UnitsTurnIntoSi) {
    EXPECT_DOUBLE_EQ(valueOf("12 cm"), 0.12);
    EXPECT_DOUBLE_EQ(valueOf("12cm"), 0.12);
    EXPECT_DOUBLE_EQ(valueOf("-1.5e2 mm"), -0.15);
    EXPECT_DOUBLE_EQ(valueOf("30 deg"), std::numbers::pi / 6.0);
    EXPECT_DOUBLE_EQ(valueOf("36 km/h"), 10.0);
    EXPECT_DOUBLE_EQ(valueOf("60 rpm"), 2.0 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(valueOf("2 N/mm"), 2000.0);
    EXPECT_DOUBLE_EQ(valueOf("50 g*cm^2"), 5e-6);
    EXPECT_DOUBLE_EQ(valueOf("1 in"), 0.0254);
    EXPECT_DOUBLE_EQ(valueOf("40 %"), 0.4);
}

TEST(ExpressionTest, ArithmeticOverParameters) {
    EXPECT_DOUBLE_EQ(valueOf("wheel_radius*2"), 0.2);
    EXPECT_DOUBLE_EQ(valueOf("2*wheel_radius + 0.05"), 0.25);
    EXPECT_DOUBLE_EQ(valueOf("-wheel_radius^2"), -0.01);
    EXPECT_DOUBLE_EQ(valueOf("sin(pi/6)"), 0.5);
    EXPECT_DOUBLE_EQ(valueOf("min(wheel_radius, 0.04)"), 0.04);
    EXPECT_DOUBLE_EQ(valueOf("(1 + 2) cm"), 0.03);
}

// A unit counts only after a blank or a plain number: names that end like a unit stay names.
TEST(ExpressionTest, NamesThatEndLikeUnitsStayNames) {
    EXPECT_DOUBLE_EQ(valueOf("link2m"), 3.0);
    EXPECT_DOUBLE_EQ(valueOf("2*m"), 14.0);
    EXPECT_THAT(namesIn("2*wheel_radius + sin(angle) - 1e-3"),
                testing::UnorderedElementsAre("wheel_radius", "angle"));
    EXPECT_THAT(namesIn("12 cm"), IsEmpty());
}

TEST(ExpressionTest, NonsenseIsAProblemAndNeverAValue) {
    for (const char* text : {" ", "1/0", "0/0", "sqrt(-1)", "log(0)", "1e999", "2*", "(1", "1)",
                             "wheel_radios", "wheel_radius = 3", "1,5", "cm", "12 parsec", "a\"b",
                             "1;2", "sin()", "\xff\xfe", "nan"}) {
        EXPECT_TRUE(fails(text)) << "'" << text << "' has a value";
    }
}

TEST(ExpressionTest, DoesNotDependOnTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
        std::setlocale(LC_ALL, name);
        EXPECT_DOUBLE_EQ(valueOf("1.5 cm"), 0.015) << name;
    }
    std::setlocale(LC_ALL, before.c_str());
}

TEST(UnitsTest, WrongDimensionIsRefused) {
    const auto wrong = evaluate(Quantity::expression("12 kg"), {}, "wheel x, radius", "length");
    ASSERT_FALSE(wrong);
    EXPECT_THAT(wrong.problems()[0].reason, HasSubstr("mass"));
    EXPECT_THAT(wrong.problems()[0].remedy, HasSubstr("length"));
    EXPECT_TRUE(evaluate(Quantity::expression("12 cm"), {}, "wheel x, radius", "length"));
    EXPECT_TRUE(evaluate(Quantity::expression("12"), {}, "wheel x, radius", "length"));
    EXPECT_FALSE(evaluate(Quantity(std::nan("")), {}, "x"));
    EXPECT_FALSE(evaluate(Quantity(INFINITY), {}, "x"));
}

TEST(UnitsTest, ShownValueReadsBack) {
    for (const char* symbol : {"mm", "cm", "m", "deg", "rpm", "kg", "g", "N*m", "N/mm"}) {
        const double si = 0.0734 * findUnit(symbol)->factor;
        const std::string text = formatIn(si, symbol) + " " + symbol;
        EXPECT_NEAR(valueOf(text), si, 1e-6 * si) << text;
        EXPECT_FALSE(unitsLike(symbol).empty());
    }
}
