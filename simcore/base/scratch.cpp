#include "simcore/base/scratch.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace simcore {
namespace {

constexpr std::size_t kBlock = 1U << 15U;  // words: room for what statics asks of any usual rover

}  // namespace

/// Blocks never move: what was given points into them.
struct Scratch::Stack {
    struct Block {
        std::unique_ptr<double[]> words;
        std::size_t size = 0;
    };

    std::vector<Block> blocks;
    Height height;
    std::size_t depth = 0;  ///< how many Scratch there are
};

Scratch::Stack& Scratch::stack() {
    thread_local Stack stack;
    return stack;
}

Scratch::Scratch() : before_(stack().height), depth_(++stack().depth) {}

Scratch::~Scratch() {
    stack().height = before_;
    --stack().depth;
}

double* Scratch::take(std::size_t words) {
    Stack& all = stack();
    assert(depth_ == all.depth);  // only the last one gives
    Height& height = all.height;
    if (height.block < all.blocks.size() && all.blocks[height.block].size - height.words < words) {
        height = {height.block + 1, 0};
    }
    if (height.block == all.blocks.size()) {
        all.blocks.emplace_back();
    }
    Stack::Block& block = all.blocks[height.block];
    if (block.size - height.words < words) {  // a new one, or one of which nothing is in use
        block.size = std::max(kBlock, words);
        block.words = std::make_unique_for_overwrite<double[]>(block.size);
    }
    double* const taken = block.words.get() + height.words;
    height.words += words;
    return taken;
}

Scratch::Vector Scratch::vector(Eigen::Index size) {
    return {take(static_cast<std::size_t>(size)), size};
}

Scratch::Matrix Scratch::matrix(Eigen::Index rows, Eigen::Index columns) {
    return {take(static_cast<std::size_t>(rows * columns)), rows, columns};
}

}  // namespace simcore
