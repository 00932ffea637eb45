#include "widgets/session/run_titles.h"

#include <algorithm>

#include "widgets/session/run_bar.h"

namespace widgets {

using simcore::project::ControllerKind;
using simcore::project::EngineKind;

QString controllerTitle(ControllerKind kind) {
    switch (kind) {
        case ControllerKind::Speed:
            return RunBar::tr("Speed control");
        case ControllerKind::Synchronised:
            return RunBar::tr("Synchronised speeds");
        case ControllerKind::CommonIntegral:
            return RunBar::tr("Common integral");
        case ControllerKind::EqualTorque:
            return RunBar::tr("Equal torque");
        case ControllerKind::Torque:
            return RunBar::tr("Torque control");
        case ControllerKind::Hybrid:
            return RunBar::tr("Hybrid");
        case ControllerKind::Manual:
            break;
    }
    return RunBar::tr("Manual (W A S D)");
}

QString engineTitle(EngineKind kind) {
    return kind == EngineKind::Ode ? RunBar::tr("ODE") : RunBar::tr("Reduced");
}

namespace {

QString frictionTitle(const simcore::run::ResolvedRun& run) {
    return RunBar::tr("μ %1").arg(run.friction, 0, 'f', 2);
}

}  // namespace

QString runTitle(const simcore::run::ResolvedRun& run) {
    return QStringList{controllerTitle(run.controller), QString::fromStdString(run.scenario),
                       frictionTitle(run), engineTitle(run.engine)}
        .join(", ");
}

QStringList shortTitles(const std::vector<const simcore::run::ResolvedRun*>& runs) {
    const auto differ = [&](auto&& of) {
        return std::any_of(runs.begin(), runs.end(),
                           [&](const auto* run) { return of(*run) != of(*runs.front()); });
    };
    const bool scenario = differ([](const auto& run) { return run.scenario; });
    const bool friction = differ([](const auto& run) { return run.friction; });
    const bool engine = differ([](const auto& run) { return run.engine; });
    QStringList titles;
    for (const auto* run : runs) {
        QStringList parts{controllerTitle(run->controller)};
        if (scenario) {
            parts << QString::fromStdString(run->scenario);
        }
        if (friction) {
            parts << frictionTitle(*run);
        }
        if (engine) {
            parts << engineTitle(run->engine);
        }
        titles << parts.join(", ");
    }
    return titles;
}

}  // namespace widgets
