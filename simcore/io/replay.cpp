#include "simcore/io/replay.h"

#include <algorithm>

#include "simcore/base/text.h"
#include "simcore/io/project_file.h"
#include "simcore/io/terrain_file.h"

namespace simcore::io {
namespace {

// Steps between two questions whether to go on: some 10 ms of work.
constexpr long kStepsPerQuestion = 50;

ReplayResult runAgain(run::Simulation& simulation, const RecordingReader& recording,
                      const std::function<bool(double)>& goOn) {
    ReplayResult result;
    const auto last = static_cast<double>(std::max(1L, recording.marks().back().step));
    auto command = recording.commands().begin();
    for (const HashMark& mark : recording.marks()) {
        while (simulation.snapshot().step < mark.step && !simulation.finished()) {
            const long step = simulation.snapshot().step;
            if (goOn && step % kStepsPerQuestion == 0 && !goOn(static_cast<double>(step) / last)) {
                result.stopped = true;
                return result;
            }
            for (; command != recording.commands().end() && command->step <= step; ++command) {
                simulation.setManualCommand(command->command);
            }
            simulation.step();
        }
        result.steps = simulation.snapshot().step;
        result.expected = mark.stateHash;
        result.found = result.steps == mark.step ? simulation.report().stateHash : "";
        if (!result.same()) {
            break;
        }
        result.sameUntil = mark.step;
    }
    return result;
}

}  // namespace

Result<run::ResolvedRun> prepareRecorded(RecordingReader& recording) {
    const RecordingHeader& header = recording.header();
    const auto project = parseProject(header.projectText, Text::of("the recorded project"));
    if (!project) {
        return project.problems();
    }
    auto files = recording.readFiles();
    if (!files) {
        return files.problems();
    }
    run::RunRequest request = header.request;
    request.files = std::move(files).value();
    const auto scenario = run::findScenario(*project, request.scenario);
    if (!scenario) {
        return scenario.problems();
    }
    if (request.files.carried) {
        const Problems missing = whyNotCarried((*scenario)->terrain, *request.files.carried);
        if (!missing.empty()) {
            return missing;
        }
    }
    return run::prepareRun(*project, request);
}

Result<ReplayResult> replay(RecordingReader& recording, const std::function<bool(double)>& goOn) {
    if (recording.marks().empty()) {
        return Problem{Severity::Critical, Text::of("recording"),
                       Text::of("it ends before its first state hash: nothing can be compared."),
                       Text::of("Record at least 2.56 s, or let the run end.")};
    }
    try {
        auto prepared = prepareRecorded(recording);
        if (!prepared) {
            return prepared.problems();
        }
        run::Simulation simulation(std::move(prepared).value());
        return runAgain(simulation, recording, goOn);
    } catch (const std::exception& error) {
        return Problem{Severity::Critical, Text::of("recording"),
                       Text::of("its run cannot be made again ({}).", error.what()),
                       Text::of("Check the rover's masses, joints and wheels.")};
    }
}

}  // namespace simcore::io
