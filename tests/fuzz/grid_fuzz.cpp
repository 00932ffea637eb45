// The reader of ASCII grids, and the ground made of them.
#include <sstream>

#include "simcore/io/terrain_file.h"
#include "tests/fuzz/raster_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream text{std::string(fuzz::textOf(data, size))};
    fuzz::checkRaster(simcore::io::readAsciiGrid(text, "input"),
                      simcore::project::TerrainKind::AsciiGrid);
    return 0;
}
