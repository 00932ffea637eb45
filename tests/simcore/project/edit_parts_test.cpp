// Adding, removing, moving, mirroring and splitting elements of the shipped projects.
#include <algorithm>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/mobility/mobility.h"
#include "simcore/project/edit.h"
#include "simcore/project/names.h"
#include "simcore/run/simulation.h"
#include "tests/support/other_language.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::project;
using namespace testsupport;
using testing::HasSubstr;

namespace {

Project must(const Result<Project>& result) {
    if (!result) {
        throw std::runtime_error(toString(result.problems()));
    }
    return *result;
}

mechanism::Mechanism mechanismOf(const Project& project) {
    auto mechanism = resolve(project);
    if (!mechanism) {
        throw std::runtime_error(toString(mechanism.problems()));
    }
    return std::move(mechanism).value();
}

ElementRef findNamed(const Project& project, ElementKind kind, const std::string& name) {
    for (int i = 0; i < countOf(project, kind); ++i) {
        if (nameOf(project, {kind, i}) == name) {
            return {kind, i};
        }
    }
    throw std::runtime_error("there is no " + name);
}

std::vector<ElementRef> allOf(const Project& project) {
    std::vector<ElementRef> all;
    for (const ElementKind kind : allElementKinds()) {
        for (int i = 0; i < countOf(project, kind); ++i) {
            all.push_back({kind, i});
        }
    }
    return all;
}

std::vector<ElementRef> mirroredOf(const Project& project) {
    std::vector<ElementRef> pairs;
    const Rover& rover = project.rover;
    const auto look = [&](const auto& list, ElementKind kind) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].mirror) {
                pairs.push_back({kind, static_cast<int>(i)});
            }
        }
    };
    look(rover.bodies, ElementKind::Body);
    look(rover.joints, ElementKind::Joint);
    look(rover.wheels, ElementKind::Wheel);
    look(rover.springs, ElementKind::Spring);
    look(rover.payloads, ElementKind::Payload);
    return pairs;
}

void expectSameFreedoms(const std::vector<mechanism::Freedom>& a,
                        const std::vector<mechanism::Freedom>& b, const std::string& name) {
    ASSERT_EQ(a.size(), b.size()) << name;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].kind, b[i].kind) << name;
        // A freedom is a line: its sense is of no consequence.
        EXPECT_NEAR(std::abs(a[i].direction.dot(b[i].direction)), 1.0, 1e-12) << name;
    }
}

/// The same parts under the same names, in whatever order.
void expectSameMechanism(const mechanism::Mechanism& a, const mechanism::Mechanism& b) {
    ASSERT_EQ(a.bodies.size(), b.bodies.size());
    ASSERT_EQ(a.joints.size(), b.joints.size());
    ASSERT_EQ(a.wheels.size(), b.wheels.size());
    ASSERT_EQ(a.springs.size(), b.springs.size());
    ASSERT_EQ(a.gears.size(), b.gears.size());
    EXPECT_EQ(a.bodies.front().name, b.bodies.front().name);
    for (const mechanism::Body& body : a.bodies) {
        const int at = b.findBody(body.name);
        ASSERT_GE(at, 0) << body.name;
        const mechanism::Body& other = b.bodies[static_cast<std::size_t>(at)];
        EXPECT_NEAR(body.mass, other.mass, 1e-12) << body.name;
        EXPECT_LT((body.com - other.com).norm(), 1e-12) << body.name;
        EXPECT_LT((body.inertia - other.inertia).norm(), 1e-12) << body.name;
        ASSERT_EQ(body.shapes.size(), other.shapes.size()) << body.name;
        for (std::size_t i = 0; i < body.shapes.size(); ++i) {
            EXPECT_LT((body.shapes[i].center - other.shapes[i].center).norm(), 1e-12) << body.name;
            EXPECT_LT((body.shapes[i].from - other.shapes[i].from).norm(), 1e-12) << body.name;
            EXPECT_LT((body.shapes[i].to - other.shapes[i].to).norm(), 1e-12) << body.name;
        }
    }
    for (const mechanism::Joint& joint : a.joints) {
        const int at = b.findJoint(joint.name);
        ASSERT_GE(at, 0) << joint.name;
        const mechanism::Joint& other = b.joints[static_cast<std::size_t>(at)];
        const auto name = [](const mechanism::Mechanism& m, int body) {
            return m.bodies[static_cast<std::size_t>(body)].name;
        };
        EXPECT_EQ(name(a, joint.first), name(b, other.first)) << joint.name;
        EXPECT_EQ(name(a, joint.second), name(b, other.second)) << joint.name;
        EXPECT_LT((joint.point - other.point).norm(), 1e-12) << joint.name;
        EXPECT_LT((joint.axis - other.axis).norm(), 1e-12) << joint.name;
        EXPECT_EQ(joint.stops, other.stops) << joint.name;
        expectSameFreedoms(joint.built, other.built, joint.name);
        expectSameFreedoms(joint.relaxed, other.relaxed, joint.name);
    }
    for (const mechanism::Wheel& wheel : a.wheels) {
        const int at = b.findWheel(wheel.name);
        ASSERT_GE(at, 0) << wheel.name;
        const mechanism::Wheel& other = b.wheels[static_cast<std::size_t>(at)];
        EXPECT_LT((wheel.center - other.center).norm(), 1e-12) << wheel.name;
        EXPECT_LT((wheel.axis - other.axis).norm(), 1e-12) << wheel.name;
        EXPECT_EQ(wheel.relaxedLateral, other.relaxedLateral) << wheel.name;
    }
    for (const auto model : {mobility::Model::Built, mobility::Model::Relaxed}) {
        const auto was = mobility::analyse(a, model);
        const auto is = mobility::analyse(b, model);
        EXPECT_EQ(was.gruebler, is.gruebler);
        EXPECT_EQ(was.rank, is.rank);
        EXPECT_EQ(was.mobility, is.mobility);
        EXPECT_EQ(was.redundant, is.redundant);
    }
}

/// What would keep the rover from being analysed or driven.
std::size_t criticals(const Project& project) {
    const Problems problems = run::checkProject(project);
    return static_cast<std::size_t>(std::count_if(
        problems.begin(), problems.end(),
        [](const Problem& problem) { return problem.severity == Severity::Critical; }));
}

}  // namespace

class ShippedPartsTest : public testing::TestWithParam<std::string> {};

TEST_P(ShippedPartsTest, EveryKindCanBeAddedAndIsValidAtOnce) {
    const Project before = shipped(GetParam());
    for (const ElementKind kind : allElementKinds()) {
        const auto next = added(before, kind);
        ASSERT_TRUE(next) << wordFor(kind) << ": " << toString(next.problems());
        EXPECT_EQ(countOf(*next, kind), countOf(before, kind) + 1) << wordFor(kind);
        EXPECT_EQ(criticals(*next), 0U)
            << wordFor(kind) << ": " << toString(run::checkProject(*next));
        EXPECT_EQ(appended(before, *next).empty(), false);
        // A second one has a name of its own.
        const auto more = added(*next, kind);
        ASSERT_TRUE(more) << wordFor(kind) << ": " << toString(more.problems());
        EXPECT_EQ(criticals(*more), 0U)
            << wordFor(kind) << ": " << toString(run::checkProject(*more));
        // Taken away together, nothing is left of it.
        EXPECT_EQ(must(removed(*more, appended(before, *more))), before) << wordFor(kind);
    }
}

TEST_P(ShippedPartsTest, SplittingAnyPairLeavesTheMechanism) {
    const Project before = shipped(GetParam());
    const auto whole = mechanismOf(before);
    for (const ElementRef pair : mirroredOf(before)) {
        SCOPED_TRACE(wordFor(pair.kind) + " " + nameOf(before, pair));
        const Project next = must(split(before, {pair}));
        EXPECT_EQ(countOf(next, pair.kind), countOf(before, pair.kind) + 1);
        expectSameMechanism(whole, mechanismOf(next));
    }
}

TEST_P(ShippedPartsTest, SplittingAllPairsLeavesTheMechanismAndMirroringBringsThemBack) {
    const Project before = shipped(GetParam());
    const std::vector<ElementRef> pairs = mirroredOf(before);
    const Project apart = must(split(before, pairs));
    EXPECT_TRUE(mirroredOf(apart).empty());
    expectSameMechanism(mechanismOf(before), mechanismOf(apart));
    std::vector<ElementRef> lefts;
    for (const ElementRef element : allOf(apart)) {
        if (nameOf(apart, element).find("left") != std::string::npos &&
            element.kind != ElementKind::Gear && element.kind != ElementKind::Parameter) {
            lefts.push_back(element);
        }
    }
    EXPECT_EQ(must(mirrored(apart, lefts, true)), before);
}

TEST_P(ShippedPartsTest, RemovingEverythingAtOnceIsNoMatterOfOrder) {
    const Project before = shipped(GetParam());
    const Project next = must(removed(before, allOf(before)));
    for (const ElementKind kind : allElementKinds()) {
        EXPECT_EQ(countOf(next, kind), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedPartsTest, testing::ValuesIn(shippedNames()),
                         [](const auto& test) { return test.param; });

TEST(RemovePartsTest, WheelGoesWithItsBodyAndAxleButNotAlone) {
    const Project before = shipped("rocker_bogie");
    const ElementRef body = findNamed(before, ElementKind::Body, "{side}_rear_wheel");
    const ElementRef axle = findNamed(before, ElementKind::Joint, "{side}_rear_axle");
    const ElementRef wheel = findNamed(before, ElementKind::Wheel, "{side}_rear");
    const auto refused = removed(before, {body, axle});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.problems().size(), 2U);  // each with its reason
    EXPECT_THAT(toString(refused.problems()), HasSubstr("wheel {side}_rear"));
    const Project next = must(removed(before, {body, axle, wheel}));
    EXPECT_EQ(mechanismOf(next).wheels.size(), 4U);
}

// After a split, a mirrored joint still names both halves by the name of the pair.
TEST(RemovePartsTest, HalfOfASplitPairIsKnownToItsMirroredUsers) {
    const Project before = shipped("rocker_bogie");
    const Project next = must(split(before, {findNamed(before, ElementKind::Body, "rocker")}));
    const ElementRef left = findNamed(next, ElementKind::Body, "rocker_left");
    EXPECT_THAT(usersOf(next, left), testing::Contains("joint rocker_pivot"));
    EXPECT_FALSE(removed(next, left));
    const auto refused = renamed(next, left, "port");
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.problems().front().remedy, HasSubstr("Split"));
}

TEST(MovePartsTest, OrderChangesAndComesBack) {
    const Project before = shipped("solero");
    const Project next = must(moved(before, {ElementKind::Body, 1}, 3));
    EXPECT_EQ(next.rover.bodies[3].name, before.rover.bodies[1].name);
    EXPECT_EQ(next.rover.bodies[1].name, before.rover.bodies[2].name);
    EXPECT_EQ(must(moved(next, {ElementKind::Body, 3}, 1)), before);
    EXPECT_FALSE(moved(before, {ElementKind::Body, 1}, -1));
    EXPECT_FALSE(moved(before, {ElementKind::Body, 1}, 1000));
}

TEST(MovePartsTest, MirroredBodyCannotBecomeTheChassis) {
    const Project before = shipped("rocker_bogie");
    ASSERT_TRUE(before.rover.bodies[1].mirror);
    const auto refused = moved(before, {ElementKind::Body, 1}, 0);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.problems().front().reason, HasSubstr("chassis"));
}

TEST(MirrorPartsTest, LegWithBodyJointAndWheelBecomesAPairAtOnce) {
    Project before = shipped("rocker_bogie");
    before = must(added(before, ElementKind::Wheel));
    // The new pair, taken apart and its right half away, is one wheel at the left.
    std::vector<ElementRef> fresh = appended(shipped("rocker_bogie"), before);
    const Project whole = before;
    const Project apart = must(split(before, fresh));
    std::vector<ElementRef> rights;
    std::vector<ElementRef> lefts;
    for (const ElementRef element : allOf(apart)) {
        const std::string& name = nameOf(apart, element);
        if (name == "wheel_right" || name == "axle_right") {
            rights.push_back(element);
        }
    }
    ASSERT_EQ(rights.size(), 3U);
    const Project single = must(removed(apart, rights));
    EXPECT_EQ(mechanismOf(single).wheels.size(), 7U);
    for (const ElementRef element : allOf(single)) {
        const std::string& name = nameOf(single, element);
        if (name == "wheel_left" || name == "axle_left") {
            lefts.push_back(element);
        }
    }
    EXPECT_EQ(must(mirrored(single, lefts, true)), whole);
}

TEST(MirrorPartsTest, UnmirroringIsRefusedWhileTheRightOneIsUsed) {
    const Project before = shipped("rocker_bogie");
    const auto refused =
        mirrored(before, {findNamed(before, ElementKind::Joint, "rocker_pivot")}, false);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.problems().front().reason, HasSubstr("gear differential"));
}

TEST(MirrorPartsTest, PayloadIsMirroredAndBack) {
    Project before = shipped("rocker_bogie");
    before = must(added(before, ElementKind::Payload));
    const ElementRef payload{ElementKind::Payload, countOf(before, ElementKind::Payload) - 1};
    const Project pair = must(mirrored(before, {payload}, true));
    EXPECT_NEAR(mechanismOf(pair).mass(), mechanismOf(before).mass() + 0.5, 1e-12);
    EXPECT_EQ(must(mirrored(pair, {payload}, false)), before);
    EXPECT_FALSE(mirrored(before, {{ElementKind::Scenario, 0}}, true));
    EXPECT_FALSE(split(before, {payload}));
}

TEST(MirrorPartsTest, ExpressionsOfTheRightSideAreNegatedWithTheirUnit) {
    Project project = cart();
    project.rover.joints[0].axis = {0.1, 1.0, Quantity::expression("track - 0.3")};
    project.rover.bodies[1].com[1] = Quantity::expression("20 cm");
    const Project next = must(split(project, {{ElementKind::Body, 1}, {ElementKind::Joint, 0}}));
    EXPECT_EQ(next.rover.bodies[2].com[1].text(), "-20 cm");
    EXPECT_EQ(next.rover.joints[1].point[1].text(), "-track/2");
    EXPECT_EQ(next.rover.joints[1].axis[2].text(), "-(track - 0.3)");
    expectSameMechanism(mechanismOf(project), mechanismOf(next));
}

TEST(AddPartsTest, WhatIsMissingIsSaid) {
    Project bare;
    bare.rover.name = "bare";
    for (const ElementKind kind : {ElementKind::Joint, ElementKind::Wheel, ElementKind::Spring,
                                   ElementKind::Gear, ElementKind::Payload}) {
        const auto refused = added(bare, kind);
        ASSERT_FALSE(refused) << wordFor(kind);
        EXPECT_THAT(refused.problems().front().remedy, HasSubstr("first"));
    }
}

// The way a rover is built from nothing: body after body, joint after joint.
TEST(AddPartsTest, LooseBodyGetsTheNextJointAndThenTheNextWheel) {
    Project project = must(added(Project{}, ElementKind::Body));
    project = must(added(project, ElementKind::Body));
    EXPECT_EQ(criticals(project), 0U);
    const ElementRef weld{ElementKind::Joint, 0};
    project = must(removed(project, weld));
    EXPECT_EQ(criticals(project), 1U);
    project = must(added(project, ElementKind::Joint));
    EXPECT_EQ(criticals(project), 0U);
    project = must(added(project, ElementKind::Wheel));
    EXPECT_EQ(project.rover.bodies.size(), 2U);
    EXPECT_EQ(project.rover.wheels.front().body, "body_2");
    EXPECT_EQ(criticals(project), 0U);
}

namespace {

/// Two bodies with one shape of every kind each, of different sizes.
Project withShapes() {
    Project project = shipped("rocker_bogie");
    for (std::size_t body = 0; body < 2; ++body) {
        project.rover.bodies[body].shapes.clear();
        for (const ShapeKind kind :
             {ShapeKind::Box, ShapeKind::Cylinder, ShapeKind::Sphere, ShapeKind::Bar}) {
            project = must(withNewShape(project, static_cast<int>(body), kind));
            project.rover.bodies[body].shapes.back().color = body == 0 ? "accent" : "link";
        }
    }
    return project;
}

std::string kindsOf(const Project& project, std::size_t body) {
    std::string kinds;
    for (const Shape& shape : project.rover.bodies[body].shapes) {
        kinds += nameOf(shape.kind).substr(0, 2) + (shape.color == "accent" ? "! " : " ");
    }
    return kinds;
}

ElementRef shapeOf(int body, int shape) {
    return {ElementKind::Body, body, shape};
}

}  // namespace

TEST(ShapePartsTest, NewOnesAreValidAndAboutTheCentreOfMass) {
    const Project project = withShapes();
    EXPECT_EQ(kindsOf(project, 0), "bo! cy! sp! ba! ");
    EXPECT_EQ(criticals(project), 0U) << toString(run::checkProject(project));
    const Body& body = project.rover.bodies[1];
    EXPECT_EQ(body.shapes[0].center, body.com);  // an expression stays one
    EXPECT_FALSE(withNewShape(project, -1, ShapeKind::Box));
}

TEST(ShapePartsTest, DeletedDuplicatedAndMovedWithinTheirBody) {
    const Project before = withShapes();
    EXPECT_EQ(kindsOf(must(removed(before, shapeOf(0, 1))), 0), "bo! sp! ba! ");
    // With the body it goes anyhow.
    const Project both = must(removed(before, {shapeOf(0, 0), shapeOf(0, 3), shapeOf(1, 2)}));
    EXPECT_EQ(kindsOf(both, 0), "cy! sp! ");
    EXPECT_EQ(kindsOf(both, 1), "bo cy ba ");
    EXPECT_EQ(kindsOf(must(duplicated(before, shapeOf(0, 1))), 0), "bo! cy! cy! sp! ba! ");
    const Project copies = must(duplicated(before, {shapeOf(0, 1), shapeOf(1, 0)}));
    EXPECT_EQ(kindsOf(copies, 0), "bo! cy! sp! ba! cy! ");
    EXPECT_EQ(kindsOf(copies, 1), "bo cy sp ba bo ");
    EXPECT_EQ(appended(before, copies), (std::vector{shapeOf(0, 4), shapeOf(1, 4)}));
    EXPECT_EQ(kindsOf(must(moved(before, shapeOf(0, 0), 2)), 0), "cy! sp! bo! ba! ");
    EXPECT_EQ(kindsOf(must(moved(before, shapeOf(0, 3), 0)), 0), "ba! bo! cy! sp! ");
    EXPECT_FALSE(moved(before, shapeOf(0, 0), 4));
    EXPECT_FALSE(moved(before, shapeOf(0, 0), -1));
}

TEST(ShapePartsTest, MoveTogetherIntoAnotherBody) {
    const Project before = withShapes();
    const Project next =
        must(withShapesMoved(before, {shapeOf(0, 2), shapeOf(0, 0), shapeOf(1, 0)}, 1, 2));
    EXPECT_EQ(kindsOf(next, 0), "cy! ba! ");
    EXPECT_EQ(kindsOf(next, 1), "cy bo! sp! bo sp ba ");
    EXPECT_FALSE(withShapesMoved(before, {shapeOf(0, 0)}, 1, 5));
    EXPECT_FALSE(withShapesMoved(before, {shapeOf(0, 0)}, 999, 0));
    EXPECT_FALSE(withShapesMoved(before, {{ElementKind::Body, 1}}, 0, 0));
}

TEST(ShapePartsTest, HaveNoNameNoUsersAndNoMirror) {
    const Project project = withShapes();
    EXPECT_FALSE(renamed(project, shapeOf(0, 0), "hull"));
    EXPECT_FALSE(mirrored(project, {shapeOf(0, 0)}, true));
    EXPECT_FALSE(split(project, {shapeOf(1, 0)}));  // though its body is a pair
    EXPECT_TRUE(userElements(project, shapeOf(0, 0)).empty());
    EXPECT_THROW(nameOf(project, shapeOf(0, 4)), std::invalid_argument);
}

TEST(ShapePartsTest, ProblemsLeadToTheShape) {
    Project project = withShapes();
    project.rover.bodies[1].shapes[2].radius = 0.0;
    std::vector<std::string> elements;
    for (const Problem& problem : validate(project)) {
        if (problem.severity == Severity::Critical) {
            elements.push_back(problem.element);
        }
    }
    ASSERT_EQ(elements.size(), 2U);  // both sides
    EXPECT_EQ(elements.front(), "body rocker_left, shape 3");
    EXPECT_EQ(findElement(project, elements.front()), shapeOf(1, 2));
    EXPECT_EQ(findElement(project, "body rocker, shape 9"), (ElementRef{ElementKind::Body, 1}));
    EXPECT_EQ(findElement(project, ElementKind::Body, "rocker_left"),
              (ElementRef{ElementKind::Body, 1}));
}

TEST(ShapePartsTest, ProblemsLeadToTheirElementInAnyLanguage) {
    const testsupport::InOtherLanguage other;
    Project project = withShapes();
    project.rover.bodies[1].shapes[2].radius = 0.0;
    std::string element;
    for (const Problem& problem : validate(project)) {
        element = problem.severity == Severity::Critical ? problem.element : element;
    }
    EXPECT_EQ(element, "BODY rocker_right, SHAPE 3");
    EXPECT_EQ(findElement(project, element), shapeOf(1, 2));
    for (const ElementKind kind : allElementKinds()) {
        for (int i = 0; i < countOf(project, kind); ++i) {
            const std::string title = titleFor(kind, nameOf(project, {kind, i}));
            EXPECT_EQ(findElement(project, title), (ElementRef{kind, i})) << title;
            EXPECT_EQ(findElement(project, title + ", height"), (ElementRef{kind, i})) << title;
        }
    }
}
