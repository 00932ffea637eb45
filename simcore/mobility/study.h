#pragma once

#include <vector>

#include "simcore/mobility/loops.h"
#include "simcore/mobility/mobility.h"
#include "simcore/mobility/moved_pose.h"
#include "simcore/mobility/reactions.h"

namespace simcore::mobility {

/// Everything that is known of the mobility of a mechanism. Dearer than analyse(), which is what
/// an editor calls after every edit.
struct Study {
    Report present;
    MovedPose moved;
    std::vector<ReactionDeterminacy> reactions;
    std::vector<Loop> loops;
};

Study study(const mechanism::Mechanism& mechanism, Model model, const Stance& stance);
/// At the drawn pose on level ground.
Study study(const mechanism::Mechanism& mechanism, Model model);

/// What the moved pose adds to the verdict, in a sentence or two; empty when it adds nothing.
std::string describe(const MovedPose& moved, const Report& present);

}  // namespace simcore::mobility
