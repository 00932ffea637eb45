#include "simcore/io/terrain_file.h"

#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "simcore/io/project_file.h"
#include "simcore/project/names.h"

namespace simcore::io {
namespace {

namespace fs = std::filesystem;
using project::TerrainKind;

constexpr std::uintmax_t kLargestFile = 256U << 20U;

bool readsFile(TerrainKind kind) {
    return kind == TerrainKind::Image || kind == TerrainKind::AsciiGrid ||
           kind == TerrainKind::Mesh;
}

Problem noFile(const project::Terrain& spec, const fs::path& folder) {
    return {Severity::Critical, "terrain " + project::nameOf(spec.kind) + ", file",
            spec.file.empty() ? "no file is given."
                              : fmt::format("there is no file '{}' in '{}'.", spec.file,
                                            folder.empty() ? "." : folder.string()),
            "Give the path of a file, relative to the project's folder or absolute."};
}

Result<std::string> bytesOf(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    if (error || size > kLargestFile) {
        return Problem{Severity::Critical, file.string(),
                       error ? "the file cannot be read." : "the file is larger than 256 MiB.",
                       error ? "Check its permissions." : "Cut or simplify it."};
    }
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(size, '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) {
        return Problem{Severity::Critical, file.string(), "the file cannot be read.",
                       "Check its permissions."};
    }
    return bytes;
}

template <class T>
void take(Result<T> read, const std::string& key, std::map<std::string, T>& into,
          Problems& problems) {
    appendNew(problems, read.problems());
    if (read) {
        into.emplace(key, std::move(read).value());
    }
}

void readInto(const project::Terrain& spec, const fs::path& folder, terrain::Imports& imports,
              Problems& problems) {
    for (const project::Terrain& part : spec.terrains) {
        readInto(part, folder, imports, problems);
    }
    if (!readsFile(spec.kind) || imports.rasters.contains(spec.file) ||
        imports.meshes.contains(spec.file)) {
        return;
    }
    const fs::path file = findTerrainFile(spec.file, folder);
    if (file.empty()) {
        appendNew(problems, {noFile(spec, folder)});
        return;
    }
    const auto text = bytesOf(file);
    appendNew(problems, text.problems());
    if (!text) {
        return;
    }
    const auto bytes = std::as_bytes(std::span(text->data(), text->size()));
    if (spec.kind == TerrainKind::Mesh) {
        const std::string extension = file.extension().string();
        take(readMesh(bytes, extension.empty() ? "" : extension.substr(1), file.string()),
             spec.file, imports.meshes, problems);
    } else if (spec.kind == TerrainKind::Image) {
        take(readPng(bytes, file.string()), spec.file, imports.rasters, problems);
    } else {
        std::istringstream stream(*text);
        take(readAsciiGrid(stream, file.string()), spec.file, imports.rasters, problems);
    }
}

}  // namespace

fs::path findTerrainFile(const std::string& text, const fs::path& folder) {
    if (text.empty()) {
        return {};
    }
    std::error_code error;
    for (const fs::path& base : {folder, examplesFolder()}) {
        const fs::path file = base / text;  // an absolute text stands alone
        if (fs::is_regular_file(file, error)) {
            return file;
        }
    }
    return {};
}

Result<terrain::Imports> readTerrainFiles(const project::Terrain& spec, const fs::path& folder) {
    terrain::Imports imports;
    Problems problems;
    readInto(spec, folder, imports, problems);
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<terrain::Imports>(std::move(imports), std::move(problems));
}

Problems whyNoTerrainFiles(const project::Terrain& spec, const fs::path& folder) {
    Problems problems;
    for (const project::Terrain& part : spec.terrains) {
        appendNew(problems, whyNoTerrainFiles(part, folder));
    }
    if (readsFile(spec.kind) && findTerrainFile(spec.file, folder).empty()) {
        appendNew(problems, {noFile(spec, folder)});
    }
    return problems;
}

}  // namespace simcore::io
