#include "simcore/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

#include "simcore/base/text.h"

namespace simcore::io {
namespace {

/// @param what  marked
Problem systemProblem(const std::filesystem::path& file, const char* what) {
    const std::string why = std::strerror(errno);  // before anything changes errno
    return {
        Severity::Critical, file.string(), Text::translated(what) + " (" + why + ").",
        Text::of(
            "Check the folder, its permissions and the free space; the old file is untouched.")};
}

/// Makes a rename last through a loss of power; the renamed file is there in any case, so that a
/// folder which cannot be flushed is no failure.
void flushFolder(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.parent_path();
    const int descriptor =
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor >= 0) {
        ::fsync(descriptor);
        ::close(descriptor);
    }
}

/// Renaming asks for the folder's permission only, and root has every one: a file without any
/// permission to write is meant to stay.
bool isProtected(const std::filesystem::path& file, const struct stat& status) {
    return (status.st_mode & 0222) == 0 || ::access(file.c_str(), W_OK) != 0;
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

    struct stat old {};

    if (::stat(target_.c_str(), &old) == 0) {
        mode_ = old.st_mode & 0777;
        protected_ = isProtected(target_, old);
        error_ = protected_ ? EACCES : 0;
        if (protected_) {
            return;
        }
    }
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

void AtomicFile::copyPermissionsOf(const std::filesystem::path& other) {
    struct stat status {};

    if (::stat(other.c_str(), &status) == 0) {
        mode_ = status.st_mode & 0777;
    }
}

void AtomicFile::write(std::string_view text) {
    if (error_ == 0 && !writeAll(descriptor_, text)) {
        error_ = errno;
    }
}

Result<bool> AtomicFile::commit() {
    errno = error_;
    if (protected_) {
        return systemProblem(file_, Text::mark("the file is read-only"));
    }
    if (!created_) {
        return systemProblem(file_, Text::mark("cannot create a file there"));
    }
    if (error_ == 0 && (::fchmod(descriptor_, mode_) != 0 || ::fsync(descriptor_) != 0)) {
        error_ = errno;
    }
    const bool closed = ::close(descriptor_) == 0;
    descriptor_ = -1;
    if (error_ != 0 || !closed || ::rename(temporary_.c_str(), target_.c_str()) != 0) {
        errno = error_ != 0 ? error_ : errno;
        Problem problem = systemProblem(file_, Text::mark("cannot write the file"));
        ::unlink(temporary_.c_str());
        return problem;
    }
    flushFolder(target_);
    return true;
}

Result<bool> writeFileAtomically(const std::filesystem::path& file, std::string_view text) {
    AtomicFile writer(file);
    writer.write(text);
    return writer.commit();
}

Result<bool> backUp(const std::filesystem::path& file) {
    std::error_code error;
    const std::filesystem::path original = std::filesystem::canonical(file, error);
    const std::filesystem::path backup = backupOf(error ? file : original);
    const auto text = readFile(file);
    if (!text) {
        return text.problems();
    }
    AtomicFile writer(backup);
    writer.copyPermissionsOf(original);
    writer.write(*text);
    return writer.commit();
}

std::filesystem::path backupOf(const std::filesystem::path& file) {
    return file.string() + "~";
}

Result<std::string> readFile(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        return Problem{Severity::Critical, file.string(), Text::of("there is no such file."),
                       Text::of("Check the path.")};
    }
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream ||
        (stream.peek() != std::ifstream::traits_type::eof() && !(text << stream.rdbuf())) ||
        stream.bad()) {
        return Problem{Severity::Critical, file.string(), Text::of("the file cannot be read."),
                       Text::of("Check its permissions.")};
    }
    return std::move(text).str();
}

}  // namespace simcore::io
