// Every proposal of the Advisor is judged by the analysis of the project it makes.
#include <algorithm>
#include <array>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/io/project_file.h"
#include "simcore/mobility/advisor.h"
#include "simcore/mobility/constraint_jacobian.h"
#include "simcore/mobility/factorisation.h"
#include "simcore/mobility/moved_pose.h"
#include "simcore/project/resolve.h"
#include "tests/support/projects.h"
#include "tests/support/rovers.h"

using namespace simcore;
using namespace simcore::mobility;
using mechanism::Mechanism;
using testing::HasSubstr;
using testsupport::shipped;

namespace {

project::Project linkage(const std::string& name) {
    auto project = io::loadProject(ROVER_SOURCE_DIR "/assets/mechanisms/" + name + ".rover");
    if (!project) {
        throw std::runtime_error(toString(project.problems()));
    }
    return std::move(project).value();
}

Mechanism resolved(const project::Project& project) {
    auto mechanism = project::resolve(project);
    if (!mechanism) {
        throw std::runtime_error(toString(mechanism.problems()));
    }
    return std::move(mechanism).value();
}

project::Project applied(const project::Project& project, const Proposal& proposal) {
    auto changed = withRelaxation(project, proposal);
    if (!changed) {
        throw std::runtime_error(toString(changed.problems()));
    }
    return std::move(changed).value();
}

/// No test waits for the clock: what it looks for is found long before.
AdvisorOptions patient(int proposals, int alike = 3) {
    AdvisorOptions options;
    options.proposals = proposals;
    options.alike = alike;
    options.seconds = 600.0;
    return options;
}

Advice adviceOn(const project::Project& project, const AdvisorOptions& options) {
    auto advice = advise(project, options);
    if (!advice) {
        throw std::runtime_error(toString(advice.problems()));
    }
    return std::move(advice).value();
}

/// Nothing redundant and nothing idle, here and after a step; of the motions as built, all but the
/// idle ones are left, and no others.
void expectExact(const project::Project& project, const Proposal& proposal) {
    SCOPED_TRACE(proposal.why);
    const Mechanism rover = resolved(applied(project, proposal));
    const Report built = analyse(rover, Model::Built);
    const Report relaxed = analyse(rover, Model::Relaxed);
    EXPECT_EQ(relaxed.redundant, 0);
    EXPECT_TRUE(relaxed.idle.empty());
    EXPECT_EQ(relaxed.mobility, built.mobility - static_cast<int>(built.idle.size()));
    EXPECT_EQ(relaxed.gruebler, relaxed.mobility);
    EXPECT_EQ(proposal.report.gruebler, relaxed.gruebler);
    EXPECT_EQ(proposal.report.rank, relaxed.rank);
    EXPECT_EQ(proposal.report.jointsByFreedom, relaxed.jointsByFreedom);
    const MovedPose moved = movedPose(rover, Model::Relaxed, drawnStance(rover));
    EXPECT_EQ(moved.redundant, 0);
    EXPECT_EQ(moved.mobility, relaxed.mobility);
    // What may move when relaxed may move as built.
    const Factorisation free(constraintJacobian(rover, Model::Relaxed).matrix);
    const ConstraintJacobian asBuilt = constraintJacobian(rover, Model::Built);
    const Eigen::MatrixXd violated = asBuilt.matrix * free.motions;
    EXPECT_LT(violated.norm(), 1e-7);
    int cost = 0;
    for (const JointChange& change : proposal.changes) {
        cost += change.cost;
    }
    EXPECT_EQ(cost, proposal.cost);
    EXPECT_GT(proposal.margin, 1e-6);
}

void expectRanked(const Advice& advice) {
    for (std::size_t i = 1; i < advice.proposals.size(); ++i) {
        EXPECT_LE(advice.proposals[i - 1].cost, advice.proposals[i].cost);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_NE(advice.proposals[i].changes, advice.proposals[k].changes);
        }
    }
}

std::vector<JointType> typesOf(const Proposal& proposal) {
    std::vector<JointType> types;
    for (const JointChange& change : proposal.changes) {
        types.push_back(change.type);
    }
    std::sort(types.begin(), types.end());
    return types;
}

/// Three wheels, none the mirror image of another.
project::Project tricycle() {
    auto project = io::parseProject(R"({
  "format": "roverstudio-project",
  "version": 1,
  "rover": {
    "name": "Tricycle",
    "bodies": [
      {"name": "chassis", "mass": 5, "com": [0, 0, 0.2], "inertia": [0.1, 0.1, 0.1, 0, 0, 0]},
      {"name": "wheel_a", "mass": 1, "com": [0.3, 0.1, 0.1], "inertia": [0.01, 0.01, 0.01, 0, 0, 0]},
      {"name": "wheel_b", "mass": 1, "com": [0, -0.2, 0.1], "inertia": [0.01, 0.01, 0.01, 0, 0, 0]},
      {"name": "wheel_c", "mass": 1, "com": [-0.2, 0.3, 0.1], "inertia": [0.01, 0.01, 0.01, 0, 0, 0]}
    ],
    "joints": [
      {"name": "axle_a", "first": "chassis", "second": "wheel_a", "point": [0.3, 0.1, 0.1]},
      {"name": "axle_b", "first": "chassis", "second": "wheel_b", "point": [0, -0.2, 0.1]},
      {"name": "axle_c", "first": "chassis", "second": "wheel_c", "point": [-0.2, 0.3, 0.1]}
    ],
    "wheels": [
      {"name": "a", "body": "wheel_a", "axle": "axle_a", "radius": 0.1, "width": 0.05},
      {"name": "b", "body": "wheel_b", "axle": "axle_b", "radius": 0.1, "width": 0.05},
      {"name": "c", "body": "wheel_c", "axle": "axle_c", "radius": 0.1, "width": 0.05}
    ]
  }
})",
                                    "tricycle");
    if (!project) {
        throw std::runtime_error(toString(project.problems()));
    }
    return std::move(project).value();
}

/// Where left and right differ, SOLERO as built cannot move at all without slipping sideways;
/// relaxed it can, and is still determinate.
void expectExactOnUnevenGround(const project::Project& project, const Proposal& proposal) {
    SCOPED_TRACE(proposal.why);
    const Mechanism rover = resolved(applied(project, proposal));
    for (std::size_t i = 0; i < rover.wheels.size(); ++i) {
        Stance stance = drawnStance(rover);
        stance.wheels[i] = standAtAngle(rover.wheels[i], Pose{}, 0.3);
        const Report report = analyse(rover, Model::Relaxed, stance);
        EXPECT_EQ(report.redundant, 0) << rover.wheels[i].name;
        EXPECT_EQ(report.mobility, 1) << rover.wheels[i].name;
    }
}

class PaperRoverTest : public testing::TestWithParam<const char*> {};

class LinkageTest : public testing::TestWithParam<const char*> {};

}  // namespace

// Lamon et al. 2004, eq. 2: 14 joints of one freedom, 1 of two, 7 of three and 6 of four.
TEST_P(PaperRoverTest, FindsThePapersCountsUnaided) {
    project::Project project = shipped(GetParam());
    for (project::Joint& joint : project.rover.joints) {
        joint.relaxed.clear();  // nothing to copy from
    }
    for (project::Wheel& wheel : project.rover.wheels) {
        wheel.relaxedLateral = false;
    }
    const Advice advice = adviceOn(project, patient(4));
    EXPECT_EQ(advice.built.redundant, 21);
    EXPECT_EQ(advice.fileRelaxed.redundant, 21);
    EXPECT_TRUE(advice.notes.empty());
    EXPECT_FALSE(advice.alreadyExact);
    EXPECT_FALSE(advice.oneSided);
    EXPECT_EQ(advice.end, AdviceEnd::Complete);
    ASSERT_EQ(advice.proposals.size(), 4U);
    expectRanked(advice);
    EXPECT_EQ(advice.proposals[0].report.jointsByFreedom, (std::array{14, 1, 7, 6, 0}));
    EXPECT_EQ(advice.proposals[0].changed, 12);
    EXPECT_NE(typesOf(advice.proposals[3]), typesOf(advice.proposals[0]));  // no more than 3 alike
    for (const Proposal& proposal : advice.proposals) {
        expectExact(project, proposal);
        expectExactOnUnevenGround(project, proposal);
        EXPECT_EQ(proposal.report.gruebler, 1);
        for (const JointChange& change : proposal.changes) {
            EXPECT_EQ(change.sides, project::Sides::Both);
            if (change.type == JointType::BallWithSlide &&
                change.element.find("{side}") != std::string::npos) {
                EXPECT_EQ(change.to, "ball with slide z");  // normal to the bogie's bars
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shipped, PaperRoverTest, testing::Values("solero", "shrimp"));

TEST(AdvisorTest, SoleroWithoutFreedContactsTakesTheSlipUpElsewhere) {
    AdvisorOptions options = patient(2);
    options.contacts = false;
    const project::Project project = shipped("solero");
    const Advice advice = adviceOn(project, options);
    ASSERT_FALSE(advice.proposals.empty());
    for (const Proposal& proposal : advice.proposals) {
        expectExact(project, proposal);
        for (const JointChange& change : proposal.changes) {
            EXPECT_EQ(change.wheel, -1);
        }
    }
}

// The lateral forces of three wheels a side have three states that differ left and right and one
// that does not; changing both sides alike lets go as many of either.
TEST(AdvisorTest, RockerBogieWithGearHasToDifferOnTheTwoSides) {
    const project::Project project = shipped("rocker_bogie");
    const Advice advice = adviceOn(project, patient(6));
    EXPECT_EQ(advice.built.redundant, 4);
    EXPECT_EQ(advice.built.gruebler, -3);
    EXPECT_TRUE(advice.oneSided);
    EXPECT_EQ(advice.end, AdviceEnd::Complete);
    ASSERT_EQ(advice.proposals.size(), 6U);
    expectRanked(advice);
    EXPECT_EQ(typesOf(advice.proposals[0]),
              (std::vector(3, JointType::SidewaysContact)));  // one pair, and two single ones
    for (const Proposal& proposal : advice.proposals) {
        expectExact(project, proposal);
        EXPECT_TRUE(std::any_of(
            proposal.changes.begin(), proposal.changes.end(),
            [](const JointChange& change) { return change.sides != project::Sides::Both; }));
    }
}

// Its rods spin between two balls; a universal joint in place of one holds them.
TEST(AdvisorTest, BarDifferentialLosesItsIdleSpins) {
    const project::Project project = shipped("rocker_bogie_bar");
    const Advice advice = adviceOn(project, patient(3));
    EXPECT_EQ(advice.built.idle.size(), 2U);
    EXPECT_EQ(advice.built.mobility, 3);
    ASSERT_EQ(advice.proposals.size(), 3U);
    for (const Proposal& proposal : advice.proposals) {
        expectExact(project, proposal);
        EXPECT_EQ(proposal.report.mobility, 1);
        const auto rod =
            std::find_if(proposal.changes.begin(), proposal.changes.end(),
                         [](const JointChange& change) { return change.element.find("rod") == 0; });
        ASSERT_NE(rod, proposal.changes.end());
        EXPECT_EQ(rod->from, "ball");
        EXPECT_EQ(rod->to, "universal");
        EXPECT_EQ(rod->freed, -2);
        EXPECT_EQ(rod->relaxed,
                  (std::vector<std::string>{"turn y", "turn z"}));  // rods lie along x
    }
}

// Reshetov: a plane four-bar lacks three freedoms, for example those of a ball and a cylinder.
TEST(AdvisorTest, PlaneFourBarTakesABallAndACylinder) {
    const project::Project project = linkage("four_bar");
    const Advice advice = adviceOn(project, patient(100, 100));
    EXPECT_EQ(advice.built.redundant, 3);
    EXPECT_EQ(advice.end, AdviceEnd::Complete);
    ASSERT_FALSE(advice.proposals.empty());
    EXPECT_EQ(typesOf(advice.proposals[0]), (std::vector{JointType::Ball, JointType::Cylindrical}));
    expectRanked(advice);
    for (const Proposal& proposal : advice.proposals) {
        expectExact(project, proposal);
        int freed = 0;
        for (const JointChange& change : proposal.changes) {
            freed += change.freed;
        }
        EXPECT_EQ(freed, 3);
    }
}

TEST_P(LinkageTest, EveryProposalIsExact) {
    const project::Project project = linkage(GetParam());
    const Advice advice = adviceOn(project, patient(20));
    EXPECT_FALSE(advice.proposals.empty());
    expectRanked(advice);
    for (const Proposal& proposal : advice.proposals) {
        expectExact(project, proposal);
    }
}

INSTANTIATE_TEST_SUITE_P(Known, LinkageTest,
                         testing::Values("slider_crank", "bennett", "sarrus", "door_on_two_hinges",
                                         "parallelogram_extra_bar"));

// Drawn folded flat, the parallelogram has two free motions; the real one is one.
TEST(AdvisorTest, SpecialPoseIsNotSoldAsExact) {
    const project::Project project = linkage("parallelogram_folded");
    ASSERT_EQ(analyse(resolved(project), Model::Built).mobility, 2);
    const Advice advice = adviceOn(project, patient(5));
    EXPECT_TRUE(advice.searchedMovedPose);
    EXPECT_EQ(advice.built.mobility, 1);
    EXPECT_EQ(advice.built.redundant, 3);
    ASSERT_FALSE(advice.proposals.empty());
    for (const Proposal& proposal : advice.proposals) {
        const Mechanism changed = resolved(applied(project, proposal));
        const MovedPose moved = movedPose(changed, Model::Relaxed, drawnStance(changed));
        EXPECT_EQ(moved.redundant, 0);
        EXPECT_EQ(moved.mobility, 1);
    }
}

TEST(AdvisorTest, RoverWithoutMirroredPartsIsAdvisedToo) {
    const project::Project project = tricycle();
    const Advice advice = adviceOn(project, patient(10, 10));
    EXPECT_EQ(advice.built.redundant, 1);
    EXPECT_EQ(advice.end, AdviceEnd::Complete);
    ASSERT_EQ(advice.proposals.size(), 3U);  // any one of the three contacts
    for (const Proposal& proposal : advice.proposals) {
        expectExact(project, proposal);
        EXPECT_EQ(proposal.changed, 1);
        EXPECT_EQ(proposal.cost, costOf(JointType::SidewaysContact));
    }
    AdvisorOptions options = patient(10, 10);
    options.contacts = false;
    EXPECT_TRUE(adviceOn(project, options).proposals.empty());
    options.axles = true;
    const Advice byAxles = adviceOn(project, options);
    ASSERT_FALSE(byAxles.proposals.empty());
    EXPECT_EQ(byAxles.proposals[0].changes[0].type, JointType::Cylindrical);
    expectExact(project, byAxles.proposals[0]);
}

TEST(AdvisorTest, SaysWhenNothingPermittedIsExact) {
    AdvisorOptions options = patient(5);
    options.ball = options.universal = options.ballWithSlide = false;
    const Advice advice = adviceOn(linkage("door_on_two_hinges"), options);
    EXPECT_TRUE(advice.proposals.empty());
    EXPECT_EQ(advice.end, AdviceEnd::Complete);
    EXPECT_THAT(describe(advice), HasSubstr("No set of permitted joints"));
}

TEST(AdvisorTest, LeavesAnExactMechanismAlone) {
    const Advice advice = adviceOn(linkage("stewart_platform"), patient(5));
    EXPECT_TRUE(advice.alreadyExact);
    EXPECT_TRUE(advice.proposals.empty());
    EXPECT_EQ(advice.end, AdviceEnd::Complete);
    EXPECT_THAT(describe(advice), HasSubstr("Exact as built"));
}

TEST(AdvisorTest, EndsWithItsTimeAndWhenCancelled) {
    AdvisorOptions options = patient(5);
    options.seconds = 0.0;
    const Advice late = adviceOn(shipped("solero"), options);
    EXPECT_EQ(late.end, AdviceEnd::TimeUp);
    EXPECT_THAT(describe(late), HasSubstr("cut short"));
    std::stop_source source;
    source.request_stop();
    const auto cancelled = advise(shipped("solero"), patient(5), source.get_token());
    ASSERT_TRUE(cancelled);
    EXPECT_EQ(cancelled->end, AdviceEnd::Cancelled);
    EXPECT_TRUE(cancelled->proposals.empty());
}

TEST(AdvisorTest, RefusesOptionsOutOfRange) {
    AdvisorOptions options;
    options.proposals = 0;
    EXPECT_THROW(static_cast<void>(advise(tricycle(), options)), std::invalid_argument);
    options = {};
    options.seconds = -1.0;
    EXPECT_THROW(static_cast<void>(advise(tricycle(), options)), std::invalid_argument);
}

TEST(AdvisorTest, ReportsWhatDoesNotResolve) {
    project::Project project = tricycle();
    project.rover.joints[0].second = "nobody";
    const auto advice = advise(project);
    ASSERT_FALSE(advice);
    EXPECT_THAT(toString(advice.problems()), HasSubstr("nobody"));
}

TEST(WithRelaxationTest, ReplacesTheRelaxedModelAndNothingElse) {
    const project::Project project = shipped("solero");
    const Advice advice = adviceOn(project, patient(1));
    ASSERT_EQ(advice.proposals.size(), 1U);
    project::Project changed = applied(project, advice.proposals[0]);
    EXPECT_NE(changed, project);
    // As saved and read again.
    const auto read = io::parseProject(io::formatProject(changed), "text");
    ASSERT_TRUE(read) << toString(read.problems());
    EXPECT_EQ(*read, changed);
    const Advice again = adviceOn(changed, patient(1));
    EXPECT_THAT(again.notes, testing::Contains(HasSubstr("file has is exact")));
    // Another proposal on top leaves nothing of the first.
    Proposal none;
    project::Project cleared = applied(changed, none);
    for (std::size_t i = 0; i < project.rover.joints.size(); ++i) {
        EXPECT_TRUE(cleared.rover.joints[i].relaxed.empty());
        cleared.rover.joints[i].relaxed = project.rover.joints[i].relaxed;
    }
    for (std::size_t i = 0; i < project.rover.wheels.size(); ++i) {
        EXPECT_FALSE(cleared.rover.wheels[i].relaxedLateral);
        cleared.rover.wheels[i].relaxedLateral = project.rover.wheels[i].relaxedLateral;
    }
    EXPECT_EQ(cleared, project);
}

TEST(WithRelaxationTest, NamesWhatIsNoLongerThere) {
    project::Project project = tricycle();
    const Advice advice = adviceOn(project, patient(1));
    ASSERT_EQ(advice.proposals.size(), 1U);
    const JointChange& change = advice.proposals[0].changes.at(0);
    project.rover.wheels[static_cast<std::size_t>(change.wheel)].name = "other";
    const auto changed = withRelaxation(project, advice.proposals[0]);
    ASSERT_FALSE(changed);
    EXPECT_THAT(toString(changed.problems()), HasSubstr(change.element));
}
