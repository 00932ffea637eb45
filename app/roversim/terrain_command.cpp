// Writing a scenario's ground for other programs.
#include <filesystem>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/terrain_file.h"
#include "simcore/run/simulation.h"

namespace roversim {

using namespace simcore;

namespace {

struct Options {
    std::string file;
    std::string scenario;
    std::string output;
    double cell = 0.02;
    std::vector<std::string> set;
};

std::optional<terrain::Terrain> groundOf(const project::Project& project, const Options& options,
                                         const std::vector<project::Assignment>& assignments) {
    const auto scenario = run::findScenario(project, options.scenario);
    printProblems(options.file, scenario.problems());
    if (!scenario) {
        return std::nullopt;
    }
    const auto parameters = project::evaluateParameters(project, (*scenario)->variant, assignments);
    printProblems(options.file, parameters.problems());
    if (!parameters) {
        return std::nullopt;
    }
    auto terrain = run::makeScenarioTerrain(**scenario, *parameters,
                                            std::filesystem::path(options.file).parent_path());
    printProblems(options.file, terrain.problems());
    return terrain ? std::optional(std::move(terrain).value()) : std::nullopt;
}

int writeTerrain(const Options& options) {
    const auto assignments = parseAssignments(options.set);
    if (!assignments) {
        return kWrongUse;
    }
    const auto project = loadOrComplain(options.file);
    const auto terrain = project ? groundOf(*project, options, *assignments) : std::nullopt;
    if (!terrain) {
        return kAnswerIsNo;
    }
    const std::string ending = std::filesystem::path(options.output).extension().string();
    if (ending == ".asc" || ending == ".png") {
        const auto scale = io::writeTerrainRaster(*terrain, options.cell, options.output);
        printProblems(options.output, scale.problems());
        if (!scale) {
            return kAnswerIsNo;
        }
        fmt::print(
            "{}: points {:.6g} m apart from x = {:.6g} m, y = {:.6g} m; heights {:.6g} to "
            "{:.6g} m\n",
            options.output, scale->cell, scale->x0, scale->y0, scale->low, scale->high);
        if (ending == ".png") {
            fmt::print(
                "to read it: {{\"kind\": \"image\", \"height\": {}, \"cell\": {}, \"file\": "
                "\"{}\", \"origin\": [{}, {}, {}]}}\n",
                scale->high - scale->low, scale->cell, options.output, scale->x0, scale->y0,
                scale->low);
        }
        return kGood;
    }
    const auto written = io::writeTerrainMesh(*terrain, options.output);
    printProblems(options.output, written.problems());
    if (!written) {
        return kAnswerIsNo;
    }
    fmt::print("{}: {} triangles, in m, z up\n", options.output, terrain->mesh().triangles.size());
    return kGood;
}

}  // namespace

void addTerrainCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("terrain", "Write a scenario's ground to a file");
    command->add_option("FILE", options->file, "Project file (.rover)")->required();
    command->add_option("--scenario", options->scenario, "Scenario of the project")->required();
    command
        ->add_option("--output", options->output,
                     "File to write: .obj, .stl, .ply (mesh), .asc or .png (heights)")
        ->required();
    command->add_option("--cell", options->cell, "Distance of heights [m]")
        ->check(CLI::Range(0.001, 10.0))
        ->capture_default_str();
    command->add_option("--set", options->set, "NAME=VALUE, set a parameter (may be repeated)")
        ->allow_extra_args(false);
    command->callback([options, &exitCode] { exitCode = writeTerrain(*options); });
}

}  // namespace roversim
