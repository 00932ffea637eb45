#include "simcore/experiment/verdict.h"

#include <algorithm>
#include <cmath>

#include "simcore/experiment/comparison.h"

namespace simcore::experiment {
namespace {

Verdict::Measure hold(double first, double second, double resolution) {
    Verdict::Measure measure;
    if (std::abs(first - second) > resolution) {
        measure.less = first < second ? Less::First : Less::Second;
    }
    measure.ratio = std::max(resolution, second) / std::max(resolution, first);
    return measure;
}

}  // namespace

Verdict judge(const Outcome& first, const Outcome& second) {
    Verdict verdict;
    verdict.bothCompleted = first.completed && second.completed;
    if (first.completed != second.completed) {
        verdict.failed = first.completed ? Less::Second : Less::First;
    }
    verdict.apart = std::hypot(first.endX - second.endX, first.endY - second.endY);
    verdict.sameWay = verdict.bothCompleted && verdict.apart < kSameEnd;
    verdict.slip = hold(first.slipAbs, second.slipAbs, kSlipResolution);
    verdict.loadedSlip = hold(first.slipLoaded, second.slipLoaded, kSlipResolution);
    verdict.energy = hold(first.energy, second.energy, kEnergyResolution);
    verdict.work = hold(first.frictionWork, second.frictionWork, kEnergyResolution);
    return verdict;
}

Result<std::vector<Outcome>> driveEach(const project::Project& project,
                                       const run::RunRequest& request,
                                       const std::vector<project::ControllerKind>& controllers) {
    std::vector<Outcome> outcomes;
    for (const project::ControllerKind controller : controllers) {
        run::RunRequest own = request;
        own.controller = controller;
        auto prepared = run::prepareRun(project, own);
        if (!prepared) {
            return prepared.problems();
        }
        const Case ran{prepared->seed, prepared->friction, controller};
        run::Simulation simulation(std::move(prepared).value());
        while (!simulation.finished()) {
            simulation.step();
        }
        outcomes.push_back(
            outcomeOf(simulation.report(), simulation.snapshot(), simulation.settings().mechanism));
        outcomes.back().ran = ran;
    }
    return outcomes;
}

}  // namespace simcore::experiment
