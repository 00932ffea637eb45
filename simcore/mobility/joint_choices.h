#pragma once

#include <vector>

#include "simcore/mobility/advisor.h"
#include "simcore/mobility/constraint_jacobian.h"
#include "simcore/mobility/exact_sets.h"
#include "simcore/mobility/stance.h"

/// From the project to the search and back: what each of its elements could become, and which
/// self-stress that would relieve.
namespace simcore::mobility {

/// An element of the project and the ways to change it, in two views with the same indices.
struct ChangeableElement {
    std::vector<JointChange> changes;
    std::vector<Choice> choices;
};

/// All changes that the options permit and that make nothing new move on their own. Joints of the
/// project first, then wheels, in the order of the file.
/// @param mechanism  resolve(project)
/// @param stance     where the self-stress states are looked at
/// @param oneSided   mirrored elements may be changed on one side only, too
std::vector<ChangeableElement> findChanges(const project::Project& project,
                                           const mechanism::Mechanism& mechanism,
                                           const Stance& stance, const AdvisorOptions& options,
                                           bool oneSided);

/// Joints with a turn less, so that no idle freedom is left and chassis and wheels move as before:
/// one of a rod's two balls becomes a universal joint. Empty where there is none, or no such
/// change.
std::vector<JointChange> holdIdleFreedoms(const project::Project& project,
                                          const mechanism::Mechanism& mechanism);

/// True when chassis and wheels (all bodies, without wheels) have the same free velocities with
/// both Jacobians of one mechanism.
bool sameWantedMotions(const mechanism::Mechanism& mechanism, const ConstraintJacobian& one,
                       const ConstraintJacobian& other);

}  // namespace simcore::mobility
