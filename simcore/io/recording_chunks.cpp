#include "simcore/io/recording_chunks.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include <zlib.h>

namespace simcore::io {
namespace {

// Quick: a run must not wait for its recording (docs/decisions/0012).
constexpr int kCompression = 1;

template <class Unsigned>
void put(Unsigned value, std::string& out) {
    for (std::size_t i = 0; i < sizeof value; ++i) {
        out += static_cast<char>((value >> (8 * i)) & 0xffU);
    }
}

template <class Unsigned>
Unsigned get(std::string_view bytes, std::size_t at) {
    Unsigned value = 0;
    for (std::size_t i = 0; i < sizeof value; ++i) {
        value |= static_cast<Unsigned>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    }
    return value;
}

std::uint32_t checksumOf(std::string_view bytes) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

std::string pack(ChunkHead head, std::string_view contents) {
    uLongf size = compressBound(contents.size());
    std::string stored(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(stored.data()), &size,
                  reinterpret_cast<const Bytef*>(contents.data()), contents.size(),
                  kCompression) != Z_OK) {
        throw std::runtime_error("recording: no memory to compress with");
    }
    stored.resize(size);
    std::string out(head.tag.data(), head.tag.size());
    put(static_cast<std::uint32_t>(stored.size()), out);
    put(static_cast<std::uint32_t>(contents.size()), out);
    put(head.count, out);
    put(std::bit_cast<std::uint64_t>(head.first), out);
    put(std::bit_cast<std::uint64_t>(head.last), out);
    put(checksumOf(stored), out);
    put(checksumOf(out), out);
    return out + stored;
}

std::optional<std::string> unpack(const ChunkHead& head, std::string_view stored) {
    std::string contents(head.unpacked, '\0');
    uLongf size = contents.size();
    const int result = uncompress(reinterpret_cast<Bytef*>(contents.data()), &size,
                                  reinterpret_cast<const Bytef*>(stored.data()), stored.size());
    if (result != Z_OK || size != head.unpacked) {
        return std::nullopt;
    }
    return contents;
}

}  // namespace

std::string packTable(const ChunkTag& tag, const Table& rows) {
    const std::size_t columns = rows.at(0).size();
    if (columns == 0 || rows.size() > kMostRows || 8 * columns * rows.size() + 4 > kLargestTable) {
        throw std::invalid_argument("recording: a table is empty or too large");
    }
    std::string contents;
    contents.reserve(4 + 8 * columns * rows.size());
    put(static_cast<std::uint32_t>(columns), contents);
    // Column by column and byte by byte: like bytes stand together and compress.
    for (std::size_t column = 0; column < columns; ++column) {
        for (unsigned shift = 0; shift < 64; shift += 8) {
            for (const std::vector<double>& row : rows) {
                contents += static_cast<char>(
                    (std::bit_cast<std::uint64_t>(row.at(column)) >> shift) & 0xffU);
            }
        }
    }
    ChunkHead head;
    head.tag = tag;
    head.count = static_cast<std::uint32_t>(rows.size());
    head.first = rows.front()[0];
    head.last = rows.back()[0];
    return pack(head, contents);
}

std::string packText(const ChunkTag& tag, std::string_view text) {
    if (text.size() > kLargestText) {
        throw std::invalid_argument("recording: the text is too long");
    }
    ChunkHead head;
    head.tag = tag;
    return pack(head, text);
}

std::string packFilePart(std::string_view name, std::uint64_t offset, std::string_view bytes) {
    std::string contents;
    contents.reserve(12 + name.size() + bytes.size());
    put(static_cast<std::uint32_t>(name.size()), contents);
    contents += name;
    put(offset, contents);
    contents += bytes;
    return packText(kFileChunk, contents);
}

bool writeFileParts(const project::ProjectFiles& files,
                    const std::function<bool(std::string_view)>& write) {
    if (!files.carried) {
        return true;
    }
    for (const auto& [name, bytes] : *files.carried) {
        for (std::size_t at = 0; at < bytes.size(); at += kFilePart) {
            if (!write(packFilePart(name, at, std::string_view(bytes).substr(at, kFilePart)))) {
                return false;
            }
        }
    }
    return true;
}

std::optional<ChunkHead> readHead(std::string_view bytes) {
    if (bytes.size() != kChunkHeadSize ||
        get<std::uint32_t>(bytes, 36) != checksumOf(bytes.substr(0, 36))) {
        return std::nullopt;
    }
    ChunkHead head;
    std::copy_n(bytes.begin(), head.tag.size(), head.tag.begin());
    head.stored = get<std::uint32_t>(bytes, 4);
    head.unpacked = get<std::uint32_t>(bytes, 8);
    head.count = get<std::uint32_t>(bytes, 12);
    head.first = std::bit_cast<double>(get<std::uint64_t>(bytes, 16));
    head.last = std::bit_cast<double>(get<std::uint64_t>(bytes, 24));
    head.checksum = get<std::uint32_t>(bytes, 32);
    const bool text = head.count == 0;
    if (head.unpacked > (text ? kLargestText : kLargestTable) || head.count > kMostRows ||
        head.stored > compressBound(head.unpacked)) {
        return std::nullopt;
    }
    return head;
}

bool checksumHolds(const ChunkHead& head, std::string_view stored) {
    return stored.size() == head.stored && checksumOf(stored) == head.checksum;
}

std::optional<Table> unpackTable(const ChunkHead& head, std::string_view stored) {
    const auto contents = unpack(head, stored);
    if (!contents || contents->size() < 4 || head.count == 0) {
        return std::nullopt;
    }
    const std::size_t columns = get<std::uint32_t>(*contents, 0);
    const std::size_t count = head.count;
    if (columns == 0 || contents->size() - 4 != 8 * columns * count) {
        return std::nullopt;
    }
    Table rows(count, std::vector<double>(columns));
    for (std::size_t column = 0; column < columns; ++column) {
        const char* bytes = contents->data() + 4 + 8 * column * count;
        for (std::size_t row = 0; row < count; ++row) {
            std::uint64_t value = 0;
            for (std::size_t byte = 0; byte < 8; ++byte) {
                value |= static_cast<std::uint64_t>(
                             static_cast<unsigned char>(bytes[byte * count + row]))
                         << (8 * byte);
            }
            rows[row][column] = std::bit_cast<double>(value);
        }
    }
    return rows;
}

std::optional<std::string> unpackText(const ChunkHead& head, std::string_view stored) {
    return unpack(head, stored);
}

std::optional<FilePart> unpackFilePart(const ChunkHead& head, std::string_view stored) {
    const auto contents = unpack(head, stored);
    if (!contents || contents->size() < 12) {
        return std::nullopt;
    }
    const std::size_t length = get<std::uint32_t>(*contents, 0);
    if (length > contents->size() - 12) {
        return std::nullopt;
    }
    return FilePart{contents->substr(4, length), get<std::uint64_t>(*contents, 4 + length),
                    contents->substr(12 + length)};
}

}  // namespace simcore::io
