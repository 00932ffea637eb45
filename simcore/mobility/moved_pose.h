#pragma once

#include <string>
#include <vector>

#include "simcore/mobility/mobility.h"

namespace simcore::mobility {

/// What becomes of a free motion when it is followed by a finite step.
enum class Continuation {
    Finite,        ///< all constraints can be closed again: it is a real motion
    Branch,        ///< only together with other free motions: the pose is a branching point
    Infinitesimal  ///< not at all: the mechanism only yields here, it does not move
};

/// A redundant row that the moved geometry does not fulfil: redundant in this pose only.
struct Inconsistency {
    ConstraintName constraint;
    double gap = 0.0;  ///< by how much it is violated after the step [m] or [rad]
};

struct FreeMotion {
    std::string body;          ///< the one that moves most
    Vec3 turn = Vec3::Zero();  ///< its angular velocity over its speed, world axes
    Vec3 slide = Vec3::Zero();
    Continuation continuation = Continuation::Finite;
    double closure = 0.0;  ///< largest violation that is left; lengths over the wheelbase, or rad
    std::vector<Inconsistency> inconsistent;
    Stance reached;  ///< the moved pose; meaningful unless Infinitesimal
};

/// What analyse() finds after a finite step along every free motion in turn.
struct MovedPose {
    std::vector<FreeMotion> motions;
    int moving = 0;        ///< motions that are not Infinitesimal
    int rank = 0;          ///< the largest of all moved poses: that of a general pose nearby
    int mobility = 0;      ///< there
    int redundant = 0;     ///< there
    double rankGap = 0.0;  ///< there
};

/// Steps along each free motion until the centre of mass of some body has moved 1e-2 of the
/// wheelbase or some body has turned 0.1 rad, then closes loops and contacts again by Newton's
/// method to 1e-12. Without free motions, or when none continues, the moved pose is the present
/// one. Deterministic: nothing is disturbed at random.
MovedPose movedPose(const mechanism::Mechanism& mechanism, Model model, const Stance& stance);

}  // namespace simcore::mobility
