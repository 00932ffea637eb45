#include "simcore/experiment/experiment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "simcore/base/text.h"
#include "simcore/project/names.h"
#include "simcore/project/resolve.h"

namespace simcore::experiment {
namespace {

/// Seeds in one plan: more would only fill the disk.
constexpr int kMostSeeds = 100000;

Problem wrong(const std::string& element, std::string reason, std::string remedy) {
    return {Severity::Critical, element, std::move(reason), std::move(remedy)};
}

Problems problemsOf(const Plan& plan) {
    Problems problems;
    if (plan.lastSeed < plan.firstSeed || plan.firstSeed < 0 ||
        plan.lastSeed - plan.firstSeed >= kMostSeeds) {
        problems.push_back(wrong(
            Text::of("seeds"), Text::of("{}..{} are no seeds.", plan.firstSeed, plan.lastSeed),
            Text::of("Give A..B with 0 <= A <= B, at most {} of them.", kMostSeeds)));
    }
    if (plan.frictions.empty() ||
        !std::all_of(plan.frictions.begin(), plan.frictions.end(),
                     [](double mu) { return std::isfinite(mu) && mu > 0.0 && mu <= 5.0; })) {
        problems.push_back(wrong(Text::of("friction"),
                                 Text::of("there is none to drive with, or one outside 0 to 5."),
                                 Text::of("Give coefficients such as 0.3,0.5,0.7.")));
    }
    if (plan.controllers.empty() || std::count(plan.controllers.begin(), plan.controllers.end(),
                                               project::ControllerKind::Manual) > 0) {
        problems.push_back(wrong(Text::of("controllers"),
                                 Text::of("there is none, or one that nobody drives."),
                                 Text::of("Give two or more to compare; not manual.")));
    }
    return problems;
}

}  // namespace

Result<std::vector<Case>> casesOf(const Plan& plan) {
    if (Problems problems = problemsOf(plan); !problems.empty()) {
        return problems;
    }
    std::vector<Case> cases;
    for (int seed = plan.firstSeed; seed <= plan.lastSeed; ++seed) {
        for (const double friction : plan.frictions) {
            for (const project::ControllerKind controller : plan.controllers) {
                cases.push_back({seed, friction, controller});
            }
        }
    }
    return cases;
}

Result<project::Project> projectOf(const project::Project& project, const Plan& plan,
                                   const Case& what) {
    const auto mechanism = project::resolve(project);
    if (!mechanism) {
        return mechanism.problems();
    }
    if (mechanism->wheels.empty()) {
        return wrong(Text::of("rover {}", project.rover.name),
                     Text::of("it has no wheels to drive."),
                     Text::of("Give it wheels with motors."));
    }
    double radius = 0.0;
    for (const mechanism::Wheel& wheel : mechanism->wheels) {
        radius += wheel.radius / static_cast<double>(mechanism->wheels.size());
    }
    project::Scenario scenario;
    scenario.name = fmt::format("{}-{}", toString(plan.set), what.seed);
    scenario.terrain = terrainOf(plan.set, what.seed, radius);
    scenario.soil.friction = what.friction;
    scenario.soil.rollingResistance = plan.rollingResistance;
    scenario.controller.kind = what.controller;
    scenario.controller.speed = plan.speed;
    scenario.controller.assumedFriction = plan.assumedFriction;
    scenario.controller.period = plan.controlPeriod;
    scenario.sensors = sensorsWithNoise(plan.noise);
    scenario.run.engine = plan.engine;
    scenario.run.step = plan.step;
    scenario.run.distance = plan.distance;
    scenario.run.seed = what.seed;
    project::Project own = project;
    own.scenarios = {std::move(scenario)};
    return own;
}

project::Sensors sensorsWithNoise(double factor) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    project::Sensors sensors;
    sensors.jointEncoder.noise = factor * 0.1 * kDegree;
    sensors.wheelRate.noise = factor * 0.02;
    sensors.orientation.noise = factor * 0.3 * kDegree;
    sensors.angularRate.noise = factor * 0.01;
    sensors.acceleration.noise = factor * 0.05;
    sensors.tactileForce.noise = factor * 0.5;
    sensors.tactileAngle.noise = factor * 2.0 * kDegree;
    sensors.bodySpeed.noise = factor * 0.005;
    return sensors;
}

Outcome notRun(const Case& what, std::string why) {
    Outcome outcome;
    outcome.ran = what;
    outcome.stopReason = std::move(why);
    return outcome;
}

Outcome drive(const project::Project& project, const Plan& plan, const Case& what) {
    const auto own = projectOf(project, plan, what);
    if (!own) {
        return notRun(what, toString(own.problems()));
    }
    run::RunRequest request;
    request.scenario = own->scenarios.front().name;
    auto prepared = run::prepareRun(*own, request);
    if (!prepared) {
        return notRun(what, toString(prepared.problems()));
    }
    run::Simulation simulation(std::move(prepared).value());
    while (!simulation.finished()) {
        simulation.step();
    }
    Outcome outcome =
        outcomeOf(simulation.report(), simulation.snapshot(), simulation.settings().mechanism);
    outcome.ran = what;
    return outcome;
}

Outcome outcomeOf(const run::RunReport& report, const run::Snapshot& end,
                  const mechanism::Mechanism& mechanism) {
    const auto chassis = static_cast<std::size_t>(mechanism.chassis);
    Outcome outcome;
    outcome.completed = report.completed;
    outcome.time = report.simTime;
    outcome.stopReason = run::toString(report.stopReason);
    outcome.slipAbs = report.slipAbs;
    outcome.slipLoaded = report.slipLoaded;
    outcome.slipSigned = report.slipSigned;
    outcome.frictionWork = report.frictionWork;
    outcome.energy = report.energy;
    for (const run::WheelReport& wheel : report.wheels) {
        outcome.peakTorque = std::max(outcome.peakTorque, wheel.maxTorque);
    }
    outcome.endX = end.bodies[chassis].position.x();
    outcome.endY = end.bodies[chassis].position.y();
    outcome.stateHash = report.stateHash;
    return outcome;
}

}  // namespace simcore::experiment
