#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "simcore/run/simulation.h"

namespace simcore::run {

enum class WorkerState { Paused, Playing, Finished };

/// What a worker drives: a Simulation, or something simpler in a test. Made, stepped and destroyed
/// on the worker's thread.
class Stepper {
  public:
    virtual ~Stepper() = default;
    virtual void reset() = 0;
    virtual void step() = 0;
    virtual bool finished() const = 0;
    virtual void setManualCommand(const ManualCommand& command) = 0;
    virtual const Snapshot& snapshot() const = 0;
    virtual RunReport report() const = 0;
};

/// Takes what a run gives while it goes, on the worker's thread: a recording for instance. It must
/// not throw.
class RunSink {
  public:
    virtual ~RunSink() = default;
    /// The run stands at its start: what came before is no part of it.
    virtual void restart() = 0;
    virtual void add(const std::vector<std::vector<double>>& rows,
                     const std::vector<std::shared_ptr<const Snapshot>>& frames) = 0;
    /// A command, in force from this step on.
    virtual void add(long step, const ManualCommand& command) = 0;
    /// Whether it is time for a mark.
    virtual bool wantsMark() const = 0;
    virtual void mark(long step, const std::string& stateHash) = 0;
};

using StepperFactory = std::function<std::unique_ptr<Stepper>(const ResolvedRun&)>;

/// Period of the recorded channel rows and of the playback frames, in simulated time [s].
inline constexpr double kRowPeriod = 0.01;
inline constexpr double kFramePeriod = 0.02;

/// Runs a Simulation in a thread of its own, paced against the clock. All public functions may be
/// called from one other thread (the GUI's); none of them blocks on a step for longer than the
/// step.
///
/// Pacing never changes the numbers: the same run gives the same state hash at any speed factor,
/// with any pauses. A run that cannot keep up falls behind the clock and realTimeFactor() says so.
/// An exception in the simulation ends the run: Finished, its text in RunReport::stopDetail.
class RunWorker {
  public:
    /// Returns when the simulation stands at its start (or failed to be made: state() is Finished).
    explicit RunWorker(ResolvedRun run, std::unique_ptr<RunSink> sink = nullptr);
    RunWorker(ResolvedRun run, StepperFactory factory, std::unique_ptr<RunSink> sink = nullptr);
    ~RunWorker();  ///< stops and joins
    RunWorker(const RunWorker&) = delete;
    RunWorker& operator=(const RunWorker&) = delete;

    /// The next four return when the worker has acted on them.
    void play();
    void pause();
    /// One engine step, then paused.
    void stepOnce();
    /// Back to the start, paused; what was sampled and not yet drained is dropped.
    void reset();
    /// 1 = real time, 0 = as fast as possible.
    void setSpeedFactor(double factor);
    void setManualCommand(const ManualCommand& command);

    /// Calls `work` on the worker's thread, between two steps, with the report so far; returns when
    /// it has returned. It must not throw.
    void betweenSteps(const std::function<void(const RunReport&)>& work) const;

    WorkerState state() const;
    const ResolvedRun& settings() const;
    /// The newest snapshot; never null.
    std::shared_ptr<const Snapshot> latest() const;
    /// Moves out what was sampled since the last call: channel rows and playback frames. The start
    /// is the first of both; where the run stopped is the last.
    void drain(std::vector<std::vector<double>>& rows,
               std::vector<std::shared_ptr<const Snapshot>>& frames);
    /// Simulated over wall time during the last second of playing.
    double realTimeFactor() const;
    /// The report so far, or the final one when finished.
    RunReport report() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace simcore::run
