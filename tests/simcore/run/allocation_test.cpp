// After its start a run on the reduced engine takes no memory from the heap: an optimiser runs
// thousands of them on all cores, which must not wait for each other.
#include <atomic>
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "simcore/run/simulation.h"
#include "tests/support/projects.h"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size)) {
        return memory;
    }
    throw std::bad_alloc();
}

}  // namespace

// NOLINTBEGIN(cppcoreguidelines-no-malloc): this is what the test counts.
void* operator new(std::size_t size) {
    return counted(size);
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}

// NOLINTEND(cppcoreguidelines-no-malloc)

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
    const long before = allocations;
    for (; !simulation.finished() && steps < 10000; ++steps) {
        simulation.step();
    }
    EXPECT_GT(steps, 5000);
    EXPECT_EQ(allocations - before, 0) << "in " << steps << " steps";
}

}  // namespace
