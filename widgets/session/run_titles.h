#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "simcore/project/project.h"
#include "simcore/run/simulation.h"

namespace widgets {

/// "Torque control", "Hybrid", ...
QString controllerTitle(simcore::project::ControllerKind kind);
/// "ODE", "Reduced".
QString engineTitle(simcore::project::EngineKind kind);
/// What tells runs of a project apart: "Hybrid, step, μ 0.50, Reduced".
QString runTitle(const simcore::run::ResolvedRun& run);

/// Titles of runs beside one another: the controller, and of the rest what is not the same in all.
QStringList shortTitles(const std::vector<const simcore::run::ResolvedRun*>& runs);

}  // namespace widgets
