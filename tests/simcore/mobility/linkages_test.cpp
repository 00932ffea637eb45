// Classical linkages whose mobility is known. Nothing is fixed to the ground: the whole linkage
// floats, so its mobility is 6 more than the textbook's.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/mobility/mobility.h"
#include "tests/support/mechanisms.h"

using namespace simcore;
using namespace testsupport;
using simcore::mobility::analyse;
using simcore::mobility::Model;

namespace {

constexpr int kFloating = 6;

struct Line {
    Vec3 point;
    Vec3 axis;
};

/// A ring of as many bodies as pins.
Mechanism makeRing(const std::vector<Line>& pins) {
    Mechanism mechanism;
    const int count = static_cast<int>(pins.size());
    for (int i = 0; i < count; ++i) {
        const Line& pin = pins[static_cast<std::size_t>(i)];
        mechanism.bodies.push_back(makeBody("link" + std::to_string(i), 1.0, pin.point));
        mechanism.joints.push_back(
            makePin("pin" + std::to_string(i), i, (i + 1) % count, pin.point, pin.axis));
    }
    return mechanism;
}

/// Bennett's linkage by its Denavit-Hartenberg table: opposite links equal, no offsets.
/// `angle` is the first joint angle; the second follows from
/// tan(first / 2) tan(second / 2) = sin((beta + alpha) / 2) / sin((beta - alpha) / 2).
Mechanism makeBennett(double a, double alpha, double b, double beta, double angle) {
    const double ratio = std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha));
    const double second = 2.0 * std::atan(ratio / std::tan(0.5 * angle));
    const double lengths[] = {a, b, a, b};
    const double twists[] = {alpha, beta, alpha, beta};
    const double angles[] = {angle, second, -angle, -second};
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    std::vector<Line> pins;
    for (int i = 0; i < 4; ++i) {
        pins.push_back({frame.translation(), frame.linear().col(2)});
        frame = frame * Eigen::AngleAxisd(angles[i], Vec3::UnitZ()) *
                Eigen::Translation3d(lengths[i], 0.0, 0.0) *
                Eigen::AngleAxisd(twists[i], Vec3::UnitX());
    }
    return makeRing(pins);
}

/// Two perpendicular chains of three parallel hinges between a base and a plate.
std::vector<Line> sarrusHinges() {
    return {{{0.5, 0.0, 0.0}, Vec3::UnitY()}, {{0.9, 0.0, 0.4}, Vec3::UnitY()},
            {{0.5, 0.0, 0.8}, Vec3::UnitY()}, {{0.0, 0.5, 0.8}, Vec3::UnitX()},
            {{0.0, 0.8, 0.4}, Vec3::UnitX()}, {{0.0, 0.5, 0.0}, Vec3::UnitX()}};
}

void expectCounts(const Mechanism& mechanism, int gruebler, int mobilityExpected, int redundant) {
    const auto report = analyse(mechanism, Model::Built);
    EXPECT_EQ(report.gruebler, gruebler);
    EXPECT_EQ(report.mobility, mobilityExpected);
    EXPECT_EQ(report.redundant, redundant);
    EXPECT_EQ(static_cast<int>(report.redundantSet.size()), redundant);
    EXPECT_GT(report.rankGap, 1e6);
}

}  // namespace

TEST(LinkagesTest, DoorOnTwoAlignedHingesHasFiveRedundantConstraints) {
    Mechanism door;
    door.bodies = {makeBody("frame", 1.0, Vec3::Zero()), makeBody("door", 1.0, {0.4, 0.0, 1.0})};
    door.joints = {makePin("lower", 0, 1, {0.0, 0.0, 0.3}, Vec3::UnitZ()),
                   makePin("upper", 0, 1, {0.0, 0.0, 1.7}, Vec3::UnitZ())};
    expectCounts(door, -4 + kFloating, 1 + kFloating, 5);
    door.joints[1].point.x() = 0.01;  // 10 mm out of line: stuck
    expectCounts(door, -4 + kFloating, kFloating, 4);
}

TEST(LinkagesTest, PlanarFourBarMovesAgainstTheCount) {
    Mechanism linkage = makeFourBar();
    expectCounts(linkage, -2 + kFloating, 1 + kFloating, 3);
    linkage.bodies[0].fixed = true;
    expectCounts(linkage, -2, 1, 3);
}

TEST(LinkagesTest, FourBarWithOneBallAndOneCylinderIsExact) {
    Mechanism linkage = makeFourBar();
    linkage.joints[1].built = {{FreedomKind::Turn, Vec3::UnitX()},
                               {FreedomKind::Turn, Vec3::UnitY()},
                               {FreedomKind::Turn, Vec3::UnitZ()}};
    linkage.joints[2].built.push_back({FreedomKind::Slide, Vec3::UnitY()});
    expectCounts(linkage, 1 + kFloating, 1 + kFloating, 0);
}

TEST(LinkagesTest, SliderCrankMovesAgainstTheCount) {
    Mechanism linkage = makeFourBar();
    linkage.joints[3].built = {{FreedomKind::Slide, Vec3(0.8, 0.0, 0.6)}};
    expectCounts(linkage, -2 + kFloating, 1 + kFloating, 3);
    linkage.joints[3].built = {{FreedomKind::Slide, Vec3::UnitY()}};  // out of the plane: stuck
    expectCounts(linkage, -2 + kFloating, kFloating, 2);
}

TEST(LinkagesTest, BennettLinkageMoves) {
    const double a = 0.4;
    const double alpha = 40.0 * std::numbers::pi / 180.0;
    const double beta = 70.0 * std::numbers::pi / 180.0;
    const double b = a * std::sin(beta) / std::sin(alpha);  // Bennett's condition
    for (const double angle : {0.6, 1.1, 2.0}) {
        expectCounts(makeBennett(a, alpha, b, beta, angle), -2 + kFloating, 1 + kFloating, 3);
    }
    // Four hinges anywhere else do not turn at all.
    Mechanism other = makeBennett(a, alpha, b, beta, 1.1);
    other.joints[2].axis = (other.joints[2].axis + Vec3(0.05, -0.02, 0.03)).normalized();
    other.joints[2].built.front().direction = other.joints[2].axis;
    expectCounts(other, -2 + kFloating, kFloating, 2);
}

TEST(LinkagesTest, SarrusLinkageMovesStraight) {
    expectCounts(makeRing(sarrusHinges()), kFloating, 1 + kFloating, 1);
    auto hinges = sarrusHinges();
    hinges[1].axis = Vec3(0.1, 1.0, 0.05).normalized();
    hinges[4].axis = Vec3(1.0, 0.1, -0.07).normalized();
    expectCounts(makeRing(hinges), kFloating, kFloating, 0);
}

TEST(LinkagesTest, GearTakesOneFreedomAway) {
    Mechanism mechanism = makeDifferential(-1.0);
    const auto with = analyse(mechanism, Model::Built);
    EXPECT_EQ(with.jointsByFreedom[4], 1);
    EXPECT_EQ(with.mobility, kFloating + 1);
    mechanism.gears.clear();
    EXPECT_EQ(analyse(mechanism, Model::Built).mobility, kFloating + 2);
}

TEST(LinkagesTest, LinkBetweenTwoBallsSpinsIdly) {
    Mechanism mechanism;
    const Vec3 from(0.1, 0.2, 0.3);
    const Vec3 to(0.5, 0.4, 0.6);
    mechanism.bodies = {makeBody("chassis", 4.0, Vec3::Zero()), makeBody("rod", 0.2, from),
                        makeBody("lever", 0.3, to)};
    mechanism.joints = {makePin("near", 0, 1, from), makePin("far", 1, 2, to),
                        makePin("pivot", 0, 2, {0.6, 0.0, 0.0})};
    for (std::size_t i : {0U, 1U}) {
        mechanism.joints[i].built = {{FreedomKind::Turn, Vec3::UnitX()},
                                     {FreedomKind::Turn, Vec3::UnitY()},
                                     {FreedomKind::Turn, Vec3::UnitZ()}};
    }
    const auto report = analyse(mechanism, Model::Built);
    EXPECT_EQ(report.redundant, 0);
    EXPECT_EQ(report.mobility, kFloating + 1);
    ASSERT_EQ(report.idle.size(), 1U);
    EXPECT_EQ(report.idle[0].body, "rod");
    const Vec3 line = (to - from).normalized();
    EXPECT_NEAR(std::abs(report.idle[0].turn.normalized().dot(line)), 1.0, 1e-9);
    mechanism.bodies[0].fixed = true;
    const auto held = analyse(mechanism, Model::Built);
    EXPECT_EQ(held.bodies, 2);
    EXPECT_EQ(held.mobility, 1);
    ASSERT_EQ(held.idle.size(), 1U);
    EXPECT_EQ(held.idle[0].body, "rod");
}

TEST(LinkagesTest, VerdictNamesTheStrainAndDistrustsTheCount) {
    const std::string text = describe(analyse(makeFourBar(), Model::Built));
    EXPECT_THAT(text, testing::HasSubstr("Hyperstatic: 3 constraints"));
    EXPECT_THAT(text, testing::HasSubstr("Grübler"));
    const std::string exact = describe(analyse(makeDifferential(-1.0), Model::Built));
    EXPECT_THAT(exact, testing::HasSubstr("Statically determinate"));
    EXPECT_THAT(exact, testing::Not(testing::HasSubstr("Grübler")));
}

TEST(LinkagesTest, BodyAloneFloatsWithSixFreedoms) {
    Mechanism mechanism;
    mechanism.bodies.push_back(makeBody("chassis", 1.0, Vec3::Zero()));
    const auto report = analyse(mechanism, Model::Built);
    EXPECT_EQ(report.gruebler, kFloating);
    EXPECT_EQ(report.rank, 0);
    EXPECT_EQ(report.mobility, kFloating);
    EXPECT_EQ(report.redundant, 0);
    EXPECT_TRUE(report.idle.empty());
}
