#pragma once

#include <cstddef>

#include "simcore/run/run_worker.h"

namespace widgets {

/// A recording whose memory is bounded: when a list is full, every second entry is dropped, and
/// from then on only every second one taken, so that a drive of any length is kept whole, evenly at
/// a coarser resolution.
class RecordingStore {
  public:
    /// About 20 minutes of rows and 10 minutes of frames at full resolution, some 300 MB together.
    explicit RecordingStore(std::size_t rowLimit = 120'000, std::size_t frameLimit = 30'000);

    void start(std::vector<simcore::run::Channel> channels);
    void clearData();
    /// What happened to the entries that were there before.
    enum class Change { None, Appended, Thinned };
    /// Takes what the worker sampled.
    Change drain(simcore::run::RunWorker& worker);
    /// Takes what follows in time; the lists are left empty.
    Change append(std::vector<std::vector<double>>& rows,
                  std::vector<std::shared_ptr<const simcore::run::Snapshot>>& frames);

    const simcore::run::Recording& recording() const { return recording_; }

    /// The frame nearest to `time` [s]; null when there is none.
    std::shared_ptr<const simcore::run::Snapshot> frameNear(double time) const;
    /// Position of the frame nearest to `time`, -1 when there is none.
    int indexNear(double time) const;

  private:
    /// Which of the entries that come are kept.
    struct Sieve {
        std::size_t limit = 0;
        std::size_t stride = 1;  ///< every so manyth
        std::size_t seen = 0;
    };

    template <class T>
    static Change take(std::vector<T>& from, std::vector<T>& to, Sieve& sieve);

    Sieve rowSieve_, frameSieve_;
    simcore::run::Recording recording_;
    std::vector<std::vector<double>> newRows_;
    std::vector<std::shared_ptr<const simcore::run::Snapshot>> newFrames_;
};

}  // namespace widgets
