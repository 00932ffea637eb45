#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "simcore/base/result.h"
#include "simcore/project/project.h"

/// Reading and writing `.rover` files (JSON). The only place that knows their syntax.
namespace simcore::io {

/// Parses the text of a project file. Problems carry line and column, or the JSON place.
Result<project::Project> parseProject(std::string_view text, const std::string& sourceName);

/// Reads and parses a file.
Result<project::Project> loadProject(const std::filesystem::path& file);

/// The text of a project file: stable key order, shortest numbers that read back exactly.
std::string formatProject(const project::Project& project);

/// Writes to a temporary file, flushes, renames: the old file is whole until the new one is.
Result<bool> saveProject(const project::Project& project, const std::filesystem::path& file);

/// Folder of the shipped projects (beside the program, or the source tree's assets when built
/// there).
std::filesystem::path examplesFolder();

}  // namespace simcore::io
