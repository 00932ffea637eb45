// A new project from a template.
#include <algorithm>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/project_file.h"
#include "simcore/project/templates.h"
#include "simcore/project/units.h"

namespace roversim {

using namespace simcore;

namespace {

struct NewOptions {
    std::string topology;
    std::string output;
    std::vector<std::string> set;
};

std::string withUnit(double value, const std::string& unit) {
    return project::formatIn(value, unit, 4) + (unit.empty() ? "" : " " + unit);
}

void listTemplates() {
    for (const auto& file : io::templateFiles()) {
        const auto templ = io::loadProject(file);
        if (!templ) {
            continue;
        }
        fmt::print("{}: {}\n    {}\n", file.stem().string(), templ->rover.name,
                   templ->rover.description);
        for (const int place : project::mainDimensions(*templ)) {
            const auto& parameter = templ->rover.parameters[static_cast<std::size_t>(place)];
            fmt::print("    {:16} {:>10}  {} to {}: {}\n", parameter.name,
                       withUnit(parameter.value.literal(), parameter.unit),
                       project::formatIn(*parameter.minimum, parameter.unit, 4),
                       withUnit(*parameter.maximum, parameter.unit), parameter.meaning);
        }
    }
}

int makeNew(const NewOptions& options) {
    if (options.topology.empty()) {
        listTemplates();
        return kGood;
    }
    if (options.output.empty()) {
        fmt::print(stderr, "roversim: new: --output is required with a topology\n");
        return kWrongUse;
    }
    const auto files = io::templateFiles();
    const auto file = std::find_if(files.begin(), files.end(), [&](const auto& one) {
        return one.stem().string() == options.topology;
    });
    if (file == files.end()) {
        fmt::print(stderr, "roversim: there is no topology '{}'; 'roversim new' lists them\n",
                   options.topology);
        return kWrongUse;
    }
    const auto assignments = parseAssignments(options.set);
    if (!assignments) {
        return kWrongUse;
    }
    const auto templ = loadOrComplain(file->string());
    if (!templ) {
        return kAnswerIsNo;
    }
    const auto rover = project::fromTemplate(*templ, *assignments);
    printProblems(options.topology, rover.problems());
    if (!rover) {
        return kAnswerIsNo;
    }
    const auto saved = io::saveProject(*rover, options.output);
    printProblems(options.output, saved.problems());
    return saved ? kGood : kAnswerIsNo;
}

}  // namespace

void addNewCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<NewOptions>();
    CLI::App* command =
        app.add_subcommand("new", "Make a project from a template, or list the templates");
    command->add_option("TOPOLOGY", options->topology, "Template; without it all are listed");
    command->add_option("--set", options->set,
                        "Main dimension as NAME=VALUE, in SI or with a unit; repeatable");
    command->add_option("-o,--output", options->output, "Project file to write");
    command->callback([options, &exitCode] { exitCode = makeNew(*options); });
}

}  // namespace roversim
