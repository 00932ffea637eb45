#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <nlohmann/json.hpp>

#include "simcore/base/text.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/json_format.h"
#include "simcore/io/recording.h"
#include "simcore/io/recording_chunks.h"
#include "simcore/io/recording_header.h"
#include "simcore/io/recording_tables.h"
#include "simcore/io/run_report_json.h"

namespace simcore::io {

struct RecordingWriter::Impl {
    std::filesystem::path file;
    std::filesystem::path partial;
    int descriptor = -1;
    Problems problems;
    RecordingTables tables{[this](std::string_view chunk) { write(chunk); }};

    void write(std::string_view bytes);
    /// @param what  marked
    void fail(const char* what);
};

void RecordingWriter::Impl::fail(const char* what) {
    const std::string why = std::strerror(errno);  // before anything changes errno
    problems.push_back(
        {Severity::Critical, file.string(),
         Text::of("{} ({}); the recording ends before the run.", Text::translated(what), why),
         Text::of("Free some space or choose another folder. What was recorded is in {}.",
                  partial.string())});
}

void RecordingWriter::Impl::write(std::string_view bytes) {
    if (problems.empty() && !writeAll(descriptor, bytes)) {
        fail(Text::mark("cannot write"));
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
        return errno == EEXIST
                   ? Problem{Severity::Critical, impl->partial.string(),
                             Text::of("an unfinished recording is there."),
                             Text::of("Another run may be writing it; else rename or remove it.")}
                   : Problem{Severity::Critical, file.string(),
                             Text::of("cannot create a file there ({}).", std::strerror(errno)),
                             Text::of("Check the folder, its permissions and the free space.")};
    }
    const auto begun = writeBeginning(header, [&](std::string_view chunk) {
        impl->write(chunk);
        return impl->problems.empty();
    });
    appendNew(impl->problems, begun.problems());
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
    impl_->tables.add(rows, frames);
}

void RecordingWriter::add(const TimedCommand& command) {
    impl_->tables.add(command);
}

bool RecordingWriter::wantsMark() const {
    return impl_->tables.wantsMark();
}

void RecordingWriter::add(const HashMark& mark) {
    impl_->tables.add(mark);
}

Result<bool> RecordingWriter::finish(const run::RunReport& report) {
    impl_->tables.flush();
    impl_->write(packText(kReportChunk, formatJson(toJson(report))));
    if (impl_->problems.empty() && ::fsync(impl_->descriptor) != 0) {
        impl_->fail(Text::mark("cannot write"));
    }
    if (::close(impl_->descriptor) != 0 && impl_->problems.empty()) {
        impl_->fail(Text::mark("cannot write"));
    }
    impl_->descriptor = -1;
    if (impl_->problems.empty() && ::rename(impl_->partial.c_str(), impl_->file.c_str()) != 0) {
        impl_->fail(Text::mark("cannot give the file its name"));
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
