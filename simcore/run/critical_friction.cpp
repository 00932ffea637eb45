#include "simcore/run/critical_friction.h"

#include <fmt/format.h>

namespace simcore::run {

Result<CriticalFriction> findCriticalFriction(
    const project::Project& project, RunRequest request, double low, double high, double tolerance,
    const std::function<void(double friction, bool completed)>& progress) {
    if (!(low >= 0.0 && high > low && tolerance > 0.0)) {
        return Problem{Severity::Critical, "friction",
                       fmt::format("{:.4g} to {:.4g} in steps of {:.4g} cannot be searched.", low,
                                   high, tolerance),
                       "Give 0 <= low < high and a tolerance above zero."};
    }
    CriticalFriction bracket{low, high, 0};
    Problems problems;
    const auto completesAt = [&](double friction) {
        request.friction = friction;
        auto prepared = prepareRun(project, request);
        if (!prepared) {
            problems = prepared.problems();
            return false;
        }
        Simulation simulation(std::move(prepared).value());
        while (!simulation.finished()) {
            simulation.step();
        }
        ++bracket.runs;
        const bool completed = simulation.report().completed;
        if (progress) {
            progress(friction, completed);
        }
        return completed;
    };
    const auto outside = [](double friction, const char* what, const char* remedy) {
        return Problem{Severity::Critical, "friction",
                       fmt::format("the run {} at {:.4g}.", what, friction), remedy};
    };
    if (!completesAt(high)) {
        return problems.empty() ? Problems{outside(high, "does not complete",
                                                   "Search higher, or make it easier.")}
                                : problems;
    }
    if (completesAt(low)) {
        return outside(low, "completes", "Search lower.");
    }
    while (bracket.completes - bracket.fails > tolerance && problems.empty()) {
        (completesAt(bracket.middle()) ? bracket.completes : bracket.fails) = bracket.middle();
    }
    if (!problems.empty()) {
        return problems;
    }
    return bracket;
}

}  // namespace simcore::run
