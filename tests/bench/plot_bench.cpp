// Plots of a long run: two plots of six wheels, 12 curves of 6000 points (60 s at 100 Hz), in the
// studio's plot panel. Timed is a whole refresh: ranges, both plots drawn and painted, values at
// the cursor. Goal: 20 ms, a quarter of the 80 ms between two refreshes of a running plot.
#include <qcustomplot.h>
#include <QApplication>

#include <benchmark/benchmark.h>

#include "tests/bench/stopwatch.h"
#include "tests/support/fake_run.h"
#include "widgets/plots/plot_panel.h"

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
    widgets::RunSession session;
    widgets::PlotPanel panel(&session);
    panel.setPlotCount(2);
    panel.setQuantity(0, "slip_ratio");
    panel.setQuantity(1, "torque_applied");
    panel.resize(1100, 320);
    panel.show();
    record(session);
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
            while (drawn < 2) {
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
    state.counters["points"] = 12.0 * static_cast<double>(session.recording().rows.size());
}

}  // namespace

BENCHMARK(replot)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(60);
