#include "app/roversim/run_options.h"

#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/project/names.h"

namespace roversim {

using namespace simcore;

void addRunOptions(CLI::App& command, RunOptions& options) {
    command.add_option("FILE", options.file, "Project file (.rover)")->required();
    command.add_option("--scenario", options.scenario, "Scenario of the project")->required();
    command.add_option("--engine", options.engine, "Engine instead of the scenario's")
        ->check(CLI::IsMember(project::allNames<project::EngineKind>()));
    command.add_option("--controller", options.controller, "Controller instead of the scenario's")
        ->check(CLI::IsMember(project::allNames<project::ControllerKind>()));
    command.add_option("--distance", options.distance, "Distance that completes the run [m]")
        ->check(CLI::Range(0.01, 1000.0));
    command.add_option("--height", options.height, "Height of the terrain's obstacles [m]");
    command.add_option("--dt", options.step, "Engine step [s]")->check(CLI::Range(1e-5, 0.02));
    command.add_option("--joints", options.joints, "Joints instead of the scenario's")
        ->check(CLI::IsMember({"built", "relaxed"}));
    command.add_option("--set", options.set, "NAME=VALUE, set a parameter (may be repeated)")
        ->allow_extra_args(false);
}

std::optional<run::RunRequest> requestOf(const RunOptions& options) {
    auto assignments = parseAssignments(options.set);
    if (!assignments) {
        return std::nullopt;
    }
    run::RunRequest request;
    request.scenario = options.scenario;
    request.files.folder = std::filesystem::path(options.file).parent_path();
    if (!options.engine.empty()) {
        request.engine = project::fromName<project::EngineKind>(options.engine);
    }
    if (!options.controller.empty()) {
        request.controller = project::fromName<project::ControllerKind>(options.controller);
    }
    request.distance = options.distance;
    request.terrainHeight = options.height;
    request.step = options.step;
    if (!options.joints.empty()) {
        request.relaxedJoints = options.joints == "relaxed";
    }
    request.assignments = std::move(*assignments);
    return request;
}

}  // namespace roversim
