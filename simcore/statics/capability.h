#pragma once

#include "simcore/mechanism/mechanism.h"
#include "simcore/statics/traverse.h"

namespace simcore::statics {

/// What a rover is asked to climb.
struct ClimbRequest {
    Model joints = Model::Built;
    double friction = 0.5;  ///< of the ground [-]
    bool backwards = false;
    double tread = 0.3;  ///< of stairs [m]
    int stairs = 3;
};

/// What it climbs, by statics: no run-up, no rolling resistance, torques within the motors' limits.
struct Capability {
    double step = 0.0;         ///< highest vertical step [m]
    double stair = 0.0;        ///< highest riser of stairs with the given tread [m]
    double slope = 0.0;        ///< steepest even slope, tip-over included [rad]
    bool stepLimited = true;   ///< false: it climbs the highest that was tried
    bool stairLimited = true;  ///< the same of the stairs
};

/// Bisected to half a millimetre and a hundredth of a degree, up to four radii of a wheel. That
/// what is lower than something climbed can be climbed is assumed.
Capability whatItClimbs(const mechanism::Mechanism& mechanism, const ClimbRequest& request);

/// Whether it climbs `count` risers of this height, `tread` apart.
bool climbsStairs(const mechanism::Mechanism& mechanism, const ClimbRequest& request, double height,
                  double tread, int count);

}  // namespace simcore::statics
