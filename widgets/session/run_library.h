#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/session/run_session.h"

namespace widgets {

/// A run held beside the one on show, to be compared with it.
struct HeldRun {
    int id = 0;     ///< never used twice
    int style = 1;  ///< of its curves: 0 is the run on show, 1 to RunLibrary::kStyles the others
    QString name;
    bool curves = true;                                ///< drawn in the plots
    bool stale = false;                                ///< the design has changed since
    std::optional<simcore::project::Project> project;  ///< nothing: an older one
    std::unique_ptr<RunSession> session;
};

/// The runs held beside the one on show. Lives on the GUI thread.
class RunLibrary : public QObject {
    Q_OBJECT
  public:
    /// Line styles to tell them by, so the number of runs that may be held at a time.
    static constexpr int kStyles = 4;

    using QObject::QObject;

    const std::vector<HeldRun>& runs() const { return runs_; }

    bool isFull() const { return static_cast<int>(runs_.size()) >= kStyles; }

    /// Position of a run, -1 when it is gone.
    int find(int id) const;
    /// Holds a copy of what `shown` has recorded; `project` is the present design. When it is full
    /// the oldest goes.
    /// @returns its id, or 0 when there is no run.
    int keep(const RunSession& shown, const simcore::project::Project& project);
    /// Holds a run of this project that may still be driving.
    int hold(std::unique_ptr<RunSession> session, std::optional<simcore::project::Project> project);
    /// Holds a run out of a recording; `project` is the present design.
    int hold(RecordedRun recorded, const simcore::project::Project& project);
    void remove(int id);
    void clear();
    void setCurves(int id, bool on);
    /// The run whose rover is shown in the 3-D view, too; 0: none.
    void setGhost(int id);

    int ghost() const { return ghost_; }

    /// The run of the ghost; null: none.
    const RunSession* ghostRun() const;
    /// Marks the runs of another design than this.
    void setProject(const simcore::project::Project& project);

  signals:
    /// A run came or went, or is to be shown otherwise.
    void changed();
    /// A held run got longer, or began anew.
    void dataChanged();

  private:
    int freeStyle() const;

    std::vector<HeldRun> runs_;
    int lastId_ = 0;
    int ghost_ = 0;
};

}  // namespace widgets
