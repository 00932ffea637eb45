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

}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
