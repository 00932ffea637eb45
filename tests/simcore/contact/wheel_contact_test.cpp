#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "simcore/contact/wheel_contact.h"
#include "tests/support/one_wheel.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::contact;
using namespace testsupport;
using project::TerrainKind;
using std::numbers::pi;

namespace {

constexpr double kRadius = 0.1;
constexpr double kWidth = 0.05;

std::vector<Contact> contactsAt(const terrain::Terrain& terrain, const Vec3& center,
                                const Eigen::Quaterniond& rotation = Eigen::Quaterniond::Identity(),
                                int slices = 2, double margin = 0.0) {
    return OneWheel{kRadius, kWidth}.contactsAt(terrain, center, rotation, slices, margin);
}

/// In the wheel plane from up to the normal, positive when the obstacle is ahead.
double angleOf(const Contact& contact) {
    return std::atan2(-contact.normal.x(), contact.normal.z());
}

}  // namespace

TEST(WheelContactTest, FlatGroundTouchesBelowTheAxle) {
    const auto terrain = made(spec(TerrainKind::Flat));
    const auto contacts = contactsAt(terrain, {0.3, 0.2, kRadius - 0.001});
    ASSERT_EQ(contacts.size(), 2u);
    for (const Contact& contact : contacts) {
        EXPECT_NEAR(contact.depth, 0.001, 1e-12);
        EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-12);
        EXPECT_LT((contact.forward - Vec3::UnitX()).norm(), 1e-12);
        EXPECT_NEAR(contact.point.x(), 0.3, 1e-12);
        EXPECT_NEAR(contact.point.z(), 0.0, 1e-12);
        EXPECT_NEAR(std::abs(contact.point.y() - 0.2), 0.45 * kWidth, 1e-12);
    }
    EXPECT_EQ(contacts[0].slice, 0);
    EXPECT_EQ(contacts[1].slice, 1);
    EXPECT_TRUE(contactsAt(terrain, {0.3, 0.2, kRadius + 1e-6}).empty());
    EXPECT_EQ(
        contactsAt(terrain, {0.3, 0.2, kRadius + 1e-4}, Eigen::Quaterniond::Identity(), 2, 2e-4)
            .size(),
        2u);
}

TEST(WheelContactTest, RampHasItsSlope) {
    for (const double degrees : {5.0, 20.0, 45.0, 70.0}) {
        const double slope = degrees * pi / 180.0;
        project::Terrain ramp = spec(TerrainKind::Ramp, 0.0, 3.0);
        ramp.slope = slope;
        // The centre stands at R - depth over the ramp at (2, tan(slope)).
        const double depth = 0.0005;
        const Vec3 normal(-std::sin(slope), 0.0, std::cos(slope));
        const Vec3 foot(2.0, 0.0, std::tan(slope));
        const auto contacts = contactsAt(made(ramp), foot + (kRadius - depth) * normal);
        ASSERT_EQ(contacts.size(), 2u) << degrees;
        for (const Contact& contact : contacts) {
            EXPECT_NEAR(angleOf(contact), slope, 1e-12);
            EXPECT_NEAR(contact.depth, depth, 1e-12);
            EXPECT_NEAR(contact.point.x(), foot.x(), 1e-12);
            EXPECT_NEAR(contact.forward.z(), std::sin(slope), 1e-12);
        }
    }
}

// A wheel on a step's edge: sin of the contact angle = horizontal distance to the edge / R.
TEST(WheelContactTest, StepEdgeTurnsTheNormalToTheAxle) {
    const double height = 0.04;
    const auto terrain = made(spec(TerrainKind::Step, height, 1.0));
    for (const double angle : {0.05, 0.2, 0.5, 0.9}) {
        const double depth = 1e-4;
        const Vec3 center(1.0 - (kRadius - depth) * std::sin(angle), 0.0,
                          height + (kRadius - depth) * std::cos(angle));
        const auto contacts = contactsAt(terrain, center);
        // Low enough it stands on the floor as well.
        const bool floor = center.z() < kRadius;
        ASSERT_EQ(contacts.size(), floor ? 4u : 2u) << angle;
        int edges = 0;
        for (const Contact& contact : contacts) {
            if (contact.normal.z() > 1.0 - 1e-12) {
                continue;
            }
            ++edges;
            EXPECT_NEAR(angleOf(contact), angle, 1e-9);
            EXPECT_NEAR(contact.depth, depth, 1e-12);
            EXPECT_NEAR(contact.point.x(), 1.0, 1e-12);
            EXPECT_NEAR(contact.point.z(), height, 1e-12);
        }
        EXPECT_EQ(edges, 2);
    }
}

// The first touch of a step lower than the axle: cos(angle) = 1 - h / R.
TEST(WheelContactTest, FirstTouchOfALowStep) {
    const double height = 0.04;
    const double angle = std::acos(1.0 - height / kRadius);
    const auto terrain = made(spec(TerrainKind::Step, height, 1.0));
    const Vec3 center(1.0 - kRadius * std::sin(angle) + 1e-7, 0.0, kRadius - 1e-9);
    const auto contacts = contactsAt(terrain, center);
    ASSERT_EQ(contacts.size(), 4u);
    double largest = 0.0;
    for (const Contact& contact : contacts) {
        largest = std::max(largest, angleOf(contact));
    }
    EXPECT_NEAR(largest, angle, 1e-5);
}

TEST(WheelContactTest, FloorAndWallTouchTwicePerSlice) {
    const auto terrain = made(spec(TerrainKind::Step, 0.3, 1.0));
    const auto contacts = contactsAt(terrain, {1.0 - kRadius + 0.001, 0.0, kRadius - 0.002});
    ASSERT_EQ(contacts.size(), 4u);
    int walls = 0;
    for (const Contact& contact : contacts) {
        const bool wall = contact.normal.x() < -0.5;
        walls += wall ? 1 : 0;
        EXPECT_LT((contact.normal - (wall ? Vec3(-1.0, 0.0, 0.0) : Vec3::UnitZ())).norm(), 1e-12);
        EXPECT_NEAR(contact.depth, wall ? 0.001 : 0.002, 1e-12);
        // On a wall rolling forward means up.
        EXPECT_NEAR(contact.forward.z(), wall ? 1.0 : 0.0, 1e-12);
    }
    EXPECT_EQ(walls, 2);
}

TEST(WheelContactTest, RidgeOfTwoRampsIsOneContact) {
    // The polyline's corner at x = 0: a roof with the same slope on both sides.
    const auto roof = terrain::Terrain::extruded(
        {{-2.0, -1.0}, {-1.0, -0.5}, {0.0, 0.0}, {1.0, -0.5}, {2.0, -1.0}}, -1.0, 1.0);
    const auto contacts = contactsAt(roof, {0.0, 0.0, kRadius - 0.0003});
    ASSERT_EQ(contacts.size(), 2u);
    for (const Contact& contact : contacts) {
        EXPECT_LT((contact.normal - Vec3::UnitZ()).norm(), 1e-9);
        EXPECT_NEAR(contact.depth, 0.0003, 1e-12);
        EXPECT_LT(std::hypot(contact.point.x(), contact.point.z()), 1e-12);
    }
}

// The joints of a polyline that lies straight are no corners and are not counted twice.
TEST(WheelContactTest, StraightJointIsNoCorner) {
    const auto ground =
        terrain::Terrain::extruded({{-2.0, 0.0}, {0.0, 0.0}, {2.0, 0.0}}, -1.0, 1.0);
    for (const double x : {-1e-7, 0.0, 1e-7, 0.013}) {
        const auto contacts = contactsAt(ground, {x, 0.0, kRadius - 0.001});
        ASSERT_EQ(contacts.size(), 2u) << x;
        EXPECT_NEAR(contacts[0].depth, 0.001, 1e-12);
    }
}

// A wheel that leans: each slice is a disc that touches with its lowest point.
TEST(WheelContactTest, LeaningWheelTouchesWithItsLowerEdge) {
    const auto terrain = made(spec(TerrainKind::Flat));
    const double lean = 0.3;
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(lean, Vec3::UnitX()));
    // Left end of the axle up: the right slice is the lower one.
    const double lowest = kRadius * std::cos(lean) + 0.45 * kWidth * std::sin(lean);
    const auto contacts = contactsAt(terrain, {0.0, 0.0, lowest - 0.0005}, rotation);
    ASSERT_EQ(contacts.size(), 1u);
    EXPECT_LT((contacts[0].normal - Vec3::UnitZ()).norm(), 1e-12);
    EXPECT_NEAR(contacts[0].depth, 0.0005, 1e-9);
    const double y = 0.45 * kWidth * -std::cos(lean) + kRadius * std::sin(lean);
    EXPECT_NEAR(contacts[0].point.y(), y, 1e-3);
    EXPECT_LT((contacts[0].forward - Vec3::UnitX()).norm(), 1e-12);
}

TEST(WheelContactTest, TurnedWheelRollsWhereItPoints) {
    const auto terrain = made(spec(TerrainKind::Flat));
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(0.6, Vec3::UnitZ()));
    for (const Contact& contact : contactsAt(terrain, {0.0, 0.0, kRadius - 0.001}, rotation)) {
        EXPECT_LT((contact.forward - Vec3(std::cos(0.6), std::sin(0.6), 0.0)).norm(), 1e-12);
    }
}

// Spinning the wheel about its axle changes nothing.
TEST(WheelContactTest, SpinDoesNotMatter) {
    const auto terrain = made(spec(TerrainKind::Stairs, 0.03, 0.07, 0.0, 20));
    Random random(9);
    for (int i = 0; i < 200; ++i) {
        const Vec3 center(random.uniform(0.9, 2.2), 0.0, random.uniform(0.1, 0.7));
        const auto still = contactsAt(terrain, center);
        const auto spun = contactsAt(
            terrain, center,
            Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(-3.0, 3.0), Vec3::UnitY())));
        ASSERT_EQ(still.size(), spun.size());
        for (std::size_t k = 0; k < still.size(); ++k) {
            EXPECT_LT((still[k].normal - spun[k].normal).norm(), 1e-9);
            EXPECT_NEAR(still[k].depth, spun[k].depth, 1e-9);
        }
    }
}

// Triangles near a wheel are kept while it stays near: slowly, faster, turning, at rest, elsewhere.
TEST(WheelContactTest, WhereTheWheelCameFromDoesNotMatter) {
    for (const auto& ground : {spec(TerrainKind::Particles, 0.0, 3.0, 0.11, 150, 3),
                               spec(TerrainKind::Sinus, 0.1, 0.4, 0.0, 4),
                               spec(TerrainKind::Stairs, 0.1, 0.2, 0.0, 6)}) {
        const auto terrain = made(ground);
        const OneWheel wheel{kRadius, kWidth};
        const mechanism::Mechanism mechanism = wheel.mechanism();
        WheelContactFinder moving(mechanism, terrain, 2, 1e-3);
        std::vector<Pose> poses(2);
        Random random(11);
        Vec3 center(0.5, 0.1, 0.0);
        double heading = 0.0;
        std::size_t total = 0;
        for (int step = 0; step < 2000; ++step) {
            const double speed = step % 400 < 50 ? 0.0 : 1e-5 * (1 + step % 400);
            center += speed * Vec3(std::cos(heading), std::sin(heading), 0.0);
            heading += random.uniform(-0.01, 0.01);
            if (step % 500 == 499) {
                center = {random.uniform(0.0, 2.0), random.uniform(-0.3, 0.3), 0.0};
            }
            center.z() = terrain.heightAt(center.x(), center.y()) + kRadius - 5e-4;
            poses[1] = {Eigen::Quaterniond(Eigen::AngleAxisd(heading, Vec3::UnitZ()) *
                                           Eigen::AngleAxisd(0.1 * heading, Vec3::UnitX())),
                        center};
            const std::vector<Contact>& found = moving.find(poses);
            const std::vector<Contact> wanted =
                wheel.contactsAt(terrain, center, poses[1].rotation, 2, 1e-3);
            total += wanted.size();
            ASSERT_EQ(found.size(), wanted.size()) << "step " << step;
            for (std::size_t i = 0; i < found.size(); ++i) {
                ASSERT_EQ(found[i].slice, wanted[i].slice);
                ASSERT_EQ(found[i].point, wanted[i].point);
                ASSERT_EQ(found[i].normal, wanted[i].normal);
                ASSERT_EQ(found[i].depth, wanted[i].depth);
            }
        }
        EXPECT_GT(total, 2000u) << "the wheel misses the ground";
    }
}

// On any ground: unit vectors, forward square to normal and axle, depth below the radius, and the
// deepest contact as deep as the nearest point of a finely sampled ground.
TEST(WheelContactTest, AgreesWithFinelySampledGround) {
    const auto terrain = made(spec(TerrainKind::RandomProfile, 0.1, 3.0, 0.0, 8, 3));
    Random random(11);
    int touching = 0;
    for (int i = 0; i < 400; ++i) {
        const double x = random.uniform(0.9, 4.1);
        const Vec3 center(x, 0.0, terrain.heightAt(x, 0.0) + random.uniform(0.85, 1.05) * kRadius);
        double nearest = 1.0;
        const auto& profile = terrain.profile();
        for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
            for (int n = 0; n <= 1000; ++n) {
                const Eigen::Vector2d p = profile[k] + (profile[k + 1] - profile[k]) * n / 1000.0;
                if (std::abs(p.x() - x) < kRadius) {
                    nearest = std::min(nearest, std::hypot(p.x() - x, p.y() - center.z()));
                }
            }
        }
        const auto contacts = contactsAt(terrain, center);
        double deepest = -1.0;
        for (const Contact& contact : contacts) {
            deepest = std::max(deepest, contact.depth);
            EXPECT_NEAR(contact.normal.norm(), 1.0, 1e-12);
            EXPECT_NEAR(contact.forward.dot(contact.normal), 0.0, 1e-12);
            EXPECT_NEAR(contact.forward.y(), 0.0, 1e-12);
        }
        if (nearest > kRadius + 1e-4) {
            EXPECT_TRUE(contacts.empty()) << "x = " << x;
        } else if (nearest < kRadius - 1e-4) {
            ++touching;
            // Samples of an edge of 3 m are up to d = 1.5 mm from its nearest point: d^2 / 2R.
            EXPECT_NEAR(deepest, kRadius - nearest, 2e-5) << "x = " << x;
        }
    }
    EXPECT_GT(touching, 150);
}
