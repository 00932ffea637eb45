// Parts on their way over the clipboard.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/io/project_file.h"
#include "simcore/project/edit.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::project;
using namespace testsupport;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

std::vector<ElementRef> named(const Project& project,
                              const std::vector<std::pair<ElementKind, std::string>>& wanted) {
    std::vector<ElementRef> found;
    for (const auto& [kind, name] : wanted) {
        for (int i = 0; i < countOf(project, kind); ++i) {
            if (nameOf(project, {kind, i}) == name) {
                found.push_back({kind, i});
            }
        }
    }
    EXPECT_EQ(found.size(), wanted.size());
    return found;
}

Project pasted(const Project& project, const std::string& text) {
    const auto parts = io::parseParts(text);
    if (!parts) {
        throw std::runtime_error(toString(parts.problems()));
    }
    const auto next = withParts(project, *parts);
    if (!next) {
        throw std::runtime_error(toString(next.problems()));
    }
    return *next;
}

const std::vector<std::pair<ElementKind, std::string>> kRearWheel{
    {ElementKind::Body, "{side}_rear_wheel"},
    {ElementKind::Joint, "{side}_rear_axle"},
    {ElementKind::Wheel, "{side}_rear"}};

}  // namespace

class ShippedClipboardTest : public testing::TestWithParam<std::string> {};

TEST_P(ShippedClipboardTest, PartsComeBackAsTheyWere) {
    const Project project = shipped(GetParam());
    std::vector<ElementRef> all;
    for (const ElementKind kind : allElementKinds()) {
        for (int i = 0; i < countOf(project, kind); ++i) {
            all.push_back({kind, i});
        }
    }
    const Parts parts = partsOf(project, all);
    EXPECT_TRUE(parts.needed.empty());
    const auto read = io::parseParts(io::formatParts(parts));
    ASSERT_TRUE(read) << toString(read.problems());
    EXPECT_EQ(*read, parts);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedClipboardTest, testing::ValuesIn(shippedNames()),
                         [](const auto& test) { return test.param; });

TEST(ClipboardTest, TakenNamesGetANumberAndTheirReferencesFollow) {
    const Project project = shipped("rocker_bogie");
    const Project next =
        pasted(project, io::formatParts(partsOf(project, named(project, kRearWheel))));
    const Wheel& wheel = next.rover.wheels.back();
    EXPECT_EQ(wheel.name, "{side}_rear_2");
    EXPECT_EQ(wheel.body, "{side}_rear_wheel_2");
    EXPECT_EQ(wheel.axle, "{side}_rear_axle_2");
    EXPECT_EQ(next.rover.joints.back().first, "bogie");  // not among the parts: the same as before
    EXPECT_FALSE(hasCritical(validate(next))) << toString(validate(next));
    EXPECT_EQ(next.rover.parameters, project.rover.parameters);
    // Again: the next numbers.
    const Project more =
        pasted(next, io::formatParts(partsOf(project, named(project, kRearWheel))));
    EXPECT_EQ(more.rover.wheels.back().body, "{side}_rear_wheel_3");
}

TEST(ClipboardTest, ParametersThatAreMissingComeAlongWithWhatTheyNeed) {
    const Project from = shipped("rocker_bogie");
    Project to = cart();
    const std::string text = io::formatParts(partsOf(from, named(from, kRearWheel)));
    const Project next = pasted(to, text);
    std::vector<std::string> names;
    for (const Parameter& parameter : next.rover.parameters) {
        names.push_back(parameter.name);
    }
    // The cart's own wheel_radius and wheel_width stay as they are.
    EXPECT_THAT(names, ElementsAre("wheel_radius", "wheel_width", "track", "wheel_mass",
                                   "wheel_spacing", "half_track", "wheel_torque_limit",
                                   "wheel_speed_limit", "rotor_inertia"));
    EXPECT_EQ(next.rover.parameters[0], to.rover.parameters[0]);
    EXPECT_TRUE(evaluateParameters(next.rover));
}

TEST(ClipboardTest, CopiedParameterIsANewOneAndWhatWasCopiedWithItUsesIt) {
    const Project project = cart();
    const Project next = pasted(
        project, io::formatParts(partsOf(project, named(project, {{ElementKind::Parameter, "track"},
                                                                  {ElementKind::Joint, "axle"}}))));
    EXPECT_EQ(next.rover.parameters.back().name, "track_2");
    EXPECT_EQ(next.rover.joints.back().point[1].text(), "track_2/2");
}

TEST(ClipboardTest, VariantBringsTheParametersItSets) {
    const Project from = cart();
    const Parts parts = partsOf(from, named(from, {{ElementKind::Variant, "big"}}));
    ASSERT_EQ(parts.needed.size(), 1U);
    EXPECT_EQ(parts.needed.front().name, "wheel_radius");
}

TEST(ClipboardTest, ForeignTextIsRefusedInWords) {
    for (const std::string text :
         {"", "hello", "{}", "[1, 2]", "{\"format\": \"roverstudio-project\", \"version\": 1}",
          cartText()}) {
        const auto parts = io::parseParts(text);
        ASSERT_FALSE(parts) << text;
        EXPECT_THAT(parts.problems().front().reason, HasSubstr("no parts")) << text;
    }
    const auto old = io::parseParts(R"({"format": "roverstudio-parts", "version": 9})");
    ASSERT_FALSE(old);
    EXPECT_THAT(old.problems().front().reason, HasSubstr("version"));
    std::string broken = io::formatParts(partsOf(cart(), {{ElementKind::Body, 0}}));
    broken.replace(broken.find("\"mass\""), 6, "\"muss\"");
    const auto misspelt = io::parseParts(broken);
    ASSERT_FALSE(misspelt);
    EXPECT_THAT(toString(misspelt.problems()), HasSubstr("muss"));
}

TEST(ClipboardTest, NothingCannotBePasted) {
    EXPECT_FALSE(withParts(cart(), Parts{}));
}

TEST(ClipboardTest, ShapesGoIntoTheChosenBodyWithTheParametersTheyNeed) {
    const Project project = shipped("rocker_bogie");
    const ElementRef chassis{ElementKind::Body, 0};
    const int count = shapeCountOf(project, 0);
    ASSERT_GT(count, 1);
    const Parts parts = partsOf(project, {{ElementKind::Body, 0, 0}, {ElementKind::Body, 0, 1}});
    EXPECT_EQ(parts.shapes.size(), 2U);
    EXPECT_TRUE(parts.elements.rover.bodies.empty());
    // With their body they need no place of their own.
    EXPECT_TRUE(partsOf(project, {chassis, {ElementKind::Body, 0, 0}}).shapes.empty());
    const auto read = io::parseParts(io::formatParts(parts));
    ASSERT_TRUE(read) << toString(read.problems());
    EXPECT_EQ(*read, parts);
    EXPECT_FALSE(withParts(project, *read));  // into which body?
    const auto next = withParts(project, *read, 0);
    ASSERT_TRUE(next);
    EXPECT_EQ(shapeCountOf(*next, 0), count + 2);
    const auto fresh = appended(project, *next);
    EXPECT_THAT(fresh, ElementsAre(ElementRef{ElementKind::Body, 0, count},
                                   ElementRef{ElementKind::Body, 0, count + 1}));
    EXPECT_EQ(shapeAt(*next, fresh.front()), shapeAt(project, {ElementKind::Body, 0, 0}));
    EXPECT_FALSE(hasCritical(validate(*next))) << toString(validate(*next));
}
