// The search for the best torques, once it has been through, takes no memory from the heap: it is
// made at every look of a controller and at every move of a mouse.
#include <gtest/gtest.h>

#include "tests/support/heap_count.h"
#include "tests/support/quasi_convex_programs.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

/// From far away, so that all ways of the search are taken, and from where it ends.
void searchAll() {
    for (int seed = 1; seed <= 200; ++seed) {
        Scratch room;
        const QuasiConvexProgram program =
            testsupport::randomProgram(room, seed, 2 + seed % 7, 3 + seed % 5, 1 + seed % 2);
        Scratch::Vector y = room.vector(program.unknowns());
        y.setConstant(10.0);
        ASSERT_TRUE(minimise(program, y, 1e-8)) << seed;
        ASSERT_TRUE(minimise(program, y, 1e-8)) << seed;
    }
}

long heapOf(void (*work)()) {
    const long before = testsupport::heapCount();
    work();
    return testsupport::heapCount() - before;
}

/// The same programs without a search of them.
void makeAll() {
    for (int seed = 1; seed <= 200; ++seed) {
        Scratch room;
        testsupport::randomProgram(room, seed, 2 + seed % 7, 3 + seed % 5, 1 + seed % 2);
    }
}

}  // namespace

TEST(SearchAllocationTest, TakesNoneFromTheHeap) {
    if (!testsupport::heapIsCounted()) {
        GTEST_SKIP() << "a sanitizer's heap";
    }
    searchAll();
    const long making = heapOf(makeAll);
    EXPECT_GT(making, 0) << "nothing is counted";
    EXPECT_EQ(heapOf(searchAll), making);
}
