// The 3.5 m run over rough ground with the speed controller, as `roversim run` drives it: time per
// step and simulated over wall time (rtf). One run a rover: its thousands of steps give the median.
// Goals: ODE in live playback, rtf > 1; the reduced engine at rtf > 100.
#include <benchmark/benchmark.h>

#include "simcore/io/project_file.h"
#include "simcore/run/simulation.h"
#include "tests/bench/stopwatch.h"

using namespace simcore;

namespace {

void drive(benchmark::State& state, const char* file, const char* scenario,
           project::EngineKind engine) {
    const auto project = io::loadProject(std::string(ROVER_SOURCE_DIR "/assets/projects/") + file);
    if (!project) {
        state.SkipWithError(toString(project.problems()).c_str());
        return;
    }
    run::RunRequest request;
    request.scenario = scenario;
    request.engine = engine;
    request.controller = project::ControllerKind::Speed;
    auto prepared = run::prepareRun(*project, request);
    if (!prepared) {
        state.SkipWithError(toString(prepared.problems()).c_str());
        return;
    }
    run::Simulation simulation(std::move(prepared).value());
    bench::Stopwatch steps;
    for (auto _ : state) {
        simulation.reset();
        while (!simulation.finished()) {
            steps.time([&] { simulation.step(); });
        }
    }
    const run::RunReport report = simulation.report();
    if (!report.completed) {
        state.SkipWithError("the rover did not get through");
    }
    state.counters["us_per_step"] = 1e6 * report.wallTime / static_cast<double>(report.steps);
    state.counters["us_median"] = 1e6 * steps.quantile(0.5);
    state.counters["us_p99"] = 1e6 * steps.quantile(0.99);
    state.counters["rtf"] = report.rtf;
    state.counters["sim_s"] = report.simTime;
    state.counters["solves_per_step"] = report.solvesPerStep;
}

void once(benchmark::internal::Benchmark* benchmark) {
    benchmark->Unit(benchmark::kSecond)->Iterations(1)->Repetitions(1);
}

using enum project::EngineKind;

}  // namespace

BENCHMARK_CAPTURE(drive, solero_rough_profile_reduced, "solero.rover", "rough-profile", Reduced)
    ->Apply(once);
BENCHMARK_CAPTURE(drive, solero_rough_3d_reduced, "solero.rover", "rough-3d", Reduced)->Apply(once);
BENCHMARK_CAPTURE(drive, solero_rough_profile_ode, "solero.rover", "rough-profile", Ode)
    ->Apply(once);
BENCHMARK_CAPTURE(drive, bench_rover_rough_profile_reduced, "bench_rover.rover", "rough-profile",
                  Reduced)
    ->Apply(once);
BENCHMARK_CAPTURE(drive, bench_rover_rough_profile_ode, "bench_rover.rover", "rough-profile", Ode)
    ->Apply(once);

BENCHMARK_MAIN();
