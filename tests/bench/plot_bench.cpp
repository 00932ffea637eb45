// Plots of long runs, of six wheels for 60 s at 100 Hz: 6000 points a curve, in the studio's plot
// panel. Timed is a whole refresh: ranges, all plots drawn and painted, values at the cursor. With
// four plots and a kept run laid over, there are 48 curves. Goal: 6 ms, of 80 ms between two
// refreshes of a running plot.
#include <qcustomplot.h>
#include <QApplication>

#include <benchmark/benchmark.h>

#include "tests/bench/stopwatch.h"
#include "tests/support/fake_run.h"
#include "widgets/plots/plot_panel.h"
#include "widgets/session/run_library.h"

namespace {

/// Lets the session record an invented drive of one minute.
void record(widgets::RunSession& session) {
    session.adopt(std::make_unique<simcore::run::RunWorker>(test_support::fakeRun(60.0),
                                                            test_support::fakeStepper()),
                  {});
    session.setSpeedFactor(0.0);
    session.play();
    while (session.state() == widgets::RunSession::State::Playing) {
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }
}

void replot(benchmark::State& state) {
    const auto plotCount = static_cast<int>(state.range(0));
    const auto kept = static_cast<int>(state.range(1));
    widgets::RunSession session;
    widgets::RunLibrary library;
    widgets::PlotPanel panel(&session, &library);
    panel.setPlotCount(plotCount);
    int place = 0;
    for (const char* quantity : {"slip_ratio", "torque_applied", "normal_force", "rate"}) {
        panel.setQuantity(place++, quantity);
    }
    panel.resize(1100, 320);
    panel.show();
    record(session);
    for (int i = 0; i < kept; ++i) {
        library.keep(session, {});
    }
    if (session.recording().rows.size() < 6000 || session.settings().mechanism.wheels.size() != 6) {
        state.SkipWithError("the recording is too short");
        return;
    }
    int drawn = 0;
    std::vector<QCustomPlot*> plots;
    for (auto* plot : panel.findChildren<QCustomPlot*>()) {
        if (plot->isVisible()) {
            plots.push_back(plot);
            QObject::connect(plot, &QCustomPlot::afterReplot, &panel, [&drawn] { ++drawn; });
        }
    }
    for (int i = 0; i < 20; ++i) {
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    bench::Stopwatch whole, curves;
    for (auto _ : state) {
        drawn = 0;
        whole.time([&] {
            panel.fit();
            while (drawn < plotCount) {
                QApplication::processEvents();
            }
            QApplication::processEvents();
        });
        state.PauseTiming();
        curves.time([&] {
            for (QCustomPlot* plot : plots) {
                plot->replot(QCustomPlot::rpImmediateRefresh);
            }
        });
        QApplication::processEvents();
        state.ResumeTiming();
    }
    state.counters["median_ms"] = whole.medianMs();
    state.counters["curves_ms"] = curves.medianMs();
    state.counters["curves"] = 6.0 * plotCount * (1 + kept);
    state.counters["points"] =
        6.0 * plotCount * (1 + kept) * static_cast<double>(session.recording().rows.size());
}

}  // namespace

BENCHMARK(replot)
    ->ArgNames({"plots", "kept"})
    ->Args({2, 0})
    ->Args({4, 0})
    ->Args({4, 1})
    ->Args({4, 4})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(60);
