#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "simcore/base/result.h"
#include "simcore/io/recording.h"
#include "simcore/run/run_worker.h"

namespace simcore::io {

/// An open file without a name: its space is free again when the last holder lets go of it, however
/// the program ends.
class PrivateFile;

/// The recording of a run up to some instant, to be saved at leisure and on any thread while the
/// run goes on.
class RunCopy {
  public:
    /// The run of a recording that is there already: saved as a copy of that file.
    static RunCopy ofRecording(std::filesystem::path recording);

    /// Writes the recording whole or not at all. `goOn` is called with the part that is done [0 to
    /// 1]; false when it said no.
    Result<bool> save(const std::filesystem::path& file,
                      const std::function<bool(double)>& goOn = {}) const;

  private:
    Result<bool> write(const std::filesystem::path& file,
                       const std::function<bool(double)>& goOn) const;
    Result<bool> copyRecording(const std::filesystem::path& file,
                               const std::function<bool(double)>& goOn) const;

    friend class RunRecorder;
    RecordingHeader header_;
    std::shared_ptr<const PrivateFile> tables_;
    std::uint64_t size_ = 0;           ///< of what is written of the tables [byte]
    std::string rest_;                 ///< the chunks behind them
    std::filesystem::path recording_;  ///< not empty: everything is in this file instead
};

/// Records whatever a worker runs into a private file in `folder`, so that the run can be saved at
/// any time. A recording that fails is given up, and gives its space back with the last of its
/// copies; the run goes on. Why so: docs/decisions/0015.
///
/// All but failed() on the worker's thread.
class RunRecorder final : public run::RunSink {
  public:
    /// A recording that nobody asked for must not fill the disk [byte].
    static constexpr std::uint64_t kKeepFree = std::uint64_t{1} << 30U;

    /// @param folder  made when it is not there
    /// @param header  of the run; its engine is that of the report in copy()
    RunRecorder(std::filesystem::path folder, RecordingHeader header,
                std::uint64_t keepFree = kKeepFree);
    ~RunRecorder() override;

    void restart() override;
    void add(const std::vector<std::vector<double>>& rows,
             const std::vector<std::shared_ptr<const run::Snapshot>>& frames) override;
    void add(long step, const run::ManualCommand& command) override;
    bool wantsMark() const override;
    void mark(long step, const std::string& stateHash) override;

    /// The run up to the instant of this report; the problem why there is no recording of it.
    Result<RunCopy> copy(const run::RunReport& report) const;

    /// The recording was given up; copy() says why. Any thread.
    bool failed() const { return failed_; }

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
    std::atomic<bool> failed_ = false;
};

}  // namespace simcore::io
