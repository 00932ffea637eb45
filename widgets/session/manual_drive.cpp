#include "widgets/session/manual_drive.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace widgets {
namespace {

enum Direction { kForward = 1, kBackward, kLeft, kRight };

/// The direction a key stands for, 0 for other keys.
int directionOf(const QKeyEvent& event) {
    if (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) {
        return 0;
    }
    switch (event.key()) {
        case Qt::Key_W:
        case Qt::Key_Up:
            return kForward;
        case Qt::Key_S:
        case Qt::Key_Down:
            return kBackward;
        case Qt::Key_A:
        case Qt::Key_Left:
            return kLeft;
        case Qt::Key_D:
        case Qt::Key_Right:
            return kRight;
        default:
            return 0;
    }
}

bool keepsItsKeys(const QWidget* widget) {
    return qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QTextEdit*>(widget) ||
           qobject_cast<const QPlainTextEdit*>(widget) ||
           qobject_cast<const QAbstractSpinBox*>(widget) ||
           qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QComboBox*>(widget);
}

}  // namespace

ManualDrive::ManualDrive(RunSession* session, QWidget* window)
    : QObject(window),
      session_(session),
      window_(window) {
    qApp->installEventFilter(this);
    connect(session, &RunSession::stateChanged, this, &ManualDrive::release);
    connect(session, &RunSession::runChanged, this, &ManualDrive::release);
}

bool ManualDrive::active() const {
    return session_->state() == RunSession::State::Playing &&
           session_->settings().controller == simcore::project::ControllerKind::Manual;
}

bool ManualDrive::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::WindowDeactivate:
            if (watched == window_) {
                release();  // the key's release will go elsewhere
            }
            return false;
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
            break;
        default:
            return false;
    }
    const auto* widget = qobject_cast<const QWidget*>(watched);
    if (!widget || widget->window() != window_ || !active() || keepsItsKeys(widget)) {
        return false;
    }
    const auto* key = static_cast<QKeyEvent*>(event);
    const int direction = directionOf(*key);
    if (direction == 0) {
        return false;
    }
    event->accept();  // as a ShortcutOverride: no shortcut, send the key itself
    if (event->type() == QEvent::KeyPress && !key->isAutoRepeat()) {
        pressed_.insert(direction);
        send();
    } else if (event->type() == QEvent::KeyRelease && !key->isAutoRepeat()) {
        pressed_.erase(direction);
        send();
    }
    return true;
}

void ManualDrive::release() {
    if (!pressed_.empty()) {
        pressed_.clear();
        send();
    }
}

void ManualDrive::send() {
    if (!session_->hasRun()) {
        return;
    }
    const auto level = [this](int plus, int minus) {
        return static_cast<double>(pressed_.count(plus)) -
               static_cast<double>(pressed_.count(minus));
    };
    const auto& run = session_->settings();
    const double turnRate = run.speed / (0.5 * run.mechanism.wheelbase());
    session_->setManualCommand(
        {.speed = level(kForward, kBackward) * run.speed, .turn = level(kLeft, kRight) * turnRate});
}

}  // namespace widgets
