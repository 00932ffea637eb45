#include "simcore/run/critical_friction.h"

#include "simcore/base/text.h"

namespace simcore::run {

Result<CriticalFriction> findCriticalFriction(
    const project::Project& project, RunRequest request, double low, double high, double tolerance,
    const std::function<void(double friction, bool completed)>& progress) {
    if (!(low >= 0.0 && high > low && tolerance > 0.0)) {
        return Problem{Severity::Critical, Text::of("friction"),
                       Text::of("{:.4g} to {:.4g} in steps of {:.4g} cannot be searched.", low,
                                high, tolerance),
                       Text::of("Give 0 <= low < high and a tolerance above zero.")};
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
    const auto outside = [](std::string reason, std::string remedy) {
        return Problem{Severity::Critical, Text::of("friction"), std::move(reason),
                       std::move(remedy)};
    };
    if (!completesAt(high)) {
        return problems.empty()
                   ? Problems{outside(Text::of("the run does not complete at {:.4g}.", high),
                                      Text::of("Search higher, or make it easier."))}
                   : problems;
    }
    if (completesAt(low)) {
        return outside(Text::of("the run completes at {:.4g}.", low), Text::of("Search lower."));
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
