#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/project/names.h"
#include "simcore/run/critical_friction.h"

namespace roversim {

using namespace simcore;

namespace {

struct Options {
    std::string file;
    std::string scenario;
    std::string controller;
    std::optional<double> distance;
    std::optional<double> height;
    std::optional<double> step;
    double low = 0.1;
    double high = 1.2;
    double tolerance = 0.005;
    std::vector<std::string> set;
    bool json = false;
};

int searchFriction(const Options& options) {
    auto assignments = parseAssignments(options.set);
    if (!assignments) {
        return kWrongUse;
    }
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    run::RunRequest request;
    request.scenario = options.scenario;
    if (!options.controller.empty()) {
        request.controller = project::fromName<project::ControllerKind>(options.controller);
    }
    request.distance = options.distance;
    request.terrainHeight = options.height;
    request.step = options.step;
    request.assignments = std::move(*assignments);
    const auto found = run::findCriticalFriction(
        *project, request, options.low, options.high, options.tolerance,
        [](double friction, bool completed) {
            fmt::print(stderr, "  {:.4f} {}\n", friction, completed ? "completes" : "fails");
        });
    printProblems(options.file, found.problems());
    if (!found) {
        return kAnswerIsNo;
    }
    if (options.json) {
        auto document = io::jsonDocument("roverstudio-critical-friction-1");
        document["scenario"] = options.scenario;
        document["fails"] = found->fails;
        document["completes"] = found->completes;
        document["runs"] = found->runs;
        fmt::print("{}", io::formatJson(document));
    } else {
        fmt::print("{} completes from a friction between {:.4f} and {:.4f} on ({} runs)\n",
                   options.scenario, found->fails, found->completes, found->runs);
    }
    return kGood;
}

}  // namespace

void addCriticalFrictionCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("critical-friction",
                                           "Find by bisection the friction that a scenario needs");
    command->add_option("FILE", options->file, "Project file (.rover)")->required();
    command->add_option("--scenario", options->scenario, "Scenario of the project")->required();
    command->add_option("--controller", options->controller, "Controller instead of the scenario's")
        ->check(CLI::IsMember(project::allNames<project::ControllerKind>()));
    command->add_option("--low", options->low, "Friction at which it fails")->capture_default_str();
    command->add_option("--high", options->high, "Friction at which it completes")
        ->capture_default_str();
    command->add_option("--tolerance", options->tolerance, "Width of the answer")
        ->capture_default_str();
    command->add_option("--distance", options->distance, "Distance that completes a run [m]")
        ->check(CLI::Range(0.01, 1000.0));
    command->add_option("--height", options->height, "Height of the terrain's obstacles [m]");
    command->add_option("--dt", options->step, "Engine step [s]")->check(CLI::Range(1e-5, 0.02));
    command->add_option("--set", options->set, "NAME=VALUE, set a parameter (may be repeated)")
        ->allow_extra_args(false);
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = searchFriction(*options); });
}

}  // namespace roversim
