#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "simcore/run/simulation.h"

namespace simcore::run {

enum class WorkerState { Paused, Playing, Finished };

/// Runs a Simulation in a thread of its own, paced against the clock. All public functions may be
/// called from one other thread (the GUI's); none of them blocks on a step for longer than the step.
class RunWorker {
  public:
    explicit RunWorker(ResolvedRun run);
    ~RunWorker();   ///< stops and joins
    RunWorker(const RunWorker&) = delete;
    RunWorker& operator=(const RunWorker&) = delete;

    void play();
    void pause();
    /// One engine step, then paused.
    void stepOnce();
    /// Back to the start, paused; the recording is emptied.
    void reset();
    /// 1 = real time, 0 = as fast as possible.
    void setSpeedFactor(double factor);
    void setManualCommand(const ManualCommand& command);

    WorkerState state() const;
    const ResolvedRun& settings() const;
    /// The newest snapshot; never null.
    std::shared_ptr<const Snapshot> latest() const;
    /// Moves out what was sampled since the last call: channel rows and playback frames.
    void drain(std::vector<std::vector<double>>& rows,
               std::vector<std::shared_ptr<const Snapshot>>& frames);
    /// Simulated over wall time during the last second.
    double realTimeFactor() const;
    /// The report so far, or the final one when finished.
    RunReport report() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace simcore::run
