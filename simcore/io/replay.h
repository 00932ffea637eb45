#pragma once

#include <functional>
#include <string>

#include "simcore/base/result.h"
#include "simcore/io/recording.h"

/// A recorded run made again.
namespace simcore::io {

/// The run of a recording, from the recording alone. A problem when its project or its files cannot
/// be read, or a file of the ground is not in it.
Result<run::ResolvedRun> prepareRecorded(RecordingReader& recording);

/// How far a run went the same way as its recording.
struct ReplayResult {
    long steps = 0;        ///< compared
    long sameUntil = 0;    ///< last mark that agrees
    std::string expected;  ///< state hash of the last mark compared
    std::string found;     ///< the same of the new run; empty when that ended earlier
    bool stopped = false;  ///< by `goOn`

    bool same() const { return expected == found && !stopped; }
};

/// Runs a recording again with the recorded commands at their steps, and compares the state hash at
/// every mark; stops at the first that differs, or when `goOn`, called with the part that is done
/// [0 to 1], says no. A problem when there is nothing to compare, or the run cannot be made.
Result<ReplayResult> replay(RecordingReader& recording,
                            const std::function<bool(double)>& goOn = {});

}  // namespace simcore::io
