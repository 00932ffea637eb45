// The 3.5 m run over the rough profile with the speed controller, as `roversim run` drives it:
// time per engine step and simulated over wall time (rtf). One run a rover: its thousands of steps
// give the median. Goal: live playback, rtf > 1; 5 to 6 is what ODE can do (trial with bounds of
// friction taken from the step before).
#include <benchmark/benchmark.h>

#include "simcore/io/project_file.h"
#include "simcore/run/simulation.h"
#include "tests/bench/stopwatch.h"

using namespace simcore;

namespace {

void driveRoughProfile(benchmark::State& state, const char* file) {
    const auto project = io::loadProject(std::string(ROVER_SOURCE_DIR "/assets/projects/") + file);
    if (!project) {
        state.SkipWithError(toString(project.problems()).c_str());
        return;
    }
    run::RunRequest request;
    request.scenario = "rough-profile";
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

}  // namespace

BENCHMARK_CAPTURE(driveRoughProfile, solero, "solero.rover")
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->Repetitions(1);
BENCHMARK_CAPTURE(driveRoughProfile, bench_rover, "bench_rover.rover")
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->Repetitions(1);

BENCHMARK_MAIN();
