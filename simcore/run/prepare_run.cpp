#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "simcore/base/text.h"
#include "simcore/contact/body_contacts.h"
#include "simcore/dynamics/engine.h"
#include "simcore/io/terrain_file.h"
#include "simcore/project/names.h"
#include "simcore/run/simulation.h"
#include "simcore/terrain/make_terrain.h"

namespace simcore::run {
namespace {

std::string scenarioNames(const project::Project& project) {
    std::string names;
    for (const project::Scenario& scenario : project.scenarios) {
        names += (names.empty() ? "" : ", ") + scenario.name;
    }
    return names.empty() ? Text::of("none") : names;
}

project::Scenario withRequest(project::Scenario scenario, const RunRequest& request) {
    if (request.engine) {
        scenario.run.engine = *request.engine;
    }
    if (request.controller) {
        scenario.controller.kind = *request.controller;
    }
    if (request.friction) {
        scenario.soil.friction = *request.friction;
    }
    if (request.duration) {
        scenario.run.duration = *request.duration;
    }
    if (request.distance) {
        scenario.run.distance = *request.distance;
    }
    if (request.terrainHeight) {
        scenario.terrain.height = *request.terrainHeight;
    }
    if (request.step) {
        scenario.run.step = *request.step;
    }
    if (request.relaxedJoints) {
        scenario.run.relaxedJoints = *request.relaxedJoints;
    }
    if (request.seed) {
        scenario.run.seed = *request.seed;
        scenario.terrain.seed = *request.seed;
        // Parts of a sum differ from each other.
        for (std::size_t i = 0; i < scenario.terrain.terrains.size(); ++i) {
            scenario.terrain.terrains[i].seed = *request.seed + static_cast<int>(i);
        }
    }
    return scenario;
}

// Deeper contacts at the start are problems [m], assumed: ten times the resting depth.
constexpr double kDeepestStart = 0.005;

/// A body that is no wheel and stands deep in an obstacle would be thrown out of it, or hang in it.
void checkStartOfBodies(const ResolvedRun& run, Problems& problems) {
    contact::BodyContactFinder finder(run.mechanism, *run.terrain, 0.0,
                                      std::numeric_limits<double>::infinity());
    std::map<int, double> depths;
    for (const contact::Contact& contact :
         finder.find(std::vector<Pose>(run.mechanism.bodies.size()))) {
        double& depth = depths[contact.body];
        depth = std::max(depth, contact.depth);
    }
    for (const auto& [body, depth] : depths) {
        if (depth > kDeepestStart) {
            problems.push_back(
                {Severity::Critical,
                 Text::of("body {}", run.mechanism.bodies[static_cast<std::size_t>(body)].name),
                 Text::of("it starts {:.1f} mm deep in the ground.", 1e3 * depth),
                 Text::of("Start the terrain's first feature further ahead, raise the body's "
                          "shapes, or set the run's body_contacts to false.")});
        }
    }
}

/// A wheel that stands deep in an obstacle at the start would be thrown out of it; one beside the
/// ground would fall.
void checkStart(const ResolvedRun& run, Problems& problems) {
    for (const mechanism::Wheel& wheel : run.mechanism.wheels) {
        // Bodies start with their frames at the origin.
        if (std::isnan(run.terrain->heightAt(wheel.center.x(), wheel.center.y()))) {
            problems.push_back(
                {Severity::Critical, Text::of("wheel {}", wheel.name),
                 Text::of("there is no ground under it at the start, x = {:.3g} "
                          "m, y = {:.3g} m.",
                          wheel.center.x(), wheel.center.y()),
                 Text::of("Move the terrain's origin, so that the rover starts on it.")});
        }
    }
    contact::WheelContactFinder finder(run.mechanism, *run.terrain);
    for (const contact::Contact& contact :
         finder.find(std::vector<Pose>(run.mechanism.bodies.size()))) {
        if (contact.depth > kDeepestStart) {
            problems.push_back(
                {Severity::Critical,
                 Text::of("wheel {}",
                          run.mechanism.wheels[static_cast<std::size_t>(contact.wheel)].name),
                 Text::of("it starts {:.1f} mm deep in the ground.", 1e3 * contact.depth),
                 Text::of("Start the terrain's first feature further ahead, or raise the wheel.")});
        }
    }
    if (run.bodyContacts) {
        checkStartOfBodies(run, problems);
    }
}

/// Whether the controller will ever turn a steering joint.
bool steers(const project::Controller& controller, double turn) {
    using project::ControllerKind;
    return controller.steering != project::SteeringMode::Skid &&
           (controller.kind == ControllerKind::Manual ||
            (controller.kind == ControllerKind::Speed && (turn != 0.0 || controller.headingHold)));
}

Problems whyEngineCannotRun(project::EngineKind engine, const mechanism::Mechanism& mechanism) {
    return engine == project::EngineKind::Ode ? dynamics::whyOdeCannotRun(mechanism)
                                              : dynamics::whyReducedCannotRun(mechanism);
}

/// Everything but the terrain.
std::optional<ResolvedRun> readRun(const project::Project& project,
                                   const project::Scenario& scenario,
                                   const project::ParameterValues& parameters, Problems& problems) {
    const auto values = project::evaluateScenario(scenario, parameters);
    auto mechanism = project::resolve(project.rover, parameters,
                                      steers(scenario.controller, values ? values->turn : 0.0)
                                          ? project::Steering::Free
                                          : project::Steering::Locked);
    appendNew(problems, mechanism.problems());
    appendNew(problems, values.problems());
    if (!mechanism) {
        return std::nullopt;
    }
    ResolvedRun run;
    run.mechanism = std::move(mechanism).value();
    appendNew(problems, whyEngineCannotRun(scenario.run.engine, run.mechanism));
    if (!values || hasCritical(problems)) {
        return std::nullopt;
    }
    static_cast<project::ScenarioValues&>(run) = *values;
    run.scenario = scenario.name;
    run.engine = scenario.run.engine;
    run.controller = scenario.controller.kind;
    run.steering = scenario.controller.steering;
    run.headingHold = scenario.controller.headingHold;
    run.bodyContacts = scenario.run.bodyContacts;
    run.seed = scenario.run.seed;
    run.joints = scenario.run.relaxedJoints ? mechanism::Model::Relaxed : mechanism::Model::Built;
    return run;
}

}  // namespace

Result<terrain::Terrain> makeScenarioTerrain(const project::Scenario& scenario,
                                             const project::ParameterValues& parameters,
                                             const project::ProjectFiles& files) {
    const auto values = project::evaluateScenario(scenario, parameters);
    if (!values) {
        return values.problems();
    }
    const auto imports = io::readTerrainFiles(scenario.terrain, files);
    if (!imports) {
        return imports.problems();
    }
    const double travel = values->speed < 0.0 ? -values->distance : values->distance;
    return terrain::makeTerrain(scenario.terrain, parameters, travel, *imports);
}

Problems checkProject(const project::Project& project, const project::ProjectFiles& files) {
    Problems problems = project::validate(project);
    if (hasCritical(problems)) {
        return problems;
    }
    const auto addNamed = [&problems](const Problems& found, const std::string& where) {
        for (Problem problem : found) {
            if (!where.empty()) {
                problem.element = where + ", " + problem.element;
            }
            appendNew(problems, {problem});
        }
    };
    std::set<std::pair<std::string, project::EngineKind>> checked;
    for (const project::Scenario& scenario : project.scenarios) {
        const auto parameters = project::evaluateParameters(project, scenario.variant);
        if (!parameters) {
            continue;  // reported above
        }
        addNamed(terrain::whyNoTerrain(scenario.terrain, *parameters),
                 Text::of("scenario {}", scenario.name));
        addNamed(io::whyNoTerrainFiles(scenario.terrain, files),
                 Text::of("scenario {}", scenario.name));
        if (!checked.insert({scenario.variant, scenario.run.engine}).second) {
            continue;  // the same rover again
        }
        if (const auto mechanism = project::resolve(project.rover, *parameters)) {
            addNamed(whyEngineCannotRun(scenario.run.engine, *mechanism),
                     scenario.variant.empty() ? "" : Text::of("variant {}", scenario.variant));
        }
    }
    return problems;
}

Result<const project::Scenario*> findScenario(const project::Project& project,
                                              const std::string& name) {
    for (const project::Scenario& scenario : project.scenarios) {
        if (scenario.name == name) {
            return &scenario;
        }
    }
    return Problem{Severity::Critical, Text::of("scenario {}", name),
                   Text::of("the project has no scenario of this name."),
                   Text::of("Use one of: {}.", scenarioNames(project))};
}

namespace {

/// What was asked for, with the scenario's own values elsewhere.
struct Asked {
    project::Scenario scenario;
    project::ParameterValues parameters;
};

Result<Asked> readRequest(const project::Project& project, const RunRequest& request) {
    const auto found = findScenario(project, request.scenario);
    if (!found) {
        return found.problems();
    }
    project::Scenario scenario = withRequest(**found, request);
    const auto parameters =
        project::evaluateParameters(project, scenario.variant, request.assignments);
    if (!parameters) {
        return parameters.problems();
    }
    return Result<Asked>({std::move(scenario), *parameters}, parameters.problems());
}

}  // namespace

Result<project::Project> asRequested(const project::Project& project, const RunRequest& request) {
    const auto found = findScenario(project, request.scenario);
    if (!found) {
        return found.problems();
    }
    project::Project result = project;
    for (project::Scenario& scenario : result.scenarios) {
        if (scenario.name == request.scenario) {
            scenario = withRequest(scenario, request);
        }
    }
    const auto variant =
        std::find_if(result.variants.begin(), result.variants.end(),
                     [&](const project::Variant& v) { return v.name == (*found)->variant; });
    for (const project::Assignment& assignment : request.assignments) {
        const project::Quantity value = project::quantityFrom(assignment.value);
        if (variant != result.variants.end()) {
            std::erase_if(variant->set, [&](const project::Override& change) {
                return change.parameter == assignment.parameter;
            });
            variant->set.push_back({assignment.parameter, value});
            continue;
        }
        for (project::Parameter& parameter : result.rover.parameters) {
            if (parameter.name == assignment.parameter) {
                parameter.value = value;
            }
        }
    }
    return result;
}

Result<ResolvedRun> evaluateRun(const project::Project& project, const RunRequest& request) {
    const auto asked = readRequest(project, request);
    if (!asked) {
        return asked.problems();
    }
    Problems problems = asked.problems();
    auto run = readRun(project, asked->scenario, asked->parameters, problems);
    if (!run) {
        return problems;
    }
    return Result<ResolvedRun>(std::move(*run), std::move(problems));
}

Result<ResolvedRun> prepareRun(const project::Project& project, const RunRequest& request) {
    const auto asked = readRequest(project, request);
    if (!asked) {
        return asked.problems();
    }
    Problems problems = asked.problems();
    auto run = readRun(project, asked->scenario, asked->parameters, problems);
    if (!run) {
        return problems;
    }
    if (run->mechanism.wheels.empty()) {
        problems.push_back({Severity::Critical, Text::of("rover {}", run->mechanism.name),
                            Text::of("it has no wheels to drive on."), Text::of("Add wheels.")});
    }
    auto terrain = makeScenarioTerrain(asked->scenario, asked->parameters, request.files);
    appendNew(problems, terrain.problems());
    if (!terrain) {
        return problems;
    }
    run->terrain = std::make_shared<const terrain::Terrain>(std::move(terrain).value());
    checkStart(*run, problems);
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<ResolvedRun>(std::move(*run), std::move(problems));
}

}  // namespace simcore::run
