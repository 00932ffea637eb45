// After its start a run on the reduced engine takes no memory from the heap: an optimiser runs
// thousands of them on all cores, which must not wait for each other.
#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/heap_count.h"
#include "tests/support/projects.h"

namespace {

using namespace simcore;

struct Drive {
    const char* project;
    const char* scenario;
};

void PrintTo(const Drive& drive, std::ostream* out) {  // NOLINT: name given by gtest
    *out << drive.project << " " << drive.scenario;
}

class AllocationTest : public ::testing::TestWithParam<Drive> {};

INSTANTIATE_TEST_SUITE_P(Drives, AllocationTest,
                         ::testing::Values(Drive{"solero", "rough-profile"},
                                           Drive{"rocker_bogie", "rough-3d"},
                                           Drive{"bench_rover", "step"}),
                         [](const auto& param) {
                             std::string name =
                                 std::string(param.param.project) + "_" + param.param.scenario;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(AllocationTest, AStepTakesNoneFromTheHeap) {
    if (!testsupport::heapIsCounted()) {
        GTEST_SKIP() << "a sanitizer's heap";
    }
    run::RunRequest request;
    request.scenario = GetParam().scenario;
    request.engine = project::EngineKind::Reduced;
    auto prepared = run::prepareRun(testsupport::shipped(GetParam().project), request);
    ASSERT_TRUE(prepared) << toString(prepared.problems());
    run::Simulation simulation(std::move(prepared).value());
    // Braked at first, which asks for reactions; then on the way over the first obstacles.
    constexpr double kWarm = 4.0;
    while (!simulation.finished() && simulation.snapshot().time < kWarm) {
        simulation.step();
    }
    long steps = 0;
    const long before = testsupport::heapCount();
    for (; !simulation.finished() && steps < 10000; ++steps) {
        simulation.step();
    }
    EXPECT_GT(steps, 5000);
    EXPECT_EQ(testsupport::heapCount() - before, 0) << "in " << steps << " steps";
}

}  // namespace
