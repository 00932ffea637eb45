// Grey images as heights.
#include "simcore/io/png_grid.h"

#include <csetjmp>
#include <cstring>
#include <limits>

#include <png.h>

#include "simcore/base/text.h"
#include "simcore/io/terrain_file.h"

namespace simcore::io {
namespace {

/// What libpng complained about; errors leave its functions by longjmp.
struct Complaint {
    std::string text;
};

[[noreturn]] void onError(png_structp png, png_const_charp text) {
    static_cast<Complaint*>(png_get_error_ptr(png))->text = text;
    png_longjmp(png, 1);
}

void onWarning(png_structp /*png*/, png_const_charp /*text*/) {}

struct Source {
    std::span<const std::byte> bytes;
    std::size_t at = 0;
};

void readBytes(png_structp png, png_bytep out, std::size_t size) {
    auto* source = static_cast<Source*>(png_get_io_ptr(png));
    if (size > source->bytes.size() - source->at) {
        png_error(png, Text::mark("the file ends early"));
    }
    std::memcpy(out, source->bytes.data() + source->at, size);
    source->at += size;
}

void writeBytes(png_structp png, png_bytep data, std::size_t size) {
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(data), size);
}

void flushNothing(png_structp /*png*/) {}

struct Image {
    png_uint_32 columns = 0, rows = 0;
    int depth = 0;
    bool alpha = false;
    std::string refusal;
    std::vector<png_byte> pixels;
    std::vector<png_bytep> lines;
};

/// Everything that libpng may leave by longjmp; no object of this function needs a destructor.
bool decode(png_structp png, png_infop info, Image& image) {
    if (setjmp(png_jmpbuf(png)) != 0) {  // NOLINT: libpng's way of reporting errors
        return false;
    }
    constexpr png_uint_32 kMostChunk = 64U << 20U;
    png_set_user_limits(png, 1'000'000, 1'000'000);
    png_set_chunk_malloc_max(png, kMostChunk);
    png_set_chunk_cache_max(png, 16);
    png_read_info(png, info);
    image.columns = png_get_image_width(png, info);
    image.rows = png_get_image_height(png, info);
    image.depth = png_get_bit_depth(png, info);
    const int colour = png_get_color_type(png, info);
    if ((colour & PNG_COLOR_MASK_COLOR) != 0) {
        image.refusal = Text::of("it is a colour image.");
        return true;
    }
    if (image.columns < 2 || image.rows < 2) {
        image.refusal = Text::of("it has fewer than 2 x 2 pixels.");
        return true;
    }
    if (static_cast<std::size_t>(image.columns) * image.rows > terrain::kMostRasterPoints) {
        image.refusal = Text::of("it has too many pixels.");
        return true;
    }
    if (image.depth < 8) {
        png_set_expand_gray_1_2_4_to_8(png);
        image.depth = 8;
    }
    if (png_get_valid(png, info, PNG_INFO_tRNS) != 0) {
        png_set_tRNS_to_alpha(png);
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    image.depth = png_get_bit_depth(png, info);
    image.alpha = png_get_channels(png, info) == 2;
    const std::size_t stride = png_get_rowbytes(png, info);
    image.pixels.assign(stride * image.rows, 0);
    image.lines.resize(image.rows);
    for (std::size_t i = 0; i < image.rows; ++i) {
        image.lines[i] = image.pixels.data() + i * stride;
    }
    png_read_image(png, image.lines.data());
    return true;
}

terrain::Raster rasterOf(const Image& image) {
    terrain::Raster raster;
    raster.columns = static_cast<int>(image.columns);
    raster.rows = static_cast<int>(image.rows);
    const std::size_t sample = image.depth == 16 ? 2 : 1;
    const std::size_t pixel = sample * (image.alpha ? 2 : 1);
    const auto read = [&](const png_byte* p) {
        return sample == 2 ? (p[0] * 256 + p[1]) / 65535.0 : p[0] / 255.0;
    };
    raster.values.reserve(static_cast<std::size_t>(image.columns) * image.rows);
    for (const png_byte* line : image.lines) {
        for (std::size_t i = 0; i < image.columns; ++i) {
            const png_byte* p = line + i * pixel;
            const bool none = image.alpha && read(p + sample) == 0.0;
            raster.values.push_back(none ? std::numeric_limits<double>::quiet_NaN() : read(p));
        }
    }
    return raster;
}

bool encode(png_structp png, png_infop info, int columns, int rows, png_bytep data) {
    if (setjmp(png_jmpbuf(png)) != 0) {  // NOLINT: libpng's way of reporting errors
        return false;
    }
    png_set_IHDR(png, info, static_cast<png_uint_32>(columns), static_cast<png_uint_32>(rows), 16,
                 PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int i = 0; i < rows; ++i) {
        png_write_row(png, data + static_cast<std::ptrdiff_t>(i) * columns * 2);
    }
    png_write_end(png, info);
    return true;
}

}  // namespace

Result<terrain::Raster> readPng(std::span<const std::byte> bytes, const std::string& name) {
    Complaint complaint;
    Source source{bytes};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &complaint, onError, onWarning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    Image image;
    bool good = false;
    if (info != nullptr) {
        png_set_read_fn(png, &source, readBytes);
        good = decode(png, info, image);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    if (!good) {
        return Problem{Severity::Critical, name,
                       Text::of("this is not a readable PNG image ({}).",
                                Text::translated(complaint.text.c_str())),
                       Text::of("Write it anew, as a grey image of 16 bit.")};
    }
    if (!image.refusal.empty()) {
        return Problem{Severity::Critical, name, image.refusal,
                       Text::of("A grey image of 16 bit is needed, at most {} pixels.",
                                terrain::kMostRasterPoints)};
    }
    return rasterOf(image);
}

std::string formatPng(int columns, int rows, const std::vector<std::uint16_t>& values) {
    std::vector<png_byte> data;
    data.reserve(2 * values.size());
    for (const std::uint16_t value : values) {
        data.push_back(static_cast<png_byte>(value >> 8U));
        data.push_back(static_cast<png_byte>(value & 0xFFU));
    }
    Complaint complaint;
    std::string bytes;
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, &complaint, onError, onWarning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info != nullptr) {
        png_set_write_fn(png, &bytes, writeBytes, flushNothing);
        if (!encode(png, info, columns, rows, data.data())) {
            bytes.clear();
        }
    }
    png_destroy_write_struct(&png, &info);
    return bytes;
}

}  // namespace simcore::io
