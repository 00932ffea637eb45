#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <sstream>
#include <thread>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/experiment/comparison.h"
#include "simcore/experiment/ground_statics.h"
#include "simcore/experiment/worker_pool.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/experiment_journal.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/io/project_file.h"
#include "simcore/project/names.h"
#include "simcore/project/resolve.h"
#include "simcore/run/simulation.h"

namespace roversim {

using namespace simcore;
using experiment::Outcome;

namespace {

struct Options {
    std::string set;
    std::string rover;
    std::string seeds = "1..10";
    std::vector<double> frictions{0.3, 0.4, 0.5, 0.7};
    std::vector<std::string> controllers;
    std::string engine = "reduced";
    double step = 0.002;
    double assumedFriction = 0.5;
    double controlPeriod = 0.01;
    double noise = 0.0;
    std::vector<std::string> parameters;
    int jobs = 0;
    std::string folder;
    bool json = false;
};

/// "A..B", or one seed.
bool readSeeds(const std::string& text, experiment::Plan& plan) {
    std::istringstream in(text);
    std::string rest;
    if (!(in >> plan.firstSeed)) {
        return false;
    }
    plan.lastSeed = plan.firstSeed;
    in >> rest;
    if (rest.empty()) {
        return true;
    }
    std::istringstream last(rest.substr(std::min<std::size_t>(2, rest.size())));
    return rest.rfind("..", 0) == 0 && (last >> plan.lastSeed) && last.peek() == EOF;
}

std::optional<experiment::Plan> planOf(const Options& options) {
    experiment::Plan plan;
    plan.set = options.set == "profiles" ? experiment::TerrainSet::Profiles
                                         : experiment::TerrainSet::Terrains;
    if (!readSeeds(options.seeds, plan)) {
        fmt::print(stderr, "roversim: --seeds {}: give a range such as 1..40\n", options.seeds);
        return std::nullopt;
    }
    plan.frictions = options.frictions;
    for (const std::string& name : options.controllers) {
        plan.controllers.push_back(*project::fromName<project::ControllerKind>(name));
    }
    if (plan.controllers.empty()) {
        for (const std::string& name : project::allNames<project::ControllerKind>()) {
            const auto kind = *project::fromName<project::ControllerKind>(name);
            if (kind != project::ControllerKind::Manual) {
                plan.controllers.push_back(kind);
            }
        }
    }
    plan.engine = *project::fromName<project::EngineKind>(options.engine);
    plan.step = options.step;
    plan.assumedFriction = options.assumedFriction;
    plan.controlPeriod = options.controlPeriod;
    plan.noise = options.noise;
    return plan;
}

/// Progress on a terminal; one line a run elsewhere would only fill logs.
void showProgress(std::size_t done, std::size_t all) {
    if (isatty(STDERR_FILENO) != 0) {
        fmt::print(stderr, "\r{} of {} runs {}", done, all, done == all ? "\n" : "");
        std::fflush(stderr);
    }
}

/// The runs that the journal has not yet, in worker processes. False after a printed problem.
bool driveMissing(const experiment::Plan& plan, const project::Project& project,
                  const std::vector<experiment::Case>& cases, int jobs,
                  io::ExperimentJournal* journal, std::vector<Outcome>& outcomes) {
    std::vector<experiment::Case> missing;
    std::vector<std::string> tasks;
    for (const experiment::Case& what : cases) {
        if (std::none_of(outcomes.begin(), outcomes.end(),
                         [&](const Outcome& outcome) { return outcome.ran == what; })) {
            missing.push_back(what);
            tasks.push_back(io::formatCase(what));
        }
    }
    bool written = true;
    const auto finished = experiment::runInWorkers(
        {"/proc/self/exe", "worker"}, io::formatPlan(plan, project), tasks, jobs,
        [&](std::size_t task, const std::optional<std::string>& answer) {
            const auto parsed = answer ? io::parseOutcome(*answer) : std::nullopt;
            outcomes.push_back(parsed ? *parsed
                                      : experiment::notRun(missing[task], "the worker crashed"));
            showProgress(outcomes.size(), cases.size());
            written = journal == nullptr || journal->add(outcomes.back());
            return written;
        });
    printProblems("reproduce", finished.problems());
    if (!written) {
        fmt::print(stderr, "roversim: the journal cannot be written; free space and go on\n");
    }
    return finished && written;
}

void printSummary(const std::vector<Outcome>& outcomes,
                  const std::vector<experiment::Comparison>& comparisons) {
    fmt::print("{:<6}{:<10}{:<16}{:<16}{:>7}{:>7}{:>6}{:>6}{:>7}{:>16}{:>8}{:>7}{:>8}\n", "mu",
               "grounds", "controller", "rival", "pairs", "valid", "wins", "ties", "ratio", "95 %",
               "loaded", "work", "energy");
    for (const experiment::Comparison& c : comparisons) {
        const std::string interval =
            c.slip.low > 0.0 ? fmt::format("{:.2f}..{:.2f}", c.slip.low, c.slip.high) : "";
        if (c.grounds != experiment::Grounds::All && c.pairs == 0) {
            continue;
        }
        fmt::print(
            "{:<6}{:<10}{:<16}{:<16}{:>7}{:>7}{:>6}{:>6}{:>7.2f}{:>16}{:>8.2f}{:>7.2f}{:>8.2f}\n",
            c.friction, toString(c.grounds), project::nameOf(c.controller),
            project::nameOf(c.rival), c.pairs, c.valid, c.slip.wins, c.slip.ties, c.slip.meanRatio,
            interval, c.loadedSlip.meanRatio, c.work.meanRatio, c.energy.meanRatio);
    }
    bool heading = false;
    for (const Outcome& outcome : outcomes) {
        if (!outcome.completed) {
            fmt::print("{}", heading ? "" : "\nnot completed:\n");
            heading = true;
            fmt::print("  seed {} mu {} {}: {}\n", outcome.ran.seed, outcome.ran.friction,
                       project::nameOf(outcome.ran.controller), outcome.stopReason);
        }
    }
}

/// The rover with parameters set, as `roversim run --set` does.
Result<project::Project> withParameters(const project::Project& project,
                                        const experiment::Plan& plan, const experiment::Case& first,
                                        const std::vector<project::Assignment>& assignments) {
    if (const auto resolved = project::resolve(project, {}, assignments); !resolved) {
        return resolved.problems();
    }
    const auto own = experiment::projectOf(project, plan, first);
    if (!own) {
        return own.problems();
    }
    run::RunRequest request;
    request.scenario = own->scenarios.front().name;
    request.assignments = assignments;
    return run::asRequested(*own, request);
}

int reproduce(const Options& options) {
    const auto plan = planOf(options);
    if (!plan) {
        return kWrongUse;
    }
    const auto cases = experiment::casesOf(*plan);
    printProblems("reproduce", cases.problems());
    if (!cases) {
        return kWrongUse;
    }
    const std::string file =
        options.rover.empty() ? (io::examplesFolder() / "solero.rover").string() : options.rover;
    const auto assignments = parseAssignments(options.parameters);
    if (!assignments) {
        return kWrongUse;
    }
    const auto loaded = loadOrComplain(file);
    if (!loaded) {
        return kAnswerIsNo;
    }
    const auto project = withParameters(*loaded, *plan, cases->front(), *assignments);
    printProblems(file, project.problems());
    if (!project) {
        return kAnswerIsNo;
    }
    std::vector<Outcome> outcomes;
    std::optional<io::ExperimentJournal> journal;
    const std::filesystem::path folder = options.folder;
    if (!options.folder.empty()) {
        auto opened =
            io::ExperimentJournal::open(folder / (options.set + ".journal"), *plan, *project);
        printProblems(options.folder, opened.problems());
        if (!opened) {
            return kAnswerIsNo;
        }
        journal = std::move(opened).value();
        outcomes = journal->outcomes();
    }
    const int jobs = options.jobs > 0
                         ? options.jobs
                         : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    if (!driveMissing(*plan, *project, *cases, jobs, journal ? &*journal : nullptr, outcomes)) {
        return kAnswerIsNo;
    }
    // In the plan's order, whichever worker was first.
    std::vector<Outcome> sorted;
    for (const experiment::Case& what : *cases) {
        const auto found =
            std::find_if(outcomes.begin(), outcomes.end(),
                         [&](const Outcome& outcome) { return outcome.ran == what; });
        if (found != outcomes.end()) {
            sorted.push_back(*found);
        }
    }
    const auto comparisons = experiment::compare(*plan, sorted);
    if (!options.folder.empty()) {
        for (const auto& [name, text] :
             {std::pair("-runs.csv", io::runsTable(sorted)),
              std::pair("-summary.csv", io::summaryTable(comparisons))}) {
            const auto saved = io::writeFileAtomically(folder / (options.set + name), text);
            printProblems(options.folder, saved.problems());
            if (!saved) {
                return kAnswerIsNo;
            }
        }
    }
    if (options.json) {
        auto document = io::jsonDocument("roverstudio-experiment-1");
        document["rover"] = project->rover.name;
        document.update(io::toJson(*plan, sorted, comparisons));
        fmt::print("{}", io::formatJson(document));
    } else {
        printSummary(sorted, comparisons);
    }
    return kGood;
}

/// The plan in the first line, then a case a line; answers an outcome a line.
int work() {
    std::string line;
    if (!std::getline(std::cin, line)) {
        return kGood;
    }
    const auto parsed = io::parsePlan(line);
    printProblems("worker", parsed.problems());
    if (!parsed) {
        return kAnswerIsNo;
    }
    experiment::GroundStatics statics;
    while (std::getline(std::cin, line)) {
        const auto what = io::parseCase(line);
        if (!what) {
            fmt::print(stderr, "roversim: worker: {}: no case of an experiment\n", line);
            return kAnswerIsNo;
        }
        Outcome outcome = experiment::drive(parsed->project, parsed->plan, *what);
        outcome.staticFriction =
            statics.frictionRequired(parsed->project, parsed->plan, what->seed);
        fmt::print("{}\n", io::formatOutcome(outcome));
        std::fflush(stdout);
    }
    return kGood;
}

}  // namespace

void addReproduceCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand(
        "reproduce", "Compare controllers on many grounds: the paper's two sets of experiments");
    command->add_option("SET", options->set, "profiles: same left and right; terrains: full 3-D")
        ->required()
        ->check(CLI::IsMember({"profiles", "terrains"}));
    command->add_option("--rover", options->rover, "Project file; the SOLERO without it");
    command->add_option("--seeds", options->seeds, "Grounds, A..B")->capture_default_str();
    command->add_option("--mu", options->frictions, "Coefficients of friction")
        ->delimiter(',')
        ->capture_default_str();
    command->add_option("--controllers", options->controllers, "Controllers; all without it")
        ->delimiter(',')
        ->check(CLI::IsMember(project::allNames<project::ControllerKind>()));
    command->add_option("--engine", options->engine, "Engine")
        ->check(CLI::IsMember(project::allNames<project::EngineKind>()))
        ->capture_default_str();
    command->add_option("--dt", options->step, "Engine step [s]")
        ->check(CLI::Range(1e-5, 0.02))
        ->capture_default_str();
    command
        ->add_option("--assumed-mu", options->assumedFriction,
                     "Friction that controllers cap traction by; 0: no cap")
        ->check(CLI::Range(0.0, 5.0))
        ->capture_default_str();
    command->add_option("--period", options->controlPeriod, "Period of the controllers [s]")
        ->check(CLI::Range(1e-3, 0.2))
        ->capture_default_str();
    command
        ->add_option("--noise", options->noise,
                     "Noise of the sensors, in multiples of that in docs/experiments.md")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    command
        ->add_option("--set", options->parameters, "NAME=VALUE, set a parameter (may be repeated)")
        ->allow_extra_args(false);
    command->add_option("--jobs", options->jobs, "Processes at a time; as many as cores without it")
        ->check(CLI::Range(1, 1024));
    command->add_option("--csv", options->folder,
                        "Write tables to this folder, and go on with what is there");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = reproduce(*options); });
}

void addWorkerCommand(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand(
        "worker", "Drive the runs that roversim reproduce asks for on its standard input");
    command->callback([&exitCode] { exitCode = work(); });
}

}  // namespace roversim
