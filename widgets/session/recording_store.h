#pragma once

#include <cstddef>

#include "simcore/run/run_worker.h"

namespace widgets {

/// A recording whose memory is bounded: when a list is full, every second entry is dropped, so that
/// a long drive is kept whole at half the resolution.
class RecordingStore {
  public:
    /// About 20 minutes of rows and 10 minutes of frames at full resolution, some 300 MB together.
    explicit RecordingStore(std::size_t rowLimit = 120'000, std::size_t frameLimit = 30'000);

    void start(const simcore::mechanism::Mechanism& mechanism);
    void clearData();
    /// Takes what the worker sampled. Returns what happened to the entries that were there before.
    enum class Change { None, Appended, Thinned };
    Change drain(simcore::run::RunWorker& worker);

    const simcore::run::Recording& recording() const { return recording_; }

    /// The frame nearest to `time` [s]; null when there is none.
    std::shared_ptr<const simcore::run::Snapshot> frameNear(double time) const;
    /// Position of the frame nearest to `time`, -1 when there is none.
    int indexNear(double time) const;

  private:
    std::size_t rowLimit_;
    std::size_t frameLimit_;
    simcore::run::Recording recording_;
    std::vector<std::vector<double>> newRows_;
    std::vector<std::shared_ptr<const simcore::run::Snapshot>> newFrames_;
};

}  // namespace widgets
