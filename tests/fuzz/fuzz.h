#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

/// What the fuzz targets share. A target is a source with LLVMFuzzerTestOneInput: libFuzzer calls
/// it with inputs of its own making, replay_main.cpp with the kept ones.
namespace fuzz {

/// Ends the program, as a finding, when the reader broke a promise.
inline void require(bool kept, std::string_view promise) {
    if (!kept) {
        std::fprintf(stderr, "fuzz: broken promise: %.*s\n", static_cast<int>(promise.size()),
                     promise.data());
        std::abort();
    }
}

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Takes bytes from the front of an input; fewer when there are no more.
class Source {
  public:
    explicit Source(std::string_view bytes) : rest_(bytes) {}

    bool empty() const { return rest_.empty(); }

    std::string_view take(std::size_t count) {
        const std::string_view taken = rest_.substr(0, count);
        rest_.remove_prefix(taken.size());
        return taken;
    }

    /// A whole number, least byte first.
    std::uint64_t number(std::size_t bytes) {
        std::uint64_t value = 0;
        std::size_t shift = 0;
        for (const char byte : take(bytes)) {
            value |= static_cast<std::uint64_t>(static_cast<unsigned char>(byte)) << shift;
            shift += 8;
        }
        return value;
    }

  private:
    std::string_view rest_;
};

}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
