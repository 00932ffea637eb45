// roverstudio: the studio's window.
#include <QApplication>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QIcon>
#include <QTimer>
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "simcore/base/version.h"
#include "simcore/io/project_file.h"
#include "simcore/project/names.h"
#include "widgets/panels/advisor_page.h"
#include "widgets/panels/compare_panel.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/session/experiment.h"
#include "widgets/session/run_bar.h"
#include "widgets/session/statics_session.h"
#include "widgets/window/action_registry.h"
#include "widgets/window/file_commands.h"
#include "widgets/window/language.h"
#include "widgets/window/main_window.h"
#include "widgets/window/recording_commands.h"
#include "widgets/window/tour.h"

namespace {

constexpr int kGood = 0;
constexpr int kAnswerIsNo = 1;
constexpr int kWrongUse = 2;
/// Until a dialog is laid out and painted.
constexpr int kDialogTime_ms = 800;

struct Options {
    std::string file;
    std::string screenshot;
    std::string size = "1440x900";
    std::string theme;
    std::string language;
    std::string scenario;
    std::string panel;
    std::string controller, against;
    std::vector<std::string> actions;
    double runFor = 0.0;
    bool tour = false, noTour = false;
    int textSize = 0;  ///< [%]; 0: as last time
};

simcore::project::ControllerKind kindOf(const std::string& name) {
    return simcore::project::fromName<simcore::project::ControllerKind>(name).value();
}

/// "1280x800" -> size; an invalid size for anything else.
QSize sizeFrom(const std::string& text) {
    const QStringList parts = QString::fromStdString(text).split('x');
    if (parts.size() != 2) {
        return {};
    }
    const QSize size(parts[0].toInt(), parts[1].toInt());
    return size.width() >= 320 && size.height() >= 240 && size.width() <= 16384 &&
                   size.height() <= 16384
               ? size
               : QSize();
}

/// Pictures are the same on every machine, whatever its settings.
QString languageOf(const Options& options) {
    if (!options.language.empty() || !options.screenshot.empty()) {
        return options.language.empty() ? "en" : QString::fromStdString(options.language);
    }
    const QString chosen = widgets::chosenLanguage();
    return chosen.isEmpty() ? widgets::systemLanguage() : chosen;
}

/// Lets the event loop run until `done` or for `limit` [ms].
template <class Done>
void waitFor(int limit, Done done) {
    QElapsedTimer clock;
    clock.start();
    while (!done() && clock.elapsed() < limit) {
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
}

/// Only of a window on the screen: the tab of a panel that was hidden can be raised then.
void showPanel(widgets::MainWindow& window, const Options& options) {
    if (!options.panel.empty()) {
        window.showPanel(QString::fromStdString(options.panel));
    }
}

int takeScreenshot(widgets::MainWindow& window, const Options& options) {
    window.resize(sizeFrom(options.size));
    window.show();
    showPanel(window, options);
    waitFor(600, [] { return false; });
    constexpr int kLongestStudy_ms = 60000;
    waitFor(kLongestStudy_ms, [&] { return !window.statics().isWorking(); });
    if (window.session().recorded() != nullptr) {
        if (options.runFor > 0.0) {
            window.session().scrub(options.runFor);
        }
    } else if (options.runFor > 0.0) {
        window.session().setSpeedFactor(0.0);
        const bool drives = options.against.empty() ? window.playPause() : window.runExperiment();
        if (!drives) {
            std::fprintf(stderr,
                         "roverstudio: %s: scenario %s cannot run; see 'roversim validate'\n",
                         options.file.c_str(), window.runBar().scenario().toUtf8().constData());
            return kAnswerIsNo;
        }
        using State = widgets::RunSession::State;
        constexpr int kLongest_ms = 600000;
        waitFor(kLongest_ms, [&] {
            const widgets::RunSession* rival = window.experiment().rival();
            const auto reached = [&](const widgets::RunSession& run) {
                return run.state() != State::Playing || run.endTime() >= options.runFor;
            };
            return reached(window.session()) && (rival == nullptr || reached(*rival));
        });
        window.session().pause();
        window.session().setSpeedFactor(1.0);
        if (window.session().endTime() > options.runFor) {
            window.session().scrub(options.runFor);
        }
    }
    QPixmap picture;
    for (const std::string& name : options.actions) {
        // A dialog that an action opens is what is to be pictured.
        QTimer dialogs;
        dialogs.setInterval(kDialogTime_ms);
        QObject::connect(&dialogs, &QTimer::timeout, [&picture] {
            if (QWidget* dialog = QApplication::activeModalWidget()) {
                picture = dialog->grab();
                dialog->close();
            }
        });
        dialogs.start();
        window.actions().at(QString::fromStdString(name))->trigger();
    }
    waitFor(kLongestStudy_ms, [&] { return !window.mobility().advisor().session().isWorking(); });
    // The plots redraw on a timer.
    waitFor(500, [] { return false; });
    for (const char* name : {"guide", "graphDock"}) {
        // A window of its own beside the main one.
        auto* beside = window.findChild<QWidget*>(name);
        if (picture.isNull() && beside != nullptr && beside->isVisible() && beside->isWindow()) {
            picture = beside->grab();
        }
    }
    if (picture.isNull()) {
        picture = window.grab();
    }
    if (!picture.save(QString::fromStdString(options.screenshot))) {
        std::fprintf(stderr,
                     "roverstudio: %s: the picture cannot be written; check that the folder exists "
                     "and that the name ends in .png\n",
                     options.screenshot.c_str());
        return kAnswerIsNo;
    }
    return kGood;
}

int run(const Options& options) {
    widgets::MainWindow window;
    const bool picturing = !options.screenshot.empty();
    if (picturing) {
        window.setDark(true);
    } else {
        window.restoreLayout();
    }
    if (!options.theme.empty()) {
        window.setDark(options.theme == "dark");
    }
    if (options.textSize > 0) {
        window.setTextSize(options.textSize);
    }
    if (!options.file.empty()) {
        const QString file = QString::fromStdString(options.file);
        if (!picturing) {
            window.open(file);
        } else if (const auto problems = widgets::RecordingCommands::isRecording(file)
                                             ? window.recordings().load(file)
                                             : window.document().open(file);
                   !problems.empty()) {
            std::fprintf(stderr, "roverstudio: %s\n", toString(problems).c_str());
            if (hasCritical(problems)) {
                return kAnswerIsNo;
            }
        }
    }
    if (!options.scenario.empty()) {
        window.runBar().setScenario(QString::fromStdString(options.scenario));
        if (window.runBar().scenario().toStdString() != options.scenario) {
            std::fprintf(stderr, "roverstudio: %s: there is no scenario '%s'\n",
                         options.file.c_str(), options.scenario.c_str());
            return kAnswerIsNo;
        }
    }
    if (!options.controller.empty()) {
        window.runBar().setController(kindOf(options.controller));
    }
    if (!options.against.empty()) {
        window.compare().setRival(kindOf(options.against));
    }
    for (const std::string& name : options.actions) {
        if (!window.actions().has(QString::fromStdString(name))) {
            std::fprintf(stderr, "roverstudio: there is no action '%s'\n", name.c_str());
            return kWrongUse;
        }
    }
    if (picturing) {
        return takeScreenshot(window, options);
    }
    window.show();
    showPanel(window, options);
    QTimer::singleShot(0, &window, [&window, &options] {
        window.files().offerRecovery();
        if (options.tour) {
            window.tour().start();
        } else if (!options.noTour) {
            window.tour().offerFirst();
        }
    });
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App commands{"Design wheeled rovers with passive suspension and drive them over terrain.",
                      "roverstudio"};
    commands.set_version_flag("--version", "roverstudio " + simcore::programVersion());
    commands.failure_message(CLI::FailureMessage::simple);
    commands.add_option("FILE", options.file, "project (.rover) or recording (.roverrec) to open");
    commands.add_option("--screenshot", options.screenshot,
                        "picture the window into this PNG file and exit");
    commands
        .add_option("--size", options.size, "size of the window for --screenshot, WIDTHxHEIGHT")
        ->check([](const std::string& text) {
            return sizeFrom(text).isValid()
                       ? std::string()
                       : "'" + text + "' is not WIDTHxHEIGHT, for example 1280x800";
        });
    commands.add_option("--theme", options.theme, "dark or light")
        ->check(CLI::IsMember({"dark", "light"}));
    commands
        .add_option("--text-size", options.textSize,
                    "size of all text [% of the system's]; else as last time, for pictures 100")
        ->check(CLI::Range(80, 200));
    auto* tour = commands.add_flag("--tour", options.tour, "begin with the tour");
    commands.add_flag("--no-tour", options.noTour, "no tour, not even at the first start")
        ->excludes(tour);
    std::vector<std::string> languages;
    for (const QString& language : widgets::languages()) {
        languages.push_back(language.toStdString());
    }
    commands
        .add_option("--language", options.language,
                    "language of the window; pictures are in English without it")
        ->check(CLI::IsMember(languages));
    commands.add_option("--scenario", options.scenario, "scenario to choose");
    commands.add_option("--panel", options.panel, "panel to bring to the front")
        ->check(CLI::IsMember({"rover", "mobility", "advisor", "motions", "graph", "statics",
                               "compare", "mass", "problems", "history", "run"}));
    const CLI::IsMember isController(
        simcore::project::allNames<simcore::project::ControllerKind>());
    commands.add_option("--controller", options.controller, "controller to choose")
        ->check(isController);
    commands
        .add_option("--against", options.against,
                    "second controller; with --run-for: drives beside the first")
        ->check(isController);
    commands
        .add_option("--do", options.actions,
                    "with --screenshot: actions to take first, such as moveParts,viewSide; of one "
                    "that opens a dialog, pictures that")
        ->delimiter(',')
        ->allow_extra_args(false);
    commands
        .add_option("--run-for", options.runFor,
                    "with --screenshot: drive this long first [s of simulated time]")
        ->check(CLI::Range(0.0, 1e5));
    try {
        commands.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return commands.exit(error) == 0 ? kGood : kWrongUse;
    }
    widgets::prepareOpenGl();
    QApplication application(argc, argv);
    QApplication::setOrganizationName("RoverStudio");
    QApplication::setApplicationName("RoverStudio");
    QApplication::setWindowIcon(QIcon::fromTheme("roverstudio"));
    QApplication::setDesktopFileName("roverstudio");
    QApplication::setApplicationVersion(QString::fromStdString(simcore::programVersion()));
    widgets::installLanguage(languageOf(options));
    return run(options);
}
