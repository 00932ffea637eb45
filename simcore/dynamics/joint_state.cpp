#include <algorithm>

#include "simcore/base/text.h"
#include "simcore/dynamics/engine.h"

namespace simcore::dynamics {
namespace {

/// Length of the part of `v` at right angles to all of `directions`, which may be oblique.
double lengthAcross(const Vec3& v, const std::vector<Vec3>& directions) {
    Vec3 across = Vec3::Zero();
    for (const Vec3& held : mechanism::orthogonalComplement(directions)) {
        across += v.dot(held) * held;
    }
    return across.norm();
}

}  // namespace

JointMotor withFriction(const mechanism::Joint& joint, const JointMotor* motor) {
    if (motor == nullptr) {
        return {-1, 0.0, joint.friction};
    }
    const double friction = motor->rate == 0.0 ? joint.friction : -joint.friction;
    return {motor->joint, motor->rate, std::max(0.0, motor->torqueLimit + friction)};
}

double jointRate(const mechanism::Joint& joint, const std::vector<Pose>& poses,
                 const std::vector<BodyVelocity>& velocities) {
    const auto first = static_cast<std::size_t>(joint.first);
    const auto second = static_cast<std::size_t>(joint.second);
    const Vec3 axis_W = poses[first].rotation * joint.axis;
    return axis_W.dot(velocities[second].angular - velocities[first].angular);
}

double wheelRate(const mechanism::Wheel& wheel, const std::vector<Pose>& poses,
                 const std::vector<BodyVelocity>& velocities) {
    const auto body = static_cast<std::size_t>(wheel.body);
    const Vec3 axis_W = poses[body].rotation * wheel.axis;
    return axis_W.dot(velocities[body].angular) -
           axis_W.dot(velocities[static_cast<std::size_t>(wheel.carrier)].angular);
}

LoopErrorMeter::LoopErrorMeter(const mechanism::Mechanism& mechanism, mechanism::Model model)
    : mechanism_(mechanism) {
    for (const mechanism::Joint& joint : mechanism.joints) {
        slides_.push_back(directionsOf(freedomsOf(joint, model), mechanism::FreedomKind::Slide));
    }
}

double LoopErrorMeter::measure(const std::vector<Pose>& poses) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < slides_.size(); ++i) {
        const mechanism::Joint& joint = mechanism_.joints[i];
        const Pose& first = poses[static_cast<std::size_t>(joint.first)];
        const Pose& second = poses[static_cast<std::size_t>(joint.second)];
        const Vec3 gap = second * joint.point - first * joint.point;
        largest =
            std::max(largest, slides_[i].empty()
                                  ? gap.norm()
                                  : lengthAcross(first.rotation.conjugate() * gap, slides_[i]));
    }
    return largest;
}

double loopError(const mechanism::Mechanism& mechanism, const std::vector<Pose>& poses,
                 mechanism::Model model) {
    return LoopErrorMeter(mechanism, model).measure(poses);
}

Problems whyNoEngineCanRun(const mechanism::Mechanism& mechanism) {
    Problems problems;
    for (const mechanism::Body& body : mechanism.bodies) {
        if (!(body.mass > 0.0) || !body.com.allFinite() || !body.inertia.allFinite()) {
            problems.push_back({Severity::Critical, Text::of("body {}", body.name),
                                Text::of("its mass, centre or inertia is not usable."),
                                Text::of("Correct them.")});
        }
    }
    return problems;
}

}  // namespace simcore::dynamics
