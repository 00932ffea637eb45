#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What each library may link, over the whole closure of its links.
namespace boundary {

enum class Toolkit { Qt, OpenSceneGraph, OpenGL };

/// The names that are (a part of) one of the toolkits: "Qt6::Core", "/usr/lib/libosg.so", "-lGL".
std::vector<std::string> linksOf(const std::vector<std::string>& names,
                                 const std::vector<Toolkit>& toolkits);

/// Lines of a text file; std::runtime_error when it cannot be read.
std::vector<std::string> readLines(const std::filesystem::path& file);

/// Shared libraries that the loader finds for a program or library (`ldd`).
std::vector<std::string> sharedLibrariesOf(const std::filesystem::path& program);

}  // namespace boundary
