#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/result.h"
#include "simcore/project/edit.h"
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

/// The text by which parts of a project travel over the clipboard: JSON, like a project file.
std::string formatParts(const project::Parts& parts);

/// Parts from such a text; problems when it is something else.
Result<project::Parts> parseParts(std::string_view text);

/// Folder of the shipped projects (beside the program, or the source tree's assets when built
/// there).
std::filesystem::path examplesFolder();

/// Files of the shipped templates for new rovers, those with the fewest bodies first; none that
/// cannot be read.
std::vector<std::filesystem::path> templateFiles();

}  // namespace simcore::io
