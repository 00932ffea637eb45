#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <nlohmann/json.hpp>

#include "simcore/io/atomic_file.h"
#include "simcore/io/json_format.h"
#include "simcore/io/recording.h"
#include "simcore/io/recording_chunks.h"
#include "simcore/io/recording_header.h"
#include "simcore/io/run_report_json.h"

namespace simcore::io {
namespace {

// Rows to a chunk: enough to compress well, and what an interruption costs at most (2.56 s of
// rows).
constexpr std::size_t kRowsPerChunk = 256;
constexpr std::size_t kFramesPerChunk = 128;

}  // namespace

struct RecordingWriter::Impl {
    std::filesystem::path file;
    std::filesystem::path partial;
    int descriptor = -1;
    Table rows, frames, commands, marks;
    bool markWanted = false;
    Problems problems;

    void write(std::string_view bytes);
    void writeTable(const ChunkTag& tag, Table& table);
    void writeTables();
    void writeFiles(const project::ProjectFiles& files);
    void fail(const char* what);
};

void RecordingWriter::Impl::fail(const char* what) {
    problems.push_back(
        {Severity::Critical, file.string(),
         std::string(what) + " (" + std::strerror(errno) + "); the recording ends before the run.",
         "Free some space or choose another folder. What was recorded is in " + partial.string() +
             "."});
}

void RecordingWriter::Impl::write(std::string_view bytes) {
    if (problems.empty() && !writeAll(descriptor, bytes)) {
        fail("cannot write");
    }
}

void RecordingWriter::Impl::writeTable(const ChunkTag& tag, Table& table) {
    if (!table.empty()) {
        write(packTable(tag, table));
        table.clear();
    }
}

void RecordingWriter::Impl::writeTables() {
    // Commands first: a recording that ends here can be run again up to its last row.
    writeTable(kCommandsChunk, commands);
    writeTable(kRowsChunk, rows);
    writeTable(kFramesChunk, frames);
    writeTable(kMarksChunk, marks);
}

void RecordingWriter::Impl::writeFiles(const project::ProjectFiles& files) {
    if (!files.carried) {
        return;
    }
    for (const auto& [name, bytes] : *files.carried) {
        for (std::size_t at = 0; at < bytes.size(); at += kFilePart) {
            write(packFilePart(name, at, std::string_view(bytes).substr(at, kFilePart)));
        }
    }
}

RecordingWriter::RecordingWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

RecordingWriter::~RecordingWriter() {
    if (impl_->descriptor >= 0) {
        ::close(impl_->descriptor);
    }
}

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::filesystem::path& file,
                                                                 const RecordingHeader& header) {
    auto impl = std::make_unique<Impl>();
    impl->file = file;
    impl->partial = file;
    impl->partial += ".part";
    impl->descriptor = ::open(impl->partial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (impl->descriptor < 0) {
        return errno == EEXIST ? Problem{Severity::Critical, impl->partial.string(),
                                         "an unfinished recording is there.",
                                         "Another run may be writing it; else rename or remove it."}
                               : Problem{Severity::Critical, file.string(),
                                         std::string("cannot create a file there (") +
                                             std::strerror(errno) + ").",
                                         "Check the folder, its permissions and the free space."};
    }
    impl->write(kRecordingMagic);
    impl->write(packText(kHeaderChunk, formatHeader(header)));
    impl->writeFiles(header.request.files);
    if (!impl->problems.empty()) {
        ::close(impl->descriptor);
        impl->descriptor = -1;
        ::unlink(impl->partial.c_str());
        return impl->problems;
    }
    return std::unique_ptr<RecordingWriter>(new RecordingWriter(std::move(impl)));
}

void RecordingWriter::add(const std::vector<std::vector<double>>& rows,
                          const std::vector<std::shared_ptr<const run::Snapshot>>& frames) {
    for (const auto& frame : frames) {
        impl_->frames.push_back(toNumbers(*frame));
        if (impl_->frames.size() >= kFramesPerChunk) {
            impl_->writeTable(kFramesChunk, impl_->frames);
        }
    }
    for (const std::vector<double>& row : rows) {
        impl_->rows.push_back(row);
        if (impl_->rows.size() >= kRowsPerChunk) {
            impl_->writeTables();
            impl_->markWanted = true;
        }
    }
}

void RecordingWriter::add(const TimedCommand& command) {
    impl_->commands.push_back(
        {static_cast<double>(command.step), command.command.speed, command.command.turn});
    if (impl_->commands.size() >= kRowsPerChunk) {
        impl_->writeTable(kCommandsChunk, impl_->commands);
    }
}

bool RecordingWriter::wantsMark() const {
    return impl_->markWanted;
}

void RecordingWriter::add(const HashMark& mark) {
    const std::uint64_t hash = std::stoull(mark.stateHash, nullptr, 16);
    impl_->marks.push_back({static_cast<double>(mark.step), static_cast<double>(hash >> 32U),
                            static_cast<double>(hash & 0xffffffffU)});
    impl_->writeTable(kMarksChunk, impl_->marks);
    impl_->markWanted = false;
}

Result<bool> RecordingWriter::finish(const run::RunReport& report) {
    impl_->writeTables();
    impl_->write(packText(kReportChunk, formatJson(toJson(report))));
    if (impl_->problems.empty() && ::fsync(impl_->descriptor) != 0) {
        impl_->fail("cannot write");
    }
    if (::close(impl_->descriptor) != 0 && impl_->problems.empty()) {
        impl_->fail("cannot write");
    }
    impl_->descriptor = -1;
    if (impl_->problems.empty() && ::rename(impl_->partial.c_str(), impl_->file.c_str()) != 0) {
        impl_->fail("cannot give the file its name");
    }
    if (!impl_->problems.empty()) {
        return impl_->problems;
    }
    return true;
}

const Problems& RecordingWriter::problems() const {
    return impl_->problems;
}

}  // namespace simcore::io
