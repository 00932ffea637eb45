#pragma once

#include <functional>

#include "simcore/run/simulation.h"

namespace simcore::run {

/// Where between two coefficients of friction a run begins to complete.
struct CriticalFriction {
    double fails = 0.0;      ///< greatest one tried that did not complete [-]
    double completes = 0.0;  ///< smallest one tried that did [-]
    int runs = 0;

    double middle() const { return 0.5 * (fails + completes); }
};

/// Bisects the ground's friction between `low` and `high` until the bracket is narrower than
/// `tolerance`, taking it that more friction never hurts. `progress` is told every run's outcome.
///
/// Problems: those of prepareRun(); a run that completes at `low` or fails at `high`.
Result<CriticalFriction> findCriticalFriction(
    const project::Project& project, RunRequest request, double low, double high, double tolerance,
    const std::function<void(double friction, bool completed)>& progress = {});

}  // namespace simcore::run
