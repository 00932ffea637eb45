#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/one_wheel.h"
#include "tests/support/walls.h"

using namespace simcore;
using namespace simcore::contact;
using namespace testsupport;
using std::numbers::pi;

namespace {

constexpr double kRadius = 0.08;
constexpr double kWidth = 0.05;
constexpr double kHalf = 0.45 * kWidth;  // to the outer slices, which bound the solid
const OneWheel kWheel{kRadius, kWidth};

std::vector<Contact> sidesOf(const std::vector<Contact>& contacts) {
    std::vector<Contact> sides;
    for (const Contact& contact : contacts) {
        if (contact.slice == kSide) {
            sides.push_back(contact);
        }
    }
    return sides;
}

Eigen::Quaterniond turned(double yaw, double roll = 0.0) {
    return Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(roll, Vec3::UnitX());
}

}  // namespace

class WallTest : public testing::TestWithParam<double> {};

// A wall left of the wheel and along it: one contact in each quarter of the side, as deep as the
// side is in the wall, however the wall is cut into triangles.
TEST_P(WallTest, WallAlongTheWheelTouchesItsSide) {
    const terrain::Terrain ground = floorAndWall(0.3, 1.0, GetParam());
    const double deep = 0.0007;
    for (const double x : {-0.0123, 0.0, 0.2}) {
        const auto contacts =
            kWheel.contactsAt(ground, {x, 0.3 - kHalf + deep, kRadius - 0.0002}, turned(0.0));
        const auto sides = sidesOf(contacts);
        ASSERT_EQ(sides.size(), 4u) << x;
        EXPECT_EQ(contacts.size(), 5u) << "one on the floor: the left slice is beyond its end";
        double ahead = 0.0;
        double behind = 0.0;
        for (const Contact& contact : sides) {
            EXPECT_NEAR(contact.depth, deep, 1e-12);
            EXPECT_LT((contact.normal + Vec3::UnitY()).norm(), 1e-12);
            EXPECT_LT((contact.forward - Vec3::UnitX()).norm(), 1e-12);
            EXPECT_NEAR(contact.point.y(), 0.3, 1e-12);
            ahead = std::max(ahead, contact.point.x() - x);
            behind = std::min(behind, contact.point.x() - x);
        }
        // Far enough apart to keep the wheel from turning into the wall.
        EXPECT_GT(ahead, 0.6 * kRadius);
        EXPECT_LT(behind, -0.6 * kRadius);
    }
}

// The same on the other side, for a wheel that looks the other way, and for one that is spun.
TEST_P(WallTest, EitherSideOfTheWheel) {
    const terrain::Terrain ground = floorAndWall(0.3, 1.0, GetParam());
    for (const double yaw : {0.0, pi}) {
        for (const double spin : {0.0, 0.7}) {
            const Eigen::Quaterniond rotation =
                turned(yaw) * Eigen::AngleAxisd(spin, Vec3::UnitY());
            EXPECT_EQ(
                sidesOf(kWheel.contactsAt(ground, {0.0, 0.3 - kHalf + 1e-4, kRadius}, rotation))
                    .size(),
                4u);
            EXPECT_TRUE(
                sidesOf(kWheel.contactsAt(ground, {0.0, 0.3 - kHalf - 1e-4, kRadius}, rotation))
                    .empty())
                << "does not reach the wall";
        }
    }
}

// Turned towards the wall, or leaning, the deepest point is that of the rim's circle:
// R sqrt(1 - a^2) + half the width times a, with a the cosine between axle and normal.
TEST_P(WallTest, TurnedWheelIsAsDeepAsItsRim) {
    const terrain::Terrain ground = floorAndWall(0.3, 1.0, GetParam());
    for (const double yaw : {-0.7, -0.3, -0.02, 1e-4, 0.1, 0.5}) {
        const Eigen::Quaterniond rotation = turned(yaw);
        const double reach = kRadius * std::abs(std::sin(yaw)) + kHalf * std::cos(yaw);
        const double deep = 0.0003;
        const auto contacts =
            kWheel.contactsAt(ground, {0.0, 0.3 - reach + deep, kRadius + 0.01}, rotation);
        double deepest = -1.0;
        for (const Contact& contact : contacts) {
            deepest = std::max(deepest, contact.depth);
            EXPECT_LT((contact.normal + Vec3::UnitY()).norm(), 1e-12) << yaw;
            EXPECT_NEAR(contact.forward.dot(contact.normal), 0.0, 1e-12);
            EXPECT_NEAR(contact.forward.norm(), 1.0, 1e-12);
        }
        EXPECT_NEAR(deepest, deep, 1e-9) << "yaw " << yaw;
    }
}

INSTANTIATE_TEST_SUITE_P(Cells, WallTest, testing::Values(0.002, 0.02, 2.0), [](const auto& test) {
    return std::to_string(std::lround(1e3 * test.param)) + "mm";
});

// A kerb lower than the axle touches the lower quarters only.
TEST(SideContactTest, KerbTouchesTheLowerQuarters) {
    const double high = 0.03;
    const terrain::Terrain ground = floorAndWall(0.3, high, 2.0);
    const auto contacts = kWheel.contactsAt(ground, {0.0, 0.3 - kHalf + 0.0005, kRadius - 0.0002});
    for (const Contact& contact : contacts) {
        EXPECT_LE(contact.depth, 0.0005 + 1e-12) << "the kerb's top, far above the rim";
    }
    const auto sides = sidesOf(contacts);
    ASSERT_EQ(sides.size(), 2u);
    for (const Contact& contact : sides) {
        EXPECT_LE(contact.point.z(), high + 1e-12);
        EXPECT_NEAR(contact.depth, 0.0005, 1e-12);
    }
}

// On a ledge, overhanging its edge: the ledge's face is not a wall that the wheel is in.
TEST(SideContactTest, LedgeThatTheWheelStandsOnDoesNotPushIt) {
    // Ground at 0.5 m from y = 0.3 on, with its face looking to -y.
    const double high = 0.5;
    const terrain::Terrain ground = floorAndWall(0.3, high, 2.0);
    for (const double overlap : {0.001, 0.003, 0.01, 0.02, 0.03}) {
        const auto contacts =
            kWheel.contactsAt(ground, {0.0, 0.3 - kHalf + overlap, high + kRadius - 0.0003});
        EXPECT_FALSE(contacts.empty());
        EXPECT_TRUE(sidesOf(contacts).empty()) << "overlap " << overlap;
    }
}

// What is far inside is left alone.
TEST(SideContactTest, WheelDeepInAWallIsNotThrownOut) {
    const terrain::Terrain ground = floorAndWall(0.3, 1.0, 2.0);
    for (const double deep : {0.006, 0.02, 0.03}) {
        EXPECT_TRUE(sidesOf(kWheel.contactsAt(ground, {0.0, 0.3 - kHalf + deep, kRadius})).empty());
    }
}

// A wheel that lies on its side rests on it.
TEST(SideContactTest, WheelLyingDownRestsOnItsSide) {
    const terrain::Terrain ground = floorAndWall(2.0, 0.1, 4.0);
    const auto contacts =
        kWheel.contactsAt(ground, {0.0, 1.7, kHalf - 0.0004}, turned(0.3, 0.5 * pi));
    ASSERT_EQ(sidesOf(contacts).size(), 4u);
    for (const Contact& contact : contacts) {
        EXPECT_NEAR(contact.depth, 0.0004, 1e-12);
        EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-12);
    }
}
