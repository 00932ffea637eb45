#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "simcore/run/simulation.h"
#include "simcore/statics/traverse.h"

namespace widgets {

/// What is to be studied.
struct StaticsTask {
    int number = 0;  ///< later tasks have greater ones
    simcore::project::Project project;
    simcore::run::RunRequest request;
    /// Where to look first: a sample of an earlier study. Without one, at the start.
    std::optional<simcore::statics::TraverseSample> near;
};

/// What a study found. Immutable once published.
struct StaticsFindings {
    int number = 0;  ///< of the task
    simcore::Problems problems;
    std::shared_ptr<const simcore::run::ResolvedRun> run;  ///< null with critical problems

    enum class Stage {
        Look,  ///< one sample: near where the task says
        Part,  ///< the way so far
        Whole
    };
    Stage stage = Stage::Look;
    simcore::statics::Traverse traverse;

    bool rollsBack() const { return run != nullptr && run->speed < 0.0; }
};

/// Studies rovers in a thread of its own: first where it was looked at last, then the whole way.
/// The latest task wins; an earlier one is given up at its next sample. Knows nothing of Qt.
class StaticsWorker {
  public:
    using Publish = std::function<void(std::shared_ptr<const StaticsFindings>)>;

    /// `publish` is called on the worker's thread; it must not throw.
    explicit StaticsWorker(Publish publish);
    ~StaticsWorker();  ///< gives up and joins
    StaticsWorker(const StaticsWorker&) = delete;
    StaticsWorker& operator=(const StaticsWorker&) = delete;

    void start(StaticsTask task);
    /// Gives up what it is doing.
    void cancel();

  private:
    void loop();
    void study(const StaticsTask& task);
    void follow(simcore::statics::PoseSolver& solver, StaticsFindings findings);

    Publish publish_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<StaticsTask> next_;
    bool ending_ = false;
    std::atomic<bool> givenUp_ = false;
    std::thread thread_;
};

}  // namespace widgets
