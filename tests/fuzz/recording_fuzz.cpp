// The reader of recordings. Checksums and compression would turn nearly every changed byte away, so
// an input is taken in two ways: as the bytes of a file, or (first byte 'P') as plain chunks that
// are packed, with the right checksums, before they are read.
#include <bit>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>

#include <zlib.h>

#include "simcore/io/recording.h"
#include "simcore/io/recording_chunks.h"
#include "tests/fuzz/fuzz.h"

using namespace simcore;
using fuzz::require;

namespace {

void put(std::uint64_t value, std::size_t bytes, std::string& out) {
    for (std::size_t i = 0; i < bytes; ++i) {
        out += static_cast<char>((value >> (8 * i)) & 0xffU);
    }
}

std::uint32_t checksum(const std::string& bytes) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// Plain chunk: kind (4 bytes), rows (4), length of the contents (4), contents. As a file has it,
/// but for the numbers a reader can find out itself.
std::string packedFile(std::string_view plain) {
    std::string file(io::kRecordingMagic);
    for (fuzz::Source source(plain); !source.empty();) {
        const std::string_view tag = source.take(4);
        const auto count = static_cast<std::uint32_t>(source.number(4));
        const std::string_view contents = source.take(source.number(4));
        uLongf size = compressBound(contents.size());
        std::string stored(size, '\0');
        compress2(reinterpret_cast<Bytef*>(stored.data()), &size,
                  reinterpret_cast<const Bytef*>(contents.data()), contents.size(), 1);
        stored.resize(size);
        std::string head(tag);
        head.resize(4);
        put(stored.size(), 4, head);
        put(contents.size(), 4, head);
        put(count, 4, head);
        head.append(16, '\0');  // times of the first and last row: anything
        put(checksum(stored), 4, head);
        put(checksum(head), 4, head);
        file += head + stored;
    }
    return file;
}

void readAll(io::RecordingReader& reader) {
    for (std::size_t block = 0; block < reader.rowBlockCount(); ++block) {
        const auto rows = reader.rowBlock(block);
        require(rows || hasCritical(rows.problems()), "no block without a reason");
        for (std::size_t i = 0; rows && i < rows->size(); ++i) {
            require((*rows)[i].size() == reader.header().channels.size(), "a number a channel");
        }
    }
    const std::size_t step = 1 + reader.frameCount() / 100;
    for (std::size_t i = 0; i < reader.frameCount(); i += step) {
        const auto frame = reader.frame(i);
        require(frame || hasCritical(frame.problems()), "no frame without a reason");
        require(!frame || frame->bodies.size() == reader.header().size.bodies, "a pose a body");
    }
    const auto files = reader.readFiles();
    require(files || hasCritical(files.problems()), "no files without a reason");
    if (files && files->carried) {
        for (const auto& [name, bytes] : *files->carried) {
            require(files->find(name) == &bytes, "a carried file is found by its name");
        }
    }
    for (const io::TimedCommand& command : reader.commands()) {
        require(command.step >= 0, "a command has a step");
    }
    const run::RunReport report = reader.report();
    require(report.wheels.size() <= 10000, "a report of a rover");
    require(!reader.complete() || !reader.header().channels.empty(), "a whole file has channels");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input = fuzz::textOf(data, size);
    const std::string file =
        input.starts_with('P') ? packedFile(input.substr(1)) : std::string(input);
    const auto reader =
        io::RecordingReader::open(std::make_unique<std::istringstream>(file), "input");
    require(reader || hasCritical(reader.problems()), "no refusal without a reason");
    if (reader) {
        readAll(**reader);
    }
    return 0;
}
