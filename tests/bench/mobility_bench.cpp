// Mobility of the largest shipped rover, as the editor calls it after every edit. Goal: < 2 ms.
#include <cstdlib>

#include <benchmark/benchmark.h>

#include "simcore/io/project_file.h"
#include "simcore/mobility/mobility.h"
#include "simcore/project/resolve.h"

using namespace simcore;

namespace {

mechanism::Mechanism loadSolero() {
    const auto project = io::loadProject(ROVER_SOURCE_DIR "/assets/projects/solero.rover");
    if (!project) {
        std::abort();
    }
    auto mechanism = project::resolve(*project);
    if (!mechanism) {
        std::abort();
    }
    return std::move(mechanism).value();
}

void analyseSolero(benchmark::State& state, mobility::Model model) {
    const mechanism::Mechanism mechanism = loadSolero();
    for (auto _ : state) {
        benchmark::DoNotOptimize(mobility::analyse(mechanism, model));
    }
}

}  // namespace

BENCHMARK_CAPTURE(analyseSolero, built, mobility::Model::Built)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(analyseSolero, relaxed, mobility::Model::Relaxed)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
