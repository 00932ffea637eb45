#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <memory>
#include <optional>
#include <thread>

#include "simcore/mobility/advisor.h"

namespace widgets {

/// The Advisor's search, and what it found for the rover that is edited.
///
/// Lives on the GUI thread; the search has a thread of its own. It begins when asked for, and ends
/// when what it searches in is edited. What the relaxed model of the project is does not matter to
/// it: a proposal that was applied leaves the advice as good as it was.
class AdvisorSession : public QObject {
    Q_OBJECT
  public:
    explicit AdvisorSession(QObject* parent = nullptr);
    ~AdvisorSession() override;

    /// The project as it is now.
    void setProject(const simcore::project::Project& project);
    /// The next project is another rover: nothing of this one is kept.
    void forget();

    /// Searches the present project.
    /// @param seconds  limit of the search [s]
    void start(double seconds);
    /// Ends the search; what was found until then is there a moment later.
    void cancel();

    bool isWorking() const { return working_; }

    /// The search was ended by an edit, and nothing has been searched since.
    bool wasInterrupted() const { return interrupted_; }

    /// Limit of the last search [s].
    double limit() const { return limit_; }

    /// Of the search that goes on [s].
    double elapsed() const;

    /// What was found last; null when nothing was, or nothing was searched.
    const simcore::mobility::Advice* advice() const { return advice_ ? &*advice_ : nullptr; }

    /// Why there is no advice; empty when there is, or nothing was searched.
    const simcore::Problems& problems() const { return problems_; }

    /// The advice is for a rover that has been edited since.
    bool isStale() const;
    /// The present project with this proposal as its relaxed model; problems when it does not fit.
    simcore::Result<simcore::project::Project> withProposal(int proposal) const;
    /// The proposal that the present project has as its relaxed model; -1: none.
    int appliedProposal() const;

  signals:
    /// Advice, its age, or isWorking() is another.
    void changed();

  private:
    /// Of a search in its thread.
    using Found = std::shared_ptr<const simcore::Result<simcore::mobility::Advice>>;
    void take(int number, const Found& found);

    simcore::project::Project project_;
    /// Of the present project, as built only: what a search depends on.
    simcore::project::Rover rover_;
    simcore::project::Rover searched_;
    bool working_ = false;
    bool interrupted_ = false;
    int number_ = 0;  ///< of the last search
    double limit_ = 0.0;
    QElapsedTimer since_;
    std::optional<simcore::mobility::Advice> advice_;
    simcore::Problems problems_;
    std::jthread thread_;  ///< last: it publishes until it is gone
};

}  // namespace widgets
