#pragma once

#include <QObject>
#include <set>

#include "widgets/session/run_session.h"

namespace widgets {

/// Drives the rover from the keyboard while a run with the manual controller plays: W/S or up/down
/// for speed, A/D or left/right to turn. Install it as event filter on the window: text fields keep
/// their keys, and outside manual runs no key is taken.
class ManualDrive : public QObject {
    Q_OBJECT
  public:
    explicit ManualDrive(RunSession* session, QObject* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool active() const;
    void send();

    RunSession* session_;
    std::set<int> pressed_;
};

}  // namespace widgets
