#pragma once

#include <memory>
#include <vector>

#include "simcore/mechanism/mechanism.h"
#include "simcore/run/snapshot.h"

namespace simcore::run {

/// Picks the instants of a run that are recorded: channel rows and playback frames at fixed periods
/// of simulated time, the start and the end always. Which instants those are depends on the run
/// only, not on how it is paced.
class Sampler {
  public:
    /// @param mechanism  must outlive the sampler
    explicit Sampler(const mechanism::Mechanism& mechanism) : mechanism_(mechanism) {}

    /// Forgets everything and takes the start of the run.
    void start(const Snapshot& snapshot);
    /// Call after every step.
    void take(const Snapshot& snapshot);
    /// Takes the last instant, unless it is taken already.
    void finish(const Snapshot& snapshot);

    bool empty() const { return rows_.empty() && frames_.empty(); }

    /// Appends what was taken since the last call to the given lists.
    void moveTo(std::vector<std::vector<double>>& rows,
                std::vector<std::shared_ptr<const Snapshot>>& frames);

  private:
    void takeRow(const Snapshot& snapshot);
    void takeFrame(const Snapshot& snapshot);

    const mechanism::Mechanism& mechanism_;
    long rowIndex_ = 0, frameIndex_ = 0;      ///< of the period last taken
    double rowTime_ = 0.0, frameTime_ = 0.0;  ///< of the instant last taken [s]
    std::vector<std::vector<double>> rows_;
    std::vector<std::shared_ptr<const Snapshot>> frames_;
};

}  // namespace simcore::run
