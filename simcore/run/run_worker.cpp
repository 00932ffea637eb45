#include "simcore/run/run_worker.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "simcore/base/text.h"
#include "simcore/run/sampler.h"

namespace simcore::run {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kWakeBudget{0.010};  ///< stepping between two looks at the clock and publications
constexpr std::chrono::milliseconds kWakePeriod{4};  ///< shortest sleep of a paced run
constexpr Seconds kLargestLag{0.1};  ///< then the clock is set anew instead of sprinting
constexpr Seconds kRateWindow{1.0};

struct Command {
    enum class Kind { Play, Pause, StepOnce, Reset, SpeedFactor, Manual, Report };
    Kind kind = Kind::Pause;
    double factor = 1.0;
    ManualCommand manual;
    std::function<void(const RunReport&)> work;  ///< of Report: what to do with it
};

/// Where simulated time should be, by the wall clock.
class Pacer {
  public:
    void setFactor(double factor) { factor_ = factor; }

    bool unlimited() const { return factor_ == 0.0; }

    void synchronise(double simTime) {
        wallStart_ = Clock::now();
        simStart_ = simTime;
    }

    /// Simulated time that is due now [s]; after too long a lag, counted from `simTime` on.
    double due(double simTime) {
        const Seconds elapsed = Clock::now() - wallStart_;
        const double target = simStart_ + factor_ * elapsed.count();
        if (target - simTime > factor_ * kLargestLag.count()) {
            synchronise(simTime);
            return simTime;
        }
        return target;
    }

    /// When `simTime` will be due.
    Clock::time_point wallTimeOf(double simTime) const {
        return wallStart_ + std::chrono::duration_cast<Clock::duration>(
                                Seconds((simTime - simStart_) / factor_));
    }

  private:
    double factor_ = 1.0;
    Clock::time_point wallStart_ = Clock::now();
    double simStart_ = 0.0;
};

/// Simulated over wall time in a sliding window.
class RateMeter {
  public:
    void restart(double simTime) { marks_.assign(1, {Clock::now(), simTime}); }

    double add(double simTime) {
        const Clock::time_point now = Clock::now();
        marks_.push_back({now, simTime});
        while (marks_.size() > 2 && now - marks_[1].wall >= kRateWindow) {
            marks_.pop_front();
        }
        const Seconds wall = now - marks_.front().wall;
        return wall.count() > 0.0 ? (simTime - marks_.front().sim) / wall.count() : 0.0;
    }

  private:
    struct Mark {
        Clock::time_point wall;
        double sim;
    };

    std::deque<Mark> marks_;
};

}  // namespace

struct RunWorker::Impl {
    Impl(ResolvedRun r, StepperFactory f, std::unique_ptr<RunSink> s)
        : run(std::move(r)),
          factory(std::move(f)),
          sink(std::move(s)),
          sampler(run.mechanism) {}

    // Written before the thread starts, only read after.
    const ResolvedRun run;
    const StepperFactory factory;

    // Shared: guarded by `mutex`, which is never held while stepping.
    mutable std::mutex mutex;
    std::condition_variable_any wake;  ///< worker: there are commands
    std::condition_variable_any done;  ///< callers: commands are handled
    std::deque<Command> commands;
    long posted = 0, handled = 0;
    bool ready = false;
    WorkerState state = WorkerState::Paused;
    std::shared_ptr<const Snapshot> latest = std::make_shared<const Snapshot>();
    std::vector<std::vector<double>> rows;
    std::vector<std::shared_ptr<const Snapshot>> frames;
    double rate = 0.0;
    std::atomic<bool> commandsWaiting = false;  ///< so that a batch of steps ends early

    // The worker thread's own.
    const std::unique_ptr<RunSink> sink;  ///< may be null
    std::unique_ptr<Stepper> stepper;
    Sampler sampler;
    Pacer pacer;
    RateMeter meter;
    ManualCommand manual;
    WorkerState nextState = WorkerState::Paused;
    std::string failure;

    std::jthread thread;  ///< last: joins before the rest goes

    void post(const Command& command) {
        std::unique_lock lock(mutex);
        const long ticket = ++posted;
        commands.push_back(command);
        commandsWaiting = true;
        wake.notify_all();
        done.wait(lock, [&] { return handled >= ticket; });
    }

    void work(const std::stop_token& stop);
    void handle(const Command& command);
    void runBatch();
    void advance();
    void restart();
    void fail(const std::string& why);
    RunReport currentReport() const;
    void publish(bool dropOld);
};

void RunWorker::Impl::work(const std::stop_token& stop) {
    restart();
    publish(true);
    while (!stop.stop_requested()) {
        std::deque<Command> batch;
        {
            std::unique_lock lock(mutex);
            const auto pending = [this] { return !commands.empty(); };
            if (nextState != WorkerState::Playing) {
                wake.wait(lock, stop, pending);
            } else if (!pacer.unlimited()) {
                // A run that is behind goes on at once; one that is ahead sleeps a while.
                const auto next = pacer.wallTimeOf(stepper->snapshot().time + run.step);
                const auto now = Clock::now();
                if (next > now) {
                    wake.wait_until(lock, stop, std::max(next, now + kWakePeriod), pending);
                }
            }
            batch.swap(commands);
            commandsWaiting = false;
        }
        bool wasReset = false;
        for (const Command& command : batch) {
            handle(command);
            wasReset = wasReset || command.kind == Command::Kind::Reset;
        }
        if (!batch.empty()) {
            publish(wasReset);
            for (const Command& command : batch) {
                if (command.kind == Command::Kind::Report) {
                    command.work(currentReport());
                }
            }
            const std::lock_guard lock(mutex);
            handled += static_cast<long>(batch.size());
            done.notify_all();
        }
        if (nextState == WorkerState::Playing) {
            runBatch();
            publish(false);
        }
    }
    stepper.reset();  // engines with per-thread data are destroyed where they were made
}

void RunWorker::Impl::handle(const Command& command) {
    const bool finished = nextState == WorkerState::Finished;
    switch (command.kind) {
        case Command::Kind::Play:
            if (nextState == WorkerState::Paused) {
                nextState = WorkerState::Playing;
                pacer.synchronise(stepper->snapshot().time);
                meter.restart(stepper->snapshot().time);
            }
            break;
        case Command::Kind::Pause:
            nextState = finished ? WorkerState::Finished : WorkerState::Paused;
            break;
        case Command::Kind::StepOnce:
            if (!finished) {
                nextState = WorkerState::Paused;
                advance();
            }
            break;
        case Command::Kind::Reset:
            restart();
            break;
        case Command::Kind::SpeedFactor:
            pacer.setFactor(command.factor);
            if (nextState == WorkerState::Playing) {
                pacer.synchronise(stepper->snapshot().time);
                meter.restart(stepper->snapshot().time);
            }
            break;
        case Command::Kind::Manual:
            if (stepper && sink && command.manual != manual) {
                sink->add(stepper->snapshot().step, command.manual);
            }
            manual = command.manual;
            if (stepper) {
                stepper->setManualCommand(manual);
            }
            break;
        case Command::Kind::Report:
            break;
    }
}

void RunWorker::Impl::runBatch() {
    const Clock::time_point begin = Clock::now();
    const double half = 0.5 * run.step;  // round-off must not cost a step
    const double target = pacer.unlimited() ? 0.0 : pacer.due(stepper->snapshot().time);
    while (nextState == WorkerState::Playing && !commandsWaiting &&
           Clock::now() - begin < kWakeBudget &&
           (pacer.unlimited() || stepper->snapshot().time + run.step <= target + half)) {
        advance();
    }
}

void RunWorker::Impl::advance() {
    try {
        stepper->step();
        sampler.take(stepper->snapshot());
        if (stepper->finished()) {
            sampler.finish(stepper->snapshot());
            nextState = WorkerState::Finished;
        }
    } catch (const std::exception& error) {
        fail(error.what());
    } catch (...) {
        fail(Text::of("the simulation stopped for an unknown reason"));
    }
}

void RunWorker::Impl::restart() {
    try {
        if (stepper && failure.empty()) {
            stepper->reset();
        } else {
            stepper = factory(run);  // after a failure nothing of the old one is trusted
        }
        failure.clear();
        if (sink) {
            sink->restart();  // before anything of the new run, should that fail
        }
        stepper->setManualCommand(manual);
        sampler.start(stepper->snapshot());
        if (sink && manual != ManualCommand{}) {
            sink->add(0, manual);
        }
        meter.restart(stepper->snapshot().time);
        nextState = stepper->finished() ? WorkerState::Finished : WorkerState::Paused;
    } catch (const std::exception& error) {
        fail(error.what());
    } catch (...) {
        fail(Text::of("the simulation could not be made"));
    }
}

void RunWorker::Impl::fail(const std::string& why) {
    failure = why;
    nextState = WorkerState::Finished;
}

RunReport RunWorker::Impl::currentReport() const {
    RunReport made;
    made.scenario = run.scenario;
    made.step = run.step;
    try {
        if (stepper) {
            made = stepper->report();
        }
    } catch (const std::exception&) {  // a failed simulation may not be able to tell
    }
    if (!failure.empty()) {
        made.completed = false;
        made.stopReason = StopReason::Stopped;
        made.stopDetail = failure;
    }
    return made;
}

void RunWorker::Impl::publish(bool dropOld) {
    std::shared_ptr<const Snapshot> newest;
    double newRate = 0.0;
    if (stepper) {
        newest = std::make_shared<const Snapshot>(stepper->snapshot());
        if (state == WorkerState::Playing && nextState != WorkerState::Paused) {
            newRate = meter.add(newest->time);
        }
    }
    std::vector<std::vector<double>> newRows;
    std::vector<std::shared_ptr<const Snapshot>> newFrames;
    sampler.moveTo(newRows, newFrames);
    if (sink && stepper) {
        sink->add(newRows, newFrames);
        if (sink->wantsMark()) {
            sink->mark(stepper->snapshot().step, currentReport().stateHash);
        }
    }
    const std::lock_guard lock(mutex);
    if (dropOld) {
        rows.clear();
        frames.clear();
        rate = 0.0;
    }
    if (newest) {
        latest.swap(newest);
    }
    if (newRate > 0.0) {
        rate = newRate;
    }
    std::move(newRows.begin(), newRows.end(), std::back_inserter(rows));
    std::move(newFrames.begin(), newFrames.end(), std::back_inserter(frames));
    state = nextState;
    ready = true;
    done.notify_all();
}

RunWorker::RunWorker(ResolvedRun run, StepperFactory factory, std::unique_ptr<RunSink> sink)
    : impl_(std::make_unique<Impl>(std::move(run), std::move(factory), std::move(sink))) {
    impl_->thread =
        std::jthread([impl = impl_.get()](const std::stop_token& stop) { impl->work(stop); });
    std::unique_lock lock(impl_->mutex);
    impl_->done.wait(lock, [this] { return impl_->ready; });
}

RunWorker::~RunWorker() = default;

void RunWorker::play() {
    impl_->post({Command::Kind::Play, 1.0, {}, {}});
}

void RunWorker::pause() {
    impl_->post({Command::Kind::Pause, 1.0, {}, {}});
}

void RunWorker::stepOnce() {
    impl_->post({Command::Kind::StepOnce, 1.0, {}, {}});
}

void RunWorker::reset() {
    impl_->post({Command::Kind::Reset, 1.0, {}, {}});
}

void RunWorker::setSpeedFactor(double factor) {
    if (!(factor >= 0.0) || !std::isfinite(factor)) {
        throw std::invalid_argument("RunWorker: the speed factor must be 0 or positive");
    }
    impl_->post({Command::Kind::SpeedFactor, factor, {}, {}});
}

void RunWorker::setManualCommand(const ManualCommand& command) {
    impl_->post({Command::Kind::Manual, 1.0, command, {}});
}

WorkerState RunWorker::state() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->state;
}

const ResolvedRun& RunWorker::settings() const {
    return impl_->run;
}

std::shared_ptr<const Snapshot> RunWorker::latest() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->latest;
}

void RunWorker::drain(std::vector<std::vector<double>>& rows,
                      std::vector<std::shared_ptr<const Snapshot>>& frames) {
    rows.clear();
    frames.clear();
    const std::lock_guard lock(impl_->mutex);
    rows.swap(impl_->rows);
    frames.swap(impl_->frames);
}

double RunWorker::realTimeFactor() const {
    const std::lock_guard lock(impl_->mutex);
    return impl_->rate;
}

void RunWorker::betweenSteps(const std::function<void(const RunReport&)>& work) const {
    impl_->post({Command::Kind::Report, 1.0, {}, work});
}

RunReport RunWorker::report() const {
    RunReport made;
    betweenSteps([&made](const RunReport& report) { made = report; });
    return made;
}

}  // namespace simcore::run
