#include "widgets/session/experiment.h"

#include <utility>

#include "widgets/session/run_titles.h"

namespace widgets {

using State = RunSession::State;

Experiment::Experiment(RunSession* shown, RunLibrary* library, QObject* parent)
    : QObject(parent),
      shown_(shown),
      library_(library) {
    connect(shown_, &RunSession::stateChanged, this, &Experiment::follow);
    connect(shown_, &RunSession::speedFactorChanged, this, [this](double factor) {
        if (RunSession* rival = find()) {
            rival->setSpeedFactor(factor);
        }
    });
    connect(shown_, &RunSession::snapshotChanged, this, [this] {
        // A single step of the run on show.
        RunSession* rival = find();
        if (rival != nullptr && shown_->state() == State::Paused && shown_->isLive() &&
            rival->endTime() < shown_->endTime() - 1e-9) {
            rival->stepOnce();
        }
    });
    connect(shown_, &RunSession::runChanged, this, [this] {
        if (!starting_ && rival_ != 0) {
            if (RunSession* rival = find()) {
                rival->pause();
            }
            rival_ = 0;
            emit changed();
        }
    });
    connect(library_, &RunLibrary::changed, this, [this] {
        if (rival_ != 0 && find() == nullptr) {
            rival_ = 0;
            emit changed();
        }
    });
}

simcore::Problems Experiment::start(const simcore::project::Project& project,
                                    const simcore::run::RunRequest& request,
                                    simcore::project::ControllerKind rival,
                                    const std::string& projectFile) {
    auto other = std::make_unique<RunSession>();
    simcore::run::RunRequest rivalRequest = request;
    rivalRequest.controller = rival;
    simcore::Problems problems = other->prepare(project, rivalRequest, projectFile);
    if (hasCritical(problems)) {
        return problems;
    }
    starting_ = true;
    appendNew(problems, shown_->prepare(project, request, projectFile));
    starting_ = false;
    if (hasCritical(problems)) {
        return problems;
    }
    const QString name = runTitle(other->settings());
    for (const HeldRun& held : library_->runs()) {
        if (held.name == name) {
            library_->remove(held.id);  // the same anew
            break;
        }
    }
    other->setSpeedFactor(shown_->speedFactor());
    connect(other.get(), &RunSession::finished, this, &Experiment::changed);
    rival_ = library_->hold(std::move(other), project);
    library_->setGhost(rival_);
    shown_->play();
    emit changed();
    return problems;
}

RunSession* Experiment::find() const {
    const int index = library_->find(rival_);
    return index < 0 ? nullptr : library_->runs()[static_cast<std::size_t>(index)].session.get();
}

const RunSession* Experiment::rival() const {
    return find();
}

void Experiment::follow(State state) {
    RunSession* rival = find();
    if (rival == nullptr) {
        return;
    }
    switch (state) {
        case State::Playing:
            rival->play();
            break;
        case State::Paused:
            rival->pause();
            break;
        case State::Ready:
            rival->reset();
            break;
        case State::Empty:
        case State::Finished:
            break;
    }
    emit changed();
}

std::optional<simcore::experiment::Verdict> Experiment::verdict() const {
    const RunSession* other = rival();
    if (other == nullptr || shown_->state() != State::Finished ||
        other->state() != State::Finished) {
        return std::nullopt;
    }
    return simcore::experiment::judge(outcomeOf(*shown_), outcomeOf(*other));
}

simcore::experiment::Outcome outcomeOf(const RunSession& run) {
    simcore::experiment::Outcome outcome =
        simcore::experiment::outcomeOf(run.report(), *run.newest(), run.settings().mechanism);
    outcome.ran.controller = run.settings().controller;
    outcome.ran.friction = run.settings().friction;
    outcome.ran.seed = run.settings().seed;
    return outcome;
}

}  // namespace widgets
