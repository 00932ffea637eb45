#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "simcore/io/csv.h"
#include "simcore/run/run_worker.h"
#include "widgets/session/recording_store.h"

namespace widgets {

/// The run the window shows: a RunWorker, what it recorded, and which instant is looked at.
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
    /// critical problems the old run stays; all problems are returned (also warnings).
    simcore::Problems prepare(const simcore::project::Project& project,
                              const simcore::run::RunRequest& request,
                              const std::string& projectFile = {});
    /// Takes over a worker made elsewhere, standing at its start.
    void adopt(std::unique_ptr<simcore::run::RunWorker> worker,
               simcore::io::RecordingOrigin origin);
    /// Back to Empty.
    void clear();

    State state() const { return state_; }

    bool hasRun() const { return worker_ != nullptr; }

    /// The project or the request changed after prepare(): what is shown is not what is drawn.
    bool isStale() const { return stale_; }

    void setStale(bool stale);

    void play();
    void pause();
    void togglePlay();
    void stepOnce();
    /// Back to the start of the same run; the recording is emptied.
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

    /// Writes the recording as CSV with its metadata beside it.
    simcore::Result<bool> exportCsv(const QString& file) const;

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

  private:
    void poll();
    void setState(State state);
    void show(std::shared_ptr<const simcore::run::Snapshot> frame);

    std::unique_ptr<simcore::run::RunWorker> worker_;
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
