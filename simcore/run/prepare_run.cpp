#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "simcore/dynamics/engine.h"
#include "simcore/project/names.h"
#include "simcore/run/simulation.h"

namespace simcore::run {
namespace {

using project::Quantity;

const project::Scenario* findScenario(const project::Project& project, const std::string& name) {
    for (const project::Scenario& scenario : project.scenarios) {
        if (scenario.name == name) {
            return &scenario;
        }
    }
    return nullptr;
}

std::string scenarioNames(const project::Project& project) {
    std::string names;
    for (const project::Scenario& scenario : project.scenarios) {
        names += (names.empty() ? "" : ", ") + scenario.name;
    }
    return names.empty() ? "none" : names;
}

/// Values and checks the numbers of one scenario.
class NumberReader {
  public:
    NumberReader(const project::ParameterValues& parameters, std::string element,
                 Problems& problems)
        : parameters_(parameters),
          element_(std::move(element)),
          problems_(problems) {}

    double operator()(const Quantity& quantity, const char* what, const char* dimension, double low,
                      double high) {
        const auto value =
            project::evaluate(quantity, parameters_, element_ + ", " + what, dimension);
        if (!value) {
            problems_.insert(problems_.end(), value.problems().begin(), value.problems().end());
            return low;
        }
        if (!(*value >= low && *value <= high)) {
            problems_.push_back(
                {Severity::Critical, element_ + ", " + what,
                 fmt::format("{:.6g} is not between {:.6g} and {:.6g}.", *value, low, high),
                 "Correct it; values are in SI unless a unit is written."});
        }
        return *value;
    }

  private:
    const project::ParameterValues& parameters_;
    std::string element_;
    Problems& problems_;
};

project::Scenario withRequest(project::Scenario scenario, const RunRequest& request) {
    if (request.controller) {
        scenario.controller.kind = *request.controller;
    }
    if (request.friction) {
        scenario.soil.friction = *request.friction;
    }
    if (request.duration) {
        scenario.run.duration = *request.duration;
    }
    if (request.step) {
        scenario.run.step = *request.step;
    }
    if (request.seed) {
        scenario.run.seed = *request.seed;
        scenario.terrain.seed = *request.seed;
    }
    return scenario;
}

/// A wheel that stands deep in an obstacle at the start would be thrown out of it.
void checkStart(const ResolvedRun& run, Problems& problems) {
    constexpr double kDeepest = 0.005;  // [m], assumed: ten times the resting depth
    contact::WheelContactFinder finder(run.mechanism, *run.terrain);
    for (const contact::Contact& contact :
         finder.find(std::vector<Pose>(run.mechanism.bodies.size()))) {
        if (contact.depth > kDeepest) {
            problems.push_back(
                {Severity::Critical,
                 "wheel " + run.mechanism.wheels[static_cast<std::size_t>(contact.wheel)].name,
                 fmt::format("it starts {:.1f} mm deep in the ground.", 1e3 * contact.depth),
                 "Start the terrain's first feature further ahead, or raise the wheel."});
        }
    }
}

std::optional<ResolvedRun> readRun(const project::Project& project,
                                   const project::Scenario& scenario, const RunRequest& request,
                                   Problems& problems) {
    const std::string element = "scenario " + scenario.name;
    std::vector<project::Override> overrides;
    for (const project::Variant& variant : project.variants) {
        if (variant.name == scenario.variant) {
            overrides = variant.set;
        }
    }
    const auto parameters =
        project::evaluateParameters(project.rover, overrides, request.assignments);
    auto mechanism = project::resolve(project, scenario.variant, request.assignments);
    problems.insert(problems.end(), mechanism.problems().begin(), mechanism.problems().end());
    if (!parameters || !mechanism) {
        return std::nullopt;
    }
    ResolvedRun run;
    run.mechanism = *mechanism;
    const Problems engineProblems = dynamics::whyOdeCannotRun(run.mechanism);
    problems.insert(problems.end(), engineProblems.begin(), engineProblems.end());

    NumberReader number(*parameters, element, problems);
    run.scenario = scenario.name;
    run.controller = scenario.controller.kind;
    run.speed = number(scenario.controller.speed, "speed", "speed", -10.0, 10.0);
    run.assumedFriction =
        number(scenario.controller.assumedFriction, "assumed friction", "ratio", 0.0, 5.0);
    run.controlPeriod = number(scenario.controller.period, "controller period", "time", 1e-4, 1.0);
    run.proportional = number(scenario.controller.proportional, "proportional gain", "", 0.0, 1e6);
    run.integral = number(scenario.controller.integral, "integral gain", "", 0.0, 1e6);
    run.derivative = number(scenario.controller.derivative, "derivative gain", "", 0.0, 1e6);
    run.friction = number(scenario.soil.friction, "friction", "ratio", 0.0, 5.0);
    run.rollingResistance =
        number(scenario.soil.rollingResistance, "rolling resistance", "ratio", 0.0, 1.0);
    run.step = number(scenario.run.step, "step", "time", 1e-5, 0.02);
    run.distance = number(scenario.run.distance, "distance", "length", 0.01, 1000.0);
    run.duration = number(scenario.run.duration, "duration", "time", 0.0, 1e5);
    run.settle = number(scenario.run.settle, "settling time", "time", 0.0, 60.0);
    run.ramp = number(scenario.run.ramp, "ramp time", "time", 0.0, 60.0);
    run.seed = scenario.run.seed;
    if (run.mechanism.wheels.empty()) {
        problems.push_back({Severity::Critical, "rover " + run.mechanism.name,
                            "it has no wheels to drive on.", "Add wheels."});
    }
    if (hasCritical(problems)) {
        return std::nullopt;
    }
    auto terrain = terrain::makeTerrain(scenario.terrain, *parameters, run.distance);
    problems.insert(problems.end(), terrain.problems().begin(), terrain.problems().end());
    if (!terrain) {
        return std::nullopt;
    }
    run.terrain = std::make_shared<const terrain::Terrain>(std::move(terrain).value());
    checkStart(run, problems);
    return run;
}

}  // namespace

Result<ResolvedRun> prepareRun(const project::Project& project, const RunRequest& request) {
    const project::Scenario* scenario = findScenario(project, request.scenario);
    if (scenario == nullptr) {
        return Problem{Severity::Critical, "scenario " + request.scenario,
                       "the project has no scenario of this name.",
                       fmt::format("Use one of: {}.", scenarioNames(project))};
    }
    Problems problems;
    auto run = readRun(project, withRequest(*scenario, request), request, problems);
    if (!run || hasCritical(problems)) {
        return problems;
    }
    return Result<ResolvedRun>(std::move(*run), std::move(problems));
}

}  // namespace simcore::run
