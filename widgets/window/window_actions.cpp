// The actions and menus of the main window.
#include <QActionGroup>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressDialog>
#include <QScreen>
#include <QSettings>

#include "simcore/io/project_file.h"
#include "simcore/project/names.h"
#include "widgets/editors/field_info.h"
#include "widgets/editors/parts_panel.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/panels/advisor_page.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/plots/plot_panel.h"
#include "widgets/session/may_replace.h"
#include "widgets/session/run_bar.h"
#include "widgets/session/run_library.h"
#include "widgets/window/action_registry.h"
#include "widgets/window/file_commands.h"
#include "widgets/window/film.h"
#include "widgets/window/language.h"
#include "widgets/window/main_window.h"
#include "widgets/window/recording_commands.h"
#include "widgets/window/text_size.h"
#include "widgets/window/tour.h"

namespace widgets {

using simcore::project::ElementKind;
using simcore::project::ShapeKind;

namespace {

/// "addBody".
QString addActionName(ElementKind kind) {
    QString word = QString::fromStdString(wordFor(kind));
    word[0] = word[0].toUpper();
    return "add" + word;
}

QString addActionName(ShapeKind kind) {
    QString word = QString::fromStdString(nameOf(kind));
    word[0] = word[0].toUpper();
    return "addShape" + word;
}

/// All of them, in the order of the file format's table.
std::vector<ShapeKind> allShapeKinds() {
    std::vector<ShapeKind> kinds;
    for (const std::string& name : simcore::project::allNames<ShapeKind>()) {
        kinds.push_back(*simcore::project::fromName<ShapeKind>(name));
    }
    return kinds;
}

}  // namespace

void MainWindow::makeActions() {
    makeFileActions();
    makePartActions();
    makeViewActions();
    makeRunActions();
    makeHelpActions();
    for (QAction* action : actions_->all()) {
        // The step keys belong to the view and the run panel alone: see makeDocks().
        if (action != actions_->at("step") && action != actions_->at("stepBack")) {
            addAction(action);
        }
    }
}

void MainWindow::makeHelpActions() {
    actions_->add("guide", tr("&User guide"), {QKeySequence(Qt::Key_F1)},
                  tr("What every panel shows and every key does"), [this] { showGuide(); });
    actions_->add("tour", tr("&Tour"), {QKeySequence("Shift+F1")},
                  tr("Five minutes with SOLERO; again: ends it"), [this] {
                      if (tour_->isRunning()) {
                          tour_->end();
                      } else {
                          tour_->start();
                      }
                  });
    actions_->add("tourNext", tr("&Next step of the tour"), {QKeySequence("Ctrl+Return")}, {},
                  [this] { tour_->next(); });
    actions_->at("tourNext")->setEnabled(false);
    actions_->add("shortcuts", tr("&Keyboard shortcuts"), {QKeySequence("Ctrl+F1")},
                  tr("List all shortcuts"), [this] { showShortcuts(*actions_, this); });
    actions_->add("system", tr("System &information"), {},
                  tr("Versions and what draws, for a report"), [this] { showSystem(); });
    actions_->add("about", tr("&About RoverStudio"), {}, {}, [this] { showAbout(); });
}

void MainWindow::makeFileActions() {
    actions_->add("new", tr("&New"), {QKeySequence::New}, tr("An empty project"),
                  [this] { files_->createNew(); });
    actions_->add("newFromTemplate", tr("New from &template..."), {QKeySequence("Ctrl+Shift+N")},
                  tr("A rover of a topology and dimensions of your choice"),
                  [this] { files_->createFromTemplate(); });
    actions_->add("open", tr("&Open..."), {QKeySequence::Open}, tr("Open a project"), [this] {
        // Among all files there are recordings, too.
        if (const QString file = files_->chooseFile(); !file.isEmpty()) {
            open(file);
        }
    });
    actions_->add("save", tr("&Save"), {QKeySequence::Save}, tr("Save the project"),
                  [this] { files_->save(); });
    actions_->add("saveAs", tr("Save &as..."), {QKeySequence("Ctrl+Shift+S")},
                  tr("Save under another name"), [this] { files_->saveAs(); });
    actions_->add("recover", tr("Recover &unsaved work..."), {},
                  tr("Fetch what sessions that ended badly left unsaved"),
                  [this] { files_->recover(); });
    actions_->add("openRecording", tr("Open recordin&g..."), {QKeySequence("Ctrl+Shift+O")},
                  tr("Look at a recorded run"), [this] { recordings_->open(); });
    actions_->add("saveRecording", tr("Save recor&ding..."), {QKeySequence("Ctrl+Shift+R")},
                  tr("Save the run so far, with all that is needed to make it again"),
                  [this] { recordings_->save(); });
    actions_->add("exportCsv", tr("Run as &CSV..."), {QKeySequence("Ctrl+E")},
                  tr("Write the recorded run as a table"), [this] { plots_->exportCsv(); });
    actions_->add("exportChannels", tr("&Channels as CSV..."), {QKeySequence("Ctrl+Alt+E")},
                  tr("Write chosen channels of the visible time, or all of it, as a table"),
                  [this] { plots_->exportChannels(); });
    actions_->add("exportPlots", tr("&Plots as picture..."), {},
                  tr("Save the plots as PNG, SVG or PDF"), [this] { plots_->exportPicture(); });
    actions_->add("copyPlots", tr("Copy pl&ots"), {QKeySequence("Ctrl+Shift+P")},
                  tr("Copy the plots as a picture"), [this] { plots_->copyPicture(); });
    actions_->add("screenshot", tr("3D &view as picture..."), {QKeySequence("Ctrl+Shift+V")},
                  tr("Save the 3D view as PNG"), [this] { saveScreenshot(); });
    actions_->at("screenshot")->setEnabled(viewport_ != nullptr);
    actions_->add("exportFilm", tr("&Film of the 3D view..."), {},
                  tr("Save the run as MP4, WebM or GIF, as fast as it is played, by ffmpeg"),
                  [this] { saveFilm(); });
    actions_->at("exportFilm")->setEnabled(false);
    actions_->add("quit", tr("&Quit"), {QKeySequence("Ctrl+Q"), QKeySequence("Ctrl+W")}, {},
                  [this] { close(); });

    QAction* undo = document_->undoStack().createUndoAction(actions_, tr("&Undo"));
    undo->setShortcuts({QKeySequence("Ctrl+Z")});
    QAction* redo = document_->undoStack().createRedoAction(actions_, tr("&Redo"));
    redo->setShortcuts({QKeySequence("Ctrl+Y"), QKeySequence("Ctrl+Shift+Z")});
    actions_->adopt("undo", undo);
    actions_->adopt("redo", redo);
}

void MainWindow::makePartActions() {
    actions_->add("cut", tr("Cu&t"), {QKeySequence::Cut}, tr("Cut the selected parts"),
                  [this] { tree_->cutSelected(); });
    actions_->add("copy", tr("&Copy"), {QKeySequence::Copy},
                  tr("Copy the selected parts, for this project or another one"),
                  [this] { tree_->copySelected(); });
    actions_->add("paste", tr("&Paste"), {QKeySequence::Paste}, tr("Paste parts"),
                  [this] { tree_->paste(); });
    actions_->add("duplicate", tr("D&uplicate part"), {QKeySequence("Ctrl+D")},
                  tr("Copy the selected parts"), [this] { tree_->duplicateSelected(); });
    actions_->add("delete", tr("&Delete part"), {QKeySequence(Qt::Key_Delete)},
                  tr("Delete the selected parts"), [this] { tree_->deleteSelected(); });
    actions_->add("rename", tr("&Rename part"), {}, tr("Rename the current part (F2 in the tree)"),
                  [this] { tree_->renameSelected(); });
    actions_->add("mirror", tr("&Mirror part"), {QKeySequence("Ctrl+Shift+I")},
                  tr("Make a left and a right one of the selected parts"),
                  [this] { tree_->mirrorSelected(); });
    actions_->add("split", tr("Spl&it pair"), {QKeySequence("Ctrl+Shift+D")},
                  tr("Make two independent parts of a mirrored one"),
                  [this] { tree_->splitSelected(); });
    actions_->add("moveUp", tr("Move part &up"), {QKeySequence("Alt+Up")},
                  tr("Move the selected parts up in their list"),
                  [this] { tree_->moveSelected(-1); });
    actions_->add("moveDown", tr("Move part d&own"), {QKeySequence("Alt+Down")},
                  tr("Move the selected parts down in their list"),
                  [this] { tree_->moveSelected(1); });
    actions_->add("search", tr("&Search parts"), {QKeySequence::Find},
                  tr("Show only parts with a text in their name"), [this] {
                      showPanel("rover");
                      parts_->search();
                  });
    for (const ElementKind kind : simcore::project::allElementKinds()) {
        const QString title = kindTitle(kind);
        actions_->add(addActionName(kind), title, {}, tr("Add: %1").arg(inSentence(title)),
                      [this, kind] {
                          showPanel("rover");
                          tree_->add(kind);
                      });
    }
    for (const ShapeKind kind : allShapeKinds()) {
        const QString title = kindTitle(kind);
        actions_->add(addActionName(kind), title, {},
                      tr("Add to the selected body: %1").arg(inSentence(title)), [this, kind] {
                          showPanel("rover");
                          tree_->addShape(kind);
                      });
    }
}

QMenu* MainWindow::makeAddMenu() {
    auto* menu = new QMenu(tr("&Add part"), this);
    for (const ElementKind kind : simcore::project::allElementKinds()) {
        menu->addAction(actions_->at(addActionName(kind)));
        if (kind == ElementKind::Body) {
            QMenu* shapes = menu->addMenu(tr("Shape"));
            for (const ShapeKind shape : allShapeKinds()) {
                shapes->addAction(actions_->at(addActionName(shape)));
            }
        }
        // The rover's parts in between, what it is tried with behind them.
        if (kind == ElementKind::Parameter || kind == ElementKind::Payload) {
            menu->addSeparator();
        }
    }
    return menu;
}

void MainWindow::makeViewActions() {
    const auto view = [this](const QString& name, const QString& text, const char* key,
                             const QString& tip, void (Viewport::*slot)()) {
        QAction* action = actions_->add(name, text, {QKeySequence(key)}, tip);
        action->setEnabled(viewport_ != nullptr);
        if (viewport_ != nullptr) {
            connect(action, &QAction::triggered, viewport_, slot);
        }
    };
    view("fit", tr("&Fit"), "F", tr("Bring the whole rover into view"), &Viewport::fit);
    view("viewIso", tr("&Oblique"), "F3", tr("Look from the front right and above"),
         &Viewport::viewIso);
    view("viewFront", tr("Fr&ont"), "Ctrl+1", tr("Look at the front"), &Viewport::viewFront);
    view("viewSide", tr("&Side"), "Ctrl+2", tr("Look at the right side: forward is to the right"),
         &Viewport::viewSide);
    view("viewTop", tr("&Top"), "Ctrl+3", tr("Look down"), &Viewport::viewTop);
    QAction* orthographic =
        actions_->add("orthographic", tr("O&rthographic"), {QKeySequence("O")},
                      tr("Without perspective; front, side and top are to scale, with rulers"));
    QAction* moveParts = actions_->add(
        "moveParts", tr("&Move parts"), {QKeySequence("M")},
        tr("Drag joints, wheels and centres of mass with the mouse. Snaps to 5 mm, not with Ctrl; "
           "Shift keeps to one axis, Alt makes numbers of expressions, Escape takes it back"));
    for (QAction* action : {orthographic, moveParts}) {
        action->setCheckable(true);
        action->setEnabled(viewport_ != nullptr);
    }
    if (viewport_ != nullptr) {
        connect(orthographic, &QAction::toggled, viewport_, &Viewport::setOrthographic);
        connect(moveParts, &QAction::toggled, this, &MainWindow::setDragging);
    }
    QAction* follow = actions_->add("follow", tr("Fo&llow"), {QKeySequence("L")},
                                    tr("Keep the driving rover in view"));
    follow->setCheckable(true);
    follow->setChecked(true);
    follow->setEnabled(viewport_ != nullptr);
    if (viewport_ != nullptr) {
        connect(follow, &QAction::toggled, viewport_, &Viewport::setFollow);
    }

    overlayMenu_ = new QMenu(tr("S&how"), this);
    const auto overlay = [this](const QString& name, const QString& text, const char* key,
                                bool render::Overlays::*member) {
        QList<QKeySequence> keys;
        if (*key != '\0') {
            keys << QKeySequence(key);
        }
        QAction* action = actions_->add(name, text, keys);
        action->setCheckable(true);
        action->setChecked(scene_->overlays().*member);
        connect(action, &QAction::toggled, this,
                [this, member](bool on) { setOverlay(member, on); });
        overlayMenu_->addAction(action);
    };
    overlay("showCom", tr("&Centre of mass"), "Ctrl+Shift+C", &render::Overlays::centerOfMass);
    overlay("showSupport", tr("&Support polygon"), "Ctrl+Shift+G",
            &render::Overlays::supportPolygon);
    overlay("showForces", tr("Contact &forces"), "Ctrl+Shift+F", &render::Overlays::contactForces);
    overlay("showFreedoms", tr("&Freedoms at the joints"), "Ctrl+Shift+J",
            &render::Overlays::jointFreedoms);
    overlay("showTrail", tr("&Trail"), "Ctrl+Shift+T", &render::Overlays::trail);
    overlay("showGrid", tr("&Grid"), "", &render::Overlays::grid);
    overlay("showAxes", tr("World &axes"), "", &render::Overlays::axes);
    overlay("showShadow", tr("Sh&adow"), "", &render::Overlays::shadow);

    auto* themes = new QActionGroup(this);
    for (const bool dark : {true, false}) {
        QAction* action =
            actions_->add(dark ? "themeDark" : "themeLight", dark ? tr("&Dark") : tr("&Light"), {},
                          {}, [this, dark] { setDark(dark); });
        action->setCheckable(true);
        themes->addAction(action);
    }
    const auto textSize = [this](const char* name, const QString& text,
                                 const QList<QKeySequence>& keys, const QString& tip, int steps) {
        actions_->add(name, text, keys, tip, [this, steps] {
            setTextSize(steps == 0 ? 100 : steppedTextSize(textSize_, steps));
            tell(tr("Text size %1 %").arg(textSize_));
        });
    };
    textSize("textLarger", tr("&Larger"), {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")},
             tr("Larger text in all panels, plots and dialogs"), 1);
    textSize("textSmaller", tr("&Smaller"), {QKeySequence("Ctrl+-")},
             tr("Smaller text in all panels, plots and dialogs"), -1);
    textSize("textNormal", tr("&Normal"), {QKeySequence("Ctrl+0")},
             tr("Text as large as the system has it"), 0);
    makeLanguageActions();
    actions_->add("fullScreen", tr("F&ull screen"), {QKeySequence(Qt::Key_F11)}, {},
                  [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
    for (const auto& [name, text, keys, tip] :
         {std::tuple("design", tr("&Design"), "Ctrl+Shift+1",
                     tr("Parts and mobility, the 3D view as large as it goes")),
          std::tuple("simulate", tr("&Simulate"), "Ctrl+Shift+2",
                     tr("The 3D view over run and plots")),
          std::tuple("compare", tr("&Compare"), "Ctrl+Shift+3",
                     tr("Plots as large as they go beside the table of runs"))}) {
        const QString work = name;
        actions_->add("arrange:" + work, text, {QKeySequence(keys)}, tip,
                      [this, work] { arrange(work); });
    }
    actions_->add("resetLayout", tr("&Reset panels"), {}, tr("All panels back to their places"),
                  [this] { restoreState(firstLayout_, kLayoutVersion); });
}

QMenu* MainWindow::makeTextSizeMenu() {
    auto* menu = new QMenu(tr("Te&xt size"), this);
    for (const char* name : {"textLarger", "textSmaller", "textNormal"}) {
        menu->addAction(actions_->at(name));
    }
    return menu;
}

void MainWindow::makeLanguageActions() {
    languageMenu_ = new QMenu(tr("&Language"), this);
    auto* group = new QActionGroup(this);
    for (const QString& language : QStringList{QString()} + languages()) {
        const QString name = language.isEmpty() ? "System" : language.toUpper();
        QAction* action = actions_->add(
            "language" + name, language.isEmpty() ? tr("As the &system") : languageName(language),
            {}, {}, [this, language] {
                chooseLanguage(language);
                QMessageBox::information(
                    this, tr("Language"),
                    tr("The language changes when RoverStudio is started the next time."));
            });
        action->setCheckable(true);
        action->setChecked(language == chosenLanguage());
        group->addAction(action);
        languageMenu_->addAction(action);
    }
}

void MainWindow::makeRunActions() {
    actions_->add("playPause", tr("&Play"), {QKeySequence(Qt::Key_Space)},
                  tr("Drive, or pause (Space)"), [this] { playPause(); });
    actions_->add("step", tr("&Step"), {QKeySequence(Qt::Key_Right)},
                  tr("One time step, or one picture on while looking back (Right)"),
                  [this] { stepForward(); });
    actions_->add("stepBack", tr("Step &back"), {QKeySequence(Qt::Key_Left)},
                  tr("One picture back (Left)"), [this] { session_->scrubFrames(-1); });
    actions_->add("reset", tr("&Reset"), {QKeySequence(Qt::Key_Backspace), QKeySequence("Ctrl+R")},
                  tr("Back to the start of the run; the design stays (Backspace)"),
                  [this] { session_->reset(); });
    actions_->add("runAgain", tr("Run again and &compare"), {QKeySequence("Ctrl+Shift+E")},
                  tr("Run the opened recording again: is it the same to the last bit?"),
                  [this] { recordings_->runAgain(); });
    actions_->add("keepRun", tr("&Keep run"), {QKeySequence("Ctrl+K")},
                  tr("Hold a copy of the run on show, to compare the next with it"), [this] {
                      library_->keep(*session_, document_->project());
                      showPanel("compare");
                  });
    actions_->add("addRecording", tr("Add recordin&g to compare..."), {QKeySequence("Ctrl+Alt+K")},
                  tr("Hold a recording beside the run on show; the project stays"),
                  [this] { recordings_->add(); });
    actions_->add("experiment", tr("Run two &controllers"), {QKeySequence("Ctrl+Shift+K")},
                  tr("Drive the scenario with the chosen controller and its rival, side by side"),
                  [this] {
                      showPanel("compare");
                      runExperiment();
                  });
    actions_->add("faster", tr("&Faster"), {QKeySequence("+"), QKeySequence("=")},
                  tr("Faster playback"), [this] { runBar_->changeSpeed(1); });
    actions_->add("slower", tr("S&lower"), {QKeySequence("-")}, tr("Slower playback"),
                  [this] { runBar_->changeSpeed(-1); });
    actions_->add("live", tr("To the &end"), {QKeySequence("Ctrl+End")},
                  tr("Show the newest instant"), [this] { session_->goLive(); });
    actions_->add("showDesign", tr("Show the &design"), {QKeySequence("Ctrl+B")},
                  tr("Show the rover as drawn instead of the run"), [this] {
                      session_->pause();
                      session_->clear();
                  });
    actions_->add("showMobility", tr("&Mobility"), {QKeySequence("Ctrl+M")},
                  tr("Show the mobility panel"), [this] { showPanel("mobility"); });
    actions_->add("advise", tr("Find e&xact joints"), {QKeySequence("Ctrl+Shift+A")},
                  tr("Search joints to free so that nothing is redundant"), [this] {
                      showPanel("advisor");
                      mobility_->advisor().search();
                  });
    actions_->add("showMotions", tr("&Free motions"), {QKeySequence("Ctrl+Shift+W")},
                  tr("Show how the rover can move"), [this] { showPanel("motions"); });
    actions_->add("showGraph", tr("Joint &graph"), {QKeySequence("Ctrl+G")},
                  tr("Draw bodies and joints as a graph"), [this] { showPanel("graph"); });
    actions_->add("showStatics", tr("&Statics"), {QKeySequence("Ctrl+T")},
                  tr("Show the statics panel"), [this] { showPanel("statics"); });
    actions_->add("showCompare", tr("&Compare"), {QKeySequence("Ctrl+Shift+X")},
                  tr("Show the panel that compares runs"), [this] { showPanel("compare"); });
    actions_->add("showHistory", tr("&History"), {QKeySequence("Ctrl+H")},
                  tr("Show every step that can be undone"), [this] { showPanel("history"); });
    actions_->add("showProblems", tr("&Problems"), {QKeySequence("Ctrl+Shift+M")},
                  tr("Show the problems panel"), [this] { showPanel("problems"); });
}

void MainWindow::makeMenus() {
    const auto fill = [this](QMenu* menu, std::initializer_list<const char*> names) {
        for (const char* name : names) {
            if (*name == '\0') {
                menu->addSeparator();
            } else {
                menu->addAction(actions_->at(name));
            }
        }
    };
    QMenu* file = menuBar()->addMenu(tr("&File"));
    fill(file, {"new", "newFromTemplate", "open", "openRecording"});
    recentMenu_ = file->addMenu(tr("Open &recent"));
    QMenu* examples = file->addMenu(tr("Open &example"));
    for (const QString& example : files_->exampleFiles()) {
        const auto project = simcore::io::loadProject(example.toStdString());
        QAction* action = examples->addAction(project ? QString::fromStdString(project->rover.name)
                                                      : QFileInfo(example).fileName());
        if (project) {
            action->setToolTip(QString::fromStdString(project->rover.description));
        }
        connect(action, &QAction::triggered, this,
                [this, example] { files_->openExample(example); });
    }
    examples->setToolTipsVisible(true);
    fill(file, {"recover"});
    file->addSeparator();
    fill(file, {"save", "saveAs", "saveRecording", ""});
    QMenu* exports = file->addMenu(tr("&Export"));
    fill(exports, {"exportCsv", "exportChannels", "exportPlots", "screenshot", "exportFilm"});
    fill(file, {"", "quit"});
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    fill(edit,
         {"undo", "redo", "showHistory", "", "cut", "copy", "paste", "duplicate", "delete", ""});
    edit->addMenu(addMenu_);
    fill(edit, {"rename", "mirror", "split", "moveUp", "moveDown", "search", "", "copyPlots"});
    QMenu* view = menuBar()->addMenu(tr("&View"));
    fill(view, {"fit", "viewIso", "viewFront", "viewSide", "viewTop", "orthographic", "",
                "moveParts", "follow"});
    view->addMenu(overlayMenu_);
    view->addSeparator();
    view->addMenu(panelMenu_);
    QMenu* theme = view->addMenu(tr("T&heme"));
    fill(theme, {"themeDark", "themeLight"});
    fill(view->addMenu(tr("&Arrangement")),
         {"arrange:design", "arrange:simulate", "arrange:compare", "", "resetLayout"});
    view->addMenu(makeTextSizeMenu());
    view->addMenu(languageMenu_);
    view->addSeparator();
    fill(view, {"fullScreen"});
    fill(menuBar()->addMenu(tr("&Run")),
         {"playPause", "step", "stepBack", "live", "reset", "runAgain", "", "keepRun",
          "addRecording", "experiment", "", "faster", "slower", "", "showDesign"});
    fill(menuBar()->addMenu(tr("&Analyze")), {"showMobility", "advise", "showMotions", "showGraph",
                                              "showStatics", "showCompare", "showProblems"});
    fill(menuBar()->addMenu(tr("&Help")),
         {"guide", "tour", "tourNext", "shortcuts", "", "system", "about"});
}

void MainWindow::updateRecent() {
    recentMenu_->clear();
    for (const QString& file : files_->recentFiles()) {
        QAction* action = recentMenu_->addAction(QFileInfo(file).fileName());
        action->setToolTip(file);
        connect(action, &QAction::triggered, this, [this, file] { open(file); });
    }
    recentMenu_->setToolTipsVisible(true);
    recentMenu_->setEnabled(!recentMenu_->isEmpty());
    if (!recentMenu_->isEmpty()) {
        recentMenu_->addSeparator();
        connect(recentMenu_->addAction(tr("&Clear list")), &QAction::triggered, files_,
                &FileCommands::forgetRecentFiles);
    }
}

void MainWindow::arrange(const QString& work) {
    const auto dock = [this](const char* name) {
        return findChild<QDockWidget*>(QString(name) + "Dock");
    };
    restoreState(firstLayout_, kLayoutVersion);
    const bool designs = work == "design";
    const bool compares = work == "compare";
    dock("run")->setVisible(!designs);
    dock("rover")->setVisible(designs);
    showPanel(designs ? "mobility" : compares ? "compare" : "statics");
    for (const char* name : {"mobility", "statics", "compare", "mass", "problems"}) {
        // While one drives, the rover's own panels are in the way.
        dock(name)->setVisible(designs || compares);
    }
    if (designs || compares) {
        showPanel(designs ? "mobility" : "compare");
    }
    resizeDocks({dock("run")}, {compares ? height() * 3 / 5 : height() * 2 / 5}, Qt::Vertical);
}

void MainWindow::saveFilm() {
    QString file = QFileDialog::getSaveFileName(this, tr("Save film of the 3D view"), "run.mp4",
                                                tr("Films (*.mp4 *.webm *.gif)"));
    if (file.isEmpty()) {
        return;
    }
    if (QFileInfo(file).suffix().isEmpty()) {
        file += ".mp4";
        if (!mayReplace(this, file)) {
            return;
        }
    }
    FilmRequest request;
    request.file = file;
    request.from = plots_->window().first;
    request.to = std::min(plots_->window().second, session_->endTime());
    request.speed = session_->speedFactor() > 0.0 ? session_->speedFactor() : 1.0;
    constexpr int kParts = 1000;
    QProgressDialog progress(tr("Filming..."), tr("Cancel"), 0, kParts, this);
    progress.setWindowModality(Qt::WindowModal);
    progress.setMinimumDuration(0);
    const auto problems = writeFilm(*session_, *viewport_, request, [&progress](double part) {
        progress.setValue(static_cast<int>(part * (kParts - 1)));
        return !progress.wasCanceled();
    });
    const bool cancelled = progress.wasCanceled();
    progress.reset();
    if (!problems.empty()) {
        QMessageBox::warning(this, tr("Save film"), QString::fromStdString(toString(problems)));
    } else if (!cancelled) {
        tell(tr("Written: %1").arg(file));
    }
}

void MainWindow::saveScreenshot() {
    const QImage image = viewport_->grabImage();
    QString file =
        QFileDialog::getSaveFileName(this, tr("Save 3D view"), "rover.png", tr("PNG (*.png)"));
    if (file.isEmpty()) {
        return;
    }
    if (QFileInfo(file).suffix().isEmpty()) {
        file += ".png";
        if (!mayReplace(this, file)) {
            return;
        }
    }
    if (image.save(file)) {
        tell(tr("Written: %1").arg(file));
    } else {
        QMessageBox::warning(this, tr("Save 3D view"),
                             tr("%1 could not be written. Check that the folder exists and can be "
                                "written, and that the name ends in .png.")
                                 .arg(file));
    }
}

}  // namespace widgets
