// How fast the studio follows an edit: the slider of a SOLERO parameter moves in a shown window
// with all panels. Timed is everything until the call returns: validation, resolving, both mobility
// analyses, masses, every panel, the 3D scene. Goal: median below 16 ms.
//
// Counters break it down: validate, resolve and mobility are the arithmetic, scene the rover built
// anew for the picture; the rest is panels and undo stack. Beside it stands paint: layouts and the
// panels' painting, and with OpenGL the window put together anew; not the 3D view itself. A frame
// of that in the window is the last benchmark.
#include <QApplication>
#include <QSlider>

#include <benchmark/benchmark.h>

#include "tests/bench/stopwatch.h"
#include "widgets/window/file_commands.h"
#include "widgets/window/main_window.h"

namespace {

/// A studio with SOLERO on show.
class Studio {
  public:
    Studio() {
        window_.document().open(QStringLiteral(ROVER_SOURCE_DIR "/assets/projects/solero.rover"));
        window_.setDark(true);
        window_.resize(1440, 900);
        window_.show();
        for (int i = 0; i < 20; ++i) {
            QApplication::processEvents(QEventLoop::AllEvents, 20);
        }
    }

    ~Studio() {
        window_.document().undoStack().setClean();
        window_.files().discardAutosave();
    }

    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    widgets::MainWindow& window() { return window_; }

  private:
    widgets::MainWindow window_;
};

void edit(benchmark::State& state, const char* parameter) {
    Studio studio;
    widgets::MainWindow& window = studio.window();
    widgets::Document& document = window.document();
    auto* slider = window.findChild<QSlider*>(QString("slider:") + parameter);
    if (slider == nullptr || !slider->isEnabled()) {
        state.SkipWithError("there is no slider for this parameter");
        return;
    }
    if (window.viewport() != nullptr) {
        window.viewport()->setUpdatesEnabled(false);
    }
    const int from = slider->minimum() + (slider->maximum() - slider->minimum()) / 4;
    const int to = slider->minimum() + (slider->maximum() - slider->minimum()) * 3 / 4;
    int position = from;
    bench::Stopwatch whole, paint, validate, resolve, mobility, scene;
    for (auto _ : state) {
        position = position + 8 > to ? from : position + 8;
        const auto before = document.derived().parameters;
        state.SetIterationTime(whole.time([&] { slider->setValue(position); }));
        paint.time([] { QApplication::processEvents(); });
        if (document.derived().parameters == before || !document.derived().mechanism) {
            state.SkipWithError("the edit did not arrive");
            break;
        }
        const auto& rover = document.project().rover;
        validate.time(
            [&] { benchmark::DoNotOptimize(simcore::project::validate(document.project())); });
        resolve.time([&] {
            benchmark::DoNotOptimize(simcore::project::resolve(
                rover, simcore::project::evaluateParameters(rover).value()));
        });
        mobility.time([&] {
            for (const auto model :
                 {simcore::mobility::Model::Built, simcore::mobility::Model::Relaxed}) {
                benchmark::DoNotOptimize(analyse(*document.derived().mechanism, model));
            }
        });
        scene.time([&] { window.scene().setMechanism(*document.derived().mechanism); });
    }
    state.counters["median_ms"] = whole.medianMs();
    state.counters["p95_ms"] = 1e3 * whole.quantile(0.95);
    state.counters["validate_ms"] = validate.medianMs();
    state.counters["resolve_ms"] = resolve.medianMs();
    state.counters["mobility_ms"] = mobility.medianMs();
    state.counters["scene_ms"] = scene.medianMs();
    state.counters["paint_ms"] = paint.medianMs();
}

// A frame of the 3D view inside the window: drawn, put together with the panels, and shown.
void paintView(benchmark::State& state) {
    Studio studio;
    widgets::Viewport* viewport = studio.window().viewport();
    if (viewport == nullptr) {
        state.SkipWithError("no OpenGL here");
        return;
    }
    bench::Stopwatch whole;
    for (auto _ : state) {
        whole.time([&] {
            viewport->repaint();
            QApplication::processEvents();
        });
    }
    state.counters["median_ms"] = whole.medianMs();
    state.SetLabel(
        QString("view of %1x%2").arg(viewport->width()).arg(viewport->height()).toStdString());
}

}  // namespace

BENCHMARK_CAPTURE(edit, wheel_radius, "wheel_radius")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);
BENCHMARK_CAPTURE(edit, chassis_com_x, "chassis_com_x")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(60);
BENCHMARK(paintView)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(20);
