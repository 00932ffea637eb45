#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "simcore/base/result.h"

namespace simcore::io {

/// Writes all of the bytes to an open file or pipe; false, with errno, when it does not take them.
bool writeAll(int descriptor, std::string_view bytes);

/// A file that is either the old or the new one, never a part: written to a temporary file beside
/// it, flushed to disk and renamed by commit(). Without a commit() nothing changes.
class AtomicFile {
  public:
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// After a failure further text is ignored; commit() reports it.
    void write(std::string_view text);
    Result<bool> commit();

  private:
    std::filesystem::path file_;
    std::filesystem::path target_;
    std::string temporary_;
    int descriptor_ = -1;
    int error_ = 0;  ///< errno of the first failure
    bool created_ = false;
};

/// Writes `text` to `file` so that the file is either the old or the new one, never a part: a
/// temporary file beside it is written, flushed to disk and renamed.
Result<bool> writeFileAtomically(const std::filesystem::path& file, std::string_view text);

}  // namespace simcore::io
