#include <algorithm>

#include "simcore/dynamics/engine.h"

namespace simcore::dynamics {

double jointRate(const mechanism::Joint& joint, const std::vector<Pose>& poses,
                 const std::vector<BodyVelocity>& velocities) {
    const auto first = static_cast<std::size_t>(joint.first);
    const auto second = static_cast<std::size_t>(joint.second);
    const Vec3 axis_W = poses[first].rotation * joint.axis;
    return axis_W.dot(velocities[second].angular - velocities[first].angular);
}

double loopError(const mechanism::Mechanism& mechanism, const std::vector<Pose>& poses,
                 mechanism::Model model) {
    double largest = 0.0;
    for (const mechanism::Joint& joint : mechanism.joints) {
        const Pose& first = poses[static_cast<std::size_t>(joint.first)];
        const Pose& second = poses[static_cast<std::size_t>(joint.second)];
        Vec3 gap = first.rotation.conjugate() * (second * joint.point - first * joint.point);
        for (const mechanism::Freedom& freedom : freedomsOf(joint, model)) {
            if (freedom.kind == mechanism::FreedomKind::Slide) {
                gap -= gap.dot(freedom.direction) * freedom.direction;
            }
        }
        largest = std::max(largest, gap.norm());
    }
    return largest;
}

}  // namespace simcore::dynamics
