// What the live path costs: the pose of a rover, its equilibrium and the friction it requires.
#include <benchmark/benchmark.h>

#include "simcore/dynamics/engine.h"
#include "simcore/io/project_file.h"
#include "simcore/project/resolve.h"
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

}  // namespace

BENCHMARK(warmPose)->Unit(benchmark::kMicrosecond);
BENCHMARK(coldPose)->Unit(benchmark::kMicrosecond);
BENCHMARK(equilibriumAndFriction)->Arg(14)->Arg(18)->Unit(benchmark::kMicrosecond);
BENCHMARK(warmPoseAndFriction)->Unit(benchmark::kMicrosecond);
BENCHMARK(overAStep)->Unit(benchmark::kMillisecond);
