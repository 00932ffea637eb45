#include "simcore/experiment/ground_statics.h"

#include <limits>

#include "simcore/run/simulation.h"
#include "simcore/statics/traverse.h"

namespace simcore::experiment {
namespace {

/// Between samples no wheel moves further than this [radii]: events are located whatever it is.
constexpr double kSampleStep = 0.15;

double study(const project::Project& project, const Plan& plan, int seed) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const Case what{seed, plan.frictions.front(), plan.controllers.front()};
    const auto own = projectOf(project, plan, what);
    if (!own) {
        return kUnknown;
    }
    run::RunRequest request;
    request.scenario = own->scenarios.front().name;
    const auto prepared = run::prepareRun(*own, request);
    if (!prepared) {
        return kUnknown;
    }
    statics::StaticModel model(prepared->mechanism, prepared->joints);
    statics::PoseSolver solver(model, *prepared->terrain);
    statics::TraverseRequest traverse;
    traverse.distance = plan.distance;
    traverse.step = kSampleStep;
    return statics::traverse(solver, traverse).frictionRequired();
}

}  // namespace

double GroundStatics::frictionRequired(const project::Project& project, const Plan& plan,
                                       int seed) {
    const auto [at, isNew] = known_.try_emplace(seed, 0.0);
    if (isNew) {
        at->second = study(project, plan, seed);
    }
    return at->second;
}

}  // namespace simcore::experiment
