#pragma once

#include <string_view>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/run/simulation.h"

/// Manual driving written down: commands and when they start.
namespace simcore::run {

struct ScriptedCommand {
    double time = 0.0;  ///< [s]
    ManualCommand command;
};

/// In order of time.
using DriveScript = std::vector<ScriptedCommand>;

/// Reads "TIME,SPEED,TURN; ..." [s, m/s, rad/s], times rising from 0 or later. Problems name the
/// entry.
Result<DriveScript> parseDriveScript(std::string_view text);

/// What the script asks for at this time; nothing before its first entry.
ManualCommand commandAt(const DriveScript& script, double time);

}  // namespace simcore::run
