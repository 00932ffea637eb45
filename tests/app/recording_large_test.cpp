// A recording of more than 4 GiB, as a sparse file: chunks that are passed over, then rows.
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "simcore/io/recording.h"
#include "simcore/io/recording_chunks.h"
#include "simcore/io/recording_header.h"

namespace simcore::io {
namespace {

void putWord(std::string& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[at + i] = static_cast<char>((value >> (8 * i)) & 0xffU);
    }
}

/// Head of a chunk of an unknown kind with `stored` bytes.
std::string headOfGap(std::uint32_t stored) {
    std::string head = packTable({'G', 'A', 'P', 'S'}, {{0.0}}).substr(0, kChunkHeadSize);
    putWord(head, 4, stored);
    putWord(head, 8, kLargestTable);
    putWord(head, 36,
            static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(head.data()), 36)));
    return head;
}

TEST(LargeRecording, OffsetsBeyondFourGibibytes) {
    const auto file = std::filesystem::path(::testing::TempDir()) / "large.roverrec";
    RecordingHeader header;
    header.channels = {{"time", "", "Time", "t", "s", "Time."}};
    const std::vector<double> row{42.5};
    {
        std::ofstream out(file, std::ios::binary);
        out << kRecordingMagic << packText(kHeaderChunk, formatHeader(header));
        for (int i = 0; i < 140; ++i) {
            out << headOfGap(kLargestTable);
            out.seekp(kLargestTable, std::ios::cur);
        }
        out << packTable(kRowsChunk, {row}) << packText(kReportChunk, "{}");
        ASSERT_TRUE(out);
    }
    EXPECT_GT(std::filesystem::file_size(file), std::uintmax_t{4} << 30U);
    auto reader = RecordingReader::open(file);
    std::filesystem::remove(file);  // the open file stays readable
    ASSERT_TRUE(reader) << toString(reader.problems());
    EXPECT_TRUE((*reader)->complete());
    ASSERT_EQ((*reader)->rowBlockCount(), 1U);
    const auto rows = (*reader)->rowBlock(0);
    ASSERT_TRUE(rows);
    EXPECT_EQ(rows->at(0), row);
}

}  // namespace
}  // namespace simcore::io
