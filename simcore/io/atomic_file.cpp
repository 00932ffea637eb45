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

bool writeAll(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0) {
            if (errno == EINTR) {
                continue;
            }
            return false;
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

}  // namespace

Result<bool> writeFileAtomically(const std::filesystem::path& file, std::string_view text) {
    // A link is followed, so that saving through it changes the file and not the link.
    std::error_code error;
    const std::filesystem::path target =
        std::filesystem::is_symlink(file, error) ? std::filesystem::canonical(file, error) : file;
    std::string temporary = (target.string().empty() ? file.string() : target.string()) + ".XXXXXX";
    const int descriptor = ::mkstemp(temporary.data());
    if (descriptor < 0) {
        return systemProblem(file, "cannot create a file there");
    }

    struct stat old {};

    const mode_t mode = ::stat(target.c_str(), &old) == 0 ? old.st_mode & 0777 : 0644;
    const bool written =
        writeAll(descriptor, text) && ::fchmod(descriptor, mode) == 0 && ::fsync(descriptor) == 0;
    const int writeError = errno;
    const bool closed = ::close(descriptor) == 0;
    if (!written || !closed || ::rename(temporary.c_str(), target.c_str()) != 0) {
        errno = written ? errno : writeError;
        Problem problem = systemProblem(file, "cannot write the file");
        ::unlink(temporary.c_str());
        return problem;
    }
    return true;
}

}  // namespace simcore::io
