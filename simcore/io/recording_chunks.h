#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/project/project_files.h"

/// The bytes of a recording: a chain of chunks, each with its length and checksums.
/// docs/recordings.md defines them.
namespace simcore::io {

inline constexpr std::string_view kRecordingMagic("ROVERREC\1\0\0\0\0\0\0\0", 16);
inline constexpr std::size_t kChunkHeadSize = 40;
/// Largest unpacked table and text, and most rows of a table: bounds of what a reader takes.
inline constexpr std::uint32_t kLargestTable = 32U << 20U;
inline constexpr std::uint32_t kLargestText = 8U << 20U;
inline constexpr std::uint32_t kMostRows = 65536;

using ChunkTag = std::array<char, 4>;
inline constexpr ChunkTag kHeaderChunk{'H', 'E', 'A', 'D'};
inline constexpr ChunkTag kFileChunk{'F', 'I', 'L', 'E'};
inline constexpr ChunkTag kRowsChunk{'R', 'O', 'W', 'S'};
inline constexpr ChunkTag kFramesChunk{'F', 'R', 'A', 'M'};
inline constexpr ChunkTag kCommandsChunk{'C', 'M', 'D', 'S'};
inline constexpr ChunkTag kMarksChunk{'M', 'A', 'R', 'K'};
inline constexpr ChunkTag kReportChunk{'R', 'P', 'R', 'T'};

struct ChunkHead {
    ChunkTag tag{};
    std::uint32_t stored = 0;    ///< bytes that follow
    std::uint32_t unpacked = 0;  ///< bytes after unpacking
    std::uint32_t count = 0;     ///< rows of a table, 0 for text
    double first = 0.0;          ///< first number of the first row of a table
    double last = 0.0;           ///< first number of the last row
    std::uint32_t checksum = 0;  ///< CRC-32 of the stored bytes
};

using Table = std::vector<std::vector<double>>;

/// Head and stored bytes of a table (rows of one length, at least one) or of a text.
std::string packTable(const ChunkTag& tag, const Table& rows);
std::string packText(const ChunkTag& tag, std::string_view text);

/// A part of a carried file: its name (length in 4 bytes before it), where in the file the part
/// begins (8 bytes), and its bytes, at most kFilePart of them.
inline constexpr std::size_t kFilePart = 4U << 20U;

struct FilePart {
    std::string name;
    std::uint64_t offset = 0;
    std::string bytes;
};

std::string packFilePart(std::string_view name, std::uint64_t offset, std::string_view bytes);
/// Hands out the chunks of all carried files, until `write` says no; false then.
bool writeFileParts(const project::ProjectFiles& files,
                    const std::function<bool(std::string_view)>& write);

/// The head in these kChunkHeadSize bytes; nothing when they are no whole head.
std::optional<ChunkHead> readHead(std::string_view bytes);
bool checksumHolds(const ChunkHead& head, std::string_view stored);
/// Unpacked contents; nothing when they are not what the head says.
std::optional<Table> unpackTable(const ChunkHead& head, std::string_view stored);
std::optional<std::string> unpackText(const ChunkHead& head, std::string_view stored);
std::optional<FilePart> unpackFilePart(const ChunkHead& head, std::string_view stored);

}  // namespace simcore::io
