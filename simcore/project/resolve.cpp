#include "simcore/project/resolve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <fmt/format.h>

#include "simcore/base/groups.h"
#include "simcore/base/text.h"
#include "simcore/mechanism/mass_properties.h"
#include "simcore/project/element_names.h"
#include "simcore/project/element_walk.h"
#include "simcore/project/expression.h"
#include "simcore/project/units.h"

namespace simcore::project {
namespace {

using mechanism::MassProperties;
using mechanism::Mechanism;

/// A steering axis is at most 45 deg from the vertical: beyond, it would not steer (assumed).
constexpr double kUpright = 0.7071;

/// Values quantities and collects what is wrong with them.
class Valuer {
  public:
    Valuer(const ParameterValues& parameters, Problems& problems) : problems_(problems) {
        for (const auto& [name, value] : parameters) {
            evaluator_.define(name, value);
        }
    }

    /// `what`: marked. `dimension`: what a unit written in the text must be of; null = anything.
    double operator()(const Quantity& quantity, const std::string& element, const char* what,
                      const char* dimension) {
        if (quantity.isLiteral()) {
            if (!std::isfinite(quantity.literal())) {
                critical(element,
                         Text::of("{}: its value is not a finite number.", Text::translated(what)),
                         Text::of("Give a number."));
                return 0.0;
            }
            return quantity.literal();
        }
        if (dimension != nullptr) {
            if (const std::string why = whyWrongDimension(quantity.text(), dimension);
                !why.empty()) {
                critical(element, fmt::format("{}: {}.", Text::translated(what), why),
                         Text::of("Write it in a unit of {}, or as a number in SI.",
                                  Text::translated(dimension)));
                return 0.0;
            }
        }
        const auto result = evaluator_.evaluate(quantity.text());
        if (const auto* reason = std::get_if<std::string>(&result)) {
            critical(element,
                     Text::of("{}: '{}' has no value: {}.", Text::translated(what), quantity.text(),
                              *reason),
                     Text::of("Use numbers, parameters of the rover and a unit at the end."));
            return 0.0;
        }
        return std::get<double>(result);
    }

    Vec3 operator()(const Quantity3& quantity, const std::string& element, const char* what) {
        return {(*this)(quantity[0], element, what, "length"),
                (*this)(quantity[1], element, what, "length"),
                (*this)(quantity[2], element, what, "length")};
    }

    /// As operator(), and complains unless the value is > 0.
    double positive(const Quantity& quantity, const std::string& element, const char* what,
                    const char* dimension) {
        const std::size_t before = problems_.size();
        const double value = (*this)(quantity, element, what, dimension);
        if (!(value > 0.0) && problems_.size() == before) {
            critical(element,
                     Text::of("the {} is {:.6g}, not positive.", Text::translated(what), value),
                     Text::of("Give a value above zero."));
        }
        return value;
    }

    double notNegative(const Quantity& quantity, const std::string& element, const char* what,
                       const char* dimension) {
        const double value = (*this)(quantity, element, what, dimension);
        if (!(value >= 0.0)) {
            critical(element,
                     Text::of("the {} is {:.6g}, negative.", Text::translated(what), value),
                     Text::of("Give zero or more."));
        }
        return value;
    }

    void critical(const std::string& element, std::string reason, std::string remedy) {
        problems_.push_back({Severity::Critical, element, std::move(reason), std::move(remedy)});
    }

    void warning(const std::string& element, std::string reason, std::string remedy) {
        problems_.push_back({Severity::Warning, element, std::move(reason), std::move(remedy)});
    }

  private:
    ExpressionEvaluator evaluator_;
    Problems& problems_;
};

// Mirror rules (y -> -y): points and slides are polar vectors, turns are axial.
Vec3 mirroredPoint(const Vec3& p, Side side) {
    return side == Side::Right ? Vec3(p.x(), -p.y(), p.z()) : p;
}

Vec3 mirroredAxis(const Vec3& a, Side side) {
    return side == Side::Right ? Vec3(-a.x(), a.y(), -a.z()) : a;
}

Mat3 mirroredInertia(Mat3 inertia, Side side) {
    if (side == Side::Right) {
        inertia(0, 1) = inertia(1, 0) = -inertia(0, 1);
        inertia(1, 2) = inertia(2, 1) = -inertia(1, 2);
    }
    return inertia;
}

bool isOnSide(Sides sides, Side side) {
    return sides == Sides::Both || (sides == Sides::Left) == (side == Side::Left);
}

/// One rigid part of the file before welded parts are merged.
struct Part {
    std::string name;
    MassProperties mass;
    std::vector<mechanism::Shape> shapes;
    bool inertiaGiven = false;
    bool fixed = false;
};

/// A joint as the file has it, welded or not; parts instead of bodies.
struct FileJoint {
    mechanism::Joint joint;
    bool locked = false;  ///< by the file, not for want of a controller that steers
    bool welded = false;
};

void addMass(mechanism::Body& body, const MassProperties& more) {
    const MassProperties sum = mechanism::merged({body.mass, body.com, body.inertia}, more);
    body.mass = sum.mass;
    body.com = sum.com;
    body.inertia = sum.inertia;
}

bool isPin(const mechanism::Joint& joint) {
    return joint.built.size() == 1 && joint.built[0].kind == mechanism::FreedomKind::Turn;
}

class Resolver {
  public:
    Resolver(const Rover& rover, const ParameterValues& parameters, Steering steering)
        : rover_(rover),
          steering_(steering),
          value_(parameters, problems_) {}

    Result<Mechanism> run() {
        mechanism_.name = rover_.name;
        readParts();
        readPayloads();
        readJoints();
        readWheels();
        finishBodies();
        readSprings();
        readGears();
        if (!hasCritical(problems_)) {
            checkConnected();
        }
        if (hasCritical(problems_)) {
            return problems_;
        }
        return Result<Mechanism>(std::move(mechanism_), std::move(problems_));
    }

  private:
    void readParts();
    void readPayloads();
    void readJoints();
    void weldSteering();
    void mergeParts();
    void readWheels();
    void readSteering(const Wheel& wheel, const std::string& element, Side side,
                      mechanism::Wheel& out);
    bool carriesWheel(int steering, int axle) const;
    void finishBodies();
    void readSprings();
    void readGears();
    void checkConnected();
    mechanism::Shape readShape(const Shape& shape, const std::string& element, Side side);
    std::optional<mechanism::Freedom> readFreedom(const FreedomText& text, const Vec3& axisAsDrawn,
                                                  const std::string& element, Side side);
    void readFreedoms(const Joint& joint, const std::string& element, Side side,
                      mechanism::Joint& out);

    int findPart(const std::string& reference, Side side, const std::string& element) {
        return find(partIndex_, reference, side, element, Text::mark("body"));
    }

    int findJoint(const std::string& reference, Side side, const std::string& element) {
        return find(jointIndex_, reference, side, element, Text::mark("joint"));
    }

    int find(const NameIndex& index, const std::string& reference, Side side,
             const std::string& element, const char* kind) {
        const int found = index.find(reference, side);
        if (found < 0) {
            value_.critical(element,
                            Text::of("there is no {} '{}'.", Text::translated(kind), reference),
                            Text::of("Known: {}.", index.list()));
        }
        return found;
    }

    void checkName(NameIndex& names, const std::string& name, const std::string& element,
                   const char* kind) {
        if (name.empty() || !names.add(name, 0)) {
            value_.critical(
                element,
                name.empty() ? Text::of("it has no name.") : Text::of("the name is used twice."),
                Text::of("Give every {} its own name.", Text::translated(kind)));
        }
    }

    void checkSides(Sides sides, const std::string& element, Side side) {
        if (sides != Sides::Both && side == Side::Center) {
            value_.critical(element, Text::of("it is relaxed on one side, but it is not mirrored."),
                            Text::of("Mirror it, or relax both sides."));
        }
    }

    int bodyOfPart(int part) const {
        return part < 0 ? -1 : bodyOfPart_[static_cast<std::size_t>(part)];
    }

    bool isFixed(int body) const {
        return body >= 0 && mechanism_.bodies[static_cast<std::size_t>(body)].fixed;
    }

    const Rover& rover_;
    const Steering steering_;
    Problems problems_;
    Valuer value_;
    Mechanism mechanism_;
    std::vector<Part> parts_;
    NameIndex partIndex_;
    std::vector<int> bodyOfPart_;
    std::vector<std::pair<int, MassProperties>> payloads_;  ///< part, what it carries
    /// Joint names of the file to mechanism joints; locked ones are known as kLocked.
    NameIndex jointIndex_;
    NameIndex fileJointIndex_;  ///< joint names of the file to fileJoints_
    std::vector<FileJoint> fileJoints_;
    static constexpr int kLocked = 1 << 20;
};

mechanism::Shape Resolver::readShape(const Shape& shape, const std::string& element, Side side) {
    mechanism::Shape out;
    out.kind = shape.kind;
    out.color = shape.color;
    switch (shape.kind) {
        case ShapeKind::Box:
            out.center =
                mirroredPoint(value_(shape.center, element, Text::mark("box center")), side);
            out.size = {
                value_.positive(shape.size[0], element, Text::mark("box length"), "length"),
                value_.positive(shape.size[1], element, Text::mark("box width"), "length"),
                value_.positive(shape.size[2], element, Text::mark("box height"), "length")};
            out.pitch = value_(shape.pitch, element, Text::mark("box pitch"), "angle");
            break;
        case ShapeKind::Sphere:
            out.center =
                mirroredPoint(value_(shape.center, element, Text::mark("sphere center")), side);
            out.radius =
                value_.positive(shape.radius, element, Text::mark("sphere radius"), "length");
            break;
        case ShapeKind::Cylinder:
        case ShapeKind::Bar:
            out.from = mirroredPoint(value_(shape.from, element, Text::mark("shape end")), side);
            out.to = mirroredPoint(value_(shape.to, element, Text::mark("shape end")), side);
            if (shape.kind == ShapeKind::Cylinder) {
                out.radius =
                    value_.positive(shape.radius, element, Text::mark("cylinder radius"), "length");
            } else {
                out.width =
                    value_.positive(shape.width, element, Text::mark("bar width"), "length");
                out.height =
                    value_.positive(shape.height, element, Text::mark("bar height"), "length");
            }
            if ((out.to - out.from).norm() < 1e-9) {
                value_.critical(element, Text::of("a shape's two ends coincide."),
                                Text::of("Move one of them."));
                out.to = out.from + Vec3::UnitX();
            }
            break;
    }
    return out;
}

void Resolver::readParts() {
    if (rover_.bodies.empty()) {
        value_.critical(Text::of("rover {}", rover_.name), Text::of("it has no bodies."),
                        Text::of("Add at least a chassis."));
    }
    for (const auto& copy : expandMirrored(rover_.bodies)) {
        const Body& body = *copy.element;
        const std::string element = Text::of("body {}", copy.name);
        Part part;
        part.name = copy.name;
        part.fixed = body.fixed;
        part.mass.mass = value_.positive(body.mass, element, Text::mark("mass"), "mass");
        part.mass.com = mirroredPoint(value_(body.com, element, Text::mark("com")), copy.side);
        for (std::size_t k = 0; k < body.shapes.size(); ++k) {
            part.shapes.push_back(
                readShape(body.shapes[k], Text::of("{}, shape {}", element, k + 1), copy.side));
        }
        if (body.inertia) {
            part.inertiaGiven = true;
            std::array<double, 6> i{};
            for (std::size_t k = 0; k < 6; ++k) {
                i[k] = value_((*body.inertia)[k], element, Text::mark("inertia"), "inertia");
            }
            Mat3 inertia;
            inertia << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
            part.mass.inertia = mirroredInertia(inertia, copy.side);
        } else {
            part.mass.inertia = mechanism::inertiaOfShapes(part.shapes, part.mass.mass);
        }
        if (copy.name.empty() || !partIndex_.add(copy.name, static_cast<int>(parts_.size()))) {
            value_.critical(element,
                            copy.name.empty() ? Text::of("it has no name.")
                                              : Text::of("the name is used twice."),
                            Text::of("Give every body its own name."));
        }
        parts_.push_back(std::move(part));
    }
}

void Resolver::readPayloads() {
    NameIndex names;
    for (const auto& copy : expandMirrored(rover_.payloads)) {
        const std::string element = Text::of("payload {}", copy.name);
        checkName(names, copy.name, element, Text::mark("payload"));
        const int part = findPart(copy.element->body, copy.side, element);
        const double mass =
            value_.positive(copy.element->mass, element, Text::mark("mass"), "mass");
        const Vec3 position = mirroredPoint(
            value_(copy.element->position, element, Text::mark("position")), copy.side);
        if (part >= 0) {
            payloads_.emplace_back(part, MassProperties{mass, position, Mat3::Zero()});
        }
    }
}

std::optional<mechanism::Freedom> Resolver::readFreedom(const FreedomText& text,
                                                        const Vec3& axisAsDrawn,
                                                        const std::string& element, Side side) {
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    std::string kind;
    std::string first;
    words >> kind >> first;
    mechanism::Freedom freedom;
    Vec3 direction = Vec3::Zero();
    bool good = kind == "turn" || kind == "slide";
    if (first == "axis") {
        direction = axisAsDrawn;
    } else if (first == "x" || first == "y" || first == "z") {
        direction = Vec3::Unit(first[0] - 'x');
    } else {
        std::istringstream numbers(text.substr(std::min(text.size(), kind.size() + 1)));
        numbers.imbue(std::locale::classic());
        good = good && (numbers >> direction.x() >> direction.y() >> direction.z()) &&
               direction.norm() > 1e-9 && direction.allFinite() && (numbers >> std::ws).eof();
    }
    if (!good) {
        value_.critical(element, Text::of("freedom '{}' is not understood.", text),
                        Text::of("Write 'turn' or 'slide', then axis, x, y, z or three numbers."));
        return std::nullopt;
    }
    freedom.kind = kind == "turn" ? mechanism::FreedomKind::Turn : mechanism::FreedomKind::Slide;
    direction.normalize();
    freedom.direction = freedom.kind == mechanism::FreedomKind::Turn
                            ? mirroredAxis(direction, side)
                            : mirroredPoint(direction, side);
    return freedom;
}

void Resolver::readFreedoms(const Joint& joint, const std::string& element, Side side,
                            mechanism::Joint& out) {
    const Vec3 axisAsDrawn = mirroredAxis(out.axis, side);  // the mirror is its own inverse
    const auto read = [&](const std::vector<FreedomText>& texts) {
        std::vector<mechanism::Freedom> freedoms;
        for (const FreedomText& text : texts) {
            if (auto freedom = readFreedom(text, axisAsDrawn, element, side)) {
                freedoms.push_back(*freedom);
            }
        }
        for (const auto kind : {mechanism::FreedomKind::Turn, mechanism::FreedomKind::Slide}) {
            Eigen::Matrix3Xd directions(3, 0);
            for (const auto& freedom : freedoms) {
                if (freedom.kind == kind) {
                    directions.conservativeResize(3, directions.cols() + 1);
                    directions.col(directions.cols() - 1) = freedom.direction;
                }
            }
            if (directions.cols() > 0 &&
                Eigen::ColPivHouseholderQR<Eigen::Matrix3Xd>(directions).setThreshold(1e-6).rank() <
                    directions.cols()) {
                value_.critical(element,
                                Text::of("two of its free directions are the same or dependent."),
                                Text::of("Remove one, or turn it."));
            }
        }
        return freedoms;
    };
    out.built = read(joint.free);
    checkSides(joint.relaxedSides, element, side);
    const std::vector<mechanism::Freedom> relaxed = read(joint.relaxed);
    const bool asBuilt = relaxed.empty() || !isOnSide(joint.relaxedSides, side);
    out.relaxed = asBuilt ? out.built : relaxed;
}

void Resolver::readJoints() {
    for (const auto& copy : expandMirrored(rover_.joints)) {
        const Joint& joint = *copy.element;
        const std::string element = Text::of("joint {}", copy.name);
        mechanism::Joint out;
        out.name = copy.name;
        out.first = findPart(joint.first, copy.side, element);
        out.second = findPart(joint.second, copy.side, element);
        if (out.first >= 0 && out.first == out.second) {
            value_.critical(element, Text::of("it joins a body to itself."),
                            Text::of("Name two bodies."));
        }
        out.point = mirroredPoint(value_(joint.point, element, Text::mark("point")), copy.side);
        const Vec3 axis = value_(joint.axis, element, Text::mark("axis"));
        if (axis.norm() > 1e-9) {
            out.axis = mirroredAxis(axis.normalized(), copy.side);
        } else {
            value_.critical(element, Text::of("its axis has no length."),
                            Text::of("Give a direction, e.g. [0, 1, 0]."));
        }
        readFreedoms(joint, element, copy.side, out);
        if (joint.stops) {
            const double low =
                value_((*joint.stops)[0], element, Text::mark("lower stop"), "angle");
            const double high =
                value_((*joint.stops)[1], element, Text::mark("upper stop"), "angle");
            if (!(low <= 0.0 && high >= 0.0 && low < high)) {
                value_.critical(
                    element,
                    Text::of("stops {:.4g} and {:.4g} rad do not enclose the drawn "
                             "pose (0).",
                             low, high),
                    Text::of("Give the lower one first, below zero, and the upper one above."));
            }
            out.stops = {low, high};
        }
        out.damping =
            value_.notNegative(joint.damping, element, Text::mark("damping"), "torsional damping");
        out.friction =
            value_.notNegative(joint.friction, element, Text::mark("friction"), "torque");
        const bool locked = joint.locked || joint.free.empty();
        if (copy.name.empty() ||
            !fileJointIndex_.add(copy.name, static_cast<int>(fileJoints_.size()))) {
            value_.critical(element,
                            copy.name.empty() ? Text::of("it has no name.")
                                              : Text::of("the name is used twice."),
                            Text::of("Give every joint its own name."));
        }
        fileJoints_.push_back({std::move(out), locked, locked});
    }
    if (steering_ == Steering::Locked) {
        weldSteering();
    }
    mergeParts();
    for (const FileJoint& one : fileJoints_) {
        if (one.welded) {
            jointIndex_.add(one.joint.name, kLocked);
            continue;
        }
        jointIndex_.add(one.joint.name, static_cast<int>(mechanism_.joints.size()));
        mechanism_.joints.push_back(one.joint);
        mechanism::Joint& out = mechanism_.joints.back();
        out.first = bodyOfPart(one.joint.first);
        out.second = bodyOfPart(one.joint.second);
        if (out.first >= 0 && out.first == out.second && one.joint.first != one.joint.second) {
            value_.critical(Text::of("joint {}", out.name),
                            Text::of("it joins two parts that are welded together."),
                            Text::of("Remove the joint, or unlock the other one."));
        } else if (isFixed(out.first) && isFixed(out.second) && out.first != out.second) {
            value_.critical(Text::of("joint {}", out.name),
                            Text::of("both its bodies are fixed: it has nothing to hold."),
                            Text::of("Remove the joint, or let one of the bodies go."));
        }
    }
}

void Resolver::weldSteering() {
    for (const auto& copy : expandMirrored(rover_.wheels)) {
        // One that is not found is reported with its wheel.
        const int joint = copy.element->steering.empty()
                              ? -1
                              : fileJointIndex_.find(copy.element->steering, copy.side);
        if (joint >= 0) {
            fileJoints_[static_cast<std::size_t>(joint)].welded = true;
        }
    }
}

void Resolver::mergeParts() {
    Groups merged(parts_.size());
    for (const FileJoint& one : fileJoints_) {
        if (one.welded && one.joint.first >= 0 && one.joint.second >= 0) {
            merged.join(one.joint.first, one.joint.second);
        }
    }
    bodyOfPart_.assign(parts_.size(), -1);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const auto root = static_cast<std::size_t>(merged.of(static_cast<int>(i)));
        Part& part = parts_[i];
        if (root == i) {
            bodyOfPart_[i] = static_cast<int>(mechanism_.bodies.size());
            mechanism_.bodies.push_back({part.name,
                                         {part.name},
                                         part.mass.mass,
                                         part.mass.com,
                                         part.mass.inertia,
                                         part.shapes,
                                         part.fixed});
            continue;
        }
        bodyOfPart_[i] = bodyOfPart_[root];
        mechanism::Body& body = mechanism_.bodies[static_cast<std::size_t>(bodyOfPart_[i])];
        addMass(body, part.mass);
        body.fixed = body.fixed || part.fixed;
        body.parts.push_back(part.name);
        body.shapes.insert(body.shapes.end(), part.shapes.begin(), part.shapes.end());
    }
}

void Resolver::readWheels() {
    NameIndex names;
    std::vector<int> wheelOfBody(mechanism_.bodies.size(), -1);
    for (const auto& copy : expandMirrored(rover_.wheels)) {
        const Wheel& wheel = *copy.element;
        const std::string element = Text::of("wheel {}", copy.name);
        mechanism::Wheel out;
        out.name = copy.name;
        out.body = bodyOfPart(findPart(wheel.body, copy.side, element));
        out.axle = findJoint(wheel.axle, copy.side, element);
        out.radius = value_.positive(wheel.radius, element, Text::mark("radius"), "length");
        out.width = value_.positive(wheel.width, element, Text::mark("width"), "length");
        out.grousers = wheel.grousers;
        out.torqueLimit =
            value_.positive(wheel.motor.torqueLimit, element, Text::mark("torque limit"), "torque");
        out.speedLimit = value_.positive(wheel.motor.speedLimit, element, Text::mark("speed limit"),
                                         "angular speed");
        out.rotorInertia = value_.notNegative(wheel.motor.rotorInertia, element,
                                              Text::mark("rotor inertia"), "inertia");
        checkSides(wheel.relaxedSides, element, copy.side);
        out.relaxedLateral = wheel.relaxedLateral && isOnSide(wheel.relaxedSides, copy.side);
        if (wheel.grousers < 0 || wheel.grousers > 200) {
            value_.critical(element, Text::of("{} grousers cannot be drawn.", wheel.grousers),
                            Text::of("Give 0 to 200."));
        }
        if (!wheel.steering.empty()) {
            readSteering(wheel, element, copy.side, out);
        }
        checkName(names, copy.name, element, Text::mark("wheel"));
        if (out.axle >= kLocked) {
            value_.critical(element, Text::of("its axle is locked or has no freedom."),
                            Text::of("Unlock the axle."));
        } else if (out.axle >= 0 && out.body >= 0) {
            const mechanism::Joint& axle = mechanism_.joints[static_cast<std::size_t>(out.axle)];
            if (!isPin(axle) || (axle.first != out.body && axle.second != out.body)) {
                value_.critical(
                    element, Text::of("'{}' is not a pin of its body.", axle.name),
                    Text::of("Name the pin joint between the wheel's body and its carrier."));
            }
            out.carrier = axle.first == out.body ? axle.second : axle.first;
            out.center = axle.point;
            out.axis = axle.axis.y() < 0.0 ? Vec3(-axle.axis) : axle.axis;
            if (std::abs(axle.axis.y()) < 0.1) {
                value_.critical(element, Text::of("its axle does not point sideways."),
                                Text::of("Wheels roll forward: give the axle an axis along y."));
            }
            mechanism::Body& body = mechanism_.bodies[static_cast<std::size_t>(out.body)];
            int& owner = wheelOfBody[static_cast<std::size_t>(out.body)];
            if (owner >= 0) {
                value_.critical(element, Text::of("body '{}' already carries a wheel.", body.name),
                                Text::of("Give each wheel its own body."));
            }
            owner = static_cast<int>(mechanism_.wheels.size());
            if (body.fixed) {
                value_.critical(element, Text::of("body '{}' is fixed.", body.name),
                                Text::of("Let the wheel go; fix the chassis for a test stand."));
            }
            if (body.inertia.isZero()) {
                body.inertia =
                    mechanism::inertiaOfCylinder(body.mass, out.radius, out.width, out.axis);
            }
            const double gap = out.center.z() - out.radius;
            if (std::abs(gap) > 1e-3) {
                value_.warning(
                    element,
                    gap > 0
                        ? Text::of("it is {:.1f} mm above the ground at the drawn pose.", 1e3 * gap)
                        : Text::of("it is {:.1f} mm below the ground at the drawn pose.",
                                   -1e3 * gap),
                    Text::of("Put its axle at the height of its radius."));
            }
        }
        mechanism_.wheels.push_back(std::move(out));
    }
}

void Resolver::readSteering(const Wheel& wheel, const std::string& element, Side side,
                            mechanism::Wheel& out) {
    const int found = find(fileJointIndex_, wheel.steering, side, element, Text::mark("joint"));
    const int axle = fileJointIndex_.find(wheel.axle, side);
    const double torque = value_.notNegative(wheel.steeringMotor.torqueLimit, element,
                                             Text::mark("steering torque"), "torque");
    const double speed = value_.positive(wheel.steeringMotor.speedLimit, element,
                                         Text::mark("steering speed"), "angular speed");
    if (found < 0 || axle < 0) {
        return;
    }
    const FileJoint& steering = fileJoints_[static_cast<std::size_t>(found)];
    const mechanism::Joint& joint = steering.joint;
    if (!isPin(joint) && !steering.locked) {
        value_.critical(element, Text::of("its steering joint '{}' is no pin.", joint.name),
                        Text::of("Leave it one free direction, 'turn axis'."));
    } else if (std::abs(joint.axis.z()) < kUpright) {
        value_.critical(element,
                        Text::of("its steering joint '{}' does not stand upright.", joint.name),
                        Text::of("Give it an axis along z, or within 45 deg of it."));
    } else if (!carriesWheel(found, axle)) {
        value_.critical(
            element,
            Text::of("'{}' does not steer it: without that joint the wheel would "
                     "still hang on the chassis.",
                     joint.name),
            Text::of("Name the pin between the wheel's carrier and the rest of the rover."));
    }
    if (!steering.welded) {
        out.steering = jointIndex_.find(joint.name, Side::Center);
        out.steeringTorqueLimit = torque > 0.0 ? torque : out.torqueLimit;
        out.steeringSpeedLimit = speed;
    }
}

/// Whether all ways from the chassis to the axle lead through the steering joint.
bool Resolver::carriesWheel(int steering, int axle) const {
    Groups merged(parts_.size());
    for (int i = 0; i < static_cast<int>(fileJoints_.size()); ++i) {
        const mechanism::Joint& joint = fileJoints_[static_cast<std::size_t>(i)].joint;
        if (i != steering && joint.first >= 0 && joint.second >= 0) {
            merged.join(joint.first, joint.second);
        }
    }
    const mechanism::Joint& pin = fileJoints_[static_cast<std::size_t>(axle)].joint;
    return pin.first < 0 || merged.of(pin.first) != merged.of(0);
}

/// Inertias that nobody gave, then what the payloads add: they must not be taken for the body's
/// own.
void Resolver::finishBodies() {
    for (mechanism::Body& body : mechanism_.bodies) {
        const std::string element = Text::of("body {}", body.name);
        if (body.mass > 0.0 && body.inertia.isZero()) {
            // Radius of a solid ball of density 2700 kg/m^3 (aluminium): assumed.
            const double radius = std::cbrt(3.0 * body.mass / (4.0 * std::numbers::pi * 2700.0));
            body.inertia = 0.4 * body.mass * radius * radius * Mat3::Identity();
            value_.warning(
                element,
                Text::of("it has neither inertia nor shapes; a solid aluminium ball is assumed."),
                Text::of("Draw a shape, or give its inertia."));
        }
    }
    for (const auto& [part, load] : payloads_) {
        addMass(mechanism_.bodies[static_cast<std::size_t>(bodyOfPart(part))], load);
    }
    for (const mechanism::Body& body : mechanism_.bodies) {
        const std::string element = Text::of("body {}", body.name);
        if (const std::string why = mechanism::whyNotInertia(body.inertia);
            body.mass > 0.0 && !why.empty()) {
            value_.critical(
                element, Text::of("its inertia is impossible: {}.", why),
                Text::of("Correct the inertia, or remove it to use that of the shapes."));
        }
    }
}

void Resolver::readSprings() {
    NameIndex names;
    for (const auto& copy : expandMirrored(rover_.springs)) {
        const Spring& spring = *copy.element;
        const std::string element = Text::of("spring {}", copy.name);
        checkName(names, copy.name, element, Text::mark("spring"));
        mechanism::Spring out;
        out.name = copy.name;
        const bool torsion = !spring.joint.empty();
        out.stiffness = value_.notNegative(spring.stiffness, element, Text::mark("stiffness"),
                                           torsion ? "torsional stiffness" : "stiffness");
        out.preload =
            value_(spring.preload, element, Text::mark("preload"), torsion ? "torque" : "force");
        out.damping = value_.notNegative(spring.damping, element, Text::mark("damping"),
                                         torsion ? "torsional damping" : "damping");
        if (torsion) {
            out.joint = findJoint(spring.joint, copy.side, element);
            if (out.joint >= kLocked) {
                value_.critical(element, Text::of("its joint is locked."),
                                Text::of("Unlock it, or remove the spring."));
            } else if (out.joint >= 0) {
                out.first = mechanism_.joints[static_cast<std::size_t>(out.joint)].first;
                out.second = mechanism_.joints[static_cast<std::size_t>(out.joint)].second;
            }
        } else {
            out.first = bodyOfPart(findPart(spring.first, copy.side, element));
            out.second = bodyOfPart(findPart(spring.second, copy.side, element));
            out.firstPoint = mirroredPoint(
                value_(spring.firstPoint, element, Text::mark("first point")), copy.side);
            out.secondPoint = mirroredPoint(
                value_(spring.secondPoint, element, Text::mark("second point")), copy.side);
            if ((out.firstPoint - out.secondPoint).norm() < 1e-4) {
                value_.critical(element, Text::of("its two ends coincide."),
                                Text::of("Move one end."));
            }
        }
        mechanism_.springs.push_back(std::move(out));
    }
}

void Resolver::readGears() {
    NameIndex names;
    for (const Gear& gear : rover_.gears) {
        const std::string element = Text::of("gear {}", gear.name);
        checkName(names, gear.name, element, Text::mark("gear"));
        mechanism::Gear out;
        out.name = gear.name;
        out.firstJoint = findJoint(gear.firstJoint, Side::Center, element);
        out.secondJoint = findJoint(gear.secondJoint, Side::Center, element);
        out.ratio = value_(gear.ratio, element, Text::mark("gear ratio"), "ratio");
        for (const int joint : {out.firstJoint, out.secondJoint}) {
            if (joint >= 0 &&
                (joint >= kLocked || !isPin(mechanism_.joints[static_cast<std::size_t>(joint)]))) {
                value_.critical(element, Text::of("it does not connect two pins."),
                                Text::of("Name two pin joints."));
            }
        }
        if (out.firstJoint == out.secondJoint && out.firstJoint >= 0) {
            value_.critical(element, Text::of("it connects a joint with itself."),
                            Text::of("Name two pin joints."));
        }
        if (!(std::abs(out.ratio) > 1e-6)) {
            value_.critical(element, Text::of("its ratio is zero."),
                            Text::of("Give the ratio of the turns."));
        }
        mechanism_.gears.push_back(std::move(out));
    }
}

void Resolver::checkConnected() {
    if (mechanism_.wheels.empty()) {
        value_.warning(Text::of("rover {}", rover_.name), Text::of("it has no wheels."),
                       Text::of("Add wheels to drive it."));
    }
    Groups merged(mechanism_.bodies.size());
    for (const mechanism::Joint& joint : mechanism_.joints) {
        merged.join(joint.first, joint.second);
    }
    int world = -1;  // all fixed bodies are connected through it
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
        if (mechanism_.bodies[i].fixed) {
            world = world < 0 ? static_cast<int>(i) : world;
            merged.join(world, static_cast<int>(i));
        }
    }
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
        if (merged.of(static_cast<int>(i)) != merged.of(mechanism_.chassis)) {
            value_.critical(Text::of("body {}", mechanism_.bodies[i].name),
                            Text::translated(kNotConnected), Text::of("Join it, or remove it."));
        }
    }
}

}  // namespace

Result<Mechanism> resolve(const Rover& rover, const ParameterValues& parameters,
                          Steering steering) {
    return Resolver(rover, parameters, steering).run();
}

Result<Mechanism> resolve(const Project& project, const std::string& variant,
                          const std::vector<Assignment>& assignments, Steering steering) {
    const auto parameters = evaluateParameters(project, variant, assignments);
    if (!parameters) {
        return parameters.problems();
    }
    return resolve(project.rover, *parameters, steering);
}

}  // namespace simcore::project
