#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "simcore/base/result.h"

namespace simcore::io {

/// Writes all of the bytes to an open file or pipe; false, with errno, when it does not take them.
bool writeAll(int descriptor, std::string_view bytes);

/// A file that is either the old or the new one, never a part: written to a temporary file beside
/// it, flushed to disk and renamed by commit(). Without a commit() nothing changes. A file that is
/// write-protected is not replaced. Other files keep their permissions.
class AtomicFile {
  public:
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Gives the new file the permissions of `other`, if that is there.
    void copyPermissionsOf(const std::filesystem::path& other);
    /// After a failure further text is ignored; commit() reports it.
    void write(std::string_view text);
    Result<bool> commit();

  private:
    std::filesystem::path file_;
    std::filesystem::path target_;
    std::string temporary_;
    int descriptor_ = -1;
    int error_ = 0;         ///< errno of the first failure
    unsigned mode_ = 0644;  ///< permissions of the new file
    bool protected_ = false;
    bool created_ = false;
};

/// Writes `text` to `file` so that the file is either the old or the new one, never a part: a
/// temporary file beside it is written, flushed to disk and renamed. So is the folder's entry.
Result<bool> writeFileAtomically(const std::filesystem::path& file, std::string_view text);

/// All bytes of a file. Problem: there is no such regular file, or it cannot be read.
Result<std::string> readFile(const std::filesystem::path& file);

/// Copies the file to backupOf() the file that a link leads to, with the same permissions; an older
/// copy is replaced whole. Problem: the copy cannot be written; the file is as it was.
Result<bool> backUp(const std::filesystem::path& file);

/// "NAME.rover~" for "NAME.rover".
std::filesystem::path backupOf(const std::filesystem::path& file);

}  // namespace simcore::io
