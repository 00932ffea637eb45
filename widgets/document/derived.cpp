#include "widgets/document/derived.h"

#include "simcore/run/simulation.h"

namespace widgets {

Derived derive(const simcore::project::Project& project,
               const simcore::project::ProjectFiles& files) {
    Derived derived;
    derived.problems = simcore::run::checkProject(project, files);
    auto parameters = simcore::project::evaluateParameters(project.rover);
    if (!parameters) {
        return derived;
    }
    derived.parameters = std::move(parameters).value();
    auto mechanism = simcore::project::resolve(project.rover, derived.parameters);
    if (!mechanism) {
        return derived;
    }
    derived.mechanism = std::move(mechanism).value();
    derived.built = simcore::mobility::analyse(*derived.mechanism, simcore::mobility::Model::Built);
    derived.relaxed =
        simcore::mobility::analyse(*derived.mechanism, simcore::mobility::Model::Relaxed);
    derived.findings = simcore::review::review(project, derived.parameters, *derived.mechanism,
                                               derived.built, derived.relaxed);
    return derived;
}

}  // namespace widgets
