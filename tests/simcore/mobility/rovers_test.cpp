// The shipped rovers against the counts of Lamon et al. 2004 and of the rocker-bogie.
#include <array>
#include <set>

#include <gtest/gtest.h>

#include "simcore/io/project_file.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/resolve.h"

using namespace simcore;
using namespace simcore::mobility;
using mechanism::Freedom;
using mechanism::FreedomKind;
using mechanism::Mechanism;

namespace {

Mechanism load(const std::string& name) {
    auto project = io::loadProject(ROVER_SOURCE_DIR "/assets/projects/" + name + ".rover");
    if (!project) {
        throw std::runtime_error(name + " does not load");
    }
    auto mechanism = project::resolve(*project);
    if (!mechanism) {
        throw std::runtime_error(name + " does not resolve");
    }
    return std::move(mechanism).value();
}

/// Grübler count, rows, rank, mobility, redundant.
std::array<int, 5> numbers(const Report& report) {
    return {report.gruebler, report.rows, report.rank, report.mobility, report.redundant};
}

class SixWheelerTest : public testing::TestWithParam<const char*> {};

const std::vector<Freedom> kBall{{FreedomKind::Turn, Vec3::UnitX()},
                                 {FreedomKind::Turn, Vec3::UnitY()},
                                 {FreedomKind::Turn, Vec3::UnitZ()}};

/// In how many of the 60 ways to make two of a bogie's six pins balls and one a ball that slides
/// along `slide` is the relaxed rover exact?
int countExactAssignments(const Vec3& slide) {
    const Mechanism rover = load("solero");
    std::vector<std::size_t> pins;
    for (const char* name :
         {"upper_pivot", "lower_pivot", "upper_front", "upper_rear", "lower_front", "lower_rear"}) {
        pins.push_back(
            static_cast<std::size_t>(rover.findJoint("bogie_left_" + std::string(name))));
    }
    std::vector<Freedom> sliding = kBall;
    sliding.push_back({FreedomKind::Slide, slide});
    int exact = 0;
    int tried = 0;
    for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = a + 1; b < 6; ++b) {
            for (std::size_t c = 0; c < 6; ++c) {
                if (c == a || c == b) {
                    continue;
                }
                Mechanism variant = rover;
                for (const std::size_t pin : pins) {
                    variant.joints[pin].relaxed = variant.joints[pin].built;
                }
                variant.joints[pins[a]].relaxed = kBall;
                variant.joints[pins[b]].relaxed = kBall;
                variant.joints[pins[c]].relaxed = sliding;
                const Report report = analyse(variant, Model::Relaxed);
                EXPECT_EQ(report.gruebler, 1);  // the count cannot tell them apart
                exact += report.redundant == 0 ? 1 : 0;
                ++tried;
            }
        }
    }
    EXPECT_EQ(tried, 60);
    return exact;
}

}  // namespace

TEST_P(SixWheelerTest, AsBuiltMatchesThePaper) {
    const Mechanism rover = load(GetParam());
    const Report report = analyse(rover, Model::Built);
    EXPECT_EQ(report.bodies, 18);
    EXPECT_EQ(report.joints, 28);
    EXPECT_EQ(report.jointsByFreedom, (std::array{22, 0, 6, 0, 0}));
    EXPECT_EQ(numbers(report), (std::array{-20, 128, 107, 1, 21}));
    EXPECT_EQ(report.removable.size(), 78U);
    EXPECT_EQ(report.redundantSet.size(), 21U);
    EXPECT_TRUE(report.idle.empty());
    EXPECT_GT(report.rankGap, 1e6);
}

TEST_P(SixWheelerTest, RelaxedMatchesThePaper) {
    const Mechanism rover = load(GetParam());
    const Report report = analyse(rover, Model::Relaxed);
    EXPECT_EQ(report.jointsByFreedom, (std::array{14, 1, 7, 6, 0}));
    EXPECT_EQ(numbers(report), (std::array{1, 107, 107, 1, 0}));
    EXPECT_TRUE(report.removable.empty());
    EXPECT_TRUE(report.redundantSet.empty());
    EXPECT_TRUE(report.idle.empty());
}

TEST_P(SixWheelerTest, FourLateralHoldsOfTheContactsAreRedundant) {
    const Report report = analyse(load(GetParam()), Model::Built);
    int contacts = 0;
    for (const ConstraintName& name : report.redundantSet) {
        contacts += name.wheel >= 0 ? 1 : 0;
        if (name.wheel >= 0) {
            EXPECT_NEAR(std::abs(name.direction.y()), 1.0, 1e-12) << name.element;
        }
    }
    EXPECT_EQ(contacts, 4);
}

INSTANTIATE_TEST_SUITE_P(Shipped, SixWheelerTest,
                         testing::Values("solero", "shrimp", "bench_rover"));

// Only the slide normal to the bars serves, and even then most assignments that count to +1 fail.
TEST(RelaxedAssignmentTest, OnlyEighteenOfSixtyAreExact) {
    EXPECT_EQ(countExactAssignments(Vec3::UnitZ()), 18);
    EXPECT_EQ(countExactAssignments(Vec3::UnitX()), 0);
    EXPECT_EQ(countExactAssignments(Vec3::UnitY()), 0);
}

TEST(RockerBogieTest, GearDifferentialCounts) {
    Mechanism rover = load("rocker_bogie");
    EXPECT_EQ(numbers(analyse(rover, Model::Built)), (std::array{-3, 69, 65, 1, 4}));
    ASSERT_EQ(rover.gears.size(), 1U);
    rover.gears[0].ratio = -rover.gears[0].ratio;  // both rockers turn the same way
    EXPECT_EQ(numbers(analyse(rover, Model::Built)), (std::array{-3, 69, 64, 2, 5}));
}

// A wheel on a slope ahead, the other side level: the sides would have to climb at different rates.
TEST(StanceTest, AsBuiltSoleroCannotMoveWhereLeftAndRightDiffer) {
    const Mechanism rover = load("solero");
    Stance stance = drawnStance(rover);
    const auto wheel = static_cast<std::size_t>(rover.findWheel("bogie_left_front"));
    stance.wheels[wheel] = standAtAngle(rover.wheels[wheel], Pose{}, 0.3);
    const Report report = analyse(rover, Model::Built, stance);
    EXPECT_EQ(numbers(report), (std::array{-20, 128, 108, 0, 20}));
    EXPECT_GT(report.rankGap, 1e6);
    // The same slope on both sides lets it move.
    const auto other = static_cast<std::size_t>(rover.findWheel("bogie_right_front"));
    stance.wheels[other] = standAtAngle(rover.wheels[other], Pose{}, 0.3);
    EXPECT_EQ(numbers(analyse(rover, Model::Built, stance)), (std::array{-20, 128, 107, 1, 21}));
}

TEST(StanceTest, HangingWheelTakesItsContactAway) {
    const Mechanism rover = load("solero");
    Stance stance = drawnStance(rover);
    stance.wheels[0].touching = false;
    const Report report = analyse(rover, Model::Relaxed, stance);
    EXPECT_EQ(report.joints, 27);
    EXPECT_EQ(report.rows, 104);
    EXPECT_EQ(report.mobility, 4);  // the front wheel spins, the fork swings, and the rover drives
}

TEST(StanceTest, ContactAngleIsPositiveWhereTheGroundRisesAhead) {
    const Mechanism rover = load("solero");
    const WheelStand stand = standAtAngle(rover.wheels[0], Pose{}, 0.5);
    EXPECT_GT(stand.point.x(), rover.wheels[0].center.x());
    EXPECT_NEAR((stand.point - rover.wheels[0].center).norm(), rover.wheels[0].radius, 1e-12);
}

// Carrying rover and ground anywhere else changes nothing.
TEST(StanceTest, CountsDoNotDependOnWhereTheRoverStands) {
    const Mechanism rover = load("rocker_bogie");
    const Pose place{Eigen::Quaterniond(Eigen::AngleAxisd(0.8, Vec3(0.3, -0.5, 0.9).normalized())),
                     Vec3(120.0, -40.0, 7.0)};
    Stance stance = drawnStance(rover);
    for (Pose& body : stance.bodies) {
        body = place * body;
    }
    for (WheelStand& wheel : stance.wheels) {
        wheel.point = place * wheel.point;
        wheel.normal = place.rotation * wheel.normal;
    }
    EXPECT_EQ(numbers(analyse(rover, Model::Built, stance)), (std::array{-3, 69, 65, 1, 4}));
    stance.wheels.pop_back();
    EXPECT_THROW(analyse(rover, Model::Built, stance), std::invalid_argument);
}

TEST(WheelOrderTest, SideBySideElementsExpandLeftFirst) {
    const Mechanism rover = load("solero");
    std::vector<std::string> names;
    for (const mechanism::Wheel& wheel : rover.wheels) {
        names.push_back(wheel.name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"front", "bogie_left_front", "bogie_left_rear",
                                               "bogie_right_front", "bogie_right_rear", "rear"}));
}
