#pragma once

#include <QObject>
#include <set>

#include "widgets/session/run_session.h"

class QWidget;

namespace widgets {

/// Drives the rover from the keyboard while a run with the manual controller plays: W/S or up/down
/// for speed, A/D or left/right to turn. Text fields, lists and sliders keep their keys, and
/// outside manual runs no key is taken. Full speed is the scenario's speed; a full turn takes a
/// circle of half a wheelbase (assumed).
class ManualDrive : public QObject {
    Q_OBJECT
  public:
    /// Listens to the keys of `window`, which it belongs to.
    ManualDrive(RunSession* session, QWidget* window);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool active() const;
    void release();
    void send();

    RunSession* session_;
    QWidget* window_;
    std::set<int> pressed_;
};

}  // namespace widgets
