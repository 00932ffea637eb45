#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/io/recording.h"
#include "simcore/io/recording_chunks.h"

namespace simcore::io {

/// Gathers what a run gives until there is enough of it to compress well, and hands out chunks.
class RecordingTables {
  public:
    /// @param write  takes whole chunks, in the order of the file
    explicit RecordingTables(std::function<void(std::string_view)> write)
        : write_(std::move(write)) {}

    void add(const std::vector<std::vector<double>>& rows,
             const std::vector<std::shared_ptr<const run::Snapshot>>& frames);
    void add(const TimedCommand& command);

    /// True when it is time for a mark: the rows so far have just been written.
    bool wantsMark() const { return markWanted_; }

    void add(const HashMark& mark);
    /// Writes what is gathered.
    void flush();
    /// The chunks that flush() would write now; nothing changes.
    std::string pending() const;

  private:
    struct Kind {
        const ChunkTag& tag;
        Table RecordingTables::*table;
    };

    /// In the order of a file.
    static const std::array<Kind, 4>& kinds();
    void write(const ChunkTag& tag, Table& table);

    std::function<void(std::string_view)> write_;
    Table rows_, frames_, commands_, marks_;
    bool markWanted_ = false;
};

/// A mark as a row of its table.
std::vector<double> toNumbers(const HashMark& mark);

}  // namespace simcore::io
