#include "widgets/session/run_session.h"

#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "simcore/base/text.h"
#include "simcore/project/resolve.h"

namespace widgets {

using simcore::Problem;
using simcore::Problems;
using simcore::Severity;
using simcore::run::RunWorker;
using simcore::run::WorkerState;

namespace {

constexpr int kPollPeriod_ms = 33;

/// Of what can be made again: a disk, not the memory that a folder for temporary files often is.
std::filesystem::path recordingFolder() {
    return std::filesystem::path(
               QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString()) /
           "runs";
}

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
    simcore::run::RunRequest carrying = request;
    Problems whyNotRecorded = simcore::io::carryFiles(project, carrying);
    // What a recording cannot carry can be driven on nevertheless.
    const bool recorded = !hasCritical(whyNotRecorded);
    auto run = simcore::run::prepareRun(project, carrying);
    if (!run) {
        return run.problems();
    }
    Problems problems = run.problems();
    std::unique_ptr<simcore::io::RunRecorder> recorder;
    if (recorded) {
        recorder = std::make_unique<simcore::io::RunRecorder>(
            recordingFolder(),
            simcore::io::recordingHeader(project, carrying, *run, {}, projectFile));
    }
    simcore::io::RunRecorder* const recording = recorder.get();
    auto worker = std::make_unique<RunWorker>(std::move(run).value(), std::move(recorder));
    const simcore::run::RunReport report = worker->report();
    if (worker->state() == WorkerState::Finished && !report.stopDetail.empty()) {
        problems.push_back(
            {Severity::Critical, simcore::Text::of("scenario {}", request.scenario),
             simcore::Text::of("the simulation could not be made: {}", report.stopDetail),
             simcore::Text::of("Check the rover's masses, joints and wheels.")});
        return problems;
    }
    adopt(std::move(worker), recording, simcore::io::originOf(project, request, projectFile));
    if (!recorded) {
        whyNoRecorder_ = whyNotRecorded;
        for (Problem& problem : whyNotRecorded) {
            problem.severity = Severity::Warning;
        }
        appendNew(problems, whyNotRecorded);
        emit recordingFailed(whyNotRecorded);
    }
    return problems;
}

void RunSession::adopt(std::unique_ptr<RunWorker> worker, simcore::io::RecordingOrigin origin) {
    adopt(std::move(worker), nullptr, std::move(origin));
}

void RunSession::adopt(std::unique_ptr<RunWorker> worker, simcore::io::RunRecorder* recorder,
                       simcore::io::RecordingOrigin origin) {
    poll_.stop();
    recorded_.reset();
    worker_ = std::move(worker);
    recorder_ = recorder;
    whyNoRecorder_.clear();
    failureTold_ = false;
    origin_ = std::move(origin);
    live_ = worker_->latest();
    scrubbed_.reset();
    store_.start(simcore::run::makeChannels(worker_->settings().mechanism));
    worker_->setSpeedFactor(speedFactor_);
    store_.drain(*worker_);
    const bool startsFinished = worker_->state() == WorkerState::Finished;
    setStale(false);
    state_ = startsFinished ? State::Finished : State::Ready;
    emit runChanged();
    emit stateChanged(state_);
    emit snapshotChanged(*live_);
}

void RunSession::show(RecordedRun run) {
    poll_.stop();
    worker_.reset();
    recorder_ = nullptr;
    store_ = std::exchange(run.store, RecordingStore());
    origin_ = run.origin;
    live_ = run.last;
    recorded_ = std::move(run);
    scrubbed_.reset();
    setStale(false);
    state_ = State::Finished;
    emit runChanged();
    emit stateChanged(state_);
    emit snapshotChanged(*live_);
}

void RunSession::clear() {
    poll_.stop();
    recorded_.reset();
    recorder_ = nullptr;
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
    if (!worker_) {
        scrub(0.0);
        return;
    }
    poll_.stop();
    failureTold_ = false;
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
    const auto near = nearest(time);
    if (near == live_) {
        goLive();
    } else {
        show(near);
    }
}

std::shared_ptr<const simcore::run::Snapshot> RunSession::nearest(double time) const {
    const auto frame = store_.frameNear(time);
    // The newest instant is usually a little younger than the last frame.
    const bool isNewest =
        live_ && (!frame || std::abs(live_->time - time) <= std::abs(frame->time - time));
    return isNewest ? live_ : frame;
}

const simcore::run::Snapshot* RunSession::instantNear(double time) const {
    return nearest(time).get();
}

RecordedRun RunSession::freeze() const {
    RecordedRun run;
    run.settings = settings();
    run.report = report();
    run.complete = state_ == State::Finished;
    run.origin = origin_;
    run.store = store_;
    run.last = live_;
    if (recorded_) {
        run.file = recorded_->file;
        run.copy = recorded_->copy;
    } else if (auto copy = copyRun()) {
        run.copy = std::make_shared<simcore::io::RunCopy>(std::move(copy).value());
    }
    return run;
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
    return worker_ ? worker_->settings() : recorded_.value().settings;
}

simcore::run::RunReport RunSession::report() const {
    return worker_ ? worker_->report() : recorded_ ? recorded_->report : simcore::run::RunReport{};
}

simcore::Result<simcore::io::RunCopy> RunSession::copyRun() const {
    if (worker_ && !whyNoRecorder_.empty()) {
        return whyNoRecorder_;
    }
    if (recorded_ && recorded_->copy) {
        return *recorded_->copy;
    }
    if (recorded_ && !recorded_->file.empty()) {
        return simcore::io::RunCopy::ofRecording(recorded_->file);
    }
    if (recorder_ == nullptr) {
        return Problem{Severity::Critical, simcore::Text::of("recording"),
                       simcore::Text::of("there is no run to save."),
                       simcore::Text::of("Run a scenario first.")};
    }
    std::optional<simcore::Result<simcore::io::RunCopy>> copy;
    worker_->betweenSteps(
        [&](const simcore::run::RunReport& report) { copy = recorder_->copy(report); });
    return std::move(*copy);
}

simcore::Result<bool> RunSession::exportCsv(const QString& file,
                                            const simcore::io::TableCut& cut) const {
    if (!hasRun()) {
        return Problem{Severity::Critical, file.toStdString(),
                       simcore::Text::of("there is no run to write."),
                       simcore::Text::of("Run a scenario first.")};
    }
    return simcore::io::saveCsv(recording(), settings(), report(), origin_,
                                std::filesystem::path(file.toStdString()), cut);
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
    if (recorder_ != nullptr && recorder_->failed() && !failureTold_) {
        failureTold_ = true;
        emit recordingFailed(copyRun().problems());
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
