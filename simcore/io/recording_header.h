#pragma once

#include <functional>
#include <string_view>

#include "simcore/io/recording.h"

namespace simcore::io {

/// Most parts of a kind that a recording has: far beyond any rover.
inline constexpr std::size_t kMostParts = 10000;

/// Whether a JSON text is nested deeper than any of a recording is: a parser's answer takes memory
/// by the level, and writing it out the stack.
bool tooDeep(const std::string& text);

std::string formatHeader(const RecordingHeader& header);

/// Hands out all that comes before the tables: what no reader would take is a problem instead.
/// False when `write` said no.
Result<bool> writeBeginning(const RecordingHeader& header,
                            const std::function<bool(std::string_view)>& write);

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
