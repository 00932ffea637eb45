#pragma once

#include <string>
#include <vector>

#include "simcore/mobility/mobility.h"

namespace simcore::mobility {

/// One number that the loads alone determine: force . F + torque . T / lever, with the force F [N]
/// and the torque T [N m] about the joint's point that the joint puts on its second body (a
/// contact: on the wheel), world axes.
struct ReactionComponent {
    Vec3 force = Vec3::Zero();
    Vec3 torque = Vec3::Zero();
    double lever = 1.0;  ///< [m]
};

enum class Determinacy { All, Some, None };

/// How much of a joint's, contact's or gear's reaction follows from the loads. The rest depends on
/// how the rover was put together: on play, on stiffness and on errors of manufacture.
struct ReactionDeterminacy {
    std::string element;  ///< joint, gear, or contactOf(wheel)
    int joint = -1;       ///< mechanism joint index, -1 for contacts and gears
    int wheel = -1;       ///< wheel index for contacts, else -1
    int components = 0;   ///< of the reaction: rows that the element holds
    Determinacy determinacy = Determinacy::All;
    /// Orthonormal basis (lengths over the lever) of the determined components: first those along
    /// one held direction, then sums of several.
    std::vector<ReactionComponent> determined;
    std::vector<ConstraintName> undetermined;  ///< held directions with a share in self-stress
};

/// Per joint, then per touching wheel, then per gear: which components of the reaction are the same
/// in every equilibrium, i.e. vanish in all self-stress states. A gear's one component is the
/// torque on its second joint.
std::vector<ReactionDeterminacy> determinedReactions(const mechanism::Mechanism& mechanism,
                                                     Model model, const Stance& stance);
/// At the drawn pose on level ground.
std::vector<ReactionDeterminacy> determinedReactions(const mechanism::Mechanism& mechanism,
                                                     Model model);

/// What of them cannot be known from the loads, in a sentence or two.
std::string describe(const std::vector<ReactionDeterminacy>& reactions);

}  // namespace simcore::mobility
