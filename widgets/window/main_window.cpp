#include "widgets/window/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QSysInfo>
#include <QTabWidget>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QUndoView>
#include <QVBoxLayout>
#include <map>

#include "simcore/base/version.h"
#include "simcore/project/element_names.h"
#include "simcore/project/units.h"
#include "widgets/editors/parameter_panel.h"
#include "widgets/editors/parts_panel.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/editors/property_panel.h"
#include "widgets/panels/advisor_page.h"
#include "widgets/panels/compare_panel.h"
#include "widgets/panels/graph_panel.h"
#include "widgets/panels/mass_panel.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/panels/motion_page.h"
#include "widgets/panels/problems_panel.h"
#include "widgets/panels/statics_panel.h"
#include "widgets/plots/plot_panel.h"
#include "widgets/session/experiment.h"
#include "widgets/session/manual_drive.h"
#include "widgets/session/run_bar.h"
#include "widgets/session/run_library.h"
#include "widgets/session/statics_session.h"
#include "widgets/session/way_reviewer.h"
#include "widgets/window/action_registry.h"
#include "widgets/window/drag_editor.h"
#include "widgets/window/file_commands.h"
#include "widgets/window/guide_window.h"
#include "widgets/window/icons.h"
#include "widgets/window/recording_commands.h"
#include "widgets/window/scene_link.h"
#include "widgets/window/text_size.h"
#include "widgets/window/theme.h"
#include "widgets/window/tour.h"

namespace widgets {

using simcore::project::ElementKind;
using simcore::project::ElementRef;
using State = RunSession::State;

namespace {

constexpr int kMessageTime_ms = 8000;

/// Name of an element of a mechanism; empty when there is none.
template <class Element>
std::string nameAt(const std::vector<Element>& elements, int index) {
    return index >= 0 && index < static_cast<int>(elements.size())
               ? elements[static_cast<std::size_t>(index)].name
               : std::string();
}

/// What is drawn at first: enough to understand the rover, not all at once.
render::Overlays firstOverlays() {
    render::Overlays overlays;
    overlays.centerOfMass = true;
    overlays.contactForces = true;
    overlays.trail = true;
    return overlays;
}

}  // namespace

MainWindow::MainWindow()
    : document_(new Document(this)),
      session_(new RunSession(this)),
      library_(new RunLibrary(this)),
      experiment_(new Experiment(session_, library_, this)),
      statics_(new StaticsSession(this)),
      ways_(new WayReviewer(this)),
      scene_(std::make_shared<render::Scene>()),
      actions_(new ActionRegistry(this)),
      files_(new FileCommands(document_, this)),
      recordings_(new RecordingCommands(session_, files_, this)) {
    setObjectName("mainWindow");
    setAcceptDrops(true);
    setDockNestingEnabled(true);
    scene_->setOverlays(firstOverlays());
    QWidget* view = makeViewport(scene_, this);
    viewport_ = qobject_cast<Viewport*>(view);
    setCentralWidget(view);
    link_ = new SceneLink(document_, session_, library_, scene_, viewport_, this);
    makeActions();
    makeDocks();
    makeMenus();
    makeToolBar();
    makeStatusBar();
    drive_ = new ManualDrive(session_, this);
    connect(drive_, &ManualDrive::commandChanged, runBar_, &RunBar::showCommand);
    tour_ = new Tour(this);
    connect(tour_, &Tour::runningChanged, actions_->at("tourNext"), &QAction::setEnabled);
    connectParts();
    onProjectChanged();
    updateTitle();
    updateRecent();
    resize(1440, 900);
    firstLayout_ = saveState(kLayoutVersion);
}

MainWindow::~MainWindow() {
    // Closing hides the panel: its pose must not leave a picture that is gone.
    statics_->setActive(false);
    ways_->setActive(false);
    mobility_->motions().stop();
    disconnect(mobility_, nullptr, this, nullptr);
    // The scene's graphics objects go while the viewport still has its context.
    delete takeCentralWidget();
}

void MainWindow::makeDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    const auto add = [this](Qt::DockWidgetArea area, const QString& title, const QString& name,
                            QWidget* content) {
        auto* dock = new QDockWidget(title, this);
        dock->setObjectName(name);
        dock->setWidget(content);
        dock->setAccessibleName(title);
        addDockWidget(area, dock);
        return dock;
    };
    QDockWidget* rover = add(Qt::LeftDockWidgetArea, tr("Rover"), "roverDock", makeLeftPanel());
    mobility_ = new MobilityPanel(document_);
    mass_ = new MassPanel(document_);
    problems_ = new ProblemsPanel(document_);
    mobilityDock_ = add(Qt::RightDockWidgetArea, tr("Mobility"), "mobilityDock", mobility_);
    staticsDock_ =
        add(Qt::RightDockWidgetArea, tr("Statics"), "staticsDock", new StaticsPanel(statics_));
    compare_ = new ComparePanel(session_, library_, experiment_);
    QDockWidget* compare = add(Qt::RightDockWidgetArea, tr("Compare"), "compareDock", compare_);
    QDockWidget* mass = add(Qt::RightDockWidgetArea, tr("Mass"), "massDock", mass_);
    problemsDock_ = add(Qt::RightDockWidgetArea, tr("Problems"), "problemsDock", problems_);
    auto* steps = new QUndoView(&document_->undoStack());
    steps->setObjectName("historyList");
    steps->setEmptyLabel(tr("As opened"));
    steps->setAccessibleName(tr("Steps that can be undone"));
    steps->setFrameShape(QFrame::NoFrame);
    steps->setSpacing(2);
    QDockWidget* history = add(Qt::RightDockWidgetArea, tr("History"), "historyDock", steps);
    tabifyDockWidget(mobilityDock_, staticsDock_);
    tabifyDockWidget(staticsDock_, compare);
    tabifyDockWidget(compare, mass);
    tabifyDockWidget(mass, problemsDock_);
    tabifyDockWidget(problemsDock_, history);
    mobilityDock_->raise();
    history->hide();
    for (QDockWidget* dock : {mobilityDock_, staticsDock_, compare, mass, problemsDock_, history}) {
        // The tab says what the title would, and a panel's height is dear.
        dock->setTitleBarWidget(new QWidget(dock));
    }

    auto* run = new QWidget;
    runBar_ = new RunBar(session_,
                         {actions_->at("playPause"), actions_->at("step"), actions_->at("reset")});
    plots_ = new PlotPanel(session_, library_);
    auto* layout = new QVBoxLayout(run);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(runBar_);
    layout->addWidget(plots_, 1);
    QDockWidget* runDock = add(Qt::BottomDockWidgetArea, tr("Run and plots"), "runDock", run);
    resizeDocks({rover, mobilityDock_}, {340, 350}, Qt::Horizontal);
    resizeDocks({runDock}, {300}, Qt::Vertical);
    // Arrow keys step through the run here, and do their usual work elsewhere.
    for (const char* name : {"step", "stepBack"}) {
        QAction* action = actions_->at(name);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        run->addAction(action);
        centralWidget()->addAction(action);
    }
    panelMenu_ = new QMenu(tr("&Panels"), this);
    for (QDockWidget* dock :
         {rover, mobilityDock_, staticsDock_, compare, mass, problemsDock_, history, runDock}) {
        panelMenu_->addAction(dock->toggleViewAction());
    }
    makeGraphDock();
}

void MainWindow::makeGraphDock() {
    graph_ = new GraphPanel(document_);
    auto* dock = new QDockWidget(tr("Joint graph"), this);
    dock->setObjectName("graphDock");
    dock->setAccessibleName(dock->windowTitle());
    dock->setWidget(graph_);
    addDockWidget(Qt::BottomDockWidgetArea, dock);
    // A window of its own at first: it wants more room than the panels have.
    dock->setFloating(true);
    dock->resize(1040, 620);
    dock->hide();
    panelMenu_->addAction(dock->toggleViewAction());
    connect(dock, &QDockWidget::visibilityChanged, graph_, &GraphPanel::setActive);
    connect(graph_, &GraphPanel::jointChosen, this,
            [this](const QString& joint) { selectJoint(joint.toStdString()); });
    connect(graph_, &GraphPanel::bodyChosen, this,
            [this](const QString& body) { selectBody(body.toStdString()); });
    connect(link_, &SceneLink::highlightChanged, graph_, &GraphPanel::select);
}

QWidget* MainWindow::makeLeftPanel() {
    tree_ = new PartsTree(document_);
    std::vector<QAction*> partActions;
    for (const char* name : {"cut", "copy", "paste", "duplicate", "delete", "", "rename", "mirror",
                             "split", "moveUp", "moveDown", ""}) {
        partActions.push_back(*name == '\0' ? nullptr : actions_->at(name));
    }
    addMenu_ = makeAddMenu();
    partActions.push_back(addMenu_->menuAction());
    tree_->setMenuActions(partActions);
    parts_ = new PartsPanel(tree_, addMenu_);
    parameters_ = new ParameterPanel(document_);
    properties_ = new PropertyPanel(document_);
    editors_ = new QTabWidget;
    editors_->setDocumentMode(true);
    editors_->setObjectName("editors");
    editors_->setAccessibleName(tr("Parameters and properties"));
    editors_->addTab(parameters_, tr("Parameters"));
    editors_->addTab(properties_, tr("Properties"));
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(parts_);
    splitter->addWidget(editors_);
    splitter->setStretchFactor(0, 2);
    splitter->setStretchFactor(1, 3);
    splitter->setSizes({320, 400});
    splitter->setChildrenCollapsible(false);
    return splitter;
}

void MainWindow::makeToolBar() {
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName("tools");
    bar->setMovable(false);
    bar->setIconSize({20, 20});
    for (const char* name : {"new", "open", "save"}) {
        bar->addAction(actions_->at(name));
    }
    bar->addSeparator();
    bar->addAction(actions_->at("undo"));
    bar->addAction(actions_->at("redo"));
    bar->addSeparator();
    for (const char* name :
         {"fit", "viewIso", "viewFront", "viewSide", "viewTop", "orthographic", "follow"}) {
        bar->addAction(actions_->at(name));
    }
    auto* overlays = new QToolButton;
    overlays->setText(tr("Show"));
    overlays->setToolTip(tr("What is drawn over the rover"));
    overlays->setAccessibleName(tr("What is drawn over the rover"));
    overlays->setPopupMode(QToolButton::InstantPopup);
    overlays->setMenu(overlayMenu_);
    overlays->setObjectName("showButton");
    bar->addWidget(overlays);
    bar->addSeparator();
    bar->addAction(actions_->at("moveParts"));
    updateIcons();
}

void MainWindow::makeStatusBar() {
    mobilityStatus_ = new QLabel;
    mobilityStatus_->setAccessibleName(tr("Mobility"));
    massStatus_ = new QLabel;
    massStatus_->setAccessibleName(tr("Mass"));
    problemStatus_ = new QToolButton;
    problemStatus_->setAutoRaise(true);
    problemStatus_->setObjectName("problemStatus");
    connect(problemStatus_, &QToolButton::clicked, this, [this] {
        problemsDock_->show();
        problemsDock_->raise();
    });
    for (QLabel* label : {mobilityStatus_, massStatus_}) {
        label->setContentsMargins(8, 0, 8, 0);
    }
    statusBar()->addPermanentWidget(mobilityStatus_);
    statusBar()->addPermanentWidget(massStatus_);
    statusBar()->addPermanentWidget(problemStatus_);
}

void MainWindow::connectParts() {
    connect(document_, &Document::changed, this, &MainWindow::onProjectChanged);
    connect(document_, &Document::fileChanged, this, &MainWindow::updateTitle);
    connect(document_, &Document::replaced, this, [this] {
        session_->clear();
        statics_->forgetPlace();
        runBar_->chooseFirst();
        if (viewport_ != nullptr) {
            viewport_->viewOverview();
        }
    });
    connect(document_, &Document::modifiedChanged, this, &MainWindow::setWindowModified);
    connect(files_, &FileCommands::message, this, &MainWindow::tell);
    connect(files_, &FileCommands::problems, problems_, &ProblemsPanel::showMore);
    connect(files_, &FileCommands::autosaveProblems, problems_, &ProblemsPanel::setStanding);
    connect(recordings_, &RecordingCommands::message, this, &MainWindow::tell);
    connect(recordings_, &RecordingCommands::opened, this, &MainWindow::showRecording);
    connect(files_, &FileCommands::recentFilesChanged, this, &MainWindow::updateRecent);

    connect(tree_, &PartsTree::elementSelected, this, &MainWindow::selectElement);
    connect(tree_, &PartsTree::selectionMoved, mobility_,
            [this] { mobility_->setSelection(tree_->selection()); });
    connect(tree_, &PartsTree::refused, this, &MainWindow::tell);
    connect(tree_, &PartsTree::message, this, &MainWindow::tell);
    connect(properties_, &PropertyPanel::refused, this, &MainWindow::tell);
    connect(properties_, &PropertyPanel::chosen, this, &MainWindow::selectElement);
    connect(properties_, &PropertyPanel::shapeWanted, tree_, &PartsTree::addShape);
    connect(problems_, &ProblemsPanel::elementChosen, this, &MainWindow::selectElement);
    connect(problems_, &ProblemsPanel::adviceRequested, actions_->at("advise"), &QAction::trigger);
    connect(problems_, &ProblemsPanel::countChanged, this, &MainWindow::updateStatus);
    connectMobility();
    connect(mass_, &MassPanel::bodyChosen, this, [this](int body) {
        const auto& mechanism = document_->derived().mechanism;
        selectBody(mechanism ? nameAt(mechanism->bodies, body) : std::string());
    });
    connect(link_, &SceneLink::problems, problems_, &ProblemsPanel::showMore);
    connect(plots_, &PlotPanel::written, this,
            [this](const QString& file) { tell(tr("Written: %1").arg(file)); });

    connect(runBar_, &RunBar::requestChanged, this, [this] {
        if (session_->state() == State::Playing) {
            session_->pause();
        }
        link_->setScenario(runBar_->scenario());
        if (session_->state() == State::Ready) {
            session_->clear();
        } else {
            session_->setStale(true);
        }
        link_->showDesign();
        updateController();
        updateStatics();
    });
    connect(compare_, &ComparePanel::startRequested, this, &MainWindow::runExperiment);
    connect(compare_, &ComparePanel::keepRequested, this,
            [this] { library_->keep(*session_, document_->project()); });
    connect(compare_, &ComparePanel::addRequested, actions_->at("addRecording"), &QAction::trigger);
    connect(compare_, &ComparePanel::saveRequested, recordings_,
            qOverload<const RunSession&>(&RecordingCommands::save));
    connect(recordings_, &RecordingCommands::added, this,
            [this](const std::shared_ptr<RecordedRun>& run) {
                library_->hold(std::move(*run), document_->project());
                showPanel("compare");
            });
    connect(document_, &Document::changed, library_,
            [this] { library_->setProject(document_->project()); });
    connect(document_, &Document::replaced, library_, &RunLibrary::clear);
    connect(staticsDock_, &QDockWidget::visibilityChanged, statics_, &StaticsSession::setActive);
    connect(statics_, &StaticsSession::shownChanged, this, &MainWindow::showStatics);
    connect(problemsDock_, &QDockWidget::visibilityChanged, ways_, &WayReviewer::setActive);
    connect(ways_, &WayReviewer::findingsChanged, problems_,
            [this] { problems_->setMoreFindings(ways_->findings()); });
    const auto updateForRun = [this] {
        const bool recorded = session_->recorded() != nullptr;
        actions_->at("saveRecording")->setEnabled(session_->hasRun() && !recorded);
        actions_->at("runAgain")->setEnabled(recorded);
        actions_->at("keepRun")->setEnabled(session_->hasRun());
        actions_->at("exportFilm")->setEnabled(session_->hasRun() && viewport_ != nullptr);
        updateTitle();
    };
    connect(session_, &RunSession::runChanged, this, updateForRun);
    updateForRun();
    connect(session_, &RunSession::recordingFailed, this,
            [this](const simcore::Problems& problems) {
                problems_->showMore(problems);
                tell(tr("The run goes on, but it cannot be saved: %1")
                         .arg(QString::fromStdString(problems.front().reason)));
            });
    connect(session_, &RunSession::finished, this, [this](const simcore::run::RunReport& report) {
        tell(tr("Run finished after %1 s: state hash %2, friction violation %3 %, largest loop "
                "error %4 mm")
                 .arg(report.simTime, 0, 'f', 2)
                 .arg(QString::fromStdString(report.stateHash))
                 .arg(report.frictionViolationPercent, 0, 'f', 2)
                 .arg(1e3 * report.loopErrorMax, 0, 'f', 4));
    });
    if (viewport_ != nullptr) {
        dragEditor_ = new DragEditor(document_, viewport_, this);
        connect(dragEditor_, &DragEditor::elementChosen, this, &MainWindow::selectElement);
        connect(link_, &SceneLink::shownChanged, this,
                [this] { dragEditor_->setDesignShown(link_->showsDrawnPose()); });
        connect(viewport_, &Viewport::jointPicked, this, [this](int joint, bool more) {
            selectJoint(nameAt(link_->mechanism().joints, joint), more);
        });
        connect(viewport_, &Viewport::bodyPicked, this, [this](int body, bool more) {
            selectBody(nameAt(link_->mechanism().bodies, body), more);
        });
        viewport_->setFollow(true);
    }
}

void MainWindow::connectMobility() {
    connect(mobility_, &MobilityPanel::jointChosen, this, [this](int joint) {
        const auto& mechanism = document_->derived().mechanism;
        selectJoint(mechanism ? nameAt(mechanism->joints, joint) : std::string());
    });
    connect(mobility_, &MobilityPanel::wheelChosen, this, [this](int wheel) {
        const auto& mechanism = document_->derived().mechanism;
        if (mechanism) {
            selectBody(nameAt(mechanism->bodies,
                              mechanism->wheels.at(static_cast<std::size_t>(wheel)).body));
        }
    });
    connect(mobility_, &MobilityPanel::modelChanged, this, [this] {
        link_->setModel(mobility_->model());
        graph_->setModel(mobility_->model());
        updateStatus();
    });
    connect(mobility_, &MobilityPanel::marked, this,
            [this](const QStringList& joints, const QStringList& bodies) {
                const auto names = [](const QStringList& list) {
                    std::vector<std::string> texts;
                    for (const QString& name : list) {
                        texts.push_back(name.toStdString());
                    }
                    return texts;
                };
                link_->mark(names(joints), names(bodies));
            });
    connect(mobilityDock_, &QDockWidget::visibilityChanged, mobility_, &MobilityPanel::setActive);
    MotionPage* motions = &mobility_->motions();
    connect(motions, &MotionPage::posesShown, link_, &SceneLink::showMotion);
    connect(motions, &MotionPage::ended, link_, &SceneLink::leaveMotion);
    connect(session_, &RunSession::snapshotChanged, motions, &MotionPage::stop);
    connect(session_, &RunSession::runChanged, motions, &MotionPage::stop);
    connect(runBar_, &RunBar::requestChanged, motions, &MotionPage::stop);
    connect(statics_, &StaticsSession::shownChanged, motions, &MotionPage::stop);
}

void MainWindow::onProjectChanged() {
    if (session_->state() == State::Playing) {
        session_->pause();
    }
    runBar_->setProject(document_->project());
    link_->setScenario(runBar_->scenario());
    if (session_->state() == State::Ready) {
        session_->clear();
    } else if (session_->hasRun()) {
        session_->setStale(true);
    }
    ways_->setSubject(document_->project(), document_->files());
    updateController();
    updateStatics();
    updateStatus();
}

void MainWindow::updateController() {
    compare_->setController(runBar_->controller());
}

void MainWindow::updateStatics() {
    simcore::run::RunRequest request = runBar_->request();
    request.files = document_->files();
    statics_->setSubject(document_->project(), request);
}

void MainWindow::showStatics() {
    if (statics_->isActive() && statics_->shown() != nullptr) {
        link_->setStanding({statics_->current()->run, statics_->snapshot()});
    } else {
        link_->leaveStanding();
    }
}

bool MainWindow::showPanel(const QString& name) {
    using Page = MobilityPanel::Page;
    const std::map<QString, Page> pages{
        {"mobility", Page::Counts}, {"advisor", Page::Advisor}, {"motions", Page::Motions}};
    const auto page = pages.find(name);
    if (page != pages.end()) {
        mobility_->setPage(page->second);
    }
    auto* dock = page != pages.end() ? mobilityDock_ : findChild<QDockWidget*>(name + "Dock");
    if (dock == nullptr) {
        return false;
    }
    const bool hidden = dock->isHidden();
    dock->show();
    dock->raise();
    if (hidden) {
        // A tab that comes back is made by the layout, later.
        QTimer::singleShot(0, dock, [dock] { dock->raise(); });
    }
    return true;
}

void MainWindow::updateTitle() {
    const RecordedRun* recorded = session_->recorded();
    setWindowTitle(tr("%1[*] - RoverStudio")
                       .arg(recorded != nullptr
                                ? QString::fromStdString(recorded->file.filename().string())
                                : document_->displayName()));
    setWindowFilePath(document_->file());
    setWindowModified(document_->isModified());
}

void MainWindow::updateStatus() {
    const auto& derived = document_->derived();
    if (derived.mechanism) {
        const bool built = mobility_->model() == simcore::mobility::Model::Built;
        const auto& report = built ? derived.built : derived.relaxed;
        mobilityStatus_->setText((built ? tr("As built: mobility %1, %2 redundant")
                                        : tr("Relaxed: mobility %1, %2 redundant"))
                                     .arg(report.mobility)
                                     .arg(report.redundant));
        massStatus_->setText(tr("%1 kg").arg(QString::fromStdString(
            simcore::project::formatIn(derived.mechanism->mass(), "kg", 4))));
    } else {
        mobilityStatus_->setText(tr("Mobility unknown"));
        massStatus_->clear();
    }
    const int count = problems_->count();
    problemStatus_->setText(count == 0   ? tr("No problems")
                            : count == 1 ? tr("1 problem")
                                         : tr("%1 problems").arg(count));
    problemsDock_->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems (%1)").arg(count));
}

void MainWindow::tell(const QString& message) {
    statusBar()->showMessage(message, kMessageTime_ms);
}

void MainWindow::selectElement(ElementRef element) {
    const bool fromTree = sender() == tree_;
    if (!fromTree) {
        tree_->select(element);
    }
    if (element.kind == ElementKind::Parameter && !fromTree) {
        // Its value is what a problem is about.
        editors_->setCurrentWidget(parameters_);
        if (element.index >= 0) {
            parameters_->focusParameter(
                QString::fromStdString(nameOf(document_->project(), element)));
        }
        return;
    }
    properties_->setElement(element);
    if (element.index < 0) {
        return;
    }
    editors_->setCurrentWidget(properties_);
    const simcore::mechanism::Mechanism& shown = link_->mechanism();
    const std::string& name = nameOf(document_->project(), element);
    // A mirrored element stands for both sides, which are all shown, the left one first.
    const auto copies = [&name](auto finder) {
        using simcore::project::Side;
        std::vector<std::string> found;
        for (const std::string& copy :
             {name, nameOnSide(name, Side::Left), nameOnSide(name, Side::Right)}) {
            if (finder(copy) >= 0 && (found.empty() || found.back() != copy)) {
                found.push_back(copy);
            }
        }
        return found;
    };
    if (element.kind == ElementKind::Joint) {
        const std::vector<std::string> joints =
            copies([&](const std::string& n) { return shown.findJoint(n); });
        link_->highlightJoints(joints);
        selectInMobility(joints.empty() ? std::string() : joints.front());
    } else if (element.kind == ElementKind::Body) {
        // A shape as one of its body; -1, the whole of it.
        link_->highlightBodies(copies([&](const std::string& n) { return shown.findBody(n); }),
                               element.shape);
    } else if (element.kind == ElementKind::Wheel) {
        const auto find = [&](const std::string& n) { return shown.findWheel(n); };
        std::vector<std::string> bodies;
        for (const std::string& wheel : copies(find)) {
            const int body = shown.wheels[static_cast<std::size_t>(find(wheel))].body;
            bodies.push_back(nameAt(shown.bodies, body));
        }
        link_->highlightBodies(std::move(bodies));
    } else {
        link_->highlightJoints({});
    }
}

void MainWindow::selectInMobility(const std::string& joint) {
    const auto& mechanism = document_->derived().mechanism;
    mobility_->selectJoint(mechanism ? mechanism->findJoint(joint) : -1);
}

void MainWindow::selectJoint(const std::string& joint, bool more) {
    link_->highlightJoints(joint.empty() ? std::vector<std::string>() : std::vector{joint});
    if (joint.empty()) {
        return;
    }
    const ElementRef element = simcore::project::findElement(
        document_->project(), simcore::project::ElementKind::Joint, joint);
    more ? tree_->toggle(element) : tree_->select(element);
    properties_->setElement(element);
    editors_->setCurrentWidget(properties_);
    selectInMobility(joint);
}

void MainWindow::selectBody(const std::string& body, bool more) {
    if (more && body.empty()) {
        return;  // a click beside the rover while collecting parts
    }
    link_->highlightBodies(body.empty() ? std::vector<std::string>() : std::vector{body});
    mobility_->selectJoint(-1);
    if (body.empty()) {
        tree_->select({});
        return;
    }
    const ElementRef element = simcore::project::findElement(
        document_->project(), simcore::project::ElementKind::Body, body);
    more ? tree_->toggle(element) : tree_->select(element);
    properties_->setElement(element);
    editors_->setCurrentWidget(properties_);
}

void MainWindow::setDragging(bool on) {
    // Handles belong to the rover as drawn, not as it stands or drives somewhere.
    link_->keepDrawnPose(on);
    if (on) {
        if (session_->state() == State::Playing) {
            session_->pause();
        }
        link_->showDesign();
    }
    dragEditor_->setActive(on);
}

void MainWindow::setOverlay(bool render::Overlays::*overlay, bool on) {
    render::Overlays overlays = scene_->overlays();
    overlays.*overlay = on;
    link_->setOverlays(overlays);
}

bool MainWindow::prepareRun() {
    files_->autosave();
    simcore::run::RunRequest request = runBar_->request();
    request.files = document_->files();
    return showRunProblems(
        session_->prepare(document_->project(), request, document_->file().toStdString()));
}

bool MainWindow::showRunProblems(const simcore::Problems& problems) {
    if (simcore::hasCritical(problems)) {
        problems_->showMore(problems);
        problemsDock_->show();
        problemsDock_->raise();
        runBar_->showStatus(tr("Cannot run: see Problems"));
        return false;
    }
    return true;
}

bool MainWindow::runExperiment() {
    files_->autosave();
    simcore::run::RunRequest request = runBar_->request();
    request.files = document_->files();
    return showRunProblems(experiment_->start(document_->project(), request, compare_->rival(),
                                              document_->file().toStdString()));
}

bool MainWindow::playPause() {
    switch (session_->state()) {
        case State::Playing:
            session_->pause();
            return true;
        case State::Finished:
            if (!session_->isStale() && session_->recorded() == nullptr) {
                session_->reset();
            }
            break;
        default:
            break;
    }
    const bool needsRun =
        !session_->hasRun() || session_->isStale() || session_->recorded() != nullptr;
    if (needsRun && !prepareRun()) {
        return false;
    }
    session_->play();
    return true;
}

void MainWindow::showRecording(const std::shared_ptr<RecordedRun>& run) {
    link_->holdTerrain(true);  // the run has it; making it again takes time
    document_->openProject(run->project, run->request.files);
    runBar_->setScenario(QString::fromStdString(run->request.scenario));
    session_->show(std::move(*run));
    link_->holdTerrain(false);
}

bool MainWindow::open(const QString& file) {
    return RecordingCommands::isRecording(file) ? recordings_->openFile(file)
                                                : files_->openFile(file);
}

void MainWindow::stepForward() {
    if (session_->hasRun() && !session_->isLive()) {
        session_->scrubFrames(1);
        return;
    }
    if ((session_->hasRun() && !session_->isStale()) || prepareRun()) {
        session_->stepOnce();
    }
}

void MainWindow::setDark(bool dark) {
    dark_ = dark;
    applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
    scene_->setTheme(dark);
    actions_->at(dark ? "themeDark" : "themeLight")->setChecked(true);
    updateIcons();
    if (viewport_ != nullptr) {
        viewport_->requestRedraw();
    }
}

void MainWindow::setTextSize(int percent) {
    textSize_ = applyTextSize(*qApp, percent);
    for (QDockWidget* dock : findChildren<QDockWidget*>()) {
        dock->setFont(QApplication::font());  // their titles do not follow by themselves
    }
    constexpr int kIcon = 20;
    const QSize icon = QSize(kIcon, kIcon) * textSize_ / 100;
    findChild<QToolBar*>("tools")->setIconSize(icon);
    for (QToolButton* button : runBar_->findChildren<QToolButton*>()) {
        button->setIconSize(icon);
    }
    actions_->at("textLarger")->setEnabled(steppedTextSize(textSize_, 1) != textSize_);
    actions_->at("textSmaller")->setEnabled(steppedTextSize(textSize_, -1) != textSize_);
    if (viewport_ != nullptr) {
        viewport_->requestRedraw();
    }
}

void MainWindow::restoreLayout() {
    const QSettings settings;
    setTextSize(settings.value("window/textSize", 100).toInt());
    restoreGeometry(settings.value("window/geometry").toByteArray());
    restoreState(settings.value("window/state").toByteArray(), kLayoutVersion);
    setDark(settings.value("window/dark", true).toBool());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!files_->mayDiscard()) {
        event->ignore();
        return;
    }
    session_->pause();
    QSettings settings;
    settings.setValue("window/geometry", saveGeometry());
    settings.setValue("window/state", saveState(kLayoutVersion));
    settings.setValue("window/dark", dark_);
    settings.setValue("window/textSize", textSize_);
    files_->discardAutosave();
    event->accept();
}

void MainWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        updateIcons();
    }
    QMainWindow::changeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    const QString file = urls.size() == 1 ? urls.front().toLocalFile() : QString();
    if (file.endsWith(".rover") || RecordingCommands::isRecording(file)) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    open(event->mimeData()->urls().front().toLocalFile());
}

void MainWindow::updateIcons() {
    if (recentMenu_ == nullptr) {
        return;
    }
    const std::pair<const char*, Icon> icons[] = {{"new", Icon::New},
                                                  {"open", Icon::Open},
                                                  {"save", Icon::Save},
                                                  {"undo", Icon::Undo},
                                                  {"redo", Icon::Redo}};
    for (const auto& [name, icon] : icons) {
        actions_->at(name)->setIcon(lineIcon(icon, palette()));
    }
}

void MainWindow::showSystem() {
    const QString renderer = openGlRenderer();
    QMessageBox box(
        QMessageBox::NoIcon, tr("System information"),
        tr("<table cellspacing=6><tr><td>RoverStudio</td><td>%1</td></tr>"
           "<tr><td>System</td><td>%2</td></tr>"
           "<tr><td>Qt</td><td>%3, platform %4</td></tr>"
           "<tr><td>OpenGL</td><td>%5</td></tr></table>")
            .arg(QString::fromStdString(simcore::programVersion()),
                 QSysInfo::prettyProductName() + ", " + QSysInfo::currentCpuArchitecture(),
                 qVersion(), QGuiApplication::platformName(),
                 renderer.isEmpty() ? tr("not available") : renderer),
        QMessageBox::Close, this);
    box.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box.exec();
}

void MainWindow::showGuide() {
    if (guide_ == nullptr) {
        guide_ = new GuideWindow(this);
    }
    guide_->show();
    guide_->raise();
    guide_->activateWindow();
}

void MainWindow::showAbout() {
    QMessageBox::about(
        this, tr("About RoverStudio"),
        tr("<h3>RoverStudio %1</h3><p>Design wheeled rovers with passive suspension, see whether "
           "they are statically determinate, and drive them over terrain.</p><p>After Lamon, "
           "Thüer, Jordi and Siegwart, <i>Modeling and Optimization of Wheeled Rovers</i>, "
           "2004.</p><p>Free software under the GNU General Public License, version 3 or later. "
           "No warranty.</p><p>Uses Qt, OpenSceneGraph, the Open Dynamics Engine, Eigen, muParser, "
           "QCustomPlot, nlohmann-json and fmt.</p>")
            .arg(QString::fromStdString(simcore::programVersion())));
}

}  // namespace widgets
