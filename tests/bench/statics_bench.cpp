// What the live path costs: the pose of a rover, its equilibrium and the friction it requires; and
// a look of the controllers that use them.
#include <algorithm>
#include <ctime>

#include <benchmark/benchmark.h>

#include "simcore/control/controller.h"
#include "simcore/dynamics/engine.h"
#include "simcore/io/project_file.h"
#include "simcore/project/resolve.h"
#include "simcore/run/simulation.h"
#include "simcore/statics/traverse.h"

using namespace simcore;
using namespace simcore::statics;

namespace {

mechanism::Mechanism rover(const std::string& name) {
    const auto project = io::loadProject(io::examplesFolder() / (name + ".rover"));
    return project::resolve(*project).value();
}

terrain::Terrain step() {
    return terrain::Terrain::extruded({{-10.0, 0.0}, {0.0, 0.0}, {0.0, 0.05}, {10.0, 0.05}}, -5.0,
                                      5.0);
}

/// At the edge of a step with its front wheel, from the pose a millimetre before.
struct AtAStep {
    StaticModel model{rover("solero"), mechanism::Model::Built};
    terrain::Terrain ground = step();
    PoseSolver solver{model, ground};
    StandingPose pose = solver.settle({-0.27, 0.0, 0.0});
};

void warmPose(benchmark::State& state) {
    AtAStep at;
    double x = -0.27;
    for (auto _ : state) {
        x = x > -0.265 ? -0.27 : x + 1e-3;
        benchmark::DoNotOptimize(at.solver.settleFrom(at.pose.state, {x, 0.0, 0.0}));
    }
}

void coldPose(benchmark::State& state) {
    AtAStep at;
    for (auto _ : state) {
        benchmark::DoNotOptimize(at.solver.settle({-0.27, 0.0, 0.0}));
    }
}

void equilibriumAndFriction(benchmark::State& state) {
    AtAStep at;
    const std::vector<Contact> contacts = rollingAlong(at.pose);
    dynamics::TreeState placed = at.pose.state;
    at.model.place(placed);
    const ContactSet set = state.range(0) == 14 ? ContactSet::Free : ContactSet::All;
    for (auto _ : state) {
        const Traction traction(at.model.equilibrium(contacts, set, dynamics::kGravity),
                                at.model.mechanism(), contacts);
        benchmark::DoNotOptimize(traction.best(Objective::Friction));
    }
}

void warmPoseAndFriction(benchmark::State& state) {
    AtAStep at;
    double x = -0.27;
    for (auto _ : state) {
        x = x > -0.265 ? -0.27 : x + 1e-3;
        const StandingPose pose = at.solver.settleFrom(at.pose.state, {x, 0.0, 0.0});
        benchmark::DoNotOptimize(studyPose(at.model, pose, std::nullopt, false, false));
    }
}

void overAStep(benchmark::State& state) {
    AtAStep at;
    TraverseRequest request;
    request.from.x = -0.7;
    request.distance = 1.4;
    for (auto _ : state) {
        benchmark::DoNotOptimize(traverse(at.solver, request));
    }
}

/// What a controller reads in a drive over a rough profile, a look every 10 ms.
std::vector<control::Sensors> looksOfADrive() {
    const auto project = io::loadProject(io::examplesFolder() / "solero.rover");
    run::RunRequest request;
    request.scenario = "rough-profile";
    request.engine = project::EngineKind::Reduced;
    request.controller = project::ControllerKind::Hybrid;
    run::Simulation simulation(run::prepareRun(*project, request).value());
    std::vector<control::Sensors> looks;
    while (!simulation.finished()) {
        simulation.step();
        if (simulation.snapshot().step % 5 == 0 && simulation.snapshot().time > 0.5) {
            looks.push_back(simulation.snapshot().measured);
        }
    }
    return looks;
}

/// Of the processor for this thread: what others do does not count [us].
double threadTime() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// A look of a controller; the counter is the longest one of the drive, which has 10 ms.
void controllerLook(benchmark::State& state, project::ControllerKind kind) {
    static const std::vector<control::Sensors> looks = looksOfADrive();
    const mechanism::Mechanism solero = rover("solero");
    control::ControllerSettings settings;
    settings.kind = kind;
    const auto controller = control::makeController(solero, settings);
    std::vector<control::WheelCommand> commands(solero.wheels.size());
    control::DriveCommand command;
    command.speed = 0.1;
    std::size_t look = 0;
    double longest = 0.0;
    for (auto _ : state) {
        const double start = threadTime();
        controller->update(looks[look], command, commands);
        longest = std::max(longest, threadTime() - start);
        look = (look + 1) % looks.size();
    }
    state.counters["longest_us"] = longest;
}

}  // namespace

BENCHMARK_CAPTURE(controllerLook, synchronised, project::ControllerKind::Synchronised)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(controllerLook, torque, project::ControllerKind::Torque)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(controllerLook, hybrid, project::ControllerKind::Hybrid)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(warmPose)->Unit(benchmark::kMicrosecond);
BENCHMARK(coldPose)->Unit(benchmark::kMicrosecond);
BENCHMARK(equilibriumAndFriction)->Arg(14)->Arg(18)->Unit(benchmark::kMicrosecond);
BENCHMARK(warmPoseAndFriction)->Unit(benchmark::kMicrosecond);
BENCHMARK(overAStep)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
