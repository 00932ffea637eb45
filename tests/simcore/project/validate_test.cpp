#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/project/edit.h"
#include "simcore/project/resolve.h"
#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::project;
using namespace testsupport;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

namespace {

Quantity text(const char* expression) {
    return Quantity::expression(expression);
}

/// One way to spoil the cart, and the element and reason that must be named.
struct Mistake {
    const char* name;
    std::function<void(Project&)> make;
    const char* element;
    const char* reason;
};

/// GoogleTest's name of a mistake.
void PrintTo(const Mistake& mistake, std::ostream* out) {  // NOLINT: name given by gtest
    *out << mistake.name;
}

std::vector<Mistake> mistakes() {
    return {
        {"NanMass", [](Project& p) { p.rover.bodies[0].mass = std::nan(""); }, "body chassis",
         "not a finite number"},
        {"InfiniteCom", [](Project& p) { p.rover.bodies[0].com[2] = INFINITY; }, "body chassis",
         "not a finite number"},
        {"NegativeMass", [](Project& p) { p.rover.bodies[0].mass = -1.0; }, "body chassis",
         "not positive"},
        {"WrongUnitOfMass", [](Project& p) { p.rover.bodies[0].mass = text("12 cm"); },
         "body chassis", "'12 cm' is a length, but this is a mass"},
        {"WrongUnitOfRadius", [](Project& p) { p.rover.wheels[0].radius = text("3 kg"); },
         "wheel wheel_left", "is a mass, but this is a length"},
        {"WrongUnitOfParameter", [](Project& p) { p.rover.parameters[0].value = text("100 deg"); },
         "parameter wheel_radius", "is a angle"},
        {"UnknownParameter", [](Project& p) { p.rover.wheels[0].radius = text("wheel_radios"); },
         "wheel wheel_left", "wheel_radios"},
        {"Circle", [](Project& p) { p.rover.parameters[0].value = text("track/4"); },
         "parameter wheel_radius", "depends on itself"},
        {"ParameterNamedTwice", [](Project& p) { p.rover.parameters[1].name = "wheel_radius"; },
         "parameter wheel_radius", "used twice"},
        {"ParameterNamedLikeAFunction", [](Project& p) { p.rover.parameters[1].name = "sin"; },
         "parameter sin", "cannot be used"},
        {"ParameterWithAnEndlessName",
         [](Project& p) { p.rover.parameters[1].name = std::string(101, 'a'); }, "parameter aaaa",
         "cannot be used"},
        {"ParameterOutOfRange", [](Project& p) { p.rover.parameters[0].value = 2.0; },
         "parameter wheel_radius", "above its maximum"},
        {"MinimumAboveMaximum", [](Project& p) { p.rover.parameters[0].minimum = 0.6; },
         "parameter wheel_radius", "minimum is above its maximum"},
        {"JointRelaxedOnASideItDoesNotHave",
         [](Project& p) {
             p.rover.joints[0].mirror = false;
             p.rover.joints[0].name = "axle_left";
             p.rover.joints[0].relaxedSides = Sides::Left;
         },
         "joint axle_left", "not mirrored"},
        {"WheelRelaxedOnASideItDoesNotHave",
         [](Project& p) {
             p.rover.wheels[0].mirror = false;
             p.rover.wheels[0].relaxedSides = Sides::Right;
         },
         "wheel wheel", "not mirrored"},
        {"GearOfSliders",
         [](Project& p) {
             p.rover.joints[0].free = {"slide y"};
             p.rover.gears.push_back({"gear", "axle_left", "axle_right", -1.0});
         },
         "gear gear", "does not connect two pins"},
        {"NanParameter", [](Project& p) { p.rover.parameters[0].value = std::nan(""); },
         "parameter wheel_radius", "not a finite number"},
        {"MissingBody", [](Project& p) { p.rover.joints[0].second = "weel"; }, "joint axle_left",
         "no body 'weel'"},
        {"MissingAxle", [](Project& p) { p.rover.wheels[0].axle = "axel"; }, "wheel wheel_left",
         "no joint 'axel'"},
        {"NoBodies", [](Project& p) { p.rover.bodies.clear(); }, "rover Cart", "no bodies"},
        {"BodyNamedTwice", [](Project& p) { p.rover.bodies.push_back(p.rover.bodies[0]); },
         "body chassis", "used twice"},
        {"JointNamedTwice", [](Project& p) { p.rover.joints.push_back(p.rover.joints[0]); },
         "joint axle_left", "used twice"},
        {"WheelNamedTwice", [](Project& p) { p.rover.wheels.push_back(p.rover.wheels[0]); },
         "wheel wheel_left", "used twice"},
        {"PayloadNamedTwice",
         [](Project& p) {
             Payload load;
             load.name = "box";
             load.body = "chassis";
             load.mass = 1.0;
             p.rover.payloads = {load, load};
         },
         "payload box", "used twice"},
        {"SpringWithoutName",
         [](Project& p) {
             Spring spring;
             spring.joint = "axle_left";
             spring.stiffness = 1.0;
             p.rover.springs = {spring};
         },
         "spring ", "no name"},
        {"NegativeStiffness",
         [](Project& p) {
             Spring spring;
             spring.name = "s";
             spring.joint = "axle_left";
             spring.stiffness = -1.0;
             p.rover.springs = {spring};
         },
         "spring s", "negative"},
        {"JointToItself", [](Project& p) { p.rover.joints[0].second = "chassis"; },
         "joint axle_left", "joins a body to itself"},
        {"NoAxis",
         [](Project& p) {
             p.rover.joints[0].axis = {0.0, 0.0, 0.0};
         },
         "joint axle_left", "no length"},
        {"UnknownFreedom", [](Project& p) { p.rover.joints[0].free = {"turn sideways"}; },
         "joint axle_left", "not understood"},
        {"SameFreedomTwice",
         [](Project& p) {
             p.rover.joints[0].free = {"turn y", "turn y"};
         },
         "joint axle_left", "same or dependent"},
        {"StopsTheWrongWayRound",
         [](Project& p) {
             p.rover.joints[0].stops = {{text("10 deg"), text("-10 deg")}};
         },
         "joint axle_left", "do not enclose"},
        {"ImpossibleInertia",
         [](Project& p) {
             p.rover.bodies[0].inertia = {{0.1, 0.1, 0.5, 0.0, 0.0, 0.0}};
         },
         "body chassis", "impossible"},
        {"BodyNotJoined",
         [](Project& p) {
             Body lost;
             lost.name = "lost";
             lost.mass = 1.0;
             p.rover.bodies.push_back(lost);
         },
         "body lost", "no joint connects it"},
        {"FixedWheel", [](Project& p) { p.rover.bodies[1].fixed = true; }, "wheel wheel_left",
         "body 'wheel_left' is fixed"},
        {"JointBetweenFixedBodies",
         [](Project& p) {
             Body stand;
             stand.name = "stand";
             stand.mass = 1.0;
             stand.fixed = true;
             p.rover.bodies.push_back(stand);
             p.rover.bodies[0].fixed = true;
             Joint hinge;
             hinge.name = "hinge";
             hinge.first = "stand";
             hinge.second = "chassis";
             p.rover.joints.push_back(hinge);
         },
         "joint hinge", "both its bodies are fixed"},
        {"UnknownVariant", [](Project& p) { p.scenarios[0].variant = "small"; }, "scenario step",
         "no variant 'small'"},
        {"VariantSetsUnknownParameter",
         [](Project& p) { p.variants[0].set[0].parameter = "radius"; }, "parameter radius",
         "no parameter of this name"},
        {"VariantSetsDerivedParameter",
         [](Project& p) { p.variants[0].set[0].parameter = "track"; }, "parameter track",
         "derived"},
        {"VariantOutOfRange", [](Project& p) { p.variants[0].set[0].value = 0.7; },
         "parameter wheel_radius", "above its maximum"},
        {"VariantMakesAMassNegative",
         [](Project& p) {
             p.rover.bodies[0].mass = text("4*(0.12 - wheel_radius)");
             p.scenarios[0].variant.clear();
         },
         "variant big, body chassis", "not positive"},
        {"ScenarioNamedTwice", [](Project& p) { p.scenarios.push_back(p.scenarios[0]); },
         "scenario step", "used twice"},
        {"NegativeFriction", [](Project& p) { p.scenarios[0].soil.friction = -0.1; },
         "scenario step, friction", "not between"},
        {"NegativeNoise", [](Project& p) { p.scenarios[0].sensors.wheelRate.noise = -0.1; },
         "scenario step, wheel rate noise", "not between"},
        {"DelayOfAnHour", [](Project& p) { p.scenarios[0].sensors.bodySpeed.delay = 3600.0; },
         "scenario step, body speed delay", "not between"},
        {"EncoderInMetres",
         [](Project& p) { p.scenarios[0].sensors.jointEncoder.resolution = text("1 mm"); },
         "scenario step, joint encoder resolution", "is a length, but this is a angle"},
        {"StepOfNoTime", [](Project& p) { p.scenarios[0].run.step = 0.0; }, "scenario step, step",
         "not between"},
        {"SpeedInMetres", [](Project& p) { p.scenarios[0].controller.speed = text("10 cm"); },
         "scenario step, speed", "is a length, but this is a speed"},
    };
}

bool names(const Problem& problem, const Mistake& mistake) {
    return problem.severity == Severity::Critical &&
           problem.element.find(mistake.element) != std::string::npos &&
           problem.reason.find(mistake.reason) != std::string::npos;
}

}  // namespace

class MistakeTest : public testing::TestWithParam<Mistake> {};

TEST_P(MistakeTest, IsNamedWithReasonAndRemedy) {
    Project project = cart();
    GetParam().make(project);
    const Problems problems = validate(project);
    const bool found = std::any_of(problems.begin(), problems.end(),
                                   [](const Problem& p) { return names(p, GetParam()); });
    EXPECT_TRUE(found) << "found only:\n" << toString(problems);
    for (const Problem& problem : problems) {
        EXPECT_THAT(problem.element, Not(IsEmpty()));
        EXPECT_THAT(problem.reason, Not(IsEmpty()));
        EXPECT_THAT(problem.remedy, Not(IsEmpty())) << toString(problem);
    }
}

INSTANTIATE_TEST_SUITE_P(All, MistakeTest, testing::ValuesIn(mistakes()),
                         [](const auto& test) { return test.param.name; });

TEST(ValidateTest, GoodProjectHasNoProblems) {
    EXPECT_THAT(validate(cart()), IsEmpty()) << toString(validate(cart()));
}

// A test stand, and what is welded to it.
TEST(ValidateTest, ChassisOfARoverMayBeFixed) {
    Project project = cart();
    Body stand;
    stand.name = "stand";
    stand.mass = 20.0;
    stand.fixed = true;
    stand.inertia = {{1.0, 1.0, 1.0, 0.0, 0.0, 0.0}};
    project.rover.bodies.push_back(stand);
    Joint clamp;
    clamp.name = "clamp";
    clamp.first = "chassis";
    clamp.second = "stand";
    clamp.locked = true;
    project.rover.joints.push_back(clamp);
    EXPECT_THAT(validate(project), IsEmpty()) << toString(validate(project));
    const auto mechanism = resolve(project);
    ASSERT_TRUE(mechanism);
    EXPECT_TRUE(mechanism->bodies[0].fixed);
    EXPECT_FALSE(mechanism->bodies[1].fixed);
    // Two stands are joined by the world.
    project.rover.joints.pop_back();
    project.rover.bodies[0].fixed = true;
    EXPECT_THAT(validate(project), IsEmpty()) << toString(validate(project));
}

TEST(ValidateTest, UnknownDisplayUnitIsAWarning) {
    Project project = cart();
    project.rover.parameters[0].unit = "furlong";
    const Problems problems = validate(project);
    ASSERT_EQ(problems.size(), 1U) << toString(problems);
    EXPECT_EQ(problems[0].severity, Severity::Warning);
    EXPECT_EQ(problems[0].element, "parameter wheel_radius");
    EXPECT_THAT(problems[0].reason, HasSubstr("furlong"));
}

// However many parameters stand between one and the number it comes from.
TEST(ResolveTest, ParametersMayFormChainsOfAnyLength) {
    constexpr int kLength = 50000;
    Rover rover;
    rover.parameters.resize(kLength + 1);
    for (int i = 0; i <= kLength; ++i) {
        Parameter& parameter = rover.parameters[static_cast<std::size_t>(i)];
        parameter.name = "p" + std::to_string(i);
        parameter.value =
            i < kLength ? Quantity::expression("p" + std::to_string(i + 1) + "+1") : Quantity(0.5);
    }
    const auto values = evaluateParameters(rover);
    ASSERT_TRUE(values) << toString(values.problems());
    EXPECT_EQ(values->at("p0"), kLength + 0.5);
}

// A wheel without shapes or inertia counts as a solid cylinder, and a point load adds m d^2 to it.
TEST(ResolveTest, PayloadAddsToTheInertiaThatIsAssumedForAWheel) {
    Project project = cart();
    const double width = 0.05;
    const auto inertiaOfWheel = [&] {
        const auto mechanism = resolve(project);
        EXPECT_TRUE(mechanism) << toString(mechanism.problems());
        return mechanism->bodies.at(static_cast<std::size_t>(mechanism->findBody("wheel_left")));
    };
    const double across = 1.0 * (3.0 * 0.1 * 0.1 + width * width) / 12.0;
    EXPECT_NEAR(inertiaOfWheel().inertia(0, 0), across, 1e-12);
    Payload load;
    load.name = "load";
    load.body = "wheel_left";
    load.mass = 1.0;
    load.position = {0.06, text("track/2"), text("wheel_radius")};
    project.rover.payloads = {load};
    const auto body = inertiaOfWheel();
    EXPECT_DOUBLE_EQ(body.mass, 2.0);
    EXPECT_NEAR(body.com.x(), 0.03, 1e-12);
    EXPECT_NEAR(body.inertia(0, 0), across, 1e-12);
    EXPECT_NEAR(body.inertia(2, 2), across + 2.0 * 0.03 * 0.03, 1e-12);
}

TEST(ValidateTest, AllProblemsAtOnce) {
    Project project = cart();
    project.rover.bodies[0].mass = -1.0;
    project.rover.joints[0].axis = {0.0, 0.0, 0.0};
    project.rover.wheels[0].radius = text("nothing");
    project.scenarios[0].soil.friction = 9.0;
    project.variants[0].set[0].parameter = "unknown";
    const std::string all = toString(validate(project));
    for (const char* part :
         {"body chassis", "joint axle_left", "joint axle_right", "wheel wheel_left", "unknown"}) {
        EXPECT_THAT(all, HasSubstr(part));
    }
    project.scenarios[0].variant.clear();
    EXPECT_THAT(toString(validate(project)), HasSubstr("scenario step, friction"));
}

// Whichever number is not a number, somebody must notice before an engine does.
TEST(ValidateTest, EveryNumberOfTheRoverIsCheckedToBeFinite) {
    // Between them they have every kind of element.
    for (const char* name : {"solero", "rocker_bogie"}) {
        const Project good = shipped(name);
        Project copy = good;
        int count = 0;
        copy.scenarios.clear();
        forEachQuantity(copy, [&](Quantity&) { ++count; });
        ASSERT_GT(count, 100);
        for (int k = 0; k < count; ++k) {
            Project project = good;
            project.scenarios.clear();
            int at = 0;
            std::string before;
            forEachQuantity(project, [&](Quantity& quantity) {
                if (at++ == k) {
                    before =
                        quantity.isLiteral() ? std::to_string(quantity.literal()) : quantity.text();
                    quantity = std::nan("");
                }
            });
            if (hasCritical(validate(project))) {
                continue;
            }
            // Only numbers that nothing reads, such as the radius of a box, may pass.
            const auto mechanism = resolve(project);
            ASSERT_TRUE(mechanism);
            for (const auto& body : mechanism->bodies) {
                ASSERT_TRUE(std::isfinite(body.mass) && body.com.allFinite() &&
                            body.inertia.allFinite())
                    << name << ", number " << k << " (" << before << ")";
            }
            for (const auto& joint : mechanism->joints) {
                ASSERT_TRUE(joint.point.allFinite() && std::isfinite(joint.damping));
            }
            for (const auto& spring : mechanism->springs) {
                ASSERT_TRUE(std::isfinite(spring.preload) && std::isfinite(spring.stiffness) &&
                            spring.firstPoint.allFinite() && spring.secondPoint.allFinite())
                    << name << ", number " << k << " (" << before << ")";
            }
        }
    }
}

// -- steering -------------------------------------------------------------------------------------

namespace {

Project steeredCart() {
    Project project = cart();
    Rover& rover = project.rover;
    Body bracket;
    bracket.name = "bracket";
    bracket.mirror = true;
    bracket.mass = 0.3;
    bracket.com = {Quantity(0.0), Quantity(0.2), Quantity(0.15)};
    bracket.inertia = {{0.001, 0.001, 0.001, 0.0, 0.0, 0.0}};
    rover.bodies.push_back(bracket);
    Joint pin;
    pin.name = "pin";
    pin.mirror = true;
    pin.first = "chassis";
    pin.second = "bracket";
    pin.point = bracket.com;
    pin.axis = {Quantity(0.0), Quantity(0.0), Quantity(1.0)};
    rover.joints.push_back(pin);
    rover.joints[0].first = "bracket";
    rover.wheels[0].steering = "pin";
    return project;
}

}  // namespace

// Welded for analyses; free for controllers that steer, unless the file locks it.
TEST(SteeringJointTest, IsWeldedUnlessFreed) {
    Project project = steeredCart();
    const auto welded = resolve(project);
    ASSERT_TRUE(welded) << toString(welded.problems());
    EXPECT_EQ(welded->bodies.size(), 3U);
    EXPECT_EQ(welded->joints.size(), 2U);
    EXPECT_EQ(welded->wheels[0].steering, -1);

    project.rover.wheels[0].steeringMotor.speedLimit = 0.7;
    const auto freed = resolve(project, "", {}, Steering::Free);
    ASSERT_TRUE(freed) << toString(freed.problems());
    EXPECT_EQ(freed->bodies.size(), 5U);
    EXPECT_EQ(freed->joints.size(), 4U);
    for (const auto& wheel : freed->wheels) {
        const std::string side = wheel.name.substr(wheel.name.find('_'));
        EXPECT_EQ(wheel.steering, freed->findJoint("pin" + side));
        EXPECT_EQ(wheel.carrier, freed->findBody("bracket" + side));
        EXPECT_EQ(wheel.steeringTorqueLimit, wheel.torqueLimit);
        EXPECT_EQ(wheel.steeringSpeedLimit, 0.7);
    }
    EXPECT_NEAR(freed->mass(), welded->mass(), 1e-12);

    project.rover.joints[1].locked = true;
    const auto locked = resolve(project, "", {}, Steering::Free);
    ASSERT_TRUE(locked) << toString(locked.problems());
    EXPECT_EQ(locked->bodies.size(), 3U);
    EXPECT_EQ(locked->wheels[0].steering, -1);
}

// What cannot steer is said, whether or not it is freed now.
TEST(SteeringJointTest, SaysWhyAJointCannotSteer) {
    const auto complaint = [](auto spoil) {
        Project project = steeredCart();
        spoil(project.rover);
        const std::string free = toString(resolve(project, "", {}, Steering::Free).problems());
        const std::string locked = toString(resolve(project).problems());
        EXPECT_FALSE(locked.empty());
        return locked + free;
    };
    EXPECT_NE(complaint([](Rover& r) { r.wheels[0].steering = "moon"; }).find("no joint 'moon'"),
              std::string::npos);
    EXPECT_NE(complaint([](Rover& r) { r.wheels[0].steering = "axle"; }).find("upright"),
              std::string::npos);
    EXPECT_NE(complaint([](Rover& r) {
                  r.joints[1].free = {"turn axis", "turn x"};
              }).find("is no pin"),
              std::string::npos);
    EXPECT_NE(complaint([](Rover& r) {
                  r.wheels[0].steeringMotor.speedLimit = 0.0;
              }).find("steering speed"),
              std::string::npos);
    // A second way from bracket to chassis: the pin steers nothing.
    EXPECT_NE(complaint([](Rover& r) {
                  Joint strut = r.joints[1];
                  strut.name = "strut";
                  r.joints.push_back(strut);
              }).find("still hang on the chassis"),
              std::string::npos);
}
