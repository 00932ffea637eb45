#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "simcore/base/random.h"
#include "simcore/contact/body_contacts.h"
#include "tests/support/carts.h"
#include "tests/support/rovers.h"
#include "tests/support/terrains.h"

using namespace simcore;
using namespace simcore::contact;
using namespace testsupport;
using project::ShapeKind;
using project::TerrainKind;

namespace {

mechanism::Shape boxShape(const Vec3& center, const Vec3& size, double pitch = 0.0) {
    mechanism::Shape shape;
    shape.kind = ShapeKind::Box;
    shape.center = center;
    shape.size = size;
    shape.pitch = pitch;
    return shape;
}

mechanism::Shape roundShape(ShapeKind kind, const Vec3& from, const Vec3& to, double radius) {
    mechanism::Shape shape;
    shape.kind = kind;
    shape.center = shape.from = from;
    shape.to = to;
    shape.radius = radius;
    return shape;
}

mechanism::Shape barShape(const Vec3& from, const Vec3& to, double width, double height) {
    mechanism::Shape shape;
    shape.kind = ShapeKind::Bar;
    shape.from = from;
    shape.to = to;
    shape.width = width;
    shape.height = height;
    return shape;
}

Mechanism bodyOfShapes(std::vector<mechanism::Shape> shapes) {
    Mechanism mechanism;
    mechanism.bodies = {makeBody("box", 1.0, Vec3::Zero())};
    mechanism.bodies[0].shapes = std::move(shapes);
    return mechanism;
}

const Vec3 kSize(0.4, 0.3, 0.1);

/// A box about the origin of its frame.
Mechanism box() {
    return bodyOfShapes({boxShape(Vec3::Zero(), kSize)});
}

Pose poseAt(const Vec3& position,
            const Eigen::Quaterniond& rotation = Eigen::Quaterniond(1, 0, 0, 0)) {
    Pose pose;
    pose.position = position;
    pose.rotation = rotation;
    return pose;
}

std::vector<Contact> contactsOf(const Mechanism& mechanism, const terrain::Terrain& terrain,
                                const Pose& pose, double margin = 0.0,
                                double deepest = BodyContactFinder::kDeepest) {
    BodyContactFinder finder(mechanism, terrain, margin, deepest);
    return finder.find(std::vector<Pose>(mechanism.bodies.size(), pose));
}

double deepestOf(const std::vector<Contact>& contacts) {
    double depth = -std::numeric_limits<double>::infinity();
    for (const Contact& contact : contacts) {
        depth = std::max(depth, contact.depth);
    }
    return depth;
}

Eigen::Quaterniond turn(double angle, const Vec3& axis) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()));
}

/// The same pose seen in a mirror at y = 0.
Pose mirrored(const Pose& pose) {
    const Eigen::Quaterniond& q = pose.rotation;
    return poseAt({pose.position.x(), -pose.position.y(), pose.position.z()},
                  Eigen::Quaterniond(q.w(), -q.x(), q.y(), -q.z()));
}

}  // namespace

TEST(BodyContactTest, ABoxOnLevelGroundTouchesWithItsFourCorners) {
    const auto contacts =
        contactsOf(box(), levelGround(), poseAt({0.7, 0.2, 0.5 * kSize.z() - 0.001}));
    ASSERT_EQ(contacts.size(), 4U);
    for (const Contact& c : contacts) {
        EXPECT_EQ(c.wheel, -1);
        EXPECT_EQ(c.body, 0);
        EXPECT_NEAR(c.depth, 0.001, 1e-12);
        EXPECT_LT((c.normal - Vec3::UnitZ()).norm(), 1e-12);
        EXPECT_LT((c.forward - Vec3::UnitX()).norm(), 1e-12);
        EXPECT_NEAR(std::abs(c.point.x() - 0.7), 0.5 * kSize.x(), 1e-12);
        EXPECT_NEAR(std::abs(c.point.y() - 0.2), 0.5 * kSize.y(), 1e-12);
        EXPECT_NEAR(c.point.z(), 0.0, 1e-12);
    }
}

TEST(BodyContactTest, NothingTouchesAboveTheGroundButWithinTheMargin) {
    const Pose above = poseAt({0.0, 0.0, 0.5 * kSize.z() + 5e-4});
    EXPECT_TRUE(contactsOf(box(), levelGround(), above).empty());
    EXPECT_TRUE(contactsOf(box(), levelGround(), above, 4e-4).empty());
    const auto near = contactsOf(box(), levelGround(), above, 6e-4);
    ASSERT_EQ(near.size(), 4U);
    EXPECT_NEAR(near[0].depth, -5e-4, 1e-12);
    EXPECT_TRUE(contactsOf(box(), levelGround(), poseAt({0.0, 0.0, 10.0}), 1e-3).empty());
    EXPECT_TRUE(contactsOf(box(), levelGround(), poseAt({500.0, 0.0, -0.01})).empty())
        << "beyond the ground is nothing";
}

// A face that is parallel to the slope and 2 mm deep in it; any heading.
TEST(BodyContactTest, DepthAndNormalOnASlopeAreExact) {
    for (const double slope : {0.1, 0.4, 0.7}) {
        const Vec3 normal(-std::sin(slope), 0.0, std::cos(slope));
        for (const double heading : {0.0, 0.6, 2.0}) {
            const Pose pose = poseAt((0.5 * kSize.z() - 0.002) * normal,
                                     turn(-slope, Vec3::UnitY()) * turn(heading, Vec3::UnitZ()));
            const auto contacts = contactsOf(box(), slopeThroughOrigin(slope), pose);
            ASSERT_EQ(contacts.size(), 4U) << slope;
            for (const Contact& c : contacts) {
                EXPECT_NEAR(c.depth, 0.002, 1e-9);
                EXPECT_LT((c.normal - normal).norm(), 1e-9);
                EXPECT_NEAR(c.point.dot(normal), 0.0, 1e-9);
                EXPECT_NEAR(c.forward.dot(normal), 0.0, 1e-12);
                EXPECT_NEAR(c.forward.norm(), 1.0, 1e-12);
            }
        }
    }
}

// The lowest point of each kind of shape, from its definition.
TEST(BodyContactTest, EveryKindOfShapeTouchesWithItsLowestPoint) {
    constexpr double kPitch = 0.4;
    constexpr double kDepth = 0.001;
    const double halfHigh = 0.2 * std::sin(kPitch) + 0.05 * std::cos(kPitch);
    // A bar that climbs: its section's height is square to it.
    const Vec3 rise(0.3, 0.1, 0.12);
    const double level = std::hypot(rise.x(), rise.y());
    const double barLow = 0.5 * 0.04 * level / rise.norm();

    struct Case {
        mechanism::Shape shape;
        double low;  ///< below its frame's origin [m]
    };

    for (const Case& c :
         {Case{boxShape(Vec3::Zero(), kSize, kPitch), halfHigh},
          Case{roundShape(ShapeKind::Sphere, {0.02, 0.01, 0.0}, Vec3::Zero(), 0.07), 0.07},
          Case{roundShape(ShapeKind::Cylinder, {0.0, -0.1, 0.0}, {0.0, 0.1, 0.0}, 0.06), 0.06},
          Case{roundShape(ShapeKind::Cylinder, {0.0, 0.0, -0.08}, {0.0, 0.0, 0.1}, 0.06), 0.08},
          Case{barShape(Vec3::Zero(), rise, 0.02, 0.04), barLow}}) {
        const auto contacts =
            contactsOf(bodyOfShapes({c.shape}), levelGround(), poseAt({0.3, 0.1, c.low - kDepth}));
        ASSERT_FALSE(contacts.empty());
        EXPECT_NEAR(deepestOf(contacts), kDepth, 1e-9);
    }
}

// The rim is a polygon that leaves the circle by at most 2 %.
TEST(BodyContactTest, ACylinderTouchesWhereverItTurns) {
    const Mechanism can =
        bodyOfShapes({roundShape(ShapeKind::Cylinder, {0.0, -0.1, 0.0}, {0.0, 0.1, 0.0}, 0.06)});
    for (int i = 0; i < 20; ++i) {
        const auto contacts = contactsOf(can, levelGround(),
                                         poseAt({0.0, 0.0, 0.058}, turn(0.05 * i, Vec3::UnitY())));
        EXPECT_LE(deepestOf(contacts), 0.002 + 1e-9);
        EXPECT_GE(deepestOf(contacts), 0.002 - 0.02 * 0.06);
    }
}

// Samples of a face stand 30 mm apart: one of them is over any place that is 40 mm long and wide.
TEST(BodyContactTest, ARockUnderTheBellyIsFound) {
    Random random(11);
    for (int i = 0; i < 50; ++i) {
        const int ix = static_cast<int>(random.uniform(42.0, 58.0));
        const int iy = static_cast<int>(random.uniform(44.0, 56.0));
        std::vector<double> heights(101 * 101, 0.0);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                heights[static_cast<std::size_t>((ix + dx) * 101 + iy + dy)] = 0.05;
            }
        }
        const auto ground = terrain::Terrain::grid(-1.0, -1.0, 0.02, 101, 101, heights);
        const auto contacts =
            contactsOf(box(), ground, poseAt({0.0, 0.0, 0.5 * kSize.z() + 0.005}));
        EXPECT_FALSE(contacts.empty()) << "rock at " << ix << ", " << iy;
        for (const Contact& c : contacts) {
            EXPECT_GT(c.normal.z(), 0.0);
            EXPECT_LE(c.depth, 0.045);
        }
    }
}

// The belly of a box that has slid 0.2 m onto a block stands 1 mm deep in its top. Its samples just
// behind the edge are nearer to the block's side, which does not look at the belly.
TEST(BodyContactTest, ABellyOnABlockIsHeldByItsTopAlone) {
    const auto block =
        terrain::Terrain::extruded({{-2.0, 0.0}, {0.0, 0.0}, {0.0, 0.2}, {2.0, 0.2}}, -2.0, 2.0);
    for (int i = 0; i < 100; ++i) {
        const double x = 0.001 * i;
        const auto contacts = contactsOf(box(), block, poseAt({x, 0.0, 0.2 + 0.049}));
        ASSERT_EQ(contacts.size(), 4U);
        for (const Contact& c : contacts) {
            EXPECT_LT((c.normal - Vec3::UnitZ()).norm(), 1e-12);
            EXPECT_NEAR(c.depth, 0.001, 1e-12);
            EXPECT_GE(c.point.x(), -1e-12);
        }
    }
}

TEST(BodyContactTest, AWallPushesBackAndIsForgottenDeepInside) {
    const auto wall =
        terrain::Terrain::extruded({{-2.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}, {2.0, 1.0}}, -2.0, 2.0);
    const auto into = [&](double depth) {
        return contactsOf(box(), wall, poseAt({-0.5 * kSize.x() + depth, 0.0, 0.3}));
    };
    const auto contacts = into(0.002);
    ASSERT_EQ(contacts.size(), 4U);
    for (const Contact& c : contacts) {
        EXPECT_LT((c.normal + Vec3::UnitX()).norm(), 1e-12);
        EXPECT_NEAR(c.depth, 0.002, 1e-12);
        EXPECT_NEAR(std::abs(c.point.y()), 0.5 * kSize.y(), 1e-12);
        EXPECT_NEAR(std::abs(c.point.z() - 0.3), 0.5 * kSize.z(), 1e-12);
    }
    // The front stands 0.1 m inside, and what of the sides is less deep looks along the wall.
    EXPECT_LE(deepestOf(into(0.1)), BodyContactFinder::kDeepest);
    for (const Contact& c : into(0.1)) {
        EXPECT_GT(c.depth, 0.0);
    }
    EXPECT_TRUE(contactsOf(box(), levelGround(), poseAt({0.0, 0.0, -1.0})).empty());
}

TEST(BodyContactTest, FixedBodiesWheelsAndWhatWheelsCoverDoNotTouch) {
    const Pose sunk = poseAt({0.0, 0.0, 0.5 * kSize.z() - 0.001});
    Mechanism mechanism = box();
    mechanism.bodies[0].fixed = true;
    EXPECT_TRUE(contactsOf(mechanism, levelGround(), sunk).empty());

    Mechanism drum = makeDrum(1.0, 0.1, 0.05);
    drum.bodies[0].shapes = {boxShape(Vec3::Zero(), kSize)};
    EXPECT_TRUE(contactsOf(drum, levelGround(), sunk).empty());

    // A hub in the wheel is behind its rim whatever it stands on; as wide as two wheels it is not.
    Mechanism cart = makeCart();
    const Vec3 center = cart.wheels[0].center;
    const auto hub = [&](double length) {
        const Vec3 half(0.0, 0.5 * length, 0.0);
        cart.bodies[0].shapes = {
            roundShape(ShapeKind::Cylinder, center - half, center + half, 0.06)};
        return contactsOf(cart, levelGround(), poseAt({0.0, 0.0, -0.015}));
    };
    EXPECT_TRUE(hub(0.049).empty());
    EXPECT_FALSE(hub(0.1).empty());
}

// Two boxes side by side are one body: their common face is inside, their outsides stay.
TEST(BodyContactTest, WhatAnotherShapeHidesDoesNotTouch) {
    const auto outer = boxShape(Vec3::Zero(), {0.2, 0.2, 0.2});
    const auto inner = boxShape(Vec3::Zero(), {0.1, 0.1, 0.1});
    const auto contacts = contactsOf(bodyOfShapes({inner, outer}), levelGround(),
                                     poseAt({0.0, 0.0, 0.045}), 0.0, 1.0);
    ASSERT_FALSE(contacts.empty());
    const std::size_t innerSamples = samplesOf(inner).size();
    const std::size_t outerSamples = samplesOf(outer).size();
    EXPECT_GT(innerSamples, 0U);
    for (const Contact& c : contacts) {
        EXPECT_NEAR(c.depth, 0.055, 1e-9) << "the outer box's belly";
        EXPECT_LT(static_cast<std::size_t>(c.slice), outerSamples);
    }
}

// On mirrored ground: random poses of the shipped rovers, sunk to their bellies.
TEST(BodyContactTest, MirroredPosesGiveMirroredContacts) {
    project::Terrain field = spec(TerrainKind::Random3d, 0.06, 3.0, 0.0, 40, 3);
    field.start = -1.0;
    field.symmetric = true;
    const auto ground = made(field);
    for (const std::string name : {"solero", "bench_rover"}) {
        const Mechanism rover = mechanismOf(name);
        // Of each body, its mirror image.
        std::vector<int> partner(rover.bodies.size());
        for (std::size_t i = 0; i < partner.size(); ++i) {
            std::string other = rover.bodies[i].name;
            if (const auto at = other.find("left"); at != std::string::npos) {
                other.replace(at, 4, "right");
            } else if (const auto there = other.find("right"); there != std::string::npos) {
                other.replace(there, 5, "left");
            }
            partner[i] = rover.findBody(other);
            ASSERT_GE(partner[i], 0) << other;
        }
        BodyContactFinder finder(rover, ground);
        Random random(5);
        std::size_t found = 0;
        for (int i = 0; i < 60; ++i) {
            const Pose pose = poseAt(
                {random.uniform(-0.5, 1.5), random.uniform(-0.3, 0.3), random.uniform(-0.2, 0.0)},
                turn(random.uniform(-0.3, 0.3), Vec3::UnitX()) *
                    turn(random.uniform(-0.3, 0.3), Vec3::UnitY()) *
                    turn(random.uniform(-3.0, 3.0), Vec3::UnitZ()));
            const std::size_t bodies = rover.bodies.size();
            const std::vector<Contact> contacts = finder.find(std::vector<Pose>(bodies, pose));
            std::vector<Contact> others = finder.find(std::vector<Pose>(bodies, mirrored(pose)));
            EXPECT_EQ(contacts.size(), others.size());
            found += contacts.size();
            for (const Contact& c : contacts) {
                const Vec3 point(c.point.x(), -c.point.y(), c.point.z());
                const Vec3 normal(c.normal.x(), -c.normal.y(), c.normal.z());
                EXPECT_TRUE(std::any_of(others.begin(), others.end(),
                                        [&](const Contact& other) {
                                            return other.body ==
                                                       partner[static_cast<std::size_t>(c.body)] &&
                                                   (other.point - point).norm() < 1e-9 &&
                                                   (other.normal - normal).norm() < 1e-9 &&
                                                   std::abs(other.depth - c.depth) < 1e-9;
                                        }))
                    << name << ", pose " << i << ", body "
                    << rover.bodies[static_cast<std::size_t>(c.body)].name;
            }
        }
        EXPECT_GT(found, 100U) << name << " touches in these poses";
    }
}

// At a pose that is its own mirror image the contacts are, too.
TEST(BodyContactTest, AStraightPoseTouchesTheSameLeftAndRight) {
    const Mechanism rover = mechanismOf("solero");
    for (const double pitch : {-0.2, 0.0, 0.1}) {
        const auto contacts =
            contactsOf(rover, levelGround(), poseAt({0.0, 0.0, -0.08}, turn(pitch, Vec3::UnitY())));
        ASSERT_FALSE(contacts.empty());
        for (const Contact& c : contacts) {
            EXPECT_TRUE(std::any_of(
                contacts.begin(), contacts.end(),
                [&](const Contact& other) {
                    return (other.point - Vec3(c.point.x(), -c.point.y(), c.point.z())).norm() <
                               1e-9 &&
                           std::abs(other.depth - c.depth) < 1e-9;
                }))
                << rover.bodies[static_cast<std::size_t>(c.body)].name << " at "
                << c.point.transpose();
        }
    }
}

TEST(BodyContactTest, NoMoreThanFourOnTheGroundAndFourOnWallsOfABody) {
    const auto corner =
        terrain::Terrain::extruded({{-2.0, 0.0}, {0.0, 0.0}, {0.0, 1.0}, {2.0, 1.0}}, -2.0, 2.0);
    const auto contacts =
        contactsOf(box(), corner, poseAt({-0.5 * kSize.x() + 0.001, 0.0, 0.5 * kSize.z() - 0.002}));
    int floor = 0;
    int wall = 0;
    for (const Contact& c : contacts) {
        (c.normal.z() > 0.5 ? floor : wall)++;
        EXPECT_NEAR(c.depth, c.normal.z() > 0.5 ? 0.002 : 0.001, 1e-12);
    }
    EXPECT_EQ(floor, 4);
    EXPECT_GE(wall, 2);
    EXPECT_LE(wall, 4);
}
