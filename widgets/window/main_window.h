#pragma once

#include <QMainWindow>
#include <memory>

#include "render/scene.h"
#include "simcore/project/edit.h"
#include "widgets/document/document.h"
#include "widgets/session/run_session.h"
#include "widgets/viewport/viewport.h"

class QLabel;
class QMenu;
class QSplitter;
class QTabWidget;
class QToolButton;

namespace widgets {

class ActionRegistry;
class ComparePanel;
class DragEditor;
class Experiment;
class FileCommands;
class GraphPanel;
class GuideWindow;
class ManualDrive;
class MassPanel;
class MobilityPanel;
class ParameterPanel;
class PartsPanel;
class PartsTree;
class PlotPanel;
class ProblemsPanel;
class PropertyPanel;
class RecordingCommands;
class RunBar;
class RunLibrary;
class SceneLink;
class StaticsPanel;
class StaticsSession;
class Tour;
class WayReviewer;

/// The studio: editors on the left, the 3D view in the middle, what follows from the design on the
/// right, run and plots at the bottom.
class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    MainWindow();
    ~MainWindow() override;

    Document& document() { return *document_; }

    RunSession& session() { return *session_; }

    FileCommands& files() { return *files_; }

    RecordingCommands& recordings() { return *recordings_; }

    ActionRegistry& actions() { return *actions_; }

    RunBar& runBar() { return *runBar_; }

    PlotPanel& plots() { return *plots_; }

    StaticsSession& statics() { return *statics_; }

    RunLibrary& library() { return *library_; }

    Experiment& experiment() { return *experiment_; }

    ComparePanel& compare() { return *compare_; }

    MobilityPanel& mobility() { return *mobility_; }

    Tour& tour() { return *tour_; }

    render::Scene& scene() { return *scene_; }

    /// Null without OpenGL.
    DragEditor* dragEditor() { return dragEditor_; }

    /// Null without OpenGL.
    Viewport* viewport() { return viewport_; }

    /// Starts or pauses; makes a new run when there is none or it is of another design. False when
    /// it cannot run; the problems panel says why.
    bool playPause();
    /// Drives the chosen scenario with the chosen controller and its rival, side by side. False
    /// when it cannot run.
    bool runExperiment();
    /// Opens a project or a recording, by its name; asks about unsaved changes first. False when it
    /// was not opened; says why.
    bool open(const QString& file);
    void setDark(bool dark);
    /// Size of all text [% of the system's]; see text_size.h.
    void setTextSize(int percent);

    int textSize() const { return textSize_; }

    /// Brings a panel to the front: "rover", "mobility", "advisor" and "motions" (pages of it),
    /// "graph", "statics", "compare", "mass", "problems", "history" or "run". False when there is
    /// no such panel.
    bool showPanel(const QString& name);
    /// Window size, panels and theme as the user left them.
    void restoreLayout();

  protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    /// Of saved arrangements of the panels.
    static constexpr int kLayoutVersion = 4;

    void makeActions();
    void makeFileActions();
    void makePartActions();
    /// "addBody" and so on, one for every kind of part.
    QMenu* makeAddMenu();
    void makeViewActions();
    QMenu* makeTextSizeMenu();
    void makeLanguageActions();
    void makeRunActions();
    void makeHelpActions();
    void makeDocks();
    QWidget* makeLeftPanel();
    void makeMenus();
    void makeToolBar();
    void makeStatusBar();
    void connectParts();
    void connectMobility();
    void makeGraphDock();

    void onProjectChanged();
    void updateStatics();
    void showStatics();
    void updateTitle();
    void updateStatus();
    void updateIcons();
    void updateRecent();
    void selectElement(simcore::project::ElementRef element);
    /// Names are those of joints and parts; "" = none. `more`: beside what is selected already.
    void selectJoint(const std::string& joint, bool more = false);
    void selectBody(const std::string& body, bool more = false);
    void selectInMobility(const std::string& joint);
    void setDragging(bool on);
    void setOverlay(bool render::Overlays::*overlay, bool on);
    bool prepareRun();
    /// False with critical problems, which it shows.
    bool showRunProblems(const simcore::Problems& problems);
    void updateController();
    void showRecording(const std::shared_ptr<RecordedRun>& run);
    void stepForward();
    void saveScreenshot();
    void saveFilm();
    /// Shows the panels of a kind of work: "design", "simulate" or "compare".
    void arrange(const QString& work);
    void showGuide();
    void showAbout();
    void showSystem();
    void tell(const QString& message);

    Document* document_;
    RunSession* session_;
    RunLibrary* library_;
    Experiment* experiment_;
    StaticsSession* statics_;
    WayReviewer* ways_;
    std::shared_ptr<render::Scene> scene_;
    ActionRegistry* actions_;
    FileCommands* files_;
    RecordingCommands* recordings_;
    Viewport* viewport_ = nullptr;
    SceneLink* link_ = nullptr;
    DragEditor* dragEditor_ = nullptr;
    ManualDrive* drive_ = nullptr;
    Tour* tour_ = nullptr;
    GuideWindow* guide_ = nullptr;
    PartsTree* tree_ = nullptr;
    PartsPanel* parts_ = nullptr;
    ParameterPanel* parameters_ = nullptr;
    PropertyPanel* properties_ = nullptr;
    QTabWidget* editors_ = nullptr;
    MobilityPanel* mobility_ = nullptr;
    GraphPanel* graph_ = nullptr;
    MassPanel* mass_ = nullptr;
    ProblemsPanel* problems_ = nullptr;
    RunBar* runBar_ = nullptr;
    PlotPanel* plots_ = nullptr;
    ComparePanel* compare_ = nullptr;
    QDockWidget* problemsDock_ = nullptr;
    QDockWidget* mobilityDock_ = nullptr;
    QDockWidget* staticsDock_ = nullptr;
    QMenu* recentMenu_ = nullptr;
    QMenu* overlayMenu_ = nullptr;
    QMenu* panelMenu_ = nullptr;
    QMenu* addMenu_ = nullptr;
    QMenu* languageMenu_ = nullptr;
    QLabel* mobilityStatus_ = nullptr;
    QLabel* massStatus_ = nullptr;
    QToolButton* problemStatus_ = nullptr;
    QByteArray firstLayout_;
    bool dark_ = true;
    int textSize_ = 100;
};

}  // namespace widgets
