// Taking hold of a rover's parts: numbers, parameters, ranges, mirrored copies.
#include "simcore/project/handles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::project;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

Handle handleOf(const Project& project, HandleKind kind, const std::string& name) {
    for (const Handle& handle : handlesOf(project)) {
        if (handle.kind == kind && handle.name == name) {
            return handle;
        }
    }
    ADD_FAILURE() << "no handle " << name;
    return {};
}

DragRequest along(std::array<bool, 3> axes, const Vec3& to) {
    DragRequest request;
    request.axes = axes;
    request.to = to;
    return request;
}

Dragged drag(const Project& project, const Handle& handle, const DragRequest& request) {
    auto result = dragged(project, handle, request);
    EXPECT_TRUE(result) << toString(result.problems());
    return std::move(result).value();
}

double parameter(const Project& project, const std::string& name) {
    return evaluateParameters(project.rover)->at(name);
}

const char* kFree = R"({
  "format": "roverstudio-project", "version": 1,
  "rover": {
    "name": "handles",
    "parameters": [
      {"name": "reach", "value": 0.3, "unit": "mm", "minimum": 0.1, "maximum": 0.5},
      {"name": "rise", "value": 0.1, "unit": "mm"},
      {"name": "twice", "value": "2*reach", "unit": "mm"}
    ],
    "bodies": [
      {"name": "chassis", "mass": 4, "com": [0, 0, 0.2], "inertia": [0.1, 0.1, 0.1, 0, 0, 0]},
      {"name": "arm", "mirror": true, "mass": 1, "com": ["twice/2 + 0.1", 0.2, 0.1],
       "inertia": [0.01, 0.01, 0.01, 0, 0, 0]},
      {"name": "disc", "mirror": true, "mass": 1, "com": [0.4, 0.3, 0.1],
       "inertia": [0.01, 0.01, 0.01, 0, 0, 0],
       "shapes": [{"kind": "sphere", "center": [0.4, 0.3, 0.1], "radius": 0.02, "color": "rim"}]}
    ],
    "joints": [
      {"name": "pin", "mirror": true, "first": "chassis", "second": "arm",
       "point": ["reach + rise", 0.2, "rise^2"]},
      {"name": "axle", "mirror": true, "first": "arm", "second": "disc", "point": [0.4, 0.3, 0.1]}
    ],
    "wheels": [{"name": "wheel", "mirror": true, "body": "disc", "axle": "axle",
                "radius": 0.1, "width": 0.05, "grousers": 0}]
  }
})";

Project freeProject() {
    auto project = io::parseProject(kFree, "test");
    EXPECT_TRUE(project) << toString(project.problems());
    return std::move(project).value();
}

}  // namespace

TEST(HandlesTest, EveryPartHasItsHandleWhereTheMechanismHasIt) {
    for (const std::string& name : testsupport::shippedNames()) {
        const Project project = testsupport::shipped(name);
        const auto mechanism = resolve(project);
        ASSERT_TRUE(mechanism);
        int wheels = 0;
        for (const Handle& handle : handlesOf(project)) {
            // Welded joints are none any more.
            if (handle.kind == HandleKind::Joint && mechanism->findJoint(handle.name) >= 0) {
                const auto& joint = mechanism->joints.at(
                    static_cast<std::size_t>(mechanism->findJoint(handle.name)));
                EXPECT_LT((handle.position - joint.point).norm(), 1e-12) << handle.name;
            } else if (handle.kind == HandleKind::Wheel) {
                ++wheels;
                const auto& wheel = mechanism->wheels.at(
                    static_cast<std::size_t>(mechanism->findWheel(handle.name)));
                EXPECT_LT((handle.position - wheel.center).norm(), 1e-12) << handle.name;
            } else if (handle.kind == HandleKind::CenterOfMass) {
                EXPECT_LT((handle.position - mechanism->centerOfMass()).norm(), 1e-12);
            }
        }
        EXPECT_EQ(wheels, static_cast<int>(mechanism->wheels.size()));
    }
}

// The centre of mass of all moves as asked, mass unchanged: that of the chassis by m / m_chassis.
TEST(HandlesTest, CentreOfMassMovesByThatOfTheChassis) {
    const Project project = freeProject();
    const Handle handle = handleOf(project, HandleKind::CenterOfMass, "chassis");
    const Dragged moved =
        drag(project, handle, along({true, false, true}, handle.position + Vec3(0.02, 0.5, -0.01)));
    EXPECT_LT((moved.reached - handle.position - Vec3(0.02, 0.0, -0.01)).norm(), 1e-12);
    EXPECT_NEAR(moved.project.rover.bodies[0].com[0].literal(), 0.02 * 8.0 / 4.0, 1e-12);
    EXPECT_EQ(resolve(moved.project)->mass(), resolve(project)->mass());
}

TEST(HandlesTest, OneParameterFollowsThroughDerivedOnes) {
    const Project project = freeProject();
    const Handle arm = handleOf(project, HandleKind::Body, "arm_right");
    EXPECT_THAT(parametersOf(project, arm)[0], ElementsAre("reach"));
    const Dragged moved = drag(project, arm, along({true, true, false}, Vec3(0.45, -0.25, 9.0)));
    EXPECT_NEAR(parameter(moved.project, "reach"), 0.35, 1e-9);
    EXPECT_THAT(moved.parameters, ElementsAre("reach"));
    EXPECT_EQ(moved.project.rover.bodies[1].com[0].text(), "twice/2 + 0.1");
    // The right copy at y = -0.25 is the file's 0.25, and the left one mirrors it.
    EXPECT_EQ(moved.project.rover.bodies[1].com[1].literal(), 0.25);
    EXPECT_EQ(moved.project.rover.bodies[1].com[2].literal(), 0.1);
    // Its range ends at 0.5.
    const Dragged far = drag(project, arm, along({true, false, false}, Vec3(2.0, 0.0, 0.0)));
    EXPECT_EQ(parameter(far.project, "reach"), 0.5);
    EXPECT_NEAR(far.reached.x(), 0.6, 1e-12);
}

TEST(HandlesTest, SeveralParametersAskWhichOne) {
    const Project project = freeProject();
    const Handle pin = handleOf(project, HandleKind::Joint, "pin_left");
    EXPECT_THAT(parametersOf(project, pin)[0], ElementsAre("reach", "rise"));
    DragRequest request = along({true, false, false}, Vec3(0.45, 0.0, 0.0));
    const auto refused = dragged(project, pin, request);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.problems().front().reason, HasSubstr("reach, rise"));
    request.choice[0] = "rise";
    EXPECT_NEAR(parameter(drag(project, pin, request).project, "rise"), 0.15, 1e-9);
    request.choice.clear();
    request.replace = true;
    EXPECT_EQ(drag(project, pin, request).project.rover.joints[0].point[0].literal(), 0.45);
}

TEST(HandlesTest, ExpressionsThatAreNotLinearAreSolved) {
    const Project project = freeProject();
    const Handle pin = handleOf(project, HandleKind::Joint, "pin_left");
    const Dragged moved = drag(project, pin, along({false, false, true}, Vec3(0.0, 0.0, 0.04)));
    EXPECT_NEAR(parameter(moved.project, "rise"), 0.2, 1e-7);
    EXPECT_FALSE(dragged(project, pin, along({false, false, true}, Vec3(0.0, 0.0, -0.04))));
}

// What a wheel's body has at fixed numbers goes along with its axle.
TEST(HandlesTest, AWheelTakesItsBodyAlong) {
    const Project project = freeProject();
    const Handle wheel = handleOf(project, HandleKind::Wheel, "wheel_left");
    const Dragged moved = drag(project, wheel, along({true, false, true}, Vec3(0.5, 0.0, 0.12)));
    const Body& disc = moved.project.rover.bodies[2];
    EXPECT_NEAR(disc.com[0].literal(), 0.5, 1e-12);
    EXPECT_NEAR(disc.com[2].literal(), 0.12, 1e-12);
    EXPECT_NEAR(disc.shapes[0].center[0].literal(), 0.5, 1e-12);
    EXPECT_EQ(disc.com[1].literal(), 0.3);
    const auto mechanism = resolve(moved.project);
    for (const auto& one : mechanism->wheels) {
        EXPECT_NEAR(one.center.x(), 0.5, 1e-12);
        EXPECT_LT((mechanism->bodies[static_cast<std::size_t>(one.body)].com - one.center).norm(),
                  1e-12);
    }
}

// SOLERO is all parameters: each wheel's coordinates can be dragged one way or say what they need.
TEST(HandlesTest, SoleroFollowsByItsParameters) {
    const Project project = testsupport::shipped("solero");
    const Handle front = handleOf(project, HandleKind::Wheel, "front");
    const Dragged moved =
        drag(project, front, along({true, false, false}, front.position + Vec3(0.013, 0.0, 0.0)));
    EXPECT_NEAR(parameter(moved.project, "front_wheel_x"),
                parameter(project, "front_wheel_x") + 0.013, 1e-9);
    EXPECT_TRUE(resolve(moved.project));
}
