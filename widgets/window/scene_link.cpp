#include "widgets/window/scene_link.h"

#include <algorithm>
#include <array>
#include <utility>

#include "simcore/run/simulation.h"
#include "simcore/terrain/terrain.h"

namespace widgets {

using simcore::project::ParameterValues;

namespace {

bool allNumbers(const simcore::project::Terrain& t) {
    const std::array quantities{&t.start,     &t.height,    &t.length,   &t.slope,
                                &t.radius,    &t.coverage,  &t.cell,     &t.scale,
                                &t.origin[0], &t.origin[1], &t.origin[2]};
    return std::all_of(quantities.begin(), quantities.end(),
                       [](const auto* quantity) { return quantity->isLiteral(); }) &&
           std::all_of(t.terrains.begin(), t.terrains.end(), allNumbers);
}

/// The parameters that a scenario's terrain depends on: none when it is all numbers.
ParameterValues parametersFor(const simcore::project::Scenario& scenario,
                              const ParameterValues& parameters) {
    const bool fixed = allNumbers(scenario.terrain) && scenario.run.distance.isLiteral() &&
                       scenario.controller.speed.isLiteral();
    return fixed ? ParameterValues() : parameters;
}

QString firstOf(const std::vector<std::string>& names) {
    return names.empty() ? QString() : QString::fromStdString(names.front());
}

}  // namespace

SceneLink::SceneLink(Document* document, RunSession* session, RunLibrary* library,
                     std::shared_ptr<render::Scene> scene, Viewport* viewport, QObject* parent)
    : QObject(parent),
      document_(document),
      session_(session),
      library_(library),
      scene_(std::move(scene)),
      viewport_(viewport) {
    connect(document_, &Document::changed, this, &SceneLink::showDesign);
    connect(session_, &RunSession::snapshotChanged, this, &SceneLink::showRun);
    const auto followGhost = [this] {
        showGhost();
        redraw();
    };
    connect(library_, &RunLibrary::changed, this, followGhost);
    connect(library_, &RunLibrary::dataChanged, this, followGhost);
    connect(session_, &RunSession::runChanged, this, [this] {
        // Whatever run was shown is gone.
        showsRun_ = false;
        if (!session_->hasRun()) {
            showDesign();
        }
    });
    connect(session_, &RunSession::dataReplaced, this, [this] {
        // A reset; a long recording is also replaced when it is thinned, which moves nothing.
        if (showsRun_ && session_->endTime() == 0.0) {
            scene_->clearTrail();
        }
    });
}

void SceneLink::showMechanism(const simcore::mechanism::Mechanism& mechanism) {
    mechanism_ = mechanism;
    standingShown_.reset();
    scene_->setMechanism(mechanism_);
    showFreedoms();
    showHighlight();
}

void SceneLink::showDesign() {
    showsRun_ = false;
    showsMotion_ = false;
    showGhost();
    if (standing_ && !keepsDrawnPose_) {
        showStanding();
    } else {
        showDrawn();
    }
    emit shownChanged();
}

void SceneLink::showDrawn() {
    const auto& derived = document_->derived();
    // With critical problems the last good rover stays on show.
    if (derived.mechanism) {
        showMechanism(*derived.mechanism);
    }
    showTerrain();
    redraw();
    emit shownChanged();
}

void SceneLink::setStanding(StandingRover standing) {
    standing_ = std::move(standing);
    if (session_->state() != RunSession::State::Playing) {
        showDesign();
    }
}

void SceneLink::showMotion(const std::vector<simcore::Pose>& bodies) {
    if (!showsMotion_) {
        showsRun_ = false;
        showGhost();
        showDrawn();
        showsMotion_ = true;
        emit shownChanged();
    }
    if (bodies.size() != mechanism_.bodies.size()) {
        return;
    }
    simcore::run::Snapshot snapshot;
    snapshot.bodies = bodies;
    snapshot.wheels.resize(mechanism_.wheels.size());
    snapshot.centerOfMass = mechanism_.centerOfMass(bodies);
    scene_->clearTrail();
    scene_->setSnapshot(snapshot);
    redraw();
}

void SceneLink::leaveMotion() {
    if (!showsMotion_) {
        return;
    }
    showsMotion_ = false;
    if (standing_) {
        showDesign();
    } else {
        showRunOrDesign();
    }
}

void SceneLink::leaveStanding() {
    if (!standing_) {
        return;
    }
    standing_.reset();
    showRunOrDesign();
}

void SceneLink::showRunOrDesign() {
    if (session_->hasRun() && !session_->isStale()) {
        showRun(*session_->shown());
    } else {
        showDesign();
    }
}

void SceneLink::showStanding() {
    if (standingShown_ != standing_->run) {
        showMechanism(standing_->run->mechanism);
        scene_->setTerrain(standing_->run->terrain);
        terrainShown_ = false;
        standingShown_ = standing_->run;
    }
    scene_->clearTrail();
    scene_->setSnapshot(standing_->snapshot);
    redraw();
}

void SceneLink::showRun(const simcore::run::Snapshot& snapshot) {
    showsMotion_ = false;
    if (!showsRun_) {
        const auto& run = session_->settings();
        showMechanism(run.mechanism);
        scene_->setTerrain(run.terrain);
        terrainShown_ = false;
        showsRun_ = true;
        if (session_->recorded() != nullptr) {
            scene_->setTrail(session_->recording().frames);
        }
        emit shownChanged();
    }
    scene_->setSnapshot(snapshot);
    showGhost();
    redraw();
}

void SceneLink::showGhost() {
    const RunSession* ghost = showsRun_ ? library_->ghostRun() : nullptr;
    if (ghost == nullptr) {
        ghostShown_ = 0;
        ghostMechanism_.reset();
        scene_->setGhost(nullptr, {});
        return;
    }
    if (ghostShown_ != library_->ghost()) {
        ghostShown_ = library_->ghost();
        ghostMechanism_ =
            std::make_shared<simcore::mechanism::Mechanism>(ghost->settings().mechanism);
    }
    scene_->setGhost(ghostMechanism_, ghost->instantNear(session_->shownTime())->bodies);
}

void SceneLink::setScenario(const QString& name) {
    scenario_ = name;
    if (!showsRun_ && !standing_) {
        showTerrain();
        redraw();
    }
}

void SceneLink::showTerrain() {
    if (terrainHeld_) {
        return;
    }
    const auto& project = document_->project();
    const simcore::project::Scenario* scenario = nullptr;
    for (const auto& one : project.scenarios) {
        if (one.name == scenario_.toStdString()) {
            scenario = &one;
        }
    }
    const auto& parameters = document_->derived().parameters;
    if (scenario == nullptr) {
        scene_->setTerrain(nullptr);
        terrainShown_ = false;
        return;
    }
    if (terrainShown_ && scenario->terrain == terrainOf_.terrain &&
        document_->files() == terrainFiles_ && scenario->run.distance == terrainOf_.run.distance &&
        scenario->controller.speed == terrainOf_.controller.speed &&
        parametersFor(*scenario, parameters) == terrainParameters_) {
        return;
    }
    auto terrain = simcore::run::makeScenarioTerrain(*scenario, parameters, document_->files());
    if (!terrain) {
        emit problems(terrain.problems());
        scene_->setTerrain(nullptr);
        terrainShown_ = false;
        return;
    }
    scene_->setTerrain(
        std::make_shared<const simcore::terrain::Terrain>(std::move(terrain).value()));
    terrainOf_ = *scenario;
    terrainFiles_ = document_->files();
    terrainParameters_ = parametersFor(*scenario, parameters);
    terrainShown_ = true;
}

void SceneLink::setModel(simcore::mobility::Model model) {
    model_ = model;
    showFreedoms();
    redraw();
}

void SceneLink::showFreedoms() {
    std::vector<int> counts;
    for (const auto& joint : mechanism_.joints) {
        counts.push_back(static_cast<int>(freedomsOf(joint, model_).size()));
    }
    scene_->setJointFreedomCounts(std::move(counts));
}

void SceneLink::setOverlays(const render::Overlays& overlays) {
    scene_->setOverlays(overlays);
    redraw();
}

void SceneLink::highlightJoints(std::vector<std::string> joints) {
    highlightedJoints_ = std::move(joints);
    highlightedBodies_.clear();
    showHighlight();
    emit highlightChanged(firstOf(highlightedJoints_), {});
    redraw();
}

void SceneLink::highlightBodies(std::vector<std::string> bodies, int shape) {
    highlightedBodies_ = std::move(bodies);
    highlightedShape_ = shape;
    highlightedJoints_.clear();
    showHighlight();
    emit highlightChanged({}, firstOf(highlightedBodies_));
    redraw();
}

void SceneLink::mark(std::vector<std::string> joints, std::vector<std::string> bodies) {
    if (joints == markedJoints_ && bodies == markedBodies_) {
        return;
    }
    markedJoints_ = std::move(joints);
    markedBodies_ = std::move(bodies);
    showHighlight();
    redraw();
}

void SceneLink::showHighlight() {
    const auto found = [](const std::vector<std::string>& names, const auto& find) {
        std::vector<int> indices;
        for (const std::string& name : names) {
            if (const int index = find(name); index >= 0) {
                indices.push_back(index);
            }
        }
        return indices;
    };
    const auto joints = [&](const std::vector<std::string>& names) {
        return found(names, [&](const std::string& name) { return mechanism_.findJoint(name); });
    };
    const auto bodies = [&](const std::vector<std::string>& names) {
        return found(names, [&](const std::string& name) { return mechanism_.findBody(name); });
    };
    render::Scene::Highlight shown{joints(highlightedJoints_), bodies(highlightedBodies_),
                                   highlightedShape_};
    // What is welded to another body shows as all of that, in which its shapes come later.
    const auto hasShape = [&](int index) {
        const auto& body = mechanism_.bodies[static_cast<std::size_t>(index)];
        return shown.shape < static_cast<int>(body.shapes.size()) &&
               std::find(highlightedBodies_.begin(), highlightedBodies_.end(), body.name) !=
                   highlightedBodies_.end();
    };
    if (!std::all_of(shown.bodies.begin(), shown.bodies.end(), hasShape)) {
        shown.shape = -1;
    }
    scene_->highlight(std::move(shown));
    scene_->mark(joints(markedJoints_), bodies(markedBodies_));
}

void SceneLink::redraw() {
    if (viewport_ != nullptr) {
        viewport_->requestRedraw();
    }
}

}  // namespace widgets
