#pragma once

#include <filesystem>
#include <string_view>

#include "simcore/base/result.h"

namespace simcore::io {

/// Writes `text` to `file` so that the file is either the old or the new one, never a part: a
/// temporary file beside it is written, flushed to disk and renamed.
Result<bool> writeFileAtomically(const std::filesystem::path& file, std::string_view text);

}  // namespace simcore::io
