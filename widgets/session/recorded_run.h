#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "simcore/base/result.h"
#include "simcore/io/csv.h"
#include "simcore/io/recording.h"
#include "simcore/io/run_recorder.h"
#include "simcore/run/simulation.h"
#include "widgets/session/recording_store.h"

namespace widgets {

/// A run out of a recording, ready to be looked at.
struct RecordedRun {
    std::filesystem::path file;
    /// As recorded, with what was asked for on top of the scenario written into it.
    simcore::project::Project project;
    simcore::run::RunRequest request;  ///< with the carried files
    simcore::run::ResolvedRun settings;
    simcore::run::RunReport report;  ///< as far as it is known
    bool complete = false;           ///< the recording was written to its end, and read to it
    simcore::io::RecordingOrigin origin;
    RecordingStore store;
    std::shared_ptr<const simcore::run::Snapshot> last;  ///< a long store may have dropped it
    /// To save it as a recording: of a run that was driven here.
    std::shared_ptr<const simcore::io::RunCopy> copy;
};

/// Reads a recording through a store, block by block: it may be larger than the memory. Takes long
/// for a long one, so belongs off the GUI thread. `store` says how much is kept. `goOn` is called
/// with the part that is done [0 to 1]; null when it said no.
///
/// A problem when there is nothing to look at; warnings when the recording ends early, is damaged
/// further on, or has no ground.
simcore::Result<std::shared_ptr<RecordedRun>> loadRecording(
    const std::filesystem::path& file, const std::function<bool(double)>& goOn = {},
    RecordingStore store = RecordingStore());

}  // namespace widgets
