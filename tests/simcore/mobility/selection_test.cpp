// Parts of rovers alone: what textbooks count for them, and that parts fit into the whole.
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/mobility/selection.h"
#include "simcore/mobility/study.h"
#include "tests/support/mechanisms.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::mobility;
using namespace testsupport;
using project::ElementKind;
using testing::ElementsAre;
using testing::UnorderedElementsAre;

namespace {

Part partNamed(const std::string& rover, const std::vector<std::string>& names) {
    const project::Project project = shipped(rover);
    const Mechanism mechanism = mechanismOf(rover);
    const auto selection = selectionOf(project, mechanism, names);
    if (!selection) {
        throw std::runtime_error(toString(selection.problems()));
    }
    return partOf(mechanism, drawnStance(mechanism), *selection);
}

std::vector<std::string> bodiesOf(const Part& part) {
    std::vector<std::string> names;
    for (const auto& body : part.mechanism.bodies) {
        names.push_back(body.name);
    }
    return names;
}

std::array<int, 4> counts(const Part& part, Model model) {
    const Report report = analyse(part.mechanism, model, part.stance);
    return {report.gruebler, report.rank, report.mobility, report.redundant};
}

}  // namespace

// Four pins in a ring: 6 (4 - 1) - 4 * 5 = -2 by Grübler, 1 in truth (a planar four-bar).
TEST(SelectionTest, ForkOfSoleroIsAFourBar) {
    const Part fork = partNamed("solero", {"chassis", "fork_upper", "fork_lower", "fork_arm"});
    EXPECT_THAT(fork.heldBodies(), ElementsAre("chassis"));
    EXPECT_EQ(fork.pieces, 1);
    EXPECT_EQ(counts(fork, Model::Built), (std::array{-2, 17, 1, 3}));
    // The paper's joints of a fork: a ball and a cylindrical joint: 6 * 3 - 17 = 1.
    EXPECT_EQ(counts(fork, Model::Relaxed), (std::array{1, 17, 1, 0}));
    EXPECT_THAT(describe(fork, analyse(fork.mechanism, Model::Built, fork.stance)),
                testing::HasSubstr("With chassis held: 1 freedom within it. 3 of its"));
}

// A parallel bogie: two bars between the chassis and two arms, two rings that share the bars.
// 6 * 4 - 6 * 5 = -6 by Grübler, 1 in truth.
TEST(SelectionTest, BogieOfSoleroIsTwoParallelogramsThatMoveAsOne) {
    const Part bogie = partNamed("solero", {"chassis", "bogie_left_upper", "bogie_left_lower",
                                            "bogie_left_front_arm", "bogie_left_rear_arm"});
    EXPECT_EQ(counts(bogie, Model::Built), (std::array{-6, 23, 1, 7}));
    EXPECT_EQ(counts(bogie, Model::Relaxed), (std::array{1, 23, 1, 0}));
}

// Of a mirrored pair the left one is looked at, unless the selection joins both sides.
TEST(SelectionTest, MirroredPartsStandForOneSideOrBoth) {
    const Part alone = partNamed("solero", {"bogie_{side}_upper", "bogie_{side}_front_arm"});
    EXPECT_THAT(bodiesOf(alone), ElementsAre("bogie_left_upper", "bogie_left_front_arm"));
    const Part both =
        partNamed("solero", {"chassis", "bogie_{side}_upper", "bogie_{side}_front_arm"});
    EXPECT_THAT(bodiesOf(both),
                UnorderedElementsAre("chassis", "bogie_left_upper", "bogie_left_front_arm",
                                     "bogie_right_upper", "bogie_right_front_arm"));
    const Part right = partNamed("solero", {"bogie_right_upper", "bogie_right_front_arm"});
    EXPECT_THAT(bodiesOf(right), ElementsAre("bogie_right_upper", "bogie_right_front_arm"));
}

TEST(SelectionTest, JointStandsForItsTwoBodiesAndWheelForItsContact) {
    const Part pin = partNamed("solero", {"joint fork_a"});
    EXPECT_EQ(pin.mechanism.bodies.size(), 2U);
    EXPECT_EQ(counts(pin, Model::Built), (std::array{1, 5, 1, 0}));
    // A wheel on the ground: three freedoms about the point where it touches.
    const Part wheel = partNamed("solero", {"wheel front"});
    EXPECT_TRUE(wheel.heldBodies().empty());
    EXPECT_EQ(counts(wheel, Model::Built), (std::array{3, 3, 3, 0}));
    // Its body alone touches nothing.
    EXPECT_EQ(partNamed("solero", {"body front_wheel"}).constraints, 0);
}

TEST(SelectionTest, EverythingSelectedIsTheWholeRover) {
    for (const char* name : {"solero", "rocker_bogie", "rocker_bogie_bar"}) {
        const Mechanism rover = mechanismOf(name);
        Selection all;
        all.bodies.resize(rover.bodies.size());
        std::iota(all.bodies.begin(), all.bodies.end(), 0);
        all.wheels.resize(rover.wheels.size());
        std::iota(all.wheels.begin(), all.wheels.end(), 0);
        const Part part = partOf(rover, drawnStance(rover), all);
        EXPECT_TRUE(part.heldBodies().empty());
        for (const Model model : {Model::Built, Model::Relaxed}) {
            const Report whole = analyse(rover, model);
            const Report same = analyse(part.mechanism, model, part.stance);
            EXPECT_EQ(same.gruebler, whole.gruebler) << name;
            EXPECT_EQ(same.rank, whole.rank) << name;
            EXPECT_EQ(same.redundant, whole.redundant) << name;
            EXPECT_EQ(same.idle.size(), whole.idle.size()) << name;
        }
    }
}

// Every piece has one body held, so what it counts is what its pieces count together.
TEST(SelectionTest, PiecesAddUp) {
    const Part two = partNamed(
        "solero", {"chassis", "fork_upper", "bogie_left_rear_arm", "bogie_left_rear_wheel"});
    EXPECT_EQ(two.pieces, 2);
    EXPECT_THAT(two.heldBodies(), ElementsAre("chassis", "bogie_left_rear_arm"));
    EXPECT_EQ(counts(two, Model::Built), (std::array{2, 10, 2, 0}));
}

TEST(SelectionTest, GearGoesWithItsTwoJoints) {
    const Part both = partNamed("rocker_bogie", {"joint rocker_pivot"});
    EXPECT_EQ(both.mechanism.gears.size(), 1U);
    EXPECT_EQ(counts(both, Model::Built), (std::array{1, 11, 1, 0}));
    const Part one = partNamed("rocker_bogie", {"joint rocker_pivot_left"});
    EXPECT_TRUE(one.mechanism.gears.empty());
    EXPECT_EQ(counts(one, Model::Built), (std::array{1, 5, 1, 0}));
}

TEST(SelectionTest, UnknownNamesAreAllTold) {
    const auto selection =
        selectionOf(shipped("solero"), mechanismOf("solero"), {"fork_a", "spoon", "wheel fork_a"});
    ASSERT_FALSE(selection);
    ASSERT_EQ(selection.problems().size(), 2U);
    EXPECT_EQ(selection.problems()[0].element, "spoon");
    EXPECT_EQ(selection.problems()[1].element, "wheel fork_a");
}

// The projector's trace is its rank: all shares add up to the redundant constraints.
TEST(SelectionTest, SharesOfTheElementsAddUpToOne) {
    for (const char* name : {"solero", "rocker_bogie", "rocker_bogie_bar"}) {
        const Report report = analyse(mechanismOf(name), Model::Built);
        double parts = 0.0, shares = 0.0;
        for (const ElementShare& share : shareByElement(report)) {
            parts += share.part;
            shares += share.share;
        }
        EXPECT_NEAR(parts, 1.0, 1e-9) << name;
        EXPECT_NEAR(shares, report.redundant, 1e-9) << name;
    }
    // The four pins of a square parallelogram are alike: a quarter each.
    Mechanism square = makeFourBar();
    const auto shares = shareByElement(analyse(square, Model::Built));
    EXPECT_EQ(shares.size(), 4U);
    EXPECT_TRUE(shareByElement(analyse(mechanismOf("solero"), Model::Relaxed)).empty());
}

TEST(SelectionTest, WhatCannotBeKnownIsTold) {
    const Part fork = partNamed("solero", {"chassis", "fork_upper", "fork_lower", "fork_arm"});
    const auto built = determinedReactions(fork.mechanism, Model::Built, fork.stance);
    // A planar linkage: of five components each pin's two forces in the plane are known.
    EXPECT_THAT(describe(built), testing::HasSubstr("Of 20 components of reactions the loads "
                                                    "determine 8;"));
    EXPECT_THAT(describe(built), testing::HasSubstr("Part of the reaction can be known of fork_a"));
    EXPECT_EQ(describe(determinedReactions(fork.mechanism, Model::Relaxed, fork.stance)),
              "Every reaction follows from the loads.");
}
