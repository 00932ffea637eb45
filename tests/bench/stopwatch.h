#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

/// Times of one kind of work, and their median.
namespace bench {

class Stopwatch {
  public:
    /// Runs the work and notes how long it took [s].
    template <class Work>
    double time(Work work) {
        const auto start = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
        times_.push_back(elapsed.count());
        return elapsed.count();
    }

    /// [s]; 0 when nothing was timed.
    double quantile(double share) const {
        if (times_.empty()) {
            return 0.0;
        }
        std::vector<double> sorted = times_;
        const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
        std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
        return sorted[static_cast<std::size_t>(at)];
    }

    double medianMs() const { return 1e3 * quantile(0.5); }

  private:
    std::vector<double> times_;
};

}  // namespace bench
