#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "widgets/session/statics_worker.h"

namespace widgets {

/// The rover on its way over the scenario's obstacle, by statics, and the place of it that is
/// looked at.
///
/// Lives on the GUI thread; a StaticsWorker works. Idle while nobody looks. After an edit the place
/// looked at comes first, then the way as far as it is known; until then way() is the one before
/// the edit.
class StaticsSession : public QObject {
    Q_OBJECT
  public:
    explicit StaticsSession(QObject* parent = nullptr);
    ~StaticsSession() override;

    /// Whether somebody looks.
    void setActive(bool active);

    bool isActive() const { return active_; }

    /// Studies this from now on. Of another scenario, or after forgetPlace(), the hardest place is
    /// looked at.
    void setSubject(const simcore::project::Project& project,
                    const simcore::run::RunRequest& request);
    /// The next subject is another rover.
    void forgetPlace();

    /// The way is being worked out.
    bool isWorking() const { return working_; }

    /// Why there is nothing to look at; null when there is, or nothing is known yet.
    const StaticsFindings* failure() const { return failure_.get(); }

    /// The way that place() counts in, or what is known of it; null when there is none.
    const StaticsFindings* way() const { return way_.get(); }

    /// What shown() belongs to; null when there is nothing to look at.
    const StaticsFindings* current() const;
    /// The rover at the place; null when there is nothing to look at.
    const simcore::statics::TraverseSample* shown() const;
    /// The same for the picture, with the forces of the best torques. Call when there is something.
    simcore::run::Snapshot snapshot() const;

    /// Sample of way() that is looked at.
    int place() const { return place_; }

    void setPlace(int sample);
    /// To the sample nearest to a way [m].
    void setWay(double way);
    /// Looks at the place that asks for the most friction, wherever edits move it.
    void goToHardest();

  signals:
    /// Another way, or none; isWorking() too.
    void findingsChanged();
    /// shown() is another.
    void shownChanged();

  private:
    void begin();
    void take(const std::shared_ptr<const StaticsFindings>& findings);
    /// Whether the way so far goes as far as the place that is looked at, or takes long.
    bool isWorthShowing(const StaticsFindings& part) const;
    int nearestSample(double way) const;
    void choosePlace();
    void lookAtPlace();

    bool active_ = false;
    bool working_ = false;
    bool pending_ = false;  ///< the subject has not been given to the worker
    int number_ = 0;        ///< of the last task
    QTimer delay_;
    QElapsedTimer since_;  ///< the last task was given to the worker
    StaticsTask subject_;
    std::shared_ptr<const StaticsFindings> way_;
    std::shared_ptr<const StaticsFindings> first_;  ///< while way_ is of an earlier subject
    std::shared_ptr<const StaticsFindings> failure_;
    std::optional<double> chosen_;  ///< way that the user chose [m]; the hardest place without one
    int place_ = 0;
    std::unique_ptr<StaticsWorker> worker_;  ///< last: it publishes until it is gone
};

}  // namespace widgets
