#pragma once

#include <QObject>
#include <optional>

#include "simcore/experiment/verdict.h"
#include "widgets/session/run_library.h"

namespace widgets {

/// Drives one scenario with two controllers side by side: the first is the run on show, the rival
/// goes along with it, plays, pauses and starts again as it does, and is held in the library.
class Experiment : public QObject {
    Q_OBJECT
  public:
    Experiment(RunSession* shown, RunLibrary* library, QObject* parent = nullptr);

    /// Makes both runs and plays them. With critical problems nothing changes; all problems are
    /// returned.
    simcore::Problems start(const simcore::project::Project& project,
                            const simcore::run::RunRequest& request,
                            simcore::project::ControllerKind rival,
                            const std::string& projectFile = {});

    /// The rival's run while it goes with the one on show; null: none.
    const RunSession* rival() const;

    /// There once both have ended.
    std::optional<simcore::experiment::Verdict> verdict() const;

  signals:
    /// It began, one of the two ended, or the run on show is another.
    void changed();

  private:
    RunSession* find() const;
    void follow(RunSession::State state);

    RunSession* shown_;
    RunLibrary* library_;
    int rival_ = 0;  ///< id in the library
    bool starting_ = false;
};

/// What a run came to so far. Call only when it has a run.
simcore::experiment::Outcome outcomeOf(const RunSession& run);

}  // namespace widgets
