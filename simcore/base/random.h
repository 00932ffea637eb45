#pragma once

#include <cstdint>

namespace simcore {

/// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine and library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }

    /// Evenly in [low, high).
    double uniform(double low, double high) {
        constexpr double kUnit = 1.0 / 9007199254740992.0;  // 2^-53
        return low + (high - low) * static_cast<double>(next() >> 11) * kUnit;
    }

    /// Mean 0, deviation 1, within 6: the sum of twelve even numbers is near enough to a Gaussian
    /// for sensor noise, and needs no logarithm, whose last digit differs between libraries.
    double normal() {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) {
            sum += uniform(0.0, 1.0);
        }
        return sum;
    }

  private:
    std::uint64_t state_;
};

}  // namespace simcore
