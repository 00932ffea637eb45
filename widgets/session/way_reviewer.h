#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "simcore/review/way_review.h"

namespace widgets {

/// Looks beside the window whether friction and motors suffice for what the project's scenarios
/// contain: some time after the last edit, while somebody looks. Lives on the GUI thread.
class WayReviewer : public QObject {
    Q_OBJECT
  public:
    explicit WayReviewer(QObject* parent = nullptr);
    ~WayReviewer() override;

    /// Whether somebody looks.
    void setActive(bool active);
    /// Reviews this from now on; what is known of another is dropped.
    void setSubject(const simcore::project::Project& project,
                    const simcore::project::ProjectFiles& files);

    const std::vector<simcore::review::Finding>& findings() const { return findings_; }

    bool isWorking() const { return working_; }

  signals:
    void findingsChanged();

  private:
    void begin();
    void stop();
    void take(int number, std::vector<simcore::review::Finding> findings);

    simcore::project::Project project_;
    simcore::project::ProjectFiles files_;
    std::vector<simcore::review::Finding> findings_;
    QTimer delay_;
    bool active_ = false;
    bool known_ = false;  ///< the findings are of the subject
    bool working_ = false;
    int number_ = 0;  ///< of the work that counts
    std::shared_ptr<std::atomic<bool>> givenUp_;
    std::thread thread_;
};

}  // namespace widgets
