#include "simcore/io/terrain_file.h"

#include <fstream>
#include <set>
#include <sstream>

#include "simcore/base/text.h"
#include "simcore/io/project_file.h"
#include "simcore/project/names.h"

namespace simcore::io {
namespace {

namespace fs = std::filesystem;
using project::TerrainKind;

bool readsFile(TerrainKind kind) {
    return kind == TerrainKind::Image || kind == TerrainKind::AsciiGrid ||
           kind == TerrainKind::Mesh;
}

Problem noFile(const project::Terrain& spec, const fs::path& folder) {
    return {Severity::Critical, Text::of("terrain {}, file", project::nameOf(spec.kind)),
            spec.file.empty() ? Text::of("no file is given.")
                              : Text::of("there is no file '{}' in '{}'.", spec.file,
                                         folder.empty() ? "." : folder.string()),
            Text::of("Give the path of a file, relative to the project's folder or absolute.")};
}

Result<std::string> bytesOf(const fs::path& file) {
    std::error_code error;
    const auto size = fs::file_size(file, error);
    if (error || size > kLargestTerrainFile) {
        return Problem{
            Severity::Critical, file.string(),
            error ? Text::of("the file cannot be read.")
                  : Text::of("the file is larger than 256 MiB."),
            error ? Text::of("Check its permissions.") : Text::of("Cut or simplify it.")};
    }
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(size, '\0');
    if (!stream.read(bytes.data(), static_cast<std::streamsize>(size))) {
        return Problem{Severity::Critical, file.string(), Text::of("the file cannot be read."),
                       Text::of("Check its permissions.")};
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

void readInto(const project::Terrain& spec, const project::ProjectFiles& files,
              terrain::Imports& imports, Problems& problems) {
    for (const project::Terrain& part : spec.terrains) {
        readInto(part, files, imports, problems);
    }
    if (!readsFile(spec.kind) || imports.rasters.contains(spec.file) ||
        imports.meshes.contains(spec.file)) {
        return;
    }
    fs::path file = spec.file;
    const std::string* text = files.find(spec.file);
    Result<std::string> read = std::string();
    if (text == nullptr) {
        file = findTerrainFile(spec.file, files.folder);
        if (file.empty()) {
            appendNew(problems, {noFile(spec, files.folder)});
            return;
        }
        read = bytesOf(file);
        appendNew(problems, read.problems());
        if (!read) {
            return;
        }
        text = &*read;
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

void listFiles(const project::Terrain& spec, std::set<std::string>& names) {
    for (const project::Terrain& part : spec.terrains) {
        listFiles(part, names);
    }
    if (readsFile(spec.kind)) {
        names.insert(spec.file);
    }
}

/// Bytes of a file, carried or not; 0 when it is not there.
std::uintmax_t sizeOf(const std::string& name, const project::ProjectFiles& files) {
    if (const std::string* bytes = files.find(name)) {
        return bytes->size();
    }
    std::error_code error;
    const auto size = fs::file_size(findTerrainFile(name, files.folder), error);
    return error ? 0 : size;
}

void carryInto(const project::Terrain& spec, const project::ProjectFiles& files,
               project::CarriedFiles& carried, Problems& problems) {
    for (const project::Terrain& part : spec.terrains) {
        carryInto(part, files, carried, problems);
    }
    if (!readsFile(spec.kind) || carried.contains(spec.file)) {
        return;
    }
    if (const std::string* bytes = files.find(spec.file)) {
        carried.emplace(spec.file, *bytes);
        return;
    }
    const fs::path file = findTerrainFile(spec.file, files.folder);
    auto bytes = file.empty() ? Result<std::string>(noFile(spec, files.folder)) : bytesOf(file);
    appendNew(problems, bytes.problems());
    if (bytes) {
        carried.emplace(spec.file, std::move(bytes).value());
    }
}

}  // namespace

fs::path findTerrainFile(const std::string& text, const fs::path& folder) {
    if (text.empty()) {
        return {};
    }
    std::error_code error;
    for (const fs::path& base : {folder, examplesFolder()}) {
        fs::path file = base / text;  // an absolute text stands alone
        if (fs::is_regular_file(file, error)) {
            return file;
        }
    }
    return {};
}

Result<terrain::Imports> readTerrainFiles(const project::Terrain& spec,
                                          const project::ProjectFiles& files) {
    terrain::Imports imports;
    Problems problems;
    readInto(spec, files, imports, problems);
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<terrain::Imports>(std::move(imports), std::move(problems));
}

Problems whyNoTerrainFiles(const project::Terrain& spec, const project::ProjectFiles& files) {
    Problems problems;
    for (const project::Terrain& part : spec.terrains) {
        appendNew(problems, whyNoTerrainFiles(part, files));
    }
    if (readsFile(spec.kind) && files.find(spec.file) == nullptr &&
        findTerrainFile(spec.file, files.folder).empty()) {
        appendNew(problems, {noFile(spec, files.folder)});
    }
    return problems;
}

Result<std::shared_ptr<const project::CarriedFiles>> carryTerrainFiles(
    const project::Terrain& spec, const project::ProjectFiles& files) {
    // Before any is read: they may be more than the memory.
    std::set<std::string> names;
    listFiles(spec, names);
    std::uintmax_t total = 0;
    for (const std::string& name : names) {
        total += sizeOf(name, files);
    }
    if (total > kMostCarried) {
        return Problem{Severity::Critical, Text::of("terrain {}", project::nameOf(spec.kind)),
                       Text::of("its files are {} MiB together; a recording carries {} MiB at "
                                "most.",
                                total >> 20U, kMostCarried >> 20U),
                       Text::of("Cut or simplify them, or run without recording.")};
    }
    auto carried = std::make_shared<project::CarriedFiles>();
    Problems problems;
    carryInto(spec, files, *carried, problems);
    if (hasCritical(problems)) {
        return problems;
    }
    return std::shared_ptr<const project::CarriedFiles>(std::move(carried));
}

Problems whyNotCarried(const project::Terrain& spec, const project::CarriedFiles& carried) {
    Problems problems;
    for (const project::Terrain& part : spec.terrains) {
        appendNew(problems, whyNotCarried(part, carried));
    }
    if (readsFile(spec.kind) && !carried.contains(spec.file)) {
        appendNew(problems,
                  {{Severity::Critical, Text::of("terrain {}, file", project::nameOf(spec.kind)),
                    Text::of("the recording lacks its file '{}'.", spec.file),
                    Text::of("Take another copy of the recording, or record the run again.")}});
    }
    return problems;
}

}  // namespace simcore::io
