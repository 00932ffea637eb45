// Verbs that take recordings.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "simcore/base/version.h"
#include "simcore/io/csv.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/io/recording.h"
#include "simcore/io/replay.h"

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

int replay(const ReplayOptions& options) {
    const auto recording = openOrComplain(options.file);
    if (!recording) {
        return kAnswerIsNo;
    }
    const io::RecordingHeader& header = recording->header();
    const auto replayed = io::replay(*recording);
    printProblems(options.file, replayed.problems());
    if (!replayed) {
        return kAnswerIsNo;
    }
    const io::ReplayResult& result = *replayed;
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

struct ExportOptions {
    std::string file;
    std::string csv;
    io::TableCut cut;
};

int exportRecording(const ExportOptions& options) {
    const auto recording = openOrComplain(options.file);
    if (!recording) {
        return kAnswerIsNo;
    }
    const auto saved = io::exportCsv(*recording, options.file, options.csv, options.cut);
    printProblems(options.csv, saved.problems());
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
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command = app.add_subcommand("export", "Write a recording as CSV");
    command->add_option("FILE", options->file, "Recording (.roverrec)")->required();
    command->add_option("CSV", options->csv, "File to write")->required();
    command
        ->add_option("--channels", options->cut.channels,
                     "Names separated by commas: slip_abs_front, or slip_abs of all wheels")
        ->delimiter(',');
    command->add_option("--from", options->cut.from, "Time of the first row [s]");
    command->add_option("--to", options->cut.to, "Time of the last row [s]");
    command->callback([options, &exitCode] { exitCode = exportRecording(*options); });
}

}  // namespace roversim
