#include "simcore/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace simcore::io {
namespace {

Problem systemProblem(const std::filesystem::path& file, const char* what) {
    return {Severity::Critical, file.string(),
            std::string(what) + " (" + std::strerror(errno) + ").",
            "Check the folder, its permissions and the free space; the old file is untouched."};
}

}  // namespace

bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            return false;
        }
    }
    return true;
}

AtomicFile::AtomicFile(std::filesystem::path file) : file_(std::move(file)) {
    // A link is followed, so that saving through it changes the file and not the link.
    std::error_code error;
    target_ = std::filesystem::is_symlink(file_, error) ? std::filesystem::canonical(file_, error)
                                                        : file_;
    temporary_ = (target_.string().empty() ? file_.string() : target_.string()) + ".XXXXXX";
    descriptor_ = ::mkstemp(temporary_.data());
    created_ = descriptor_ >= 0;
    error_ = created_ ? 0 : errno;
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
        ::unlink(temporary_.c_str());
    }
}

void AtomicFile::write(std::string_view text) {
    if (error_ == 0 && !writeAll(descriptor_, text)) {
        error_ = errno;
    }
}

Result<bool> AtomicFile::commit() {
    if (!created_) {
        errno = error_;
        return systemProblem(file_, "cannot create a file there");
    }

    struct stat old {};

    const mode_t mode = ::stat(target_.c_str(), &old) == 0 ? old.st_mode & 0777 : 0644;
    if (error_ == 0 && (::fchmod(descriptor_, mode) != 0 || ::fsync(descriptor_) != 0)) {
        error_ = errno;
    }
    const bool closed = ::close(descriptor_) == 0;
    descriptor_ = -1;
    if (error_ != 0 || !closed || ::rename(temporary_.c_str(), target_.c_str()) != 0) {
        errno = error_ != 0 ? error_ : errno;
        Problem problem = systemProblem(file_, "cannot write the file");
        ::unlink(temporary_.c_str());
        return problem;
    }
    return true;
}

Result<bool> writeFileAtomically(const std::filesystem::path& file, std::string_view text) {
    AtomicFile writer(file);
    writer.write(text);
    return writer.commit();
}

}  // namespace simcore::io
