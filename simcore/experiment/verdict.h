#pragma once

#include <vector>

#include "simcore/experiment/experiment.h"

namespace simcore::experiment {

/// Which of two runs has less of something.
enum class Less { Neither, First, Second };

/// Two runs of one scenario held against each other: what the paper's second set of experiments
/// asks of a pair.
struct Verdict {
    bool bothCompleted = false;
    Less failed = Less::Neither;  ///< the only one of the two that did not complete
    double apart = 0.0;           ///< of the places where they ended, on the ground [m]
    bool sameWay = false;  ///< both completed, less than kSameEnd apart: slip may be compared

    struct Measure {
        Less less = Less::Neither;  ///< by more than the resolution
        double ratio = 0.0;         ///< second over first, both at least the resolution [-]
    };

    Measure slip;        ///< Outcome::slipAbs
    Measure loadedSlip;  ///< Outcome::slipLoaded
    Measure energy;      ///< Outcome::energy
    Measure work;        ///< Outcome::frictionWork
};

/// The measures are there whether or not they may be compared.
Verdict judge(const Outcome& first, const Outcome& second);

/// Drives the scenario asked for once with each controller, one after the other.
/// @returns one outcome a controller. Problems: what keeps any of them from being prepared.
Result<std::vector<Outcome>> driveEach(const project::Project& project,
                                       const run::RunRequest& request,
                                       const std::vector<project::ControllerKind>& controllers);

}  // namespace simcore::experiment
