// The reader of images, and the ground made of them. Checksums and compression would turn nearly
// every changed byte away, so an input is taken in two ways: as the bytes of a file, or (first byte
// 'P') as plain chunks that get their checksums, the pixels compressed, before they are read.
#include <span>
#include <string>

#include <zlib.h>

#include "simcore/io/terrain_file.h"
#include "tests/fuzz/raster_checks.h"

namespace {

void putBigEndian(std::uint32_t value, std::string& out) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        out += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xffU);
    }
}

std::string compressed(std::string_view bytes) {
    uLongf size = compressBound(bytes.size());
    std::string out(size, '\0');
    compress2(reinterpret_cast<Bytef*>(out.data()), &size,
              reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 1);
    out.resize(size);
    return out;
}

/// Plain chunk: kind (4 bytes), length (4, least first), contents.
std::string packedFile(std::string_view plain) {
    std::string file("\x89PNG\r\n\x1a\n");
    for (fuzz::Source source(plain); !source.empty();) {
        std::string chunk(source.take(4));
        const bool pixels = chunk == "IDAT";
        const std::string_view contents = source.take(source.number(4));
        chunk += pixels ? compressed(contents) : std::string(contents);
        putBigEndian(static_cast<std::uint32_t>(chunk.size() < 4 ? 0 : chunk.size() - 4), file);
        file += chunk;
        putBigEndian(
            static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(chunk.data()),
                                             static_cast<uInt>(chunk.size()))),
            file);
    }
    return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input = fuzz::textOf(data, size);
    const std::string file =
        input.starts_with('P') ? packedFile(input.substr(1)) : std::string(input);
    fuzz::checkRaster(simcore::io::readPng(std::as_bytes(std::span(file)), "input"),
                      simcore::project::TerrainKind::Image);
    return 0;
}
