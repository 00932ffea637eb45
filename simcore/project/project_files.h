#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace simcore::project {

/// Bytes of files, by the text that the project names them with: a key, never a path.
using CarriedFiles = std::map<std::string, std::string>;

/// Where the files that a project names are found: among those carried along with it, else relative
/// to its folder. A folder alone is such a place.
struct ProjectFiles {
    ProjectFiles() = default;

    // NOLINTNEXTLINE(google-explicit-constructor): nearly every project has just a folder
    ProjectFiles(std::filesystem::path folderOfProject,
                 std::shared_ptr<const CarriedFiles> carriedAlong = nullptr)
        : folder(std::move(folderOfProject)),
          carried(std::move(carriedAlong)) {}

    /// Of the project file. Empty = the working directory.
    std::filesystem::path folder;
    /// Null = none; kept while a run is recorded and as long as a recording is on show.
    std::shared_ptr<const CarriedFiles> carried;

    /// The carried bytes of a file; null when it is not carried.
    const std::string* find(const std::string& name) const {
        if (!carried) {
            return nullptr;
        }
        const auto found = carried->find(name);
        return found == carried->end() ? nullptr : &found->second;
    }

    bool operator==(const ProjectFiles&) const = default;
};

}  // namespace simcore::project
