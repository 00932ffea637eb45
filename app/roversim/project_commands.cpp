// Loading, and the verbs that concern the project file itself.
#include <cstdio>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/io/project_file.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/resolve.h"
#include "simcore/review/review.h"
#include "simcore/review/way_review.h"
#include "simcore/run/simulation.h"

namespace roversim {

using namespace simcore;

void printProblems(const std::string& file, const Problems& problems) {
    for (const Problem& problem : problems) {
        const bool named = problem.element.find(file) != std::string::npos;
        fmt::print(stderr, "{}{}\n", named ? "" : file + ": ", toString(problem));
    }
}

std::optional<project::Project> loadOrComplain(const std::string& file) {
    auto loaded = io::loadProject(file);
    printProblems(file, loaded.problems());
    if (!loaded) {
        return std::nullopt;
    }
    return std::move(loaded).value();
}

std::optional<std::vector<project::Assignment>> parseAssignments(
    const std::vector<std::string>& texts) {
    std::vector<project::Assignment> assignments;
    for (const std::string& text : texts) {
        const std::size_t equals = text.find('=');
        if (equals == 0 || equals == std::string::npos || equals + 1 == text.size()) {
            fmt::print(stderr,
                       "roversim: --set {}: expected NAME=VALUE, e.g. --set wheel_radius=8cm\n",
                       text);
            return std::nullopt;
        }
        assignments.push_back({text.substr(0, equals), text.substr(equals + 1)});
    }
    return assignments;
}

namespace {

/// Problems of the project itself and of everything its scenarios would run.
Problems everythingWrong(const project::Project& project, const std::filesystem::path& folder) {
    Problems problems = run::checkProject(project, folder);
    if (hasCritical(problems)) {
        return problems;
    }
    for (const project::Scenario& scenario : project.scenarios) {
        run::RunRequest request;
        request.scenario = scenario.name;
        request.files = folder;
        for (Problem problem : run::prepareRun(project, request).problems()) {
            if (problem.severity == Severity::Critical) {
                problem.element = "scenario " + scenario.name + ", " + problem.element;
                problems.push_back(problem);
            }
        }
    }
    return problems;
}

/// What is unwise in a project that is not wrong.
std::vector<review::Finding> findingsOf(const project::Project& project) {
    const auto parameters = project::evaluateParameters(project.rover);
    if (!parameters) {
        return {};
    }
    const auto mechanism = project::resolve(project.rover, *parameters);
    if (!mechanism) {
        return {};
    }
    return review::review(project, *parameters, *mechanism,
                          mobility::analyse(*mechanism, mobility::Model::Built),
                          mobility::analyse(*mechanism, mobility::Model::Relaxed));
}

int validateFile(const std::string& file, bool climb, bool json) {
    auto loaded = io::loadProject(file);
    Problems problems = loaded.problems();
    std::vector<review::Finding> findings;
    if (loaded) {
        const Problems more = everythingWrong(*loaded, std::filesystem::path(file).parent_path());
        problems.insert(problems.end(), more.begin(), more.end());
        findings = findingsOf(*loaded);
        const auto folder = std::filesystem::path(file).parent_path();
        for (std::size_t i = 0; climb && i < loaded->scenarios.size(); ++i) {
            const auto ways = review::reviewWay(*loaded, loaded->scenarios[i].name, folder);
            findings.insert(findings.end(), ways.begin(), ways.end());
        }
    }
    const bool bad = hasCritical(problems);
    if (json) {
        auto document = io::jsonDocument("roverstudio-validation-1");
        document["file"] = file;
        document["valid"] = !bad;
        document["problems"] = io::toJson(problems);
        document["findings"] = nlohmann::ordered_json::array();
        for (const review::Finding& finding : findings) {
            document["findings"].push_back({{"kind", finding.kind},
                                            {"severity", toString(finding.severity)},
                                            {"element", finding.element},
                                            {"reason", finding.reason},
                                            {"remedy", finding.remedy},
                                            {"value", finding.value},
                                            {"limit", finding.limit}});
        }
        fmt::print("{}", io::formatJson(document));
    } else {
        for (const Problem& problem : problems) {
            fmt::print("{}\n", toString(problem));
        }
        for (const review::Finding& finding : findings) {
            fmt::print("{}\n", toString(review::asProblem(finding)));
        }
        fmt::print("{}: {}\n", file, bad ? "not usable" : problems.empty() ? "good" : "usable");
    }
    return bad ? kAnswerIsNo : kGood;
}

}  // namespace

void addValidateCommand(CLI::App& app, int& exitCode) {
    struct Options {
        std::string file;
        bool climb = false;
        bool json = false;
    };

    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("validate", "List everything wrong with a project");
    command->add_option("FILE", options->file, "Project file (.rover)")->required();
    command->add_flag("--climb", options->climb,
                      "Also whether friction and motors suffice for steps, stairs and rough ground "
                      "(a second each)");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] {
        exitCode = validateFile(options->file, options->climb, options->json);
    });
}

void addConvertCommand(CLI::App& app, int& exitCode) {
    struct Options {
        std::string file;
        std::string output;
    };

    auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("convert", "Write a project in RoverStudio's own layout of the file");
    command->add_option("FILE", options->file, "Project file to read")->required();
    command->add_option("OUT", options->output, "Project file to write")->required();
    command->callback([options, &exitCode] {
        const auto project = loadOrComplain(options->file);
        if (!project) {
            exitCode = kAnswerIsNo;
            return;
        }
        const auto saved = io::saveProject(*project, options->output);
        printProblems(options->output, saved.problems());
        exitCode = saved ? kGood : kAnswerIsNo;
    });
}

}  // namespace roversim
