#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "simcore/io/csv.h"
#include "simcore/io/run_recorder.h"
#include "simcore/run/run_worker.h"
#include "widgets/session/recorded_run.h"
#include "widgets/session/recording_store.h"

namespace widgets {

/// The run the window shows: a RunWorker and what it recorded, or a run out of a recording; and
/// which instant is looked at.
///
/// Lives on the GUI thread. Polls the worker 30 times a second; the worker knows nothing of Qt.
/// The run works on a copy of the project: editing does not touch it, it only makes it *stale*.
class RunSession : public QObject {
    Q_OBJECT
  public:
    /// Empty: nothing prepared. Ready: at its start. Playing, Paused, Finished: as said.
    enum class State { Empty, Ready, Playing, Paused, Finished };
    Q_ENUM(State)

    explicit RunSession(QObject* parent = nullptr);
    ~RunSession() override;

    /// Makes the run that `request` asks for, standing at its start, and drops the old one. With
    /// critical problems the old run stays; all problems are returned (also warnings). Everything
    /// the run does is recorded into a private file.
    /// @param projectFile  as the user knows it; only for people
    simcore::Problems prepare(const simcore::project::Project& project,
                              const simcore::run::RunRequest& request,
                              const std::string& projectFile = {});
    /// Takes over a worker made elsewhere, standing at its start.
    void adopt(std::unique_ptr<simcore::run::RunWorker> worker,
               simcore::io::RecordingOrigin origin);
    /// Shows a run out of a recording, at its end, Finished; nothing is run.
    void show(RecordedRun run);
    /// Back to Empty.
    void clear();

    State state() const { return state_; }

    bool hasRun() const { return worker_ != nullptr || recorded_; }

    /// The run on show if it is out of a recording, less its store; else null.
    const RecordedRun* recorded() const { return recorded_ ? &*recorded_ : nullptr; }

    /// The project or the request changed after prepare(): what is shown is not what is drawn.
    bool isStale() const { return stale_; }

    void setStale(bool stale);

    void play();
    void pause();
    void togglePlay();
    void stepOnce();
    /// Back to the start of the same run; its record is emptied. Of a run out of a recording, shows
    /// the start.
    void reset();
    /// 1 = real time, 0 = as fast as possible; kept for later runs.
    void setSpeedFactor(double factor);

    double speedFactor() const { return speedFactor_; }

    void setManualCommand(const simcore::run::ManualCommand& command);

    /// Shows the recorded frame nearest to `time` [s]; pauses a playing run first.
    void scrub(double time);
    /// Shows the frame `count` frames later (< 0: earlier) than the shown one.
    void scrubFrames(int count);
    /// Shows the newest instant again. play() and stepOnce() do that too.
    void goLive();

    bool isLive() const { return scrubbed_ == nullptr; }

    /// The instant on show; null when Empty.
    const simcore::run::Snapshot* shown() const;
    double shownTime() const;  ///< [s]
    double endTime() const;    ///< of the newest instant [s]
    double realTimeFactor() const;

    /// Numbers of the run; call only when hasRun().
    const simcore::run::ResolvedRun& settings() const;
    simcore::run::RunReport report() const;

    /// File of the project that is run; empty when it has none yet.
    const std::string& projectFile() const { return origin_.projectFile; }

    const simcore::run::Recording& recording() const { return store_.recording(); }

    const simcore::io::RecordingOrigin& origin() const { return origin_; }

    /// The run so far, as one to be looked at or saved; its project stays empty. Call only when
    /// hasRun().
    RecordedRun freeze() const;

    /// The newest instant; null when Empty.
    const simcore::run::Snapshot* newest() const { return live_.get(); }

    /// The recorded or newest instant nearest to `time` [s]; null when Empty.
    const simcore::run::Snapshot* instantNear(double time) const;

    /// The run so far, for saving. A problem when there is none, or its recording failed.
    simcore::Result<simcore::io::RunCopy> copyRun() const;

    /// Writes the recording, or part of it, as CSV with its metadata beside it.
    simcore::Result<bool> exportCsv(const QString& file,
                                    const simcore::io::TableCut& cut = {}) const;

  signals:
    /// Another run (or none) is there: wheels, channels, terrain may all be different.
    void runChanged();
    void stateChanged(widgets::RunSession::State state);
    void staleChanged(bool stale);
    /// Another instant is on show, live or scrubbed.
    void snapshotChanged(const simcore::run::Snapshot& snapshot);
    /// recording() got longer; what was there before is unchanged.
    void dataAppended();
    /// recording() was emptied by reset(), or thinned because it was full.
    void dataReplaced();
    void finished(const simcore::run::RunReport& report);
    void speedFactorChanged(double factor);
    /// The run goes on, but it can no longer be saved.
    void recordingFailed(const simcore::Problems& problems);

  private:
    void poll();
    void setState(State state);
    void show(std::shared_ptr<const simcore::run::Snapshot> frame);
    std::shared_ptr<const simcore::run::Snapshot> nearest(double time) const;
    void adopt(std::unique_ptr<simcore::run::RunWorker> worker, simcore::io::RunRecorder* recorder,
               simcore::io::RecordingOrigin origin);

    std::unique_ptr<simcore::run::RunWorker> worker_;  ///< null when empty or out of a recording
    simcore::io::RunRecorder* recorder_ = nullptr;     ///< the worker's
    simcore::Problems whyNoRecorder_;                  ///< when the worker has none
    bool failureTold_ = false;
    std::optional<RecordedRun> recorded_;
    RecordingStore store_;
    simcore::io::RecordingOrigin origin_;
    std::shared_ptr<const simcore::run::Snapshot> live_;
    std::shared_ptr<const simcore::run::Snapshot> scrubbed_;  ///< null while live
    State state_ = State::Empty;
    bool stale_ = false;
    double speedFactor_ = 1.0;
    QTimer poll_;
};

}  // namespace widgets
