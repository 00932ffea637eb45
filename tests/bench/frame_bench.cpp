// A frame of the 3D view during playback: a new instant of SOLERO on the rough 3D course, all
// overlays shown, drawn without a window and waited for. Shadow of 1024 px, no multisampling: what
// the studio chooses for a software renderer. Goal there, two cores: 50 ms at 800x600, so that
// playback shows 20 frames a second; 100 ms at 1600x1000.
#include <benchmark/benchmark.h>

#include "render/offscreen.h"
#include "simcore/io/project_file.h"
#include "simcore/project/resolve.h"
#include "simcore/terrain/make_terrain.h"
#include "tests/bench/stopwatch.h"
#include "tests/support/snapshots.h"

using namespace simcore;

namespace {

/// SOLERO on its rough 3D course, with everything that can be shown.
void fill(render::Scene& scene, const project::Project& project,
          const mechanism::Mechanism& mechanism) {
    for (const auto& scenario : project.scenarios) {
        if (scenario.name == "rough-3d") {
            auto terrain = terrain::makeTerrain(scenario.terrain, {}, 3.5);
            scene.setTerrain(std::make_shared<const terrain::Terrain>(std::move(terrain).value()));
        }
    }
    scene.setMechanism(mechanism);
    scene.setJointFreedomCounts(std::vector<int>(mechanism.joints.size(), 1));
    scene.setOverlays({.centerOfMass = true,
                       .supportPolygon = true,
                       .contactForces = true,
                       .jointFreedoms = true,
                       .trail = true,
                       .axes = true});
}

void drawFrame(benchmark::State& state) {
    const auto project = io::loadProject(ROVER_SOURCE_DIR "/assets/projects/solero.rover");
    const auto mechanism = project::resolve(*project);
    auto renderer = render::OffscreenRenderer::create(static_cast<int>(state.range(0)),
                                                      static_cast<int>(state.range(1)));
    if (!renderer) {
        state.SkipWithError(toString(renderer.problems()).c_str());
        return;
    }
    state.SetLabel((*renderer)->rendererName());
    render::Scene scene;
    fill(scene, *project, *mechanism);
    int frame = 0;
    bench::Stopwatch update, draw;
    const auto next = [&] {
        const double x = 0.004 * (frame % 300);
        const auto snapshot = testsupport::rolled(*mechanism, x, 0.02 * frame);
        ++frame;
        double seconds = update.time([&] { scene.setSnapshot(snapshot); });
        const auto camera = scene.view(render::View::Overview, (*renderer)->aspect());
        seconds += draw.time([&] { (*renderer)->drawOnly(scene, camera); });
        return seconds;
    };
    next();  // shaders and buffers are made with the first picture
    update = draw = {};
    for (auto _ : state) {
        state.SetIterationTime(next());
    }
    state.counters["update_ms"] = update.medianMs();
    state.counters["draw_ms"] = draw.medianMs();
}

}  // namespace

BENCHMARK(drawFrame)
    ->Args({800, 600})
    ->Args({1600, 1000})
    ->ArgNames({"width", "height"})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
