#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <set>

#include "widgets/session/gamepad.h"
#include "widgets/session/run_session.h"

class QWidget;

namespace widgets {

/// Drives the rover from keyboard or gamepad while a run with the manual controller plays: W/S or
/// up/down for speed, A/D or left/right to turn, Shift for a third of both; or the sticks. Text
/// fields, lists and sliders keep their keys, and outside manual runs no key is taken. Full speed
/// is the scenario's speed; a full turn takes a circle of half a wheelbase (assumed).
class ManualDrive : public QObject {
    Q_OBJECT
  public:
    /// Listens to the keys of `window`, which it belongs to.
    ManualDrive(RunSession* session, QWidget* window,
                std::unique_ptr<Gamepad> gamepad = makeSdlGamepad());

    bool eventFilter(QObject* watched, QEvent* event) override;

  signals:
    /// Something else is asked of the rover now.
    void commandChanged(const simcore::run::ManualCommand& command);

  private:
    bool active() const;
    void pollGamepad();
    void release();
    void send();
    DriveInput input() const;

    RunSession* session_;
    QWidget* window_;
    std::unique_ptr<Gamepad> gamepad_;
    QTimer poll_;
    std::set<int> pressed_;
    bool shift_ = false;
    DriveInput pad_;
    DriveInput sent_;
};

}  // namespace widgets
