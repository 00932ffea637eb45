#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/io/recording.h"
#include "simcore/run/simulation.h"

/// Recordings as comma-separated values. docs/csv.md defines the columns.
namespace simcore::io {

/// Where the numbers of a recording come from, for the file beside the table.
struct RecordingOrigin {
    std::string projectName;  ///< Rover::name
    std::string projectFile;  ///< path as the user knows it; may be empty
    std::string variant;
    project::ParameterValues parameters;           ///< values the run used [SI]
    std::vector<project::Assignment> assignments;  ///< overrides on top of the file's values
};

/// The origin of a run of this project as requested: parameters with the scenario's variant and the
/// request's overrides.
RecordingOrigin originOf(const project::Project& project, const run::RunRequest& request,
                         const std::string& projectFile);

/// The table: UTF-8, comma, LF, decimal point whatever the locale; one header row, not commented.
/// Numbers are the shortest that read back exactly; a NaN (a missing value) is an empty cell.
/// A row whose length is not that of `channels` is a caller's mistake (std::invalid_argument).
std::string formatCsv(const std::vector<run::Channel>& channels,
                      const std::vector<std::vector<double>>& rows);

/// Part of a recording for a table.
struct TableCut {
    /// Names of channels: "slip_abs_front" is one, "slip_abs" the quantity of all objects; empty:
    /// all. Time always comes first, the others in the order of the recording.
    std::vector<std::string> channels;
    /// Rows from and to these times [s], both included; nothing: from the start, to the end.
    std::optional<double> from, to;
};

/// Positions of the channels that the names mean, ascending, time first. Problems: for every name
/// that none has.
Result<std::vector<std::size_t>> chosenChannels(const std::vector<run::Channel>& channels,
                                                const std::vector<std::string>& names);

/// Writes the table of a recording file and its metadata, block by block: a recording may be larger
/// than the memory. Problems also when `cut` names unknown channels or no row lies in its times.
Result<bool> exportCsv(RecordingReader& recording, const std::string& recordingFile,
                       const std::filesystem::path& file, const TableCut& cut = {});

/// Where the metadata of a table goes: "out.csv" -> "out.json".
std::filesystem::path csvMetadataFile(const std::filesystem::path& csvFile);

/// Writes the table and its metadata, each first to a temporary file and then renamed. Problems
/// also as exportCsv() has them.
Result<bool> saveCsv(const run::Recording& recording, const run::ResolvedRun& settings,
                     const run::RunReport& report, const RecordingOrigin& origin,
                     const std::filesystem::path& file, const TableCut& cut = {});

}  // namespace simcore::io
