#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <span>
#include <string>

#include "simcore/base/result.h"
#include "simcore/project/project.h"
#include "simcore/project/project_files.h"
#include "simcore/terrain/imports.h"

/// Ground from and to files: the one place where terrain files are read. Readers take bytes or a
/// stream, whatever is in them: what cannot be read gives a problem that names `name`.
namespace simcore::io {

/// ESRI ASCII grid (.asc): ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize,
/// nodata_value (-9999 when not given), then heights row by row from the largest y on.
Result<terrain::Raster> readAsciiGrid(std::istream& text, const std::string& name);

/// PNG, grey values 0 to 1 at the file's depth (16 bit for ground without terraces). Colour is
/// refused; a pixel of full transparency has no ground.
Result<terrain::Raster> readPng(std::span<const std::byte> bytes, const std::string& name);

/// A mesh in a format that assimp tells from `extension`: obj, stl, ply, dae, glb, off, 3ds. All of
/// its parts, placed as the file says. Read in a process of its own, which may use 5 s and 1 GiB:
/// assimp is not proof against every broken file.
Result<terrain::TriangleMesh> readMesh(std::span<const std::byte> bytes,
                                       const std::string& extension, const std::string& name);

/// Largest file of a terrain, and all the files of one together that a recording carries [byte].
inline constexpr std::uintmax_t kLargestTerrainFile = 256U << 20U;
inline constexpr std::uintmax_t kMostCarried = 512U << 20U;

/// The file that a terrain means by its text: an absolute path, or one relative to the `folder` of
/// the project or, failing that, to the folder of the shipped projects. Empty when there is none.
std::filesystem::path findTerrainFile(const std::string& text, const std::filesystem::path& folder);

/// Reads the files of a terrain and of its parts, carried ones first.
Result<terrain::Imports> readTerrainFiles(const project::Terrain& spec,
                                          const project::ProjectFiles& files);

/// The problems of readTerrainFiles() that can be seen without reading: no such file.
Problems whyNoTerrainFiles(const project::Terrain& spec, const project::ProjectFiles& files);

/// The bytes of all files of a terrain and of its parts, for a recording to carry. A problem when
/// one cannot be read or they are more than kMostCarried.
Result<std::shared_ptr<const project::CarriedFiles>> carryTerrainFiles(
    const project::Terrain& spec, const project::ProjectFiles& files);

/// A problem for every file of a terrain that is not carried.
Problems whyNotCarried(const project::Terrain& spec, const project::CarriedFiles& carried);

/// What a written image means in metres.
struct RasterScale {
    double x0 = 0.0, y0 = 0.0;     ///< world, of the lower left point [m]
    double cell = 0.0;             ///< [m]
    double low = 0.0, high = 0.0;  ///< heights of black and white [m]
};

/// Writes the ground's mesh as .obj, .stl (binary) or .ply (binary), in m.
Result<bool> writeTerrainMesh(const terrain::Terrain& terrain, const std::filesystem::path& file);

/// Writes the highest ground at points `cell` [m] apart as .asc or .png (16 bit).
Result<RasterScale> writeTerrainRaster(const terrain::Terrain& terrain, double cell,
                                       const std::filesystem::path& file);

}  // namespace simcore::io
