// main() of benchmarks that open windows: settings and user folders of their own.
#include <QApplication>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

#include "widgets/viewport/viewport.h"

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const QTemporaryDir home;
    qputenv("HOME", home.path().toUtf8());
    qputenv("XDG_DATA_HOME", (home.path() + "/data").toUtf8());
    qputenv("XDG_CONFIG_HOME", (home.path() + "/config").toUtf8());
    widgets::prepareOpenGl();
    QApplication application(argc, argv);
    QApplication::setOrganizationName("RoverStudioBench");
    QApplication::setApplicationName("RoverStudioBench");
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
