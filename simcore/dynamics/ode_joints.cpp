#include "simcore/dynamics/ode_joints.h"

#include <cmath>

#include "simcore/base/text.h"
#include "simcore/dynamics/ode_world.h"

namespace simcore::dynamics {
namespace {

/// Soft, as contacts: a stop overrun in one step would else throw its arm back.
constexpr double kStopErrorReduction = 0.2;
constexpr double kParallel = 1.0 - 1e-9;

using mechanism::directionsOf;
using mechanism::Freedom;
using mechanism::FreedomKind;
using mechanism::Joint;

bool parallel(const Vec3& a, const Vec3& b) {
    return std::abs(a.dot(b)) > kParallel;
}

/// Rotation vector that takes the first body's frame to the second's, in the first.
Vec3 relativeTurn(const Pose& first, const Pose& second) {
    const Eigen::AngleAxisd turn(first.rotation.conjugate() * second.rotation);
    return turn.angle() * turn.axis();
}

}  // namespace

// ODE measures the first body of a joint against its second: all are attached the other way round.
dJointID OdeJoint::add(Part& part, dJointID id) {
    dJointAttach(id, second_, first_);
    dJointSetFeedback(id, &part.feedback);
    part.id = id;
    return id;
}

OdeJoint::OdeJoint(dWorldID world, const Joint& joint, const std::vector<Freedom>& freedoms,
                   dBodyID first, dBodyID second)
    : joint_(joint),
      first_(first),
      second_(second),
      turns_(directionsOf(freedoms, FreedomKind::Turn)) {
    const std::vector<Vec3> slides = directionsOf(freedoms, FreedomKind::Slide);
    const Vec3& p = joint.point;
    native_ = true;
    if (slides.empty() && turns_.size() == 1) {
        isPin_ = parallel(turns_[0], joint.axis);
        pinSign_ = turns_[0].dot(joint.axis) < 0.0 ? -1.0 : 1.0;
        const dJointID id = add(main_, dJointCreateHinge(world, nullptr));
        dJointSetHingeAnchor(id, p.x(), p.y(), p.z());
        dJointSetHingeAxis(id, turns_[0].x(), turns_[0].y(), turns_[0].z());
        dJointSetHingeParam(id, dParamStopERP, kStopErrorReduction);
    } else if (slides.empty() && turns_.size() == 2 && std::abs(turns_[0].dot(turns_[1])) < 1e-9) {
        const dJointID id = add(main_, dJointCreateUniversal(world, nullptr));
        dJointSetUniversalAnchor(id, p.x(), p.y(), p.z());
        dJointSetUniversalAxis2(id, turns_[0].x(), turns_[0].y(), turns_[0].z());
        dJointSetUniversalAxis1(id, turns_[1].x(), turns_[1].y(), turns_[1].z());
    } else if (slides.size() == 1 && turns_.empty()) {
        const dJointID id = add(main_, dJointCreateSlider(world, nullptr));
        dJointSetSliderAxis(id, slides[0].x(), slides[0].y(), slides[0].z());
    } else if (slides.size() == 1 && turns_.size() == 1 && parallel(turns_[0], slides[0])) {
        const dJointID id = add(main_, dJointCreatePiston(world, nullptr));
        dJointSetPistonAnchor(id, p.x(), p.y(), p.z());
        dJointSetPistonAxis(id, slides[0].x(), slides[0].y(), slides[0].z());
    } else {
        native_ = false;
        heldSlides_ = mechanism::orthogonalComplement(slides);
        if (slides.empty()) {
            const dJointID id = add(main_, dJointCreateBall(world, nullptr));
            dJointSetBallAnchor(id, p.x(), p.y(), p.z());
        } else {
            freeSlide_ = slides[0];
        }
        if (turns_.size() < 3) {
            const dJointID id = add(rotations_, dJointCreateAMotor(world, nullptr));
            dJointSetAMotorMode(id, dAMotorUser);
        }
    }
}

/// The friction rows of a contact, unbounded, as holds along one or two directions.
void OdeJoint::holdTranslations(const OdeSolve& solve) {
    if (heldSlides_.empty() || heldSlides_.size() == 3) {
        return;
    }
    const Pose& first = solve.poses[static_cast<std::size_t>(joint_.first)];
    const Pose& second = solve.poses[static_cast<std::size_t>(joint_.second)];
    const Vec3 point = second * joint_.point;
    const Vec3 error = first.rotation.conjugate() * (point - first * joint_.point);
    const double rate = -kJointErrorReduction / solve.step;
    dContact c{};
    c.surface.mode =
        dContactMu2 | dContactFDir1 | dContactSoftCFM | dContactMotion1 | dContactMotion2;
    c.surface.mu = dInfinity;
    c.surface.soft_cfm = kNoForce;
    // ODE takes normal x fdir1 as the second friction direction.
    const Vec3& along = heldSlides_[0];
    Vec3 normal = freeSlide_ - freeSlide_.dot(along) * along;
    if (heldSlides_.size() == 2) {
        normal = along.cross(heldSlides_[1]);
    }
    normal.normalize();
    c.surface.motion1 = rate * error.dot(along);
    if (heldSlides_.size() == 2) {
        c.surface.mu2 = dInfinity;
        c.surface.motion2 = rate * error.dot(normal.cross(along));
    }
    toOde(c.geom.pos, point);
    toOde(c.geom.normal, first.rotation * normal);
    toOde(c.fdir1, first.rotation * along);
    add(main_, dJointCreateContact(solve.world, solve.group, &c));
}

void OdeJoint::holdRotations(const OdeSolve& solve) {
    if (native_ || turns_.size() == 3) {
        return;
    }
    const Pose& first = solve.poses[static_cast<std::size_t>(joint_.first)];
    const Pose& second = solve.poses[static_cast<std::size_t>(joint_.second)];
    std::vector<Vec3> axes;  // world, with the error about each
    std::vector<double> errors;
    if (turns_.size() == 2) {
        // The first free axis belongs to the first body, the second one to the second: their
        // angle stays.
        const Vec3 a = first.rotation * turns_[0];
        const Vec3 b = second.rotation * turns_[1];
        const Vec3 across = a.cross(b);
        axes.push_back(across.normalized());
        errors.push_back((turns_[0].dot(turns_[1]) - a.dot(b)) / across.norm());
    } else {
        const Vec3 error =
            turns_.empty()
                ? relativeTurn(first, second)
                : turns_[0].cross(first.rotation.conjugate() * (second.rotation * turns_[0]));
        for (const Vec3& held : mechanism::orthogonalComplement(turns_)) {
            axes.emplace_back(first.rotation * held);
            errors.push_back(error.dot(held));
        }
    }
    constexpr int kVelocity[] = {dParamVel1, dParamVel2, dParamVel3};
    constexpr int kTorque[] = {dParamFMax1, dParamFMax2, dParamFMax3};
    dJointSetAMotorNumAxes(rotations_.id, static_cast<int>(axes.size()));
    for (std::size_t i = 0; i < axes.size(); ++i) {
        dJointSetAMotorAxis(rotations_.id, static_cast<int>(i), 0, axes[i].x(), axes[i].y(),
                            axes[i].z());
        dJointSetAMotorParam(rotations_.id, kTorque[i], dInfinity);
        dJointSetAMotorParam(rotations_.id, kVelocity[i],
                             -kJointErrorReduction / solve.step * errors[i]);
    }
}

/// Of pins by ODE's own joint, of others by a motor about the axis, which stays in the first body.
void OdeJoint::setStopsAndMotor(const OdeSolve& solve, const JointMotor* motor) {
    const JointMotor turning = withFriction(joint_, motor);
    if (!joint_.stops && turning.torqueLimit == 0.0 && axis_.id == nullptr && !isPin_) {
        return;
    }
    if (!isPin_ && axis_.id == nullptr) {
        const dJointID id = add(axis_, dJointCreateAMotor(solve.world, nullptr));
        dJointSetAMotorMode(id, dAMotorUser);
        dJointSetAMotorNumAxes(id, 1);
        dJointSetAMotorParam(id, dParamStopERP, kStopErrorReduction);
    }
    const double sign = isPin_ ? pinSign_ : 1.0;
    const auto setParam = [&](int parameter, double value) {
        if (isPin_) {
            dJointSetHingeParam(main_.id, parameter, value);
        } else {
            dJointSetAMotorParam(axis_.id, parameter, value);
        }
    };
    if (!isPin_) {
        const Vec3 axis =
            solve.poses[static_cast<std::size_t>(joint_.first)].rotation * joint_.axis;
        dJointSetAMotorAxis(axis_.id, 0, 0, axis.x(), axis.y(), axis.z());
        dJointSetAMotorAngle(axis_.id, 0, jointAngle(joint_, solve.poses));
    }
    if (joint_.stops) {
        const double low = sign > 0 ? joint_.stops->first : -joint_.stops->second;
        const double high = sign > 0 ? joint_.stops->second : -joint_.stops->first;
        // Twice: ODE refuses a lower stop above the present upper one.
        setParam(dParamLoStop, low);
        setParam(dParamHiStop, high);
        setParam(dParamLoStop, low);
    }
    setParam(dParamVel, sign * turning.rate);
    setParam(dParamFMax, turning.torqueLimit);
}

void OdeJoint::prepare(const OdeSolve& solve, const JointMotor* motor) {
    holdTranslations(solve);
    holdRotations(solve);
    setStopsAndMotor(solve, motor);
}

JointReaction OdeJoint::reaction(const OdeSolve& solve) const {
    const auto second = static_cast<std::size_t>(joint_.second);
    const Pose& pose = solve.poses[second];
    JointReaction sum;
    for (const Part* part : {&main_, &rotations_, &axis_}) {
        if (part->id != nullptr) {
            sum.force += toVec3(part->feedback.f1);
            sum.torque += toVec3(part->feedback.t1);
        }
    }
    // ODE's torque is about the body's centre of mass.
    const Vec3 arm = pose.rotation * (joint_.point - solve.mechanism.bodies[second].com);
    sum.torque -= arm.cross(sum.force);
    return sum;
}

OdeJoints::OdeJoints(dWorldID world, const mechanism::Mechanism& mechanism, mechanism::Model model,
                     const std::vector<dBodyID>& bodies)
    : allBodies_(bodies),
      motorOf_(mechanism.joints.size(), nullptr) {
    for (const Joint& joint : mechanism.joints) {
        joints_.emplace_back(world, joint, freedomsOf(joint, model),
                             bodies[static_cast<std::size_t>(joint.first)],
                             bodies[static_cast<std::size_t>(joint.second)]);
    }
    for (const mechanism::Gear& gear : mechanism.gears) {
        gears_.emplace_back(world, mechanism, gear, bodies);
        allBodies_.push_back(gears_.back().spider());
        auxiliaryPositions_.push_back(gears_.back().spiderPosition());
    }
}

void OdeJoints::prepare(const OdeSolve& solve, std::span<const JointMotor> motors) {
    motorOf_.assign(joints_.size(), nullptr);
    for (const JointMotor& motor : motors) {
        motorOf_[static_cast<std::size_t>(motor.joint)] = &motor;
    }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        joints_[i].prepare(solve, motorOf_[i]);
    }
    for (const OdeGear& gear : gears_) {
        gear.addMeshes(solve.world, solve.group, solve.step);
    }
}

void OdeJoints::readReactions(const OdeSolve& solve, std::vector<JointReaction>& reactions) const {
    reactions.resize(joints_.size());
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        reactions[i] = joints_[i].reaction(solve);
    }
}

Problems whyOdeCannotRun(const mechanism::Mechanism& mechanism) {
    Problems problems;
    for (const mechanism::Gear& gear : mechanism.gears) {
        if (carrierOf(mechanism, gear) < 0) {
            problems.push_back({Severity::Critical, Text::of("gear {}", gear.name),
                                Text::of("its two pins do not turn in one common body."),
                                Text::of("Connect pins of the same carrier.")});
        }
    }
    appendNew(problems, whyNoEngineCanRun(mechanism));
    return problems;
}

}  // namespace simcore::dynamics
