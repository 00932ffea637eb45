#include <gtest/gtest.h>

#include "simcore/project/resolve.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::mechanism;
using namespace testsupport;

namespace {

Vec3 mirroredPolar(const Vec3& v) {
    return {v.x(), -v.y(), v.z()};
}

Vec3 mirroredAxial(const Vec3& v) {
    return {-v.x(), v.y(), -v.z()};
}

Mechanism resolved(const project::Project& project, const std::string& variant = {}) {
    auto mechanism = project::resolve(project, variant);
    if (!mechanism) {
        throw std::runtime_error(toString(mechanism.problems()));
    }
    return std::move(mechanism).value();
}

std::string otherSide(std::string name) {
    const std::size_t at = name.find("left");
    return at == std::string::npos ? "" : name.replace(at, 4, "right");
}

}  // namespace

class ShippedProjectTest : public testing::TestWithParam<std::string> {};

TEST_P(ShippedProjectTest, ResolvesWithoutCriticalProblems) {
    const project::Project project = shipped(GetParam());
    const Problems problems = project::validate(project);
    EXPECT_FALSE(hasCritical(problems)) << toString(problems);
    const Mechanism mechanism = resolved(project);
    EXPECT_EQ(mechanism.wheels.size(), 6u);
    EXPECT_GT(mechanism.mass(), 1.0);
    EXPECT_GT(mechanism.wheelbase(), 0.3);
    for (const project::Variant& variant : project.variants) {
        EXPECT_TRUE(project::resolve(project, variant.name)) << variant.name;
    }
}

// Each left element has its mirror image: polar vectors (x, -y, z), axial ones (-x, y, -z).
TEST_P(ShippedProjectTest, MirroredPairsAreSymmetric) {
    const Mechanism m = resolved(shipped(GetParam()));
    int pairs = 0;
    for (const Body& left : m.bodies) {
        const int index = m.findBody(otherSide(left.name));
        if (otherSide(left.name).empty() || index < 0) {
            continue;
        }
        ++pairs;
        const Body& right = m.bodies[static_cast<std::size_t>(index)];
        EXPECT_DOUBLE_EQ(left.mass, right.mass);
        EXPECT_LT((mirroredPolar(left.com) - right.com).norm(), 1e-12) << left.name;
        const Mat3 flip = Vec3(1.0, -1.0, 1.0).asDiagonal();
        EXPECT_LT((flip * left.inertia * flip - right.inertia).norm(), 1e-12) << left.name;
        ASSERT_EQ(left.shapes.size(), right.shapes.size());
    }
    for (const Joint& left : m.joints) {
        const int index = m.findJoint(otherSide(left.name));
        if (otherSide(left.name).empty() || index < 0) {
            continue;
        }
        ++pairs;
        const Joint& right = m.joints[static_cast<std::size_t>(index)];
        EXPECT_LT((mirroredPolar(left.point) - right.point).norm(), 1e-12) << left.name;
        EXPECT_LT((mirroredAxial(left.axis) - right.axis).norm(), 1e-12) << left.name;
        EXPECT_EQ(left.stops, right.stops);
        const std::string first = m.bodies[static_cast<std::size_t>(left.first)].name;
        const std::string wanted = otherSide(first).empty() ? first : otherSide(first);
        EXPECT_EQ(m.bodies[static_cast<std::size_t>(right.first)].name, wanted) << left.name;
        for (const auto& [a, b] :
             {std::pair{left.built, right.built}, std::pair{left.relaxed, right.relaxed}}) {
            ASSERT_EQ(a.size(), b.size());
            for (std::size_t i = 0; i < a.size(); ++i) {
                const Vec3 image = a[i].kind == FreedomKind::Turn ? mirroredAxial(a[i].direction)
                                                                  : mirroredPolar(a[i].direction);
                EXPECT_EQ(a[i].kind, b[i].kind);
                EXPECT_LT((image - b[i].direction).norm(), 1e-12) << left.name;
            }
        }
    }
    for (const Wheel& left : m.wheels) {
        const int index = m.findWheel(otherSide(left.name));
        if (otherSide(left.name).empty() || index < 0) {
            continue;
        }
        ++pairs;
        const Wheel& right = m.wheels[static_cast<std::size_t>(index)];
        EXPECT_LT((mirroredPolar(left.center) - right.center).norm(), 1e-12);
        EXPECT_GT(left.axis.y(), 0.0);  // a positive torque drives forward on every wheel
        EXPECT_GT(right.axis.y(), 0.0);
        EXPECT_DOUBLE_EQ(left.radius, right.radius);
    }
    EXPECT_GE(pairs, 6);
    EXPECT_LT(std::abs(m.centerOfMass().y()), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedProjectTest, testing::ValuesIn(shippedNames()),
                         [](const auto& test) { return test.param; });

TEST(MirrorTest, ProductsOfInertiaChangeSign) {
    project::Project project = cart();
    project.rover.bodies[1].inertia = {{0.02, 0.03, 0.025, 0.001, 0.002, 0.003}};
    const Mechanism m = resolved(project);
    const Mat3& left = m.bodies[static_cast<std::size_t>(m.findBody("wheel_left"))].inertia;
    const Mat3& right = m.bodies[static_cast<std::size_t>(m.findBody("wheel_right"))].inertia;
    EXPECT_DOUBLE_EQ(left(0, 1), 0.001);
    EXPECT_DOUBLE_EQ(right(0, 1), -0.001);
    EXPECT_DOUBLE_EQ(right(0, 2), 0.002);
    EXPECT_DOUBLE_EQ(right(1, 2), -0.003);
}

TEST(MirrorTest, VariantSetsParametersOfTheWholeRover) {
    const project::Project project = cart();
    EXPECT_DOUBLE_EQ(resolved(project).wheels[0].radius, 0.1);
    EXPECT_DOUBLE_EQ(resolved(project).wheels[0].center.y(), 0.2);
    const Mechanism big = resolved(project, "big");
    EXPECT_DOUBLE_EQ(big.wheels[0].radius, 0.15);
    EXPECT_DOUBLE_EQ(big.wheels[0].center.y(), 0.3);  // derived parameters follow
    EXPECT_DOUBLE_EQ(big.wheels[1].center.y(), -0.3);
    EXPECT_FALSE(project::resolve(project, "huge"));
}

TEST(RelaxedSidesTest, ConcernOneCopyOfAMirroredElement) {
    project::Project project = cart();
    project::Joint& axle = project.rover.joints.at(0);
    project::Wheel& wheel = project.rover.wheels.at(0);
    axle.relaxed = {"turn axis", "slide axis"};
    wheel.relaxedLateral = true;
    for (const project::Sides sides :
         {project::Sides::Both, project::Sides::Left, project::Sides::Right}) {
        axle.relaxedSides = wheel.relaxedSides = sides;
        const Mechanism m = resolved(project);
        for (const bool left : {true, false}) {
            const std::string side = left ? "left" : "right";
            const bool relaxed =
                sides == project::Sides::Both || (sides == project::Sides::Left) == left;
            const auto joint = static_cast<std::size_t>(m.findJoint("axle_" + side));
            const auto at = static_cast<std::size_t>(m.findWheel("wheel_" + side));
            EXPECT_EQ(m.joints[joint].relaxed.size(), relaxed ? 2U : 1U) << side;
            EXPECT_EQ(m.joints[joint].built.size(), 1U) << side;
            EXPECT_EQ(m.wheels[at].relaxedLateral, relaxed) << side;
        }
    }
}
