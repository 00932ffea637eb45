#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "render/geometry/rover_model.h"
#include "render/geometry/wheel_model.h"
#include "tests/support/rovers.h"
#include "tests/support/scene_graph.h"

using namespace simcore;
using namespace testsupport;
using mechanism::Mechanism;
using mechanism::Shape;
using mechanism::Wheel;
using project::ShapeKind;

namespace {

constexpr double kRounding = 1e-5;

std::vector<DrawnVertex> drawnBody(const Mechanism& mechanism, int body) {
    return verticesBelow(*render::makeBodyGeometry(mechanism, body));
}

Eigen::AlignedBox3d boxOf(const std::vector<DrawnVertex>& drawn) {
    Eigen::AlignedBox3d box;
    for (const DrawnVertex& vertex : drawn) {
        box.extend(vertex.place);
    }
    return box;
}

Mechanism withShape(const Shape& shape) {
    Mechanism mechanism;
    mechanism.bodies.emplace_back().shapes = {shape};
    return mechanism;
}

void expectBox(const Eigen::AlignedBox3d& box, const Vec3& min, const Vec3& max) {
    EXPECT_LT((box.min() - min).norm(), kRounding) << box.min().transpose();
    EXPECT_LT((box.max() - max).norm(), kRounding) << box.max().transpose();
}

/// A wheel off the origin, its axis turned off y.
Wheel obliqueWheel() {
    Wheel wheel;
    wheel.body = 0;
    wheel.center = Vec3(0.3, -0.2, 0.15);
    wheel.axis = Vec3(0.2, 1.0, 0.1).normalized();
    wheel.radius = 0.11;
    wheel.width = 0.07;
    wheel.grousers = 17;
    return wheel;
}

std::vector<DrawnVertex> drawnWheel(const Wheel& wheel) {
    render::MeshBuilder mesh;
    render::addWheel(mesh, wheel, render::wheelColor(0));
    return verticesBelow(*mesh.build());
}

}  // namespace

// A box is drawn with its size, at its place.
TEST(BodyGeometry, BoxHasItsSize) {
    Shape box;
    box.kind = ShapeKind::Box;
    box.center = Vec3(0.1, 0.2, 0.3);
    box.size = Vec3(0.4, 0.2, 0.1);
    expectBox(boxOf(drawnBody(withShape(box), 0)), {-0.1, 0.1, 0.25}, {0.3, 0.3, 0.35});
}

// The pitch of a box turns it about y as a nose-down pitch of the rover does.
TEST(BodyGeometry, PitchedBoxTurnsAboutItsCentre) {
    Shape box;
    box.kind = ShapeKind::Box;
    box.size = Vec3(0.4, 0.2, 0.1);
    box.pitch = 0.5 * std::numbers::pi;
    expectBox(boxOf(drawnBody(withShape(box), 0)), {-0.05, -0.1, -0.2}, {0.05, 0.1, 0.2});
    box.pitch = 0.3;
    const auto drawn = drawnBody(withShape(box), 0);
    Vec3 front = Vec3::Zero();
    for (const DrawnVertex& vertex : drawn) {
        front = vertex.place.x() > front.x() ? vertex.place : front;
    }
    EXPECT_LT(front.z(), -0.01);
}

// Cylinder, sphere and bar reach as far as their numbers say.
TEST(BodyGeometry, RoundShapesAndBarsHaveTheirSize) {
    Shape cylinder;
    cylinder.kind = ShapeKind::Cylinder;
    cylinder.from = Vec3(0, -0.1, 0.5);
    cylinder.to = Vec3(0, 0.3, 0.5);
    cylinder.radius = 0.05;
    expectBox(boxOf(drawnBody(withShape(cylinder), 0)), {-0.05, -0.1, 0.45}, {0.05, 0.3, 0.55});
    Shape sphere;
    sphere.kind = ShapeKind::Sphere;
    sphere.center = Vec3(1, 2, 3);
    sphere.radius = 0.25;
    expectBox(boxOf(drawnBody(withShape(sphere), 0)), {0.75, 1.75, 2.75}, {1.25, 2.25, 3.25});
    Shape bar;
    bar.kind = ShapeKind::Bar;
    bar.from = Vec3(-0.2, 0.1, 0.3);
    bar.to = Vec3(0.4, 0.1, 0.3);
    bar.width = 0.04;
    bar.height = 0.02;
    expectBox(boxOf(drawnBody(withShape(bar), 0)), {-0.2, 0.08, 0.29}, {0.4, 0.12, 0.31});
}

// A body is drawn in the colours of its shapes.
TEST(BodyGeometry, ShapesKeepTheirColours) {
    Shape red;
    red.kind = ShapeKind::Sphere;
    red.radius = 0.1;
    red.color = "#c01020";
    Shape blue = red;
    blue.color = "#1020c0";
    Mechanism mechanism = withShape(red);
    mechanism.bodies.front().shapes.push_back(blue);
    std::set<std::array<int, 3>> colors;
    for (const DrawnVertex& vertex : drawnBody(mechanism, 0)) {
        colors.insert({vertex.color.r(), vertex.color.g(), vertex.color.b()});
    }
    EXPECT_EQ(colors, (std::set<std::array<int, 3>>{{0xc0, 0x10, 0x20}, {0x10, 0x20, 0xc0}}));
}

// A body without shapes is not invisible: it shows as a bar between its joints.
TEST(BodyGeometry, BodyWithoutShapesSpansItsJoints) {
    Mechanism mechanism;
    mechanism.bodies.resize(2);
    for (const double x : {-0.3, 0.4}) {
        auto& joint = mechanism.joints.emplace_back();
        joint.first = 0;
        joint.second = 1;
        joint.point = Vec3(x, 0.1, 0.2);
    }
    const Eigen::AlignedBox3d box = boxOf(drawnBody(mechanism, 1));
    EXPECT_TRUE(box.contains(Vec3(-0.3, 0.1, 0.2)));
    EXPECT_TRUE(box.contains(Vec3(0.4, 0.1, 0.2)));
    EXPECT_LT(box.sizes().y(), 0.1);
}

// Every body of every shipped rover has something to see, with unit normals and finite places.
TEST(BodyGeometry, EveryShippedBodyShows) {
    for (const std::string& name : shippedNames()) {
        const Mechanism mechanism = mechanismOf(name);
        for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
            const auto drawn = drawnBody(mechanism, static_cast<int>(body));
            EXPECT_GE(drawn.size(), 36U) << name << ": " << mechanism.bodies[body].name;
            for (const DrawnVertex& vertex : drawn) {
                ASSERT_TRUE(vertex.place.allFinite());
                ASSERT_NEAR(vertex.normal.norm(), 1.0, 1e-4) << mechanism.bodies[body].name;
            }
        }
    }
}

// The ball that views are fitted to holds all that is drawn, and is not much larger.
TEST(BodyGeometry, BoundsHoldTheRover) {
    for (const std::string& name : shippedNames()) {
        const Mechanism mechanism = mechanismOf(name);
        const render::RoverBounds bounds = render::boundsOf(mechanism);
        double farthest = 0.0;
        for (std::size_t body = 0; body < mechanism.bodies.size(); ++body) {
            for (const DrawnVertex& vertex : drawnBody(mechanism, static_cast<int>(body))) {
                farthest = std::max(farthest, (vertex.place - bounds.center).norm());
            }
        }
        EXPECT_LE(farthest, 1.01 * bounds.radius) << name;
        EXPECT_GE(farthest, 0.7 * bounds.radius) << name;
    }
}

// The tyre is a disc of the wheel's radius and width about its axis: what the contacts are made of.
TEST(WheelGeometry, ReachesItsRadiusAndWidth) {
    const Wheel wheel = obliqueWheel();
    double radius = 0.0, left = 0.0, right = 0.0;
    for (const DrawnVertex& vertex : drawnWheel(wheel)) {
        const Vec3 from = vertex.place - wheel.center;
        const double along = from.dot(wheel.axis);
        radius = std::max(radius, (from - along * wheel.axis).norm());
        left = std::max(left, along);
        right = std::min(right, along);
    }
    EXPECT_NEAR(radius, wheel.radius, 0.005 * wheel.radius);
    EXPECT_NEAR(left, 0.5 * wheel.width, 0.03 * wheel.width);
    EXPECT_NEAR(right, -0.5 * wheel.width, 0.03 * wheel.width);
}

// As many grousers stand out of the tread as the project says, evenly around it.
TEST(WheelGeometry, HasItsGrousers) {
    const Wheel wheel = obliqueWheel();
    const auto [u, v] = render::perpendiculars(wheel.axis);
    constexpr int kBins = 1440;
    std::vector<bool> high(kBins, false);
    for (const DrawnVertex& vertex : drawnWheel(wheel)) {
        const Vec3 from = vertex.place - wheel.center;
        const Vec3 out = from - from.dot(wheel.axis) * wheel.axis;
        if (out.norm() > 0.99 * wheel.radius) {
            const double turn = std::atan2(out.dot(v), out.dot(u)) / (2.0 * std::numbers::pi);
            high[static_cast<std::size_t>((turn + 1.0) * kBins) % kBins] = true;
        }
    }
    // A grouser's top has corners on its two edges: bins within half a spacing are one grouser.
    std::vector<int> at;
    for (int bin = 0; bin < kBins; ++bin) {
        if (high[static_cast<std::size_t>(bin)]) {
            at.push_back(bin);
        }
    }
    const double spacing = static_cast<double>(kBins) / wheel.grousers;
    int count = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const int next = i + 1 < at.size() ? at[i + 1] : at[0] + kBins;
        if (next - at[i] > 0.5 * spacing) {
            EXPECT_NEAR(next - at[i], 0.66 * spacing, 0.12 * spacing);
            ++count;
        }
    }
    EXPECT_EQ(count, wheel.grousers);
}
