#pragma once

#include <array>
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

    /// In lanes of their own, which do not wait for each other: of a state there is one a step.
    void add(std::span<const double> numbers) {
        constexpr std::size_t kLanes = 4;
        std::array<StateHash, kLanes> lanes;
        std::size_t i = 0;
        for (; i + kLanes <= numbers.size(); i += kLanes) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                lanes[lane].add(std::bit_cast<std::uint64_t>(numbers[i + lane]));
            }
        }
        for (; i < numbers.size(); ++i) {
            add(std::bit_cast<std::uint64_t>(numbers[i]));
        }
        for (const StateHash& lane : lanes) {
            add(lane.value_);
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
