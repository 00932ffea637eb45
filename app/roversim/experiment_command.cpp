#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "app/roversim/run_options.h"
#include "simcore/experiment/verdict.h"
#include "simcore/io/experiment_json.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/project/names.h"

namespace roversim {

using namespace simcore;
using experiment::Less;
using experiment::Outcome;
using experiment::Verdict;

namespace {

struct Options : RunOptions {
    std::string rival;
    std::optional<double> friction;
    bool json = false;
};

std::string nameOf(const Outcome& outcome) {
    return project::nameOf(outcome.ran.controller);
}

void printMeasure(const char* name, const char* unit, double factor, double first, double second) {
    fmt::print("{:<16} {:>16.4g} {:>16.4g}  {}\n", name, factor * first, factor * second, unit);
}

/// "Slip: less with hybrid, by a factor of 1.68."
void printLess(const char* what, const Verdict::Measure& measure, const std::string& first,
               const std::string& second) {
    if (measure.less == Less::Neither) {
        fmt::print("{}: no difference.\n", what);
        return;
    }
    const bool isFirst = measure.less == Less::First;
    fmt::print("{}: less with {}, by a factor of {:.2f}.\n", what, isFirst ? first : second,
               isFirst ? measure.ratio : 1.0 / measure.ratio);
}

void print(const Outcome& first, const Outcome& second, const Verdict& verdict) {
    fmt::print("{:<16} {:>16} {:>16}\n", "", nameOf(first), nameOf(second));
    fmt::print("{:<16} {:>16} {:>16}\n", "ended", first.stopReason, second.stopReason);
    printMeasure("time", "s", 1.0, first.time, second.time);
    printMeasure("slip", "mm", 1e3, first.slipAbs, second.slipAbs);
    printMeasure("loaded slip", "mm", 1e3, first.slipLoaded, second.slipLoaded);
    printMeasure("friction work", "J", 1.0, first.frictionWork, second.frictionWork);
    printMeasure("energy", "J", 1.0, first.energy, second.energy);
    printMeasure("peak torque", "N m", 1.0, first.peakTorque, second.peakTorque);
    printMeasure("end x", "m", 1.0, first.endX, second.endX);
    printMeasure("end y", "m", 1.0, first.endY, second.endY);
    if (verdict.failed != Less::Neither) {
        fmt::print("Only {} completes.\n",
                   verdict.failed == Less::First ? nameOf(second) : nameOf(first));
    } else if (!verdict.bothCompleted) {
        fmt::print("Neither completes.\n");
    } else if (!verdict.sameWay) {
        fmt::print("They end {:.3f} m apart: they did not drive the same way.\n", verdict.apart);
    } else {
        printLess("Slip", verdict.slip, nameOf(first), nameOf(second));
        printLess("Loaded slip", verdict.loadedSlip, nameOf(first), nameOf(second));
        printLess("Energy", verdict.energy, nameOf(first), nameOf(second));
    }
}

int experimentWith(const Options& options) {
    auto request = requestOf(options);
    if (!request) {
        return kWrongUse;
    }
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    request->friction = options.friction;
    // The first controller may be left to the scenario.
    const auto settings = run::evaluateRun(*project, *request);
    if (!settings) {
        printProblems(options.file, settings.problems());
        return kAnswerIsNo;
    }
    const auto outcomes = experiment::driveEach(
        *project, *request,
        {settings->controller, *project::fromName<project::ControllerKind>(options.rival)});
    printProblems(options.file, outcomes.problems());
    if (!outcomes) {
        return kAnswerIsNo;
    }
    const Outcome& first = outcomes->front();
    const Outcome& second = outcomes->back();
    const Verdict verdict = experiment::judge(first, second);
    if (options.json) {
        auto document = io::jsonDocument("roverstudio-experiment-1");
        document["scenario"] = options.scenario;
        document.update(io::toJson(first, second, verdict));
        fmt::print("{}", io::formatJson(document));
    } else {
        print(first, second, verdict);
    }
    return verdict.bothCompleted ? kGood : kAnswerIsNo;
}

}  // namespace

void addExperimentCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "experiment", "Drive a scenario with two controllers and say which does better");
    addRunOptions(*command, *options);
    command->add_option("--against", options->rival, "The other controller")
        ->required()
        ->check(CLI::IsMember(project::allNames<project::ControllerKind>()));
    command->add_option("--mu", options->friction, "Friction instead of the scenario's")
        ->check(CLI::Range(0.01, 5.0));
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = experimentWith(*options); });
}

}  // namespace roversim
