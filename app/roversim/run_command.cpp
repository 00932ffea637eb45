#include <unistd.h>

#include <iterator>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/roversim/commands.h"
#include "app/roversim/run_options.h"
#include "simcore/io/csv.h"
#include "simcore/io/json_format.h"
#include "simcore/io/mobility_json.h"
#include "simcore/io/recording.h"
#include "simcore/io/run_report_json.h"
#include "simcore/project/names.h"
#include "simcore/run/drive_script.h"
#include "simcore/run/sampler.h"
#include "simcore/run/simulation.h"

namespace roversim {

using namespace simcore;

namespace {

struct Options : RunOptions {
    std::optional<double> friction;
    std::optional<double> duration;
    std::optional<int> seed;
    std::string drive;
    std::string csv;
    std::string record;
    bool json = false;
};

/// One line on a terminal, rewritten about five times a simulated second.
class Progress {
  public:
    Progress() : shown_(isatty(STDERR_FILENO) != 0) {}

    void update(const run::Simulation& simulation) {
        const run::Snapshot& now = simulation.snapshot();
        if (!shown_ || now.time < next_) {
            return;
        }
        next_ = now.time + 0.2;
        fmt::print(stderr, "\r{:7.1f} s  {:6.3f} of {:.3g} m ", now.time, now.distance,
                   simulation.settings().distance);
        std::fflush(stderr);
    }

    ~Progress() {
        if (shown_) {
            fmt::print(stderr, "\r{:40}\r", "");
        }
    }

  private:
    bool shown_;
    double next_ = 0.0;
};

/// Drives to the end; `writer` takes the recording as it comes, and only what a table needs is
/// kept.
run::Recording drive(run::Simulation& simulation, const run::DriveScript& script,
                     io::RecordingWriter* writer, bool keepRows) {
    run::Recording recording;
    recording.channels = run::makeChannels(simulation.settings().mechanism);
    run::Sampler sampler(simulation.settings().mechanism);
    sampler.start(simulation.snapshot());
    std::vector<std::vector<double>> rows;
    std::vector<std::shared_ptr<const run::Snapshot>> frames;
    const auto pass = [&] {
        sampler.moveTo(rows, frames);
        if (writer != nullptr) {
            writer->add(rows, frames);
            if (writer->wantsMark()) {
                writer->add(
                    io::HashMark{simulation.snapshot().step, simulation.report().stateHash});
            }
        }
        if (keepRows) {
            std::move(rows.begin(), rows.end(), std::back_inserter(recording.rows));
        }
        rows.clear();
        frames.clear();
    };
    Progress progress;
    run::ManualCommand commanded;
    while (!simulation.finished()) {
        const run::ManualCommand command = run::commandAt(script, simulation.snapshot().time);
        if (command != commanded) {
            commanded = command;
            simulation.setManualCommand(command);
            if (writer != nullptr) {
                writer->add(io::TimedCommand{simulation.snapshot().step, command});
            }
        }
        simulation.step();
        sampler.take(simulation.snapshot());
        pass();
        progress.update(simulation);
    }
    sampler.finish(simulation.snapshot());
    pass();
    if (writer != nullptr) {
        writer->add(io::HashMark{simulation.snapshot().step, simulation.report().stateHash});
    }
    return recording;
}

void printTable(const run::RunReport& report) {
    fmt::print("{} on {}: {}{}\n", report.engine, report.scenario, run::toString(report.stopReason),
               report.stopDetail.empty() ? "" : " (" + report.stopDetail + ")");
    fmt::print(
        "  {:.3f} m in {:.2f} s simulated, {:.2f} s of work ({:.1f} x real time), {} steps of "
        "{:.3g} ms\n",
        report.distance, report.simTime, report.wallTime, report.rtf, report.steps,
        1e3 * report.step);
    fmt::print("  slip {:.4f} m absolute, {:.4f} m of it loaded, {:.4f} m signed\n", report.slipAbs,
               report.slipLoaded, report.slipSigned);
    fmt::print("  drive energy {:.2f} J, friction work {:.3f} J\n", report.energy,
               report.frictionWork);
    fmt::print(
        "  friction violation {:.2f} % (worst {:.0f} %), loop error {:.2g} mm, penetration {:.3f} "
        "mm\n",
        report.frictionViolationPercent, report.frictionWorstPercent, 1e3 * report.loopErrorMax,
        1e3 * report.penetrationMax);
    fmt::print(
        "  {:.2f} solves a step, {} fallbacks, {} solver messages, contact residual {:.1g} N\n",
        report.solvesPerStep, report.fallbacks, report.solverMessages, report.contactResidualMax);
    fmt::print("  least pivot ratio {:.2g}, {} divided steps; state hash {}\n",
               report.pivotRatioMin, report.dividedSteps, report.stateHash);
    for (const std::string& warning : report.warnings) {
        fmt::print("  warning: {}\n", warning);
    }
    fmt::print("\n");
    fmt::print("  {:<22}{:>11}{:>12}{:>12}{:>10}{:>13}{:>9}{:>14}\n", "wheel", "slip [mm]",
               "loaded [mm]", "signed [mm]", "load [N]", "torque [Nm]", "air [s]", "friction [J]");
    for (const run::WheelReport& wheel : report.wheels) {
        fmt::print("  {:<22}{:>11.2f}{:>12.2f}{:>12.2f}{:>10.2f}{:>13.3f}{:>9.2f}{:>14.3f}\n",
                   wheel.name, 1e3 * wheel.slipAbs, 1e3 * wheel.slipLoaded, 1e3 * wheel.slipSigned,
                   wheel.meanNormalForce, wheel.maxTorque, wheel.airTime, wheel.frictionWork);
    }
    if (!report.bodies.empty()) {
        fmt::print("\n  {:<22}{:>12}{:>12}{:>14}\n", "body on the ground", "time [s]", "force [N]",
                   "friction [J]");
    }
    for (const run::BodyReport& body : report.bodies) {
        fmt::print("  {:<22}{:>12.2f}{:>12.2f}{:>14.3f}\n", body.name, body.contactTime,
                   body.maxForce, body.frictionWork);
    }
}

int runScenario(const Options& options) {
    auto request = requestOf(options);
    if (!request) {
        return kWrongUse;
    }
    request->friction = options.friction;
    request->duration = options.duration;
    request->seed = options.seed;
    run::DriveScript script;
    if (!options.drive.empty()) {
        auto parsed = run::parseDriveScript(options.drive);
        if (!parsed) {
            printProblems("--drive", parsed.problems());
            return kWrongUse;
        }
        script = std::move(parsed).value();
    }
    const auto project = loadOrComplain(options.file);
    if (!project) {
        return kAnswerIsNo;
    }
    if (!options.record.empty()) {
        const Problems problems = io::carryFiles(*project, *request);
        printProblems(options.file, problems);
        if (hasCritical(problems)) {
            return kAnswerIsNo;
        }
    }
    auto prepared = run::prepareRun(*project, *request);
    printProblems(options.file, prepared.problems());
    if (!prepared) {
        return kAnswerIsNo;
    }
    if (prepared->controller == project::ControllerKind::Manual && !(prepared->duration > 0.0)) {
        fmt::print(stderr,
                   "roversim: nobody drives a manual run here, so it would never end: give "
                   "--duration, or another --controller\n");
        return kWrongUse;
    }
    if (prepared->controller != project::ControllerKind::Manual && !script.empty()) {
        fmt::print(stderr,
                   "roversim: --drive is for the manual controller: add --controller "
                   "manual\n");
        return kWrongUse;
    }
    run::Simulation simulation(std::move(prepared).value());
    std::unique_ptr<io::RecordingWriter> writer;
    if (!options.record.empty()) {
        auto created = io::RecordingWriter::create(
            options.record, io::recordingHeader(*project, *request, simulation.settings(),
                                                simulation.report().engine, options.file));
        printProblems(options.record, created.problems());
        if (!created) {
            return kAnswerIsNo;
        }
        writer = std::move(created).value();
    }
    const run::Recording recording = drive(simulation, script, writer.get(), !options.csv.empty());
    const run::RunReport report = simulation.report();
    bool recorded = true;
    if (writer) {
        // A run without its recording is still a run: its report is printed.
        const auto finished = writer->finish(report);
        printProblems(options.record, finished.problems());
        recorded = finished.ok();
    }
    if (!options.csv.empty()) {
        const io::RecordingOrigin origin = io::originOf(*project, *request, options.file);
        const auto saved =
            io::saveCsv(recording, simulation.settings(), report, origin, options.csv);
        printProblems(options.csv, saved.problems());
        if (!saved) {
            return kAnswerIsNo;
        }
    }
    if (options.json) {
        auto document = io::jsonDocument("roverstudio-run-1");
        document["rover"] = project->rover.name;
        document.update(io::toJson(report));
        fmt::print("{}", io::formatJson(document));
    } else {
        printTable(report);
    }
    return report.completed && recorded ? kGood : kAnswerIsNo;
}

}  // namespace

void addRunCommand(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("run", "Drive a scenario and report slip and torque");
    addRunOptions(*command, *options);
    command->add_option("--mu", options->friction, "Friction coefficient")
        ->check(CLI::Range(0.0, 5.0));
    command->add_option("--duration", options->duration, "Simulated time [s]")
        ->check(CLI::Range(1e-3, 1e5));
    command->add_option("--seed", options->seed, "Seed of random terrain");
    command->add_option("--drive", options->drive,
                        "Commands of a manual run: TIME,SPEED,TURN; ... [s, m/s, rad/s]");
    command->add_option("--csv", options->csv, "Write all channels to this file");
    command->add_option("--record", options->record, "Write a recording (.roverrec) to this file");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &exitCode] { exitCode = runScenario(*options); });
}

}  // namespace roversim
