#pragma once

#include "simcore/io/recording.h"

namespace simcore::io {

std::string formatHeader(const RecordingHeader& header);

/// The header and where each of snapshotColumns(header.size) is in a row of frames.
struct ParsedHeader {
    RecordingHeader header;
    std::vector<int> framePositions;
    std::size_t frameColumns = 0;
};

/// Any text may be given; `source` names the file in problems.
Result<ParsedHeader> parseHeader(const std::string& text, const std::string& source);

}  // namespace simcore::io
