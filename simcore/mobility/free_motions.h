#pragma once

#include <string>
#include <vector>

#include "simcore/mobility/moved_pose.h"

namespace simcore::mobility {

/// How far freeMotions() follows a motion to either side, whichever comes first. Assumed: enough to
/// be seen, and little enough that a rover stays near the pose that was analysed.
struct SwingLimits {
    double travel = 0.05;  ///< of the centre of mass of any body, over the characteristic length
    double turn = 0.5;     ///< of any body [rad]
    int steps = 24;        ///< poses to either side, at least 1
};

/// A free motion of the mechanism, followed to both sides of where it stands with loops and
/// contacts closed.
struct Swing {
    std::string description;  ///< what moves, for people
    std::string body;         ///< the one that moves most
    bool idle = false;        ///< moves neither chassis nor wheels; see IdleFreedom
    /// Infinitesimal: nothing can be shown, poses has the stance alone.
    Continuation continuation = Continuation::Finite;
    /// X_WB of all bodies, evenly along the motion; poses[middle] is the stance it was asked for.
    std::vector<std::vector<Pose>> poses;
    std::size_t middle = 0;
    double closure = 0.0;  ///< largest violation in any pose; lengths over the wheelbase, or rad

    /// The poses at -1 (one end) to 1 (the other end), 0 is the stance. Between two poses
    /// positions and turns are interpolated; steps are so small that joints stay closed to
    /// hundredths of a millimetre in rovers of half a metre.
    std::vector<Pose> at(double swing) const;
};

/// All free motions, as many as the mobility: idle ones last, the others at right angles to them.
/// Of several that belong together such are chosen as move few bodies. Throws std::invalid_argument
/// when the stance does not fit the mechanism, or there are no steps.
std::vector<Swing> freeMotions(const mechanism::Mechanism& mechanism, Model model,
                               const Stance& stance, const SwingLimits& limits = {});
/// At the drawn pose on level ground.
std::vector<Swing> freeMotions(const mechanism::Mechanism& mechanism, Model model);

}  // namespace simcore::mobility
