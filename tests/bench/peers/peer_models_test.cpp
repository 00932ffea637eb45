// What other engines are given, without any of them: the tree, the ground and MuJoCo's model.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/bench/peers/mjcf.h"
#include "tests/support/mechanisms.h"
#include "tests/support/rovers.h"

using namespace peers;
using simcore::mechanism::Mechanism;
using simcore::mechanism::Spring;
using testing::HasSubstr;
using testsupport::makeFourBar;
using testsupport::makePin;
using testsupport::mechanismOf;

namespace {

/// An element of an XML text.
struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::vector<Element> children;

    /// All of a name below this one.
    std::vector<const Element*> all(const std::string& wanted) const {
        std::vector<const Element*> found;
        for (const Element& child : children) {
            if (child.name == wanted) {
                found.push_back(&child);
            }
            for (const Element* deeper : child.all(wanted)) {
                found.push_back(deeper);
            }
        }
        return found;
    }

    std::vector<double> numbers(const std::string& attribute) const {
        std::istringstream text(attributes.at(attribute));
        return {std::istream_iterator<double>(text), {}};
    }

    double number(const std::string& attribute) const { return numbers(attribute).at(0); }
};

/// Reads the part of XML that the models use, strictly: elements and quoted attributes. Throws on
/// anything else, on an attribute given twice, and on tags that do not match.
class XmlReader {
  public:
    explicit XmlReader(std::string text) : text_(std::move(text)) {}

    Element read() {
        skipSpace();
        Element root = element();
        skipSpace();
        require(at_ == text_.size(), "something follows the root");
        return root;
    }

  private:
    void require(bool good, const std::string& what) const {
        if (!good) {
            throw std::runtime_error(what + " at " + text_.substr(std::min(at_, text_.size()), 40));
        }
    }

    void skipSpace() { at_ = std::min(text_.find_first_not_of(" \n", at_), text_.size()); }

    bool take(const std::string& token) {
        const bool found = text_.compare(at_, token.size(), token) == 0;
        at_ += found ? token.size() : 0;
        return found;
    }

    std::string word() {
        const std::size_t end = text_.find_first_not_of("abcdefghijklmnopqrstuvwxyz12", at_);
        require(end != std::string::npos && end > at_, "no name");
        std::string found = text_.substr(at_, end - at_);
        at_ = end;
        return found;
    }

    std::string quoted() {
        require(take("\""), "no quote");
        std::string value;
        while (!take("\"")) {
            require(at_ < text_.size() && text_[at_] != '<', "a bare < or no end of a value");
            if (take("&amp;")) {
                value += '&';
            } else if (take("&lt;")) {
                value += '<';
            } else if (take("&quot;")) {
                value += '"';
            } else {
                require(text_[at_] != '&', "a bare &");
                value += text_[at_++];
            }
        }
        return value;
    }

    Element element() {
        require(take("<"), "no element");
        Element made;
        made.name = word();
        while (take(" ")) {
            const std::string name = word();
            require(take("="), "no =");
            require(made.attributes.emplace(name, quoted()).second, "twice the same attribute");
        }
        if (take("/>")) {
            return made;
        }
        require(take(">"), "no end of a tag");
        skipSpace();
        while (!take("</" + made.name + ">")) {
            made.children.push_back(element());
            skipSpace();
        }
        return made;
    }

    std::string text_;
    std::size_t at_ = 0;
};

PeerTree treeOf(const Mechanism& mechanism) {
    auto tree = peerTreeOf(mechanism);
    if (!tree) {
        throw std::runtime_error(toString(tree.problems()));
    }
    return std::move(tree).value();
}

/// Level ground but for one point.
HeightGrid smallGround() {
    return {-1.0, -0.5, 0.5, 5, 3, {0, 0, 0, 0, 0, 0, 0, 0.25, 0, 0, 0, 0, 0, 0, -0.125}};
}

Element modelOf(const Mechanism& mechanism, const MjcfSettings& settings = {}) {
    return XmlReader(mjcfOf(mechanism, treeOf(mechanism), smallGround(), settings)).read();
}

std::string whyNot(const Mechanism& mechanism) {
    return toString(peerTreeOf(mechanism).problems());
}

}  // namespace

// -- MuJoCo's model -------------------------------------------------------------------------------

TEST(MjcfTest, HasEveryBodyWithItsInertia) {
    const Mechanism rover = mechanismOf("bench_rover");
    const Element model = modelOf(rover);
    EXPECT_EQ(model.name, "mujoco");
    const auto bodies = model.all("body");
    ASSERT_EQ(bodies.size(), rover.bodies.size());
    double mass = 0.0;
    for (const Element* element : bodies) {
        const int index = rover.findBody(element->attributes.at("name"));
        ASSERT_GE(index, 0) << element->attributes.at("name");
        const auto& body = rover.bodies[static_cast<std::size_t>(index)];
        ASSERT_EQ(element->children.at(1).name, "inertial");
        const Element& inertial = element->children.at(1);
        mass += inertial.number("mass");
        const auto com = inertial.numbers("pos");
        const auto inertia = inertial.numbers("fullinertia");
        ASSERT_EQ(inertia.size(), 6U);
        const int rows[] = {0, 1, 2, 0, 0, 1};
        const int columns[] = {0, 1, 2, 1, 2, 2};
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(inertia[i], body.inertia(rows[i], columns[i])) << body.name;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(com.at(i), body.com[static_cast<Eigen::Index>(i)]) << body.name;
        }
    }
    EXPECT_NEAR(mass, rover.mass(), 1e-12);
    EXPECT_NEAR(mass, 12.0, 1e-12) << "as the comparison defines it";
}

// Joints of the tree and points that close loops are all pins, each once; a tree of n bodies has
// one joint a body, the chassis' free one among them.
TEST(MjcfTest, HasEveryPinOnce) {
    const Mechanism rover = mechanismOf("bench_rover");
    const Element model = modelOf(rover);
    const auto hinges = model.all("joint");
    EXPECT_EQ(model.all("freejoint").size(), 1U);
    EXPECT_EQ(hinges.size() + 1, rover.bodies.size());
    const auto closures = model.all("connect");
    EXPECT_EQ(hinges.size() + closures.size(), rover.joints.size());
    EXPECT_EQ(rover.joints.size(), 22U);
    std::set<std::string> names;
    for (const Element* hinge : hinges) {
        names.insert(hinge->attributes.at("name"));
        const int joint = rover.findJoint(hinge->attributes.at("name"));
        ASSERT_GE(joint, 0);
        const auto point = hinge->numbers("pos");
        EXPECT_EQ(Vec3(point.at(0), point.at(1), point.at(2)),
                  rover.joints[static_cast<std::size_t>(joint)].point);
    }
    EXPECT_EQ(names.size(), hinges.size());
    for (const Element* closure : closures) {
        const int first = rover.findBody(closure->attributes.at("body1"));
        const int second = rover.findBody(closure->attributes.at("body2"));
        const auto anchor = closure->numbers("anchor");
        const auto of = std::find_if(rover.joints.begin(), rover.joints.end(), [&](const auto& j) {
            return !names.contains(j.name) && j.first == first && j.second == second;
        });
        ASSERT_NE(of, rover.joints.end());
        EXPECT_EQ(Vec3(anchor.at(0), anchor.at(1), anchor.at(2)), of->point);
    }
}

TEST(MjcfTest, DrivesEveryWheelForwardWithinItsTorque) {
    Mechanism rover = mechanismOf("bench_rover");
    rover.wheels[2].torqueLimit = 1.25;
    rover.wheels[2].rotorInertia = 0.004;
    // A pin that points to the right: the wheel still has to roll forward for a positive speed.
    auto& axle = rover.joints[static_cast<std::size_t>(rover.wheels[2].axle)];
    axle.axis = axle.built[0].direction = -Vec3::UnitY();
    const Element model = modelOf(rover);
    const auto motors = model.all("velocity");
    ASSERT_EQ(motors.size(), rover.wheels.size());
    for (std::size_t i = 0; i < motors.size(); ++i) {
        const auto& wheel = rover.wheels[i];
        const auto& joint = rover.joints[static_cast<std::size_t>(wheel.axle)];
        EXPECT_EQ(motors[i]->attributes.at("joint"), joint.name);
        EXPECT_THAT(motors[i]->numbers("forcerange"),
                    testing::ElementsAre(-wheel.torqueLimit, wheel.torqueLimit));
        for (const Element* hinge : model.all("joint")) {
            if (hinge->attributes.at("name") == joint.name) {
                EXPECT_THAT(hinge->numbers("axis"), testing::ElementsAre(0.0, 1.0, 0.0));
                EXPECT_EQ(hinge->number("armature"), wheel.rotorInertia);
            }
        }
    }
}

// MuJoCo's torque is stiffness (springref - turn) - damping rate.
TEST(MjcfTest, SpringPushesWithItsPreloadAtTheDrawnPose) {
    Mechanism rover = mechanismOf("bench_rover");
    ASSERT_EQ(rover.springs.size(), 1U);
    const Spring& spring = rover.springs[0];
    const auto springs = [](const Element& model) {
        std::vector<const Element*> found;
        for (const Element* hinge : model.all("joint")) {
            if (hinge->attributes.contains("stiffness")) {
                found.push_back(hinge);
            }
        }
        return found;
    };
    const Element model = modelOf(rover);
    ASSERT_EQ(springs(model).size(), 1U);
    const Element& hinge = *springs(model)[0];
    EXPECT_EQ(hinge.attributes.at("name"), "fork_a");
    EXPECT_NEAR(hinge.number("stiffness") * hinge.number("springref"), spring.preload, 1e-12);
    EXPECT_EQ(hinge.number("damping"), spring.damping);

    // The same spring on the joint named the other way round, and about the opposite axis: the
    // torque on the link turns over twice.
    auto& joint = rover.joints[static_cast<std::size_t>(spring.joint)];
    std::swap(joint.first, joint.second);
    joint.stops = std::pair(-0.2, 0.3);
    const auto turned = [&] {
        const Element other = modelOf(rover);
        const Element& pin = *springs(other).at(0);
        const auto range = pin.numbers("range");
        // The link's own axis may point either way.
        const double axis = pin.numbers("axis").at(1);
        return std::pair(axis * pin.number("springref"), axis > 0
                                                             ? std::pair(range[0], range[1])
                                                             : std::pair(-range[1], -range[0]));
    };
    const double rest = spring.preload / spring.stiffness;
    EXPECT_NEAR(turned().first, -rest, 1e-12);
    EXPECT_EQ(turned().second, std::pair(-0.3, 0.2));
    joint.axis = -joint.axis;
    EXPECT_NEAR(turned().first, rest, 1e-12);
    EXPECT_EQ(turned().second, std::pair(-0.2, 0.3));
}

TEST(MjcfTest, WheelsHaveTheShapeAskedFor) {
    const Mechanism rover = mechanismOf("bench_rover");
    const std::map<WheelShape, std::vector<double>> sizes{
        {WheelShape::Ellipsoid, {0.07, 0.07, 0.025}},
        {WheelShape::Cylinder, {0.07, 0.025}},
        {WheelShape::Sphere, {0.07}}};
    for (const auto& [shape, size] : sizes) {
        MjcfSettings settings;
        settings.wheel = shape;
        settings.friction = 0.6;
        const Element model = modelOf(rover, settings);
        std::size_t wheels = 0;
        for (const Element* geom : model.all("geom")) {
            EXPECT_THAT(geom->numbers("friction"), testing::ElementsAre(0.6, 0.0, 0.0));
            if (geom->attributes.at("name") != kMjcfGround) {
                ++wheels;
                EXPECT_EQ(geom->attributes.at("type"), toString(shape));
                EXPECT_EQ(geom->numbers("size"), size);
            }
        }
        EXPECT_EQ(wheels, rover.wheels.size());
    }
}

// The field is centred on its geom and spans it: corners and elevation are those of the grid.
TEST(MjcfTest, GroundLiesWhereTheGridDoes) {
    const HeightGrid grid = smallGround();
    const Element model = modelOf(makeFourBar());
    const Element& field = *model.all("hfield").at(0);
    const Element& ground = *model.all("geom").at(0);
    const auto size = field.numbers("size");
    const auto pos = ground.numbers("pos");
    EXPECT_EQ(field.number("ncol"), 5.0);
    EXPECT_EQ(field.number("nrow"), 3.0);
    EXPECT_EQ(pos.at(0) - size.at(0), grid.x0);
    EXPECT_EQ(pos.at(1) - size.at(1), grid.y0);
    EXPECT_EQ(pos.at(0) + size.at(0), grid.x1());
    EXPECT_EQ(pos.at(1) + size.at(1), grid.y1());
    EXPECT_EQ(pos.at(2), -0.125);
    EXPECT_EQ(pos.at(2) + size.at(2), 0.25);
}

TEST(MjcfTest, NamesMayHoldAnything) {
    Mechanism mechanism = makeFourBar();
    mechanism.bodies[1].name = R"(a "crank" & <co>)";
    const Element model = modelOf(mechanism);
    EXPECT_EQ(model.all("body").at(1)->attributes.at("name"), mechanism.bodies[1].name);
}

// -- refusals -------------------------------------------------------------------------------------

TEST(PeerTreeTest, RefusesWhatThePeersAreNotGiven) {
    using simcore::mechanism::FreedomKind;
    Mechanism slider = makeFourBar();
    slider.joints[0].built = {{FreedomKind::Slide, Vec3::UnitX()}};
    EXPECT_THAT(whyNot(slider), HasSubstr("joint a: it is no pin"));

    Mechanism slot = makeFourBar();
    slot.joints[1].built.push_back({FreedomKind::Slide, Vec3::UnitX()});
    slot.joints[2].built.push_back({FreedomKind::Slide, Vec3::UnitX()});
    EXPECT_THAT(whyNot(slot), HasSubstr("closes a loop and is neither a pin nor a ball"));

    Mechanism stand = makeFourBar();
    stand.bodies[0].fixed = true;
    EXPECT_THAT(whyNot(stand), HasSubstr("body chassis"));

    EXPECT_THAT(whyNot(testsupport::makeDifferential(-1.0)), HasSubstr("gear differential"));

    Mechanism strut = makeFourBar();
    Spring spring;
    spring.name = "strut";
    spring.first = 0;
    spring.second = 2;
    spring.stiffness = 100.0;
    strut.springs = {spring};
    EXPECT_THAT(whyNot(strut), HasSubstr("spring strut"));

    EXPECT_TRUE(peerTreeOf(makeFourBar()).ok());
}

// A point holds a pin only where the loop is planar; a ball it holds anywhere.
TEST(PeerTreeTest, ClosesPlanarLoopsAndBalls) {
    using simcore::mechanism::FreedomKind;
    Mechanism bent = makeFourBar();
    const auto bendPin = [&bent](std::size_t joint) {
        bent.joints[joint].axis = bent.joints[joint].built[0].direction =
            Vec3(0.0, 1.0, 0.1).normalized();
    };
    bendPin(0);
    EXPECT_THAT(whyNot(bent), HasSubstr("not planar"));
    const auto closing = static_cast<std::size_t>(treeOf(makeFourBar()).closures.at(0).joint);
    bent.joints[closing].built = {{FreedomKind::Turn, Vec3::UnitX()},
                                  {FreedomKind::Turn, Vec3::UnitY()},
                                  {FreedomKind::Turn, Vec3::UnitZ()}};
    EXPECT_EQ(treeOf(bent).closures.size(), 1U);
}

// -- the ground -----------------------------------------------------------------------------------

TEST(SampleGroundTest, TakesHeightsWithinTheBoxAndTheGround) {
    // z = x + 10 y on points 0.25 m apart.
    std::vector<double> heights;
    for (int ix = 0; ix < 9; ++ix) {
        for (int iy = 0; iy < 5; ++iy) {
            heights.push_back(0.25 * ix - 1.0 + 10.0 * (0.25 * iy - 0.5));
        }
    }
    const auto terrain = simcore::terrain::Terrain::grid(-1.0, -0.5, 0.25, 9, 5, heights);
    const auto grid = sampleGround(terrain, 0.25, {-0.5, -9.0, 9.0, 0.3});
    ASSERT_TRUE(grid) << toString(grid.problems());
    EXPECT_EQ(grid->columns, 7);  // -0.5 to 1
    EXPECT_EQ(grid->rows, 4);     // -0.5 to 0.25
    for (int row = 0; row < grid->rows; ++row) {
        for (int column = 0; column < grid->columns; ++column) {
            const double x = grid->x0 + column * grid->cell;
            const double y = grid->y0 + row * grid->cell;
            EXPECT_NEAR(grid->heights[static_cast<std::size_t>(row * grid->columns + column)],
                        x + 10.0 * y, 1e-12);
        }
    }
    EXPECT_NEAR(grid->lowest(), -0.5 - 5.0, 1e-12);
    EXPECT_NEAR(grid->highest(), 1.0 + 2.5, 1e-12);
    EXPECT_FALSE(sampleGround(terrain, 0.25, {2.0, -0.5, 3.0, 0.5}));

    heights[22] = NAN;  // x = 0, y = 0
    const auto holed = simcore::terrain::Terrain::grid(-1.0, -0.5, 0.25, 9, 5, heights);
    EXPECT_THAT(toString(sampleGround(holed, 0.25, {-1.0, -0.5, 1.0, 0.5}).problems()),
                HasSubstr("hole at x = 0.000"));
}

namespace {

double lattice(int i, int j, std::uint32_t seed) {
    std::uint32_t h = seed * 0x9E3779B9U + static_cast<std::uint32_t>(i) * 0x85EBCA6BU +
                      static_cast<std::uint32_t>(j) * 0xC2B2AE35U;
    h = (h ^ (h >> 16)) * 0x7FEB352DU;
    h = (h ^ (h >> 15)) * 0x846CA68BU;
    return (h ^ (h >> 16)) / 4294967295.0;
}

double smooth(double t) {
    return t * t * (3.0 - 2.0 * t);
}

double valueNoise(double x, double y, std::uint32_t seed) {
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const double u = smooth(x - i);
    const double v = smooth(y - j);
    return std::lerp(std::lerp(lattice(i, j, seed), lattice(i + 1, j, seed), u),
                     std::lerp(lattice(i, j + 1, seed), lattice(i + 1, j + 1, seed), u), v);
}

double flat(double /*x*/, double /*y*/) {
    return 0.0;
}

double step(double x, double /*y*/) {
    return 0.1 * std::clamp(std::min(x - 1.0, 2.21 - x) / 0.01, 0.0, 1.0);
}

double sinus(double x, double /*y*/) {
    return x < 0.6 ? 0.0 : 0.05 * (1.0 - std::cos(2.0 * std::numbers::pi * (x - 0.6) / 0.8));
}

double rough(double x, double y) {
    return smooth(std::clamp((x - 0.6) / 0.3, 0.0, 1.0)) *
           (0.10 * valueNoise(x / 0.40, y / 0.40, 1) + 0.04 * valueNoise(x / 0.17, y / 0.17, 2) +
            0.01 * valueNoise(x / 0.06, y / 0.06, 3));
}

}  // namespace

// The grounds that the engines are compared on are these functions at points 10 mm apart, within
// half a grey level of the files (2.5 um), and straight between them.
TEST(BenchGroundsTest, AreTheirFormulasOnAGridOf10Millimetres) {
    const std::map<std::string, double (*)(double, double)> formulas{
        {"flat", flat}, {"step", step}, {"sinus", sinus}, {"rough", rough}};
    const auto project = testsupport::shipped("bench_rover");
    for (const auto& [name, height] : formulas) {
        simcore::run::RunRequest request;
        request.scenario = name;
        request.files.folder = testsupport::shippedFile("bench_rover").parent_path();
        const auto run = prepareRun(project, request);
        ASSERT_TRUE(run) << toString(run.problems());
        EXPECT_EQ(run->friction, 0.7);
        EXPECT_EQ(run->speed, 0.1);
        EXPECT_EQ(run->settle, 0.5);
        EXPECT_EQ(run->ramp, 0.5);
        EXPECT_EQ(run->distance, 3.5);
        EXPECT_EQ(run->duration, 0.0);
        const auto grid = sampleGround(*run->terrain, 0.01, {-1.0, -0.8, 5.0, 0.8});
        ASSERT_TRUE(grid) << toString(grid.problems());
        ASSERT_EQ(grid->columns, 601) << name;
        ASSERT_EQ(grid->rows, 161) << name;
        double worst = 0.0;
        double between = 0.0;
        for (int row = 0; row < grid->rows; ++row) {
            for (int column = 0; column < grid->columns; ++column) {
                const double x = -1.0 + 0.01 * column;
                const double y = -0.8 + 0.01 * row;
                const double z =
                    grid->heights[static_cast<std::size_t>(row * grid->columns + column)];
                worst = std::max(worst, std::abs(z - height(x, y)));
                if (column > 0) {
                    const double before =
                        grid->heights[static_cast<std::size_t>(row * grid->columns + column - 1)];
                    between = std::max(between, std::abs(run->terrain->heightAt(x - 0.005, y) -
                                                         0.5 * (z + before)));
                }
            }
        }
        EXPECT_LT(worst, 1.3e-6) << name;
        EXPECT_LT(between, 1e-9) << name;
    }
}
