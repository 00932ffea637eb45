#include "simcore/io/run_recorder.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>

#include "simcore/base/text.h"
#include "simcore/io/atomic_file.h"
#include "simcore/io/json_format.h"
#include "simcore/io/recording_header.h"
#include "simcore/io/recording_tables.h"
#include "simcore/io/run_report_json.h"

namespace simcore::io {

class PrivateFile {
  public:
    /// errno says why it is not open.
    explicit PrivateFile(const std::filesystem::path& folder)
        : descriptor_(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600)) {
        if (descriptor_ < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {
            // A file system that has no files without names.
            std::string name = (folder / "run.XXXXXX").string();
            descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
            if (descriptor_ >= 0) {
                ::unlink(name.c_str());
            }
        }
    }

    ~PrivateFile() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
    }

    PrivateFile(const PrivateFile&) = delete;
    PrivateFile& operator=(const PrivateFile&) = delete;

    bool isOpen() const { return descriptor_ >= 0; }

    bool append(std::string_view bytes) { return writeAll(descriptor_, bytes); }

    /// Space left on its disk [byte]; nothing when that is not known.
    std::optional<std::uint64_t> spaceLeft() const {
        struct statvfs disk {};

        return ::fstatvfs(descriptor_, &disk) == 0
                   ? std::optional(std::uint64_t{disk.f_bavail} * disk.f_frsize)
                   : std::nullopt;
    }

    /// All of `count` bytes; false when they are not there.
    bool read(std::uint64_t offset, std::size_t count, std::string& bytes) const {
        bytes.resize(count);
        for (std::size_t have = 0; have < count;) {
            const ssize_t got = ::pread(descriptor_, bytes.data() + have, count - have,
                                        static_cast<off_t>(offset + have));
            if (got == 0 || (got < 0 && errno != EINTR)) {
                return false;
            }
            have += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
        }
        return true;
    }

  private:
    int descriptor_;
};

Result<bool> RunCopy::save(const std::filesystem::path& file,
                           const std::function<bool(double)>& goOn) const {
    try {
        return recording_.empty() ? write(file, goOn) : copyRecording(file, goOn);
    } catch (const std::exception& error) {
        return Problem{Severity::Critical, file.string(),
                       Text::of("the recording cannot be written ({}).", error.what()),
                       Text::of("Close other programs if there is no memory left.")};
    }
}

RunCopy RunCopy::ofRecording(std::filesystem::path recording) {
    RunCopy copy;
    copy.recording_ = std::move(recording);
    return copy;
}

Result<bool> RunCopy::copyRecording(const std::filesystem::path& file,
                                    const std::function<bool(double)>& goOn) const {
    std::error_code error;
    if (std::filesystem::equivalent(recording_, file, error)) {
        return true;  // it is there
    }
    const auto unreadable = [this] {
        return Problem{Severity::Critical, recording_.string(),
                       Text::of("the recording cannot be read."),
                       Text::of("Check that the file is still there.")};
    };
    const auto total = static_cast<double>(std::filesystem::file_size(recording_, error));
    std::ifstream in(recording_, std::ios::binary);
    if (error || !in) {
        return unreadable();
    }
    AtomicFile out(file);
    std::string piece(1U << 20U, '\0');
    for (double done = 0.0;
         in.read(piece.data(), static_cast<std::streamsize>(piece.size())), in.gcount() > 0;) {
        out.write(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount())));
        done += static_cast<double>(in.gcount());
        if (goOn && !goOn(std::min(1.0, done / std::max(1.0, total)))) {
            return false;
        }
    }
    if (in.bad()) {
        return unreadable();
    }
    return out.commit();
}

Result<bool> RunCopy::write(const std::filesystem::path& file,
                            const std::function<bool(double)>& goOn) const {
    constexpr std::size_t kPiece = 1U << 20U;
    std::uint64_t total = size_, done = 0;
    if (const auto& carried = header_.request.files.carried) {
        for (const auto& [name, bytes] : *carried) {
            total += bytes.size();
        }
    }
    AtomicFile out(file);
    const auto pass = [&](std::string_view bytes) {
        if (goOn && !goOn(std::min(1.0, static_cast<double>(done) / static_cast<double>(total)))) {
            return false;
        }
        out.write(bytes);
        done += bytes.size();
        return true;
    };
    auto begun = writeBeginning(header_, pass);
    if (!begun || !*begun) {
        return begun;
    }
    std::string piece;
    for (std::uint64_t at = 0; at < size_; at += piece.size()) {
        if (!tables_->read(at, std::min<std::uint64_t>(kPiece, size_ - at), piece)) {
            return Problem{Severity::Critical, file.string(),
                           Text::of("the run's recording is no longer there."),
                           Text::of("Free some space on the disk and run again.")};
        }
        if (!pass(piece)) {
            return false;
        }
    }
    out.write(rest_);
    return out.commit();
}

struct RunRecorder::Impl {
    std::filesystem::path folder;
    RecordingHeader header;
    std::uint64_t keepFree = 0;
    std::shared_ptr<PrivateFile> file;
    std::uint64_t size = 0;
    std::unique_ptr<RecordingTables> tables;
    std::optional<Problem> failure;
};

RunRecorder::RunRecorder(std::filesystem::path folder, RecordingHeader header,
                         std::uint64_t keepFree)
    : impl_(std::make_unique<Impl>()) {
    impl_->folder = std::move(folder);
    impl_->header = std::move(header);
    impl_->keepFree = keepFree;
}

RunRecorder::~RunRecorder() = default;

void RunRecorder::restart() {
    Impl& s = *impl_;
    const auto giveUp = [this](const std::string& why) {
        impl_->failure =
            Problem{Severity::Critical, Text::of("recording of the run"),
                    Text::of("{}; it was given up.", why),
                    Text::of("Free some space in {} and run again.", impl_->folder.string())};
        impl_->file.reset();  // a copy that is being saved may still hold it
        failed_ = true;
    };
    s.failure.reset();
    failed_ = false;
    s.size = 0;
    std::error_code error;
    std::filesystem::create_directories(s.folder, error);
    s.file = std::make_shared<PrivateFile>(s.folder);
    if (!s.file->isOpen()) {
        giveUp(Text::of("no file can be made ({})", std::strerror(errno)));
    }
    s.tables = std::make_unique<RecordingTables>([this, giveUp](std::string_view chunk) {
        Impl& now = *impl_;
        if (now.failure) {
            return;
        }
        const auto left = now.file->spaceLeft();
        if (left && *left < now.keepFree + chunk.size()) {
            giveUp(Text::of("less than {} MiB of the disk are free", now.keepFree >> 20U));
        } else if (!now.file->append(chunk)) {
            giveUp(Text::of("it cannot be written ({})", std::strerror(errno)));
        } else {
            now.size += chunk.size();
        }
    });
}

void RunRecorder::add(const std::vector<std::vector<double>>& rows,
                      const std::vector<std::shared_ptr<const run::Snapshot>>& frames) {
    if (!failed_) {
        impl_->tables->add(rows, frames);
    }
}

void RunRecorder::add(long step, const run::ManualCommand& command) {
    if (!failed_) {
        impl_->tables->add(TimedCommand{step, command});
    }
}

bool RunRecorder::wantsMark() const {
    return !failed_ && impl_->tables->wantsMark();
}

void RunRecorder::mark(long step, const std::string& stateHash) {
    if (!failed_ && !stateHash.empty()) {  // a failed simulation has none
        impl_->tables->add(HashMark{step, stateHash});
    }
}

Result<RunCopy> RunRecorder::copy(const run::RunReport& report) const {
    if (impl_->failure) {
        return *impl_->failure;
    }
    if (!impl_->tables) {
        return Problem{Severity::Critical, Text::of("recording of the run"),
                       Text::of("the run never began."),
                       Text::of("Check the rover's masses, joints and wheels.")};
    }
    RunCopy copy;
    copy.header_ = impl_->header;
    copy.header_.engine = report.engine;
    copy.tables_ = impl_->file;
    copy.size_ = impl_->size;
    copy.rest_ = impl_->tables->pending();
    if (!report.stateHash.empty()) {
        copy.rest_ += packTable(kMarksChunk, {toNumbers(HashMark{report.steps, report.stateHash})});
    }
    copy.rest_ += packText(kReportChunk, formatJson(toJson(report)));
    return copy;
}

}  // namespace simcore::io
