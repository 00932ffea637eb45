// Verbs that take recordings.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/base/version.h"
#include "simcore/io/csv.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/io/project_file.h"
#include "simcore/io/recording.h"

namespace roversim {

using namespace simcore;

namespace {

struct ReplayOptions {
    std::string file;
    bool json = false;
};

std::unique_ptr<io::RecordingReader> openOrComplain(const std::string& file) {
    auto opened = io::RecordingReader::open(file);
    printProblems(file, opened.problems());
    return opened ? std::move(opened).value() : nullptr;
}

/// The run of a recording, from the recording alone.
std::optional<run::ResolvedRun> prepareOrComplain(const std::string& file,
                                                  const io::RecordingHeader& header) {
    const auto project = io::parseProject(header.projectText, file + " (its project)");
    printProblems(file, project.problems());
    if (!project) {
        return std::nullopt;
    }
    auto prepared = run::prepareRun(*project, header.request);
    printProblems(file, prepared.problems());
    return prepared ? std::optional(std::move(prepared).value()) : std::nullopt;
}

/// How far a run went the same way as its recording.
struct Comparison {
    long steps = 0;      ///< compared
    long sameUntil = 0;  ///< last mark that agrees
    std::string expected, found;

    bool same() const { return expected == found; }
};

/// Runs again, and stops at the first mark that differs.
Comparison runAgain(run::Simulation& simulation, const io::RecordingReader& recording) {
    Comparison comparison;
    auto command = recording.commands().begin();
    for (const io::HashMark& mark : recording.marks()) {
        while (simulation.snapshot().step < mark.step && !simulation.finished()) {
            for (; command != recording.commands().end() &&
                   command->step <= simulation.snapshot().step;
                 ++command) {
                simulation.setManualCommand(command->command);
            }
            simulation.step();
        }
        comparison.steps = simulation.snapshot().step;
        comparison.expected = mark.stateHash;
        comparison.found = comparison.steps == mark.step ? simulation.report().stateHash : "";
        if (!comparison.same()) {
            break;
        }
        comparison.sameUntil = mark.step;
    }
    return comparison;
}

int replay(const ReplayOptions& options) {
    const auto recording = openOrComplain(options.file);
    if (!recording) {
        return kAnswerIsNo;
    }
    const io::RecordingHeader& header = recording->header();
    if (recording->marks().empty()) {
        fmt::print(stderr, "{}: it ends before its first state hash: nothing can be compared\n",
                   options.file);
        return kAnswerIsNo;
    }
    auto prepared = prepareOrComplain(options.file, header);
    if (!prepared) {
        return kAnswerIsNo;
    }
    run::Simulation simulation(std::move(*prepared));
    const Comparison result = runAgain(simulation, *recording);
    if (options.json) {
        auto document = io::jsonDocument("roverstudio-replay-1");
        document["recorded_with"] = header.programVersion;
        document["scenario"] = header.request.scenario;
        document["complete"] = recording->complete();
        document["same"] = result.same();
        document["steps"] = result.steps;
        document["same_until_step"] = result.sameUntil;
        document["state_hash_recorded"] = result.expected;
        document["state_hash"] = result.found;
        fmt::print("{}", io::formatJson(document));
    } else if (result.same()) {
        fmt::print("{}: the same run, {} steps, state hash {}\n", options.file, result.steps,
                   result.found);
    } else {
        fmt::print(
            "{}: another run: state hash {} was recorded, {} came out; the same until step "
            "{}, compared at step {}\n",
            options.file, result.expected, result.found.empty() ? "an earlier end" : result.found,
            result.sameUntil, result.steps);
        if (header.programVersion != programVersion()) {
            fmt::print("  it was recorded with version {}, this is {}\n", header.programVersion,
                       programVersion());
        }
    }
    return result.same() ? kGood : kAnswerIsNo;
}

int exportRecording(const std::string& file, const std::string& csv) {
    const auto recording = openOrComplain(file);
    if (!recording) {
        return kAnswerIsNo;
    }
    const auto saved = io::exportCsv(*recording, file, csv);
    printProblems(csv, saved.problems());
    return saved ? kGood : kAnswerIsNo;
}

}  // namespace

void addReplayCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<ReplayOptions>();
    CLI::App* command =
        app.add_subcommand("replay", "Run a recording again and compare: 0 same, 1 different");
    command->add_option("FILE", options->file, "Recording (.roverrec)")->required();
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = replay(*options); });
}

void addExportCommand(CLI::App& app, int& exitCode) {
    struct Options {
        std::string file;
        std::string csv;
    };

    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("export", "Write a recording as CSV");
    command->add_option("FILE", options->file, "Recording (.roverrec)")->required();
    command->add_option("CSV", options->csv, "File to write")->required();
    command->callback(
        [options, &exitCode] { exitCode = exportRecording(options->file, options->csv); });
}

}  // namespace roversim
