#include "simcore/io/recording_tables.h"

namespace simcore::io {
namespace {

// Rows to a chunk: enough to compress well, and what an interruption costs at most (2.56 s of
// rows).
constexpr std::size_t kRowsPerChunk = 256;
constexpr std::size_t kFramesPerChunk = 128;

}  // namespace

std::vector<double> toNumbers(const HashMark& mark) {
    const std::uint64_t hash = std::stoull(mark.stateHash, nullptr, 16);
    return {static_cast<double>(mark.step), static_cast<double>(hash >> 32U),
            static_cast<double>(hash & 0xffffffffU)};
}

void RecordingTables::write(const ChunkTag& tag, Table& table) {
    if (!table.empty()) {
        write_(packTable(tag, table));
        table.clear();
    }
}

const std::array<RecordingTables::Kind, 4>& RecordingTables::kinds() {
    // Commands first: a recording that ends here can be run again up to its last row.
    static const std::array<Kind, 4> kinds{{{kCommandsChunk, &RecordingTables::commands_},
                                            {kRowsChunk, &RecordingTables::rows_},
                                            {kFramesChunk, &RecordingTables::frames_},
                                            {kMarksChunk, &RecordingTables::marks_}}};
    return kinds;
}

void RecordingTables::flush() {
    for (const Kind& kind : kinds()) {
        write(kind.tag, this->*kind.table);
    }
}

std::string RecordingTables::pending() const {
    std::string chunks;
    for (const Kind& kind : kinds()) {
        const Table& table = this->*kind.table;
        if (!table.empty()) {
            chunks += packTable(kind.tag, table);
        }
    }
    return chunks;
}

void RecordingTables::add(const std::vector<std::vector<double>>& rows,
                          const std::vector<std::shared_ptr<const run::Snapshot>>& frames) {
    for (const auto& frame : frames) {
        frames_.push_back(toNumbers(*frame));
        if (frames_.size() >= kFramesPerChunk) {
            write(kFramesChunk, frames_);
        }
    }
    for (const std::vector<double>& row : rows) {
        rows_.push_back(row);
        if (rows_.size() >= kRowsPerChunk) {
            flush();
            markWanted_ = true;
        }
    }
}

void RecordingTables::add(const TimedCommand& command) {
    commands_.push_back(
        {static_cast<double>(command.step), command.command.speed, command.command.turn});
    if (commands_.size() >= kRowsPerChunk) {
        write(kCommandsChunk, commands_);
    }
}

void RecordingTables::add(const HashMark& mark) {
    marks_.push_back(toNumbers(mark));
    write(kMarksChunk, marks_);
    markWanted_ = false;
}

}  // namespace simcore::io
