// The mechanisms of assets/mechanisms: published counts, and that they move as they should.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "simcore/mobility/constraint_system.h"
#include "simcore/mobility/loops.h"
#include "simcore/mobility/moved_pose.h"
#include "simcore/mobility/reactions.h"
#include "tests/support/mechanisms.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::mobility;
using namespace testsupport;

namespace {

std::filesystem::path fileOf(const std::string& name) {
    return std::filesystem::path(ROVER_SOURCE_DIR) / "assets/mechanisms" / (name + ".rover");
}

Mechanism mechanismFile(const std::string& name) {
    const auto project = io::loadProject(fileOf(name));
    if (!project) {
        throw std::runtime_error(toString(project.problems()));
    }
    auto mechanism = project::resolve(*project);
    if (!mechanism) {
        throw std::runtime_error(toString(mechanism.problems()));
    }
    return std::move(mechanism).value();
}

struct Known {
    const char* file;
    int gruebler;
    int mobility;
    int redundant;
    int movedMobility;
    int finite;  ///< free motions that continue
};

void PrintTo(const Known& known, std::ostream* out) {  // NOLINT: name given by gtest
    *out << known.file;
}

class KnownMechanismTest : public testing::TestWithParam<Known> {};

MovedPose move(const Mechanism& mechanism) {
    return movedPose(mechanism, Model::Built, drawnStance(mechanism));
}

}  // namespace

TEST_P(KnownMechanismTest, FileIsAsTheProgramWritesIt) {
    std::stringstream text;
    text << std::ifstream(fileOf(GetParam().file)).rdbuf();
    const auto project = io::parseProject(text.str(), GetParam().file);
    ASSERT_TRUE(project);
    EXPECT_EQ(io::formatProject(*project), text.str());
}

TEST_P(KnownMechanismTest, CountsAsPublished) {
    const Report report = analyse(mechanismFile(GetParam().file), Model::Built);
    EXPECT_EQ(report.gruebler, GetParam().gruebler);
    EXPECT_EQ(report.mobility, GetParam().mobility);
    EXPECT_EQ(report.redundant, GetParam().redundant);
    EXPECT_GT(report.rankGap, 1e6);
    EXPECT_TRUE(report.idle.empty());
}

TEST_P(KnownMechanismTest, MovesAFiniteStepWithEveryJointClosed) {
    const Mechanism mechanism = mechanismFile(GetParam().file);
    const ConstraintSystem system(mechanism, Model::Built, drawnStance(mechanism));
    const MovedPose moved = move(mechanism);
    EXPECT_EQ(static_cast<int>(moved.motions.size()), GetParam().mobility);
    EXPECT_EQ(moved.moving, GetParam().finite);
    EXPECT_EQ(moved.mobility, GetParam().movedMobility);
    EXPECT_EQ(moved.redundant, GetParam().movedMobility - GetParam().gruebler);
    for (const FreeMotion& motion : moved.motions) {
        if (motion.continuation == Continuation::Infinitesimal) {
            EXPECT_FALSE(motion.inconsistent.empty());
            continue;
        }
        EXPECT_LE(system.residual(motion.reached).cwiseAbs().maxCoeff(), 1e-12);
        double way = 0.0;
        for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
            const Pose& pose = motion.reached.bodies[b];
            way = std::max({way, (pose * mechanism.bodies[b].com - mechanism.bodies[b].com).norm(),
                            0.1 * Eigen::AngleAxisd(pose.rotation).angle()});
        }
        EXPECT_GT(way, 0.5e-2 * system.length());
    }
}

INSTANTIATE_TEST_SUITE_P(Files, KnownMechanismTest,
                         testing::Values(Known{"four_bar", -2, 1, 3, 1, 1},
                                         Known{"bennett", -2, 1, 3, 1, 1},
                                         Known{"sarrus", 0, 1, 1, 1, 1},
                                         Known{"slider_crank", -2, 1, 3, 1, 1},
                                         Known{"stewart_platform", 6, 6, 0, 6, 6},
                                         Known{"door_on_two_hinges", -4, 1, 5, 1, 1},
                                         Known{"parallelogram_extra_bar", -6, 1, 7, 1, 1},
                                         Known{"parallelogram_folded", -2, 2, 4, 1, 2},
                                         Known{"bars_in_line", -3, 1, 4, 1, 0}),
                         [](const auto& test) { return test.param.file; });

// Opposite angles of Bennett's linkage: tan(a/2) tan(b/2) stays what the twists make it.
TEST(MovedPoseTest, BennettKeepsItsRatioOfHalfAngles) {
    const Mechanism mechanism = mechanismFile("bennett");
    const auto motion = move(mechanism).motions.at(0);
    const auto turn = [&](std::size_t i) {
        const Joint& joint = mechanism.joints[i];
        const Eigen::Quaterniond R =
            motion.reached.bodies[static_cast<std::size_t>(joint.first)].rotation.conjugate() *
            motion.reached.bodies[static_cast<std::size_t>(joint.second)].rotation;
        return 2.0 * std::atan2(joint.axis.dot(R.vec()), R.w());
    };
    // Opposite joints turn by the same amount.
    EXPECT_NEAR(std::abs(turn(0)), std::abs(turn(2)), 1e-10);
    EXPECT_NEAR(std::abs(turn(1)), std::abs(turn(3)), 1e-10);
    EXPECT_GT(std::abs(turn(0)), 0.01);
}

TEST(MovedPoseTest, SarrusPlateGoesStraight) {
    const Mechanism mechanism = mechanismFile("sarrus");
    const auto plate = static_cast<std::size_t>(mechanism.findBody("plate"));
    const Pose pose = move(mechanism).motions.at(0).reached.bodies[plate];
    EXPECT_LT(pose.position.head<2>().norm(), 1e-10);
    EXPECT_GT(std::abs(pose.position.z()), 1e-3);
    EXPECT_LT(Eigen::AngleAxisd(pose.rotation).angle(), 1e-10);
}

TEST(MovedPoseTest, FoldedParallelogramIsABranchingPoint) {
    for (const FreeMotion& motion : move(mechanismFile("parallelogram_folded")).motions) {
        EXPECT_EQ(motion.continuation, Continuation::Branch);
    }
}

// The middle pin moves by s across bars of lengths a and b, which then miss each other by
// s^2/2 (1/a + 1/b).
TEST(MovedPoseTest, BarsInLineMissEachOtherByTheSquareOfTheStep) {
    const MovedPose moved = move(mechanismFile("bars_in_line"));
    ASSERT_EQ(moved.motions.size(), 1U);
    ASSERT_EQ(moved.motions[0].inconsistent.size(), 1U);
    const Inconsistency& found = moved.motions[0].inconsistent[0];
    EXPECT_EQ(found.constraint.kind, "slide");
    EXPECT_NEAR(std::abs(found.constraint.direction.x()), 1.0, 1e-9);
    const double s = 0.01;  // the bars' centres, in their middles, go 1e-2 of 0.5 m
    const double expected = 0.5 * s * s * (1.0 / 0.2 + 1.0 / 0.3);
    EXPECT_NEAR(found.gap, expected, 0.01 * expected);
}

TEST(MovedPoseTest, ShippedRoversRoll) {
    for (const char* name : {"solero", "shrimp", "rocker_bogie"}) {
        const Mechanism rover = mechanismOf(name);
        const MovedPose moved = move(rover);
        ASSERT_EQ(moved.motions.size(), 1U) << name;
        EXPECT_EQ(moved.motions[0].continuation, Continuation::Finite) << name;
        EXPECT_EQ(moved.mobility, 1) << name;
        // Without slip: turn times radius is the way.
        const Pose& wheel =
            moved.motions[0].reached.bodies[static_cast<std::size_t>(rover.wheels[0].body)];
        const double way = (wheel * rover.wheels[0].center - rover.wheels[0].center).x();
        EXPECT_NEAR(std::abs(way),
                    Eigen::AngleAxisd(wheel.rotation).angle() * rover.wheels[0].radius, 1e-10);
    }
}

TEST(MovedPoseTest, BarDifferentialCounts) {
    const Mechanism rover = mechanismOf("rocker_bogie_bar");
    const Report report = analyse(rover, Model::Built);
    EXPECT_EQ(
        (std::array{report.gruebler, report.rows, report.rank, report.mobility, report.redundant}),
        (std::array{-1, 85, 81, 3, 4}));
    EXPECT_EQ(report.idle.size(), 2U);
    const MovedPose moved = move(rover);
    EXPECT_EQ(moved.moving, 3);
    EXPECT_EQ(moved.mobility, 3);
}

TEST(LoopsTest, LoopOfFourBarHasItsThreeRedundantConstraints) {
    const Mechanism mechanism = mechanismFile("four_bar");
    const auto loops = findLoops(mechanism, Model::Built, drawnStance(mechanism));
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_EQ(loops[0].joints, (std::vector<std::string>{"pin_a", "pin_b", "pin_c", "pin_d"}));
    EXPECT_EQ(loops[0].gruebler, -2);
    EXPECT_EQ(loops[0].mobility, 1);
    EXPECT_EQ(loops[0].redundant, 3);
    EXPECT_TRUE(loops[0].throughWorld);
}

// freedoms - 6 loops - gears (+ 6 when nothing is held) is the Grübler count.
TEST(LoopsTest, LoopsAccountForTheWholeCount) {
    for (const char* name : {"solero", "rocker_bogie", "rocker_bogie_bar"}) {
        const Mechanism rover = mechanismOf(name);
        const auto loops = findLoops(rover, Model::Built, drawnStance(rover));
        const Report report = analyse(rover, Model::Built);
        int freedoms = 0;
        for (std::size_t f = 0; f < 4; ++f) {
            freedoms += (static_cast<int>(f) + 1) * report.jointsByFreedom[f];
        }
        const int gears = static_cast<int>(rover.gears.size());
        const int rings = static_cast<int>(loops.size()) - gears;
        EXPECT_EQ(report.gruebler, freedoms - 6 * rings - gears) << name;
        int redundant = 0;
        for (const Loop& loop : loops) {
            EXPECT_EQ(loop.mobility, loop.gruebler + loop.redundant);
            redundant += loop.redundant;
        }
        EXPECT_LE(redundant, report.redundant) << name;
    }
}

TEST(LoopsTest, TreeHasNone) {
    Mechanism tree;
    tree.bodies = {makeBody("base", 1.0, Vec3::Zero()), makeBody("arm", 1.0, Vec3::UnitX())};
    tree.joints = {makePin("pin", 0, 1, Vec3::Zero())};
    EXPECT_TRUE(findLoops(tree, Model::Built, drawnStance(tree)).empty());
}

// A planar linkage determines the forces in its plane and no torque of a pin.
TEST(ReactionsTest, PinsOfAFourBarAreDeterminedInTheirPlaneOnly) {
    const auto reactions = determinedReactions(mechanismFile("four_bar"), Model::Built);
    ASSERT_EQ(reactions.size(), 4U);
    for (const ReactionDeterminacy& reaction : reactions) {
        EXPECT_EQ(reaction.components, 5);
        EXPECT_EQ(reaction.determinacy, Determinacy::Some);
        ASSERT_EQ(reaction.determined.size(), 2U);
        for (const ReactionComponent& component : reaction.determined) {
            EXPECT_LT(component.torque.norm(), 1e-9);
            EXPECT_NEAR(component.force.y(), 0.0, 1e-9);
        }
        EXPECT_EQ(reaction.undetermined.size(), 3U);
    }
}

TEST(ReactionsTest, DoorTellsNothingButStewartPlatformEverything) {
    for (const auto& reaction :
         determinedReactions(mechanismFile("door_on_two_hinges"), Model::Built)) {
        EXPECT_EQ(reaction.determinacy, Determinacy::None) << reaction.element;
    }
    for (const auto& reaction :
         determinedReactions(mechanismFile("stewart_platform"), Model::Built)) {
        EXPECT_EQ(reaction.determinacy, Determinacy::All) << reaction.element;
    }
}

// Determined components are the same in every equilibrium: independent check by two solutions.
TEST(ReactionsTest, DeterminedComponentsAreTheSameInEveryEquilibrium) {
    const Mechanism rover = mechanismOf("rocker_bogie");
    const auto jacobian = constraintJacobian(rover, Model::Built);
    const double length = characteristicLength(rover);
    Eigen::VectorXd load = Eigen::VectorXd::Zero(jacobian.matrix.cols());
    for (std::size_t b = 0; b < rover.bodies.size(); ++b) {
        const Vec3 weight(0.0, 0.0, -rover.bodies[b].mass * 9.81);
        load.segment<3>(jacobian.firstColumn[b]) = weight * length;
        load.segment<3>(jacobian.firstColumn[b] + 3) = rover.bodies[b].com.cross(weight);
    }
    // Two equilibria: with all rows and without one redundant set.
    const Eigen::VectorXd spread =
        jacobian.matrix.transpose().completeOrthogonalDecomposition().solve(-load);
    Eigen::MatrixXd weighted = jacobian.matrix.transpose();
    Eigen::VectorXd scale(weighted.cols());
    for (Eigen::Index i = 0; i < scale.size(); ++i) {
        scale[i] = 1.0 + 0.37 * static_cast<double>(i % 5);
        weighted.col(i) *= scale[i];
    }
    const Eigen::VectorXd other =
        scale.cwiseProduct(weighted.completeOrthogonalDecomposition().solve(-load).eval());
    ASSERT_GT((spread - other).norm(), 1e-3 * spread.norm());
    for (const ReactionDeterminacy& reaction : determinedReactions(rover, Model::Built)) {
        for (const ReactionComponent& component : reaction.determined) {
            double first = 0.0;
            double second = 0.0;
            for (std::size_t i = 0; i < jacobian.names.size(); ++i) {
                const ConstraintName& row = jacobian.names[i];
                if (row.element == reaction.element && row.kind != "gear") {
                    const double weight = (row.kind == "slide" ? component.force : component.torque)
                                              .dot(row.direction);
                    first += weight * spread[static_cast<Eigen::Index>(i)];
                    second += weight * other[static_cast<Eigen::Index>(i)];
                }
            }
            EXPECT_NEAR(first, second, 1e-9 * spread.norm()) << reaction.element;
        }
    }
}
