#include "widgets/session/run_session.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "simcore/project/resolve.h"

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;
using simcore::run::RunWorker;
using simcore::run::WorkerState;

namespace {

constexpr int kPollPeriod_ms = 33;

}  // namespace

RunSession::RunSession(QObject* parent) : QObject(parent) {
    poll_.setInterval(kPollPeriod_ms);
    poll_.setTimerType(Qt::PreciseTimer);
    connect(&poll_, &QTimer::timeout, this, &RunSession::poll);
}

RunSession::~RunSession() = default;

Problems RunSession::prepare(const simcore::project::Project& project,
                             const simcore::run::RunRequest& request,
                             const std::string& projectFile) {
    simcore::run::RunRequest located = request;
    located.files.folder = std::filesystem::path(projectFile).parent_path();
    auto run = simcore::run::prepareRun(project, located);
    if (!run) {
        return run.problems();
    }
    Problems problems = run.problems();
    auto worker = std::make_unique<RunWorker>(std::move(run).value());
    const simcore::run::RunReport report = worker->report();
    if (worker->state() == WorkerState::Finished && !report.stopDetail.empty()) {
        problems.push_back({Severity::Critical, "scenario " + request.scenario,
                            "the simulation could not be made: " + report.stopDetail,
                            "Check the rover's masses, joints and wheels."});
        return problems;
    }
    adopt(std::move(worker), simcore::io::originOf(project, request, projectFile));
    return problems;
}

void RunSession::adopt(std::unique_ptr<RunWorker> worker, simcore::io::RecordingOrigin origin) {
    poll_.stop();
    worker_ = std::move(worker);
    origin_ = std::move(origin);
    live_ = worker_->latest();
    scrubbed_.reset();
    store_.start(worker_->settings().mechanism);
    worker_->setSpeedFactor(speedFactor_);
    store_.drain(*worker_);
    const bool startsFinished = worker_->state() == WorkerState::Finished;
    setStale(false);
    state_ = startsFinished ? State::Finished : State::Ready;
    emit runChanged();
    emit stateChanged(state_);
    emit snapshotChanged(*live_);
}

void RunSession::clear() {
    poll_.stop();
    worker_.reset();
    live_.reset();
    scrubbed_.reset();
    store_.start({});
    setStale(false);
    state_ = State::Empty;
    emit runChanged();
    emit stateChanged(state_);
}

void RunSession::setStale(bool stale) {
    if (stale_ != stale) {
        stale_ = stale;
        emit staleChanged(stale);
    }
}

void RunSession::play() {
    if (state_ != State::Ready && state_ != State::Paused) {
        return;
    }
    goLive();
    worker_->play();
    setState(State::Playing);
    poll_.start();
}

void RunSession::pause() {
    if (state_ == State::Playing) {
        worker_->pause();
        poll();
    }
}

void RunSession::togglePlay() {
    if (state_ == State::Playing) {
        pause();
    } else {
        play();
    }
}

void RunSession::stepOnce() {
    if (!hasRun() || state_ == State::Finished) {
        return;
    }
    scrubbed_.reset();
    worker_->stepOnce();
    poll();
}

void RunSession::reset() {
    if (!hasRun()) {
        return;
    }
    poll_.stop();
    worker_->reset();
    store_.clearData();
    scrubbed_.reset();
    store_.drain(*worker_);
    live_ = worker_->latest();
    emit dataReplaced();
    setState(worker_->state() == WorkerState::Finished ? State::Finished : State::Ready);
    emit snapshotChanged(*live_);
}

void RunSession::setSpeedFactor(double factor) {
    if (factor == speedFactor_) {
        return;
    }
    speedFactor_ = factor;
    if (worker_) {
        worker_->setSpeedFactor(factor);
    }
    emit speedFactorChanged(factor);
}

void RunSession::setManualCommand(const simcore::run::ManualCommand& command) {
    if (worker_) {
        worker_->setManualCommand(command);
    }
}

void RunSession::scrub(double time) {
    if (!hasRun()) {
        return;
    }
    pause();
    const auto frame = store_.frameNear(time);
    // The newest instant is usually a little younger than the last frame.
    if (!frame || std::abs(live_->time - time) <= std::abs(frame->time - time)) {
        goLive();
        return;
    }
    show(frame);
}

void RunSession::scrubFrames(int count) {
    if (!hasRun()) {
        return;
    }
    pause();
    const auto& frames = recording().frames;
    const int index = store_.indexNear(shownTime()) + count;
    if (index >= static_cast<int>(frames.size())) {
        goLive();
    } else {
        show(frames[static_cast<std::size_t>(std::max(0, index))]);
    }
}

void RunSession::show(std::shared_ptr<const simcore::run::Snapshot> frame) {
    scrubbed_ = std::move(frame);
    emit snapshotChanged(*scrubbed_);
}

void RunSession::goLive() {
    if (scrubbed_) {
        scrubbed_.reset();
        emit snapshotChanged(*live_);
    }
}

const simcore::run::Snapshot* RunSession::shown() const {
    return scrubbed_ ? scrubbed_.get() : live_.get();
}

double RunSession::shownTime() const {
    return shown() ? shown()->time : 0.0;
}

double RunSession::endTime() const {
    return live_ ? live_->time : 0.0;
}

double RunSession::realTimeFactor() const {
    return worker_ ? worker_->realTimeFactor() : 0.0;
}

const simcore::run::ResolvedRun& RunSession::settings() const {
    return worker_->settings();
}

simcore::run::RunReport RunSession::report() const {
    return worker_ ? worker_->report() : simcore::run::RunReport{};
}

simcore::Result<bool> RunSession::exportCsv(const QString& file) const {
    if (!hasRun()) {
        return Problem{Severity::Critical, file.toStdString(), "there is no run to write.",
                       "Run a scenario first."};
    }
    return simcore::io::saveCsv(recording(), settings(), report(), origin_,
                                std::filesystem::path(file.toStdString()));
}

void RunSession::poll() {
    // State first: when it says Finished, everything sampled is there to be drained.
    const WorkerState workerState = worker_->state();
    const auto change = store_.drain(*worker_);
    auto newest = worker_->latest();
    const bool moved = newest != live_;
    live_ = std::move(newest);
    if (workerState != WorkerState::Playing) {
        poll_.stop();
    }
    if (change == RecordingStore::Change::Thinned) {
        emit dataReplaced();
    } else if (change == RecordingStore::Change::Appended) {
        emit dataAppended();
    }
    if (moved && isLive()) {
        emit snapshotChanged(*live_);
    }
    switch (workerState) {
        case WorkerState::Playing:
            setState(State::Playing);
            break;
        case WorkerState::Paused:
            setState(live_->step == 0 ? State::Ready : State::Paused);
            break;
        case WorkerState::Finished:
            if (state_ != State::Finished) {
                setState(State::Finished);
                emit finished(worker_->report());
            }
            break;
    }
}

void RunSession::setState(State state) {
    if (state_ != state) {
        state_ = state;
        emit stateChanged(state);
    }
}

}  // namespace widgets
