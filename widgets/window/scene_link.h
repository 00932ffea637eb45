#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "render/scene.h"
#include "widgets/document/document.h"
#include "widgets/session/run_library.h"
#include "widgets/session/run_session.h"
#include "widgets/viewport/viewport.h"

namespace widgets {

/// A rover that stands somewhere without a run, with the run it would be of.
struct StandingRover {
    std::shared_ptr<const simcore::run::ResolvedRun> run;
    simcore::run::Snapshot snapshot;
};

/// Keeps the 3D scene in step with what is looked at: the *design*, drawn standing on the chosen
/// scenario's terrain or as statics find it, or an instant of a *run*, with the rover and the
/// terrain that run was made with.
class SceneLink : public QObject {
    Q_OBJECT
  public:
    SceneLink(Document* document, RunSession* session, RunLibrary* library,
              std::shared_ptr<render::Scene> scene, Viewport* viewport, QObject* parent = nullptr);

    /// The scenario whose terrain the design stands on.
    void setScenario(const QString& name);

    /// Leaves the design's terrain alone while it is held: a run's own will be shown instead.
    void holdTerrain(bool held) { terrainHeld_ = held; }

    /// Model whose freedoms are written at the joints.
    void setModel(simcore::mobility::Model model);
    void setOverlays(const render::Overlays& overlays);
    /// By name, as a run may have more joints and bodies than the design: "" = none.
    /// Both copies of a mirrored one, the first of them to other views; none: nothing is.
    void highlightJoints(std::vector<std::string> joints);
    /// @param shape  of each of them, instead of the whole body; -1: all of it
    void highlightBodies(std::vector<std::string> bodies, int shape = -1);

    /// Marks several, beside what is highlighted; by name, too.
    void mark(std::vector<std::string> joints, std::vector<std::string> bodies);

    /// What is on show.
    const simcore::mechanism::Mechanism& mechanism() const { return mechanism_; }

    bool showsRun() const { return showsRun_; }

    /// The rover as drawn, neither in a run nor standing somewhere nor swinging.
    bool showsDrawnPose() const { return !showsRun_ && !showsMotion_ && standingShown_ == nullptr; }

    /// Shows the rover as drawn also where it could stand somewhere.
    void keepDrawnPose(bool keep) { keepsDrawnPose_ = keep; }

    /// Shows the design again after looking at a run.
    void showDesign();

    /// The design stands like this, not as drawn, from now on; a playing run stays on show.
    void setStanding(StandingRover standing);
    /// As drawn again; a run that is there is on show again.
    void leaveStanding();

    /// The design as drawn, but with its bodies at these poses X_WB, until something else is shown.
    /// Ignored when they are not as many as the design's.
    void showMotion(const std::vector<simcore::Pose>& bodies);
    /// What showMotion() took the place of is on show again.
    void leaveMotion();

  signals:
    /// Another kind of thing is on show: the design, a standing rover, a run.
    void shownChanged();
    /// Another joint or body is highlighted, by name; "" = none.
    void highlightChanged(const QString& joint, const QString& body);
    /// Why the terrain cannot be shown.
    void problems(const simcore::Problems& problems);

  private:
    void showRun(const simcore::run::Snapshot& snapshot);
    void showGhost();
    void showStanding();
    void showDrawn();
    void showRunOrDesign();
    void showMechanism(const simcore::mechanism::Mechanism& mechanism);
    void showTerrain();
    void showFreedoms();
    void showHighlight();
    void redraw();

    Document* document_;
    RunSession* session_;
    RunLibrary* library_;
    std::shared_ptr<render::Scene> scene_;
    Viewport* viewport_;
    simcore::mechanism::Mechanism mechanism_;  ///< of what is on show
    // By name: an edit may give the element another place.
    std::vector<std::string> highlightedJoints_, highlightedBodies_;
    int highlightedShape_ = -1;  ///< of each of these bodies; -1: all of it
    std::vector<std::string> markedJoints_, markedBodies_;
    QString scenario_;
    simcore::mobility::Model model_ = simcore::mobility::Model::Built;
    bool showsRun_ = false;
    bool keepsDrawnPose_ = false;
    bool showsMotion_ = false;
    int ghostShown_ = 0;  ///< id of its run
    std::shared_ptr<const simcore::mechanism::Mechanism> ghostMechanism_;
    std::optional<StandingRover> standing_;
    std::shared_ptr<const simcore::run::ResolvedRun> standingShown_;  ///< null: something else is
    // What the design's terrain was made from.
    simcore::project::Scenario terrainOf_;
    simcore::project::ParameterValues terrainParameters_;
    simcore::project::ProjectFiles terrainFiles_;
    bool terrainShown_ = false, terrainHeld_ = false;
};

}  // namespace widgets
