#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace simcore {

/// Disjoint groups of indices.
class Groups {
  public:
    explicit Groups(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    /// The least index of the group that `i` is in.
    int of(int i) const {
        while (parent_[static_cast<std::size_t>(i)] != i) {
            i = parent_[static_cast<std::size_t>(i)];
        }
        return i;
    }

    void join(int a, int b) {
        const int ofA = of(a);
        const int ofB = of(b);
        parent_[static_cast<std::size_t>(std::max(ofA, ofB))] = std::min(ofA, ofB);
    }

  private:
    std::vector<int> parent_;
};

}  // namespace simcore
