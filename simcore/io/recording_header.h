#pragma once

#include "simcore/io/recording.h"

namespace simcore::io {

std::string formatHeader(const RecordingHeader& header);

/// A file that the recording carries.
struct ListedFile {
    std::string name;        ///< as the project names it
    std::uint64_t size = 0;  ///< [byte]
};

/// The header and where each of snapshotColumns(header.size) is in a row of frames.
struct ParsedHeader {
    RecordingHeader header;
    std::vector<int> framePositions;
    std::size_t frameColumns = 0;
    /// Nothing when the recording is of a version that carried none.
    std::optional<std::vector<ListedFile>> files;
};

/// Any text may be given; `source` names the file in problems.
Result<ParsedHeader> parseHeader(const std::string& text, const std::string& source);

}  // namespace simcore::io
