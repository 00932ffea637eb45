#include "simcore/dynamics/ode_joints.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "simcore/dynamics/engine.h"
#include "simcore/dynamics/ode_world.h"

namespace simcore::dynamics {
namespace {

/// Soft, as contacts: a stop overrun in one step would else throw its arm back.
constexpr double kStopErrorReduction = 0.2;

using mechanism::Freedom;
using mechanism::FreedomKind;
using mechanism::Joint;

/// Joint types of ODE that hold exactly what a list of freedoms holds.
enum class OdeType { Pin, Ball, Universal, Slider, Cylindrical };

std::vector<Vec3> directions(const std::vector<Freedom>& freedoms, FreedomKind kind) {
    std::vector<Vec3> found;
    for (const Freedom& freedom : freedoms) {
        if (freedom.kind == kind) {
            found.push_back(freedom.direction);
        }
    }
    return found;
}

std::optional<OdeType> odeTypeOf(const std::vector<Freedom>& freedoms) {
    const auto turns = directions(freedoms, FreedomKind::Turn);
    const auto slides = directions(freedoms, FreedomKind::Slide);
    constexpr double kParallel = 1.0 - 1e-9;
    if (turns.size() == 1 && slides.empty()) {
        return OdeType::Pin;
    }
    if (turns.size() == 3 && slides.empty()) {
        return OdeType::Ball;
    }
    if (turns.size() == 2 && slides.empty() && std::abs(turns[0].dot(turns[1])) < 1e-9) {
        return OdeType::Universal;
    }
    if (turns.empty() && slides.size() == 1) {
        return OdeType::Slider;
    }
    if (turns.size() == 1 && slides.size() == 1 && std::abs(turns[0].dot(slides[0])) > kParallel) {
        return OdeType::Cylindrical;
    }
    return std::nullopt;
}

void makeJoint(dWorldID world, const Joint& joint, dBodyID first, dBodyID second) {
    const Vec3& p = joint.point;
    switch (*odeTypeOf(joint.built)) {
        case OdeType::Pin: {
            const Vec3& a = joint.built[0].direction;
            const dJointID id = dJointCreateHinge(world, nullptr);
            // Second body first: ODE measures the turn of its first body against its second.
            dJointAttach(id, second, first);
            dJointSetHingeAnchor(id, p.x(), p.y(), p.z());
            dJointSetHingeAxis(id, a.x(), a.y(), a.z());
            if (joint.stops) {
                const double sign = a.dot(joint.axis) < 0.0 ? -1.0 : 1.0;
                const double low = sign > 0 ? joint.stops->first : -joint.stops->second;
                const double high = sign > 0 ? joint.stops->second : -joint.stops->first;
                dJointSetHingeParam(id, dParamStopERP, kStopErrorReduction);
                // Twice: ODE refuses a lower stop above the present upper one.
                dJointSetHingeParam(id, dParamLoStop, low);
                dJointSetHingeParam(id, dParamHiStop, high);
                dJointSetHingeParam(id, dParamLoStop, low);
            }
            break;
        }
        case OdeType::Ball: {
            const dJointID id = dJointCreateBall(world, nullptr);
            dJointAttach(id, first, second);
            dJointSetBallAnchor(id, p.x(), p.y(), p.z());
            break;
        }
        case OdeType::Universal: {
            const auto turns = directions(joint.built, FreedomKind::Turn);
            const dJointID id = dJointCreateUniversal(world, nullptr);
            dJointAttach(id, first, second);
            dJointSetUniversalAnchor(id, p.x(), p.y(), p.z());
            dJointSetUniversalAxis2(id, turns[1].x(), turns[1].y(), turns[1].z());
            dJointSetUniversalAxis1(id, turns[0].x(), turns[0].y(), turns[0].z());
            break;
        }
        case OdeType::Slider: {
            const Vec3& a = joint.built[0].direction;
            const dJointID id = dJointCreateSlider(world, nullptr);
            dJointAttach(id, first, second);
            dJointSetSliderAxis(id, a.x(), a.y(), a.z());
            break;
        }
        case OdeType::Cylindrical: {
            const Vec3& a = joint.built[0].direction;
            const dJointID id = dJointCreatePiston(world, nullptr);
            dJointAttach(id, first, second);
            dJointSetPistonAnchor(id, p.x(), p.y(), p.z());
            dJointSetPistonAxis(id, a.x(), a.y(), a.z());
            break;
        }
    }
}

/// The body that both pins of a gear turn against; -1 when there is none.
int carrierOf(const mechanism::Mechanism& mechanism, const mechanism::Gear& gear) {
    const Joint& a = mechanism.joints[static_cast<std::size_t>(gear.firstJoint)];
    const Joint& b = mechanism.joints[static_cast<std::size_t>(gear.secondJoint)];
    if (a.first == b.first || a.first == b.second) {
        return a.first;
    }
    return a.second == b.first || a.second == b.second ? a.second : -1;
}

// The spider must not be felt: a gram, and the inertia of a gram at the mesh radius.
constexpr double kSpiderMass = 1e-3;
constexpr double kMeshRadius = 0.1;
// Compliance that takes all force out of a mesh's unwanted normal row.
constexpr double kNoForce = 1e3;
// Share of the gear error corrected per step.
constexpr double kErrorReduction = 0.2;

}  // namespace

OdeGear::OdeGear(dWorldID world, const mechanism::Mechanism& mechanism, const mechanism::Gear& gear,
                 const std::vector<dBodyID>& bodies) {
    const int carrier = carrierOf(mechanism, gear);
    carrier_ = bodies[static_cast<std::size_t>(carrier)];
    carrierCom_ = mechanism.bodies[static_cast<std::size_t>(carrier)].com;
    const Joint& first = mechanism.joints[static_cast<std::size_t>(gear.firstJoint)];
    const Joint& second = mechanism.joints[static_cast<std::size_t>(gear.secondJoint)];
    pinAxis_ = first.axis;
    center_ = 0.5 * (first.point + second.point);
    spiderAxis_ = (std::abs(pinAxis_.z()) < 0.9 ? pinAxis_.cross(Vec3::UnitZ())
                                                : pinAxis_.cross(Vec3::UnitX()))
                      .normalized();
    tooth_ = pinAxis_.cross(spiderAxis_);
    // A pinned body turning by w moves the mesh by w r along the tooth, the spider turning by g by
    // -g c, where c is the mesh's place along the pin axis: g = -w r / c. The first mesh has
    // c = -r, so the spider turns as the first body does.
    double firstSign = 1.0;
    for (const Joint* joint : {&first, &second}) {
        const bool isFirst = joint == &first;
        const double carrierSign = joint->first == carrier ? 1.0 : -1.0;
        const double along = joint->axis.dot(pinAxis_) > 0.0 ? 1.0 : -1.0;
        if (isFirst) {
            firstSign = carrierSign;
        }
        const double arm =
            isFirst ? -kMeshRadius : -along * kMeshRadius * carrierSign * firstSign * gear.ratio;
        Vec3 point = joint->point + kMeshRadius * spiderAxis_;
        point += (arm - (point - center_).dot(pinAxis_)) * pinAxis_;
        const int pinned = joint->first == carrier ? joint->second : joint->first;
        meshes_.push_back(
            {bodies[static_cast<std::size_t>(pinned)], arm, -kMeshRadius / arm, point});
    }
    dMass mass;
    const double inertia = kSpiderMass * kMeshRadius * kMeshRadius;
    dMassSetParameters(&mass, kSpiderMass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
    spider_ = dBodyCreate(world);
    dBodySetMass(spider_, &mass);
    dBodySetPosition(spider_, center_.x(), center_.y(), center_.z());
    dBodySetGravityMode(spider_, 0);
    const dJointID pin = dJointCreateHinge(world, nullptr);
    dJointAttach(pin, spider_, carrier_);
    dJointSetHingeAnchor(pin, center_.x(), center_.y(), center_.z());
    dJointSetHingeAxis(pin, spiderAxis_.x(), spiderAxis_.y(), spiderAxis_.z());
}

void OdeGear::addMeshes(dWorldID world, dJointGroupID group, double step) const {
    const auto rotationOf = [](dBodyID body) {
        const dReal* q = dBodyGetQuaternion(body);
        return Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
    };
    const auto turnAbout = [&](dBodyID body, const Vec3& axis) {
        const Eigen::Quaterniond relative = rotationOf(carrier_).conjugate() * rotationOf(body);
        return std::remainder(2.0 * std::atan2(axis.dot(relative.vec()), relative.w()),
                              2.0 * std::numbers::pi);
    };
    const Eigen::Quaterniond R = rotationOf(carrier_);
    const Vec3 origin = toVec3(dBodyGetPosition(carrier_)) - R * carrierCom_;
    const double spiderTurn = turnAbout(spider_, spiderAxis_);
    for (const Mesh& mesh : meshes_) {
        const Vec3 point = origin + R * mesh.point;
        const Vec3 tooth = R * tooth_;
        const Vec3 normal = R * spiderAxis_;
        const double error = std::remainder(
            mesh.turnSign * turnAbout(mesh.pinned, pinAxis_) - spiderTurn, 2.0 * std::numbers::pi);
        dContact c{};
        c.surface.mode = dContactMu2 | dContactFDir1 | dContactSoftCFM | dContactMotion1;
        c.surface.mu = dInfinity;
        c.surface.mu2 = 0.0;
        c.surface.soft_cfm = kNoForce;
        // The row asks for pinned minus spider speed along the tooth; the error shrinks with it.
        c.surface.motion1 = kErrorReduction / step * mesh.spiderArm * error;
        for (int k = 0; k < 3; ++k) {
            c.geom.pos[k] = point[k];
            c.geom.normal[k] = normal[k];
            c.fdir1[k] = tooth[k];
        }
        const dJointID joint = dJointCreateContact(world, group, &c);
        dJointAttach(joint, mesh.pinned, spider_);
    }
}

OdeJoints::OdeJoints(dWorldID world, const mechanism::Mechanism& mechanism,
                     const std::vector<dBodyID>& bodies)
    : allBodies_(bodies) {
    for (const Joint& joint : mechanism.joints) {
        makeJoint(world, joint, bodies[static_cast<std::size_t>(joint.first)],
                  bodies[static_cast<std::size_t>(joint.second)]);
    }
    for (const mechanism::Gear& gear : mechanism.gears) {
        gears_.emplace_back(world, mechanism, gear, bodies);
        allBodies_.push_back(gears_.back().spider());
        auxiliaryPositions_.push_back(gears_.back().spiderPosition());
    }
}

void OdeJoints::addStepJoints(dWorldID world, dJointGroupID group, double step) const {
    for (const OdeGear& gear : gears_) {
        gear.addMeshes(world, group, step);
    }
}

Problems whyOdeCannotRun(const mechanism::Mechanism& mechanism) {
    Problems problems;
    for (const Joint& joint : mechanism.joints) {
        if (!odeTypeOf(joint.built)) {
            problems.push_back(
                {Severity::Critical, "joint " + joint.name,
                 "the ODE engine has no joint with these free directions.",
                 "Use a pin, ball, universal, slider or cylindrical joint as built."});
        }
    }
    for (const mechanism::Gear& gear : mechanism.gears) {
        const Joint& a = mechanism.joints[static_cast<std::size_t>(gear.firstJoint)];
        const Joint& b = mechanism.joints[static_cast<std::size_t>(gear.secondJoint)];
        if (carrierOf(mechanism, gear) < 0 || std::abs(a.axis.dot(b.axis)) < 1.0 - 1e-9) {
            problems.push_back({Severity::Critical, "gear " + gear.name,
                                "its two pins do not turn in one common body about parallel axes.",
                                "Connect pins of the same carrier."});
        }
    }
    for (const mechanism::Body& body : mechanism.bodies) {
        if (!(body.mass > 0.0) || !body.com.allFinite() || !body.inertia.allFinite()) {
            problems.push_back({Severity::Critical, "body " + body.name,
                                "its mass, centre or inertia is not usable.", "Correct them."});
        }
    }
    return problems;
}

}  // namespace simcore::dynamics
