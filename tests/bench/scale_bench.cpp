// Time of a step against the number of bodies, of wheels and against the step, on synthetic rovers
// over the rough profile, with both engines: everything a run does in a step, with the speed
// controller. us_median is the time of one step, us_each that time shared among the bodies, rtf
// simulated over wall time. docs/plot-cost.py draws the numbers.
#include <string>

#include <benchmark/benchmark.h>

#include "simcore/run/simulation.h"
#include "tests/bench/stopwatch.h"

using namespace simcore;

namespace {

constexpr double kWheelRadius = 0.07;
constexpr double kAxleDistance = 0.2;

void addBody(project::Rover& rover, const std::string& name, double mass,
             const project::Quantity3& com) {
    project::Body body;
    body.name = name;
    body.mass = mass;
    body.com = com;
    body.inertia = {0.01 * mass, 0.01 * mass, 0.01 * mass, 0.0, 0.0, 0.0};
    rover.bodies.push_back(body);
}

void addPin(project::Rover& rover, const std::string& name, const std::string& first,
            const std::string& second, const project::Quantity3& point) {
    project::Joint joint;
    joint.name = name;
    joint.first = first;
    joint.second = second;
    joint.point = point;
    joint.damping = 0.001;
    rover.joints.push_back(joint);
}

/// Chassis on `axles` pairs of wheels, and a chain of `links` pendulums of 2 cm hanging from a mast
/// on it. Each link is one body and one pin, as in a suspension, and the rover drives on as before.
project::Project makeRover(int axles, int links) {
    project::Project project;
    project::Rover& rover = project.rover;
    rover.name = "synthetic";
    const double length = kAxleDistance * (axles - 1);
    addBody(rover, "chassis", 2.0 * axles, {-length / 2.0, 0.0, 0.1});
    for (int axle = 0; axle < axles; ++axle) {
        for (const double side : {1.0, -1.0}) {
            const std::string name = std::to_string(axle) + (side > 0.0 ? "_left" : "_right");
            const project::Quantity3 center{-kAxleDistance * axle, 0.2 * side, kWheelRadius};
            addBody(rover, "wheel_" + name, 0.3, center);
            rover.bodies.back().inertia.reset();  // that of a cylinder
            addPin(rover, "axle_" + name, "chassis", "wheel_" + name, center);
            project::Wheel wheel;
            wheel.name = "wheel_" + name;
            wheel.body = "wheel_" + name;
            wheel.axle = "axle_" + name;
            wheel.radius = kWheelRadius;
            wheel.width = 0.05;
            rover.wheels.push_back(wheel);
        }
    }
    std::string above = "chassis";
    for (int link = 0; link < links; ++link) {
        const std::string name = "link_" + std::to_string(link);
        const double top = 1.5 - 0.02 * link;
        addBody(rover, name, 0.02, {-length / 2.0, 0.0, top - 0.01});
        rover.bodies.back().inertia = {1e-5, 1e-5, 1e-5, 0.0, 0.0, 0.0};
        addPin(rover, "pin_" + std::to_string(link), above, name, {-length / 2.0, 0.0, top});
        above = name;
    }
    project::Scenario scenario;
    scenario.name = "rough";
    scenario.terrain.kind = project::TerrainKind::RandomProfile;
    scenario.terrain.start = 0.3;
    scenario.terrain.height = 0.03;
    scenario.terrain.length = 2.0;
    scenario.terrain.count = 40;
    scenario.run.distance = 1.0;
    project.scenarios = {scenario};
    return project;
}

void drive(benchmark::State& state, project::EngineKind engine, int axles, int links, double step) {
    run::RunRequest request;
    request.scenario = "rough";
    request.duration = 4.0;
    request.engine = engine;
    request.step = step;
    auto prepared = run::prepareRun(makeRover(axles, links), request);
    if (!prepared) {
        state.SkipWithError(toString(prepared.problems()).c_str());
        return;
    }
    const auto bodies = static_cast<double>(prepared->mechanism.bodies.size());
    const auto wheels = static_cast<double>(prepared->mechanism.wheels.size());
    run::Simulation simulation(std::move(prepared).value());
    bench::Stopwatch steps;
    for (auto _ : state) {
        simulation.reset();
        while (!simulation.finished()) {
            steps.time([&] { simulation.step(); });
        }
    }
    const run::StopReason reason = simulation.report().stopReason;
    if (reason != run::StopReason::Completed && reason != run::StopReason::TimeUp) {
        state.SkipWithError(("the run ended: " + toString(reason)).c_str());
        return;
    }
    const double median = 1e6 * steps.quantile(0.5);
    state.counters["bodies"] = bodies;
    state.counters["wheels"] = wheels;
    state.counters["step_ms"] = 1e3 * step;
    state.counters["us_median"] = median;
    state.counters["us_p99"] = 1e6 * steps.quantile(0.99);
    state.counters["us_each"] = median / bodies;
    state.counters["rtf"] = 1e6 * step / median;
}

constexpr double kStep = 0.002;
constexpr int kAxles = 3;

template <project::EngineKind engine>
void stepAgainstWheels(benchmark::State& state) {
    drive(state, engine, static_cast<int>(state.range(0)) / 2, 0, kStep);
}

template <project::EngineKind engine>
void stepAgainstBodies(benchmark::State& state) {
    drive(state, engine, kAxles, static_cast<int>(state.range(0)) - 1 - 2 * kAxles, kStep);
}

/// Of a rover of 20 bodies; the argument is the step [us].
template <project::EngineKind engine>
void stepAgainstStep(benchmark::State& state) {
    constexpr int kBodies = 20;
    drive(state, engine, kAxles, kBodies - 1 - 2 * kAxles,
          1e-6 * static_cast<double>(state.range(0)));
}

void once(benchmark::internal::Benchmark* benchmark) {
    // One run each: its thousand steps and more give the median.
    benchmark->Unit(benchmark::kSecond)->Iterations(1)->Repetitions(1);
}

void wheels(benchmark::internal::Benchmark* benchmark) {
    once(benchmark->DenseRange(4, 12, 2));
}

void bodies(benchmark::internal::Benchmark* benchmark) {
    for (const int count : {10, 20, 30, 40}) {
        benchmark->Arg(count);
    }
    once(benchmark);
}

void lengths(benchmark::internal::Benchmark* benchmark) {
    for (const int step : {500, 1000, 2000, 5000, 10000}) {
        benchmark->Arg(step);
    }
    once(benchmark);
}

using enum project::EngineKind;

}  // namespace

BENCHMARK(stepAgainstWheels<Reduced>)->Apply(wheels);
BENCHMARK(stepAgainstWheels<Ode>)->Apply(wheels);
BENCHMARK(stepAgainstBodies<Reduced>)->Apply(bodies);
BENCHMARK(stepAgainstBodies<Ode>)->Apply(bodies);
BENCHMARK(stepAgainstStep<Reduced>)->Apply(lengths);
BENCHMARK(stepAgainstStep<Ode>)->Apply(lengths);

BENCHMARK_MAIN();
