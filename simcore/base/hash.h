#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string_view>

namespace simcore {

/// FNV-1a over words of 64 bits instead of bytes, with the upper half folded into the lower: eight
/// times quicker, and every bit of a word still reaches the lower bits of the next product. Tells
/// equal from different; not meant against forgery.
class StateHash {
  public:
    void add(std::uint64_t word) {
        constexpr std::uint64_t kPrime = 1099511628211ULL;
        value_ = (value_ ^ word) * kPrime;
        value_ ^= value_ >> 32;
    }

    void add(std::span<const double> numbers) {
        for (const double number : numbers) {
            add(std::bit_cast<std::uint64_t>(number));
        }
    }

    void add(std::string_view text) {
        for (const char c : text) {
            add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
        }
    }

    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 14695981039346656037ULL;
};

}  // namespace simcore
