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
#include <cmath>
#include <utility>

namespace widgets {
namespace {

/// Of full speed and turn, while Shift or a shoulder button is held (assumed).
constexpr double kSlow = 1.0 / 3.0;
/// A gamepad is looked at this often.
constexpr int kPoll_ms = 20;

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

ManualDrive::ManualDrive(RunSession* session, QWidget* window, std::unique_ptr<Gamepad> gamepad)
    : QObject(window),
      session_(session),
      window_(window),
      gamepad_(std::move(gamepad)) {
    qApp->installEventFilter(this);
    poll_.setInterval(kPoll_ms);
    connect(&poll_, &QTimer::timeout, this, &ManualDrive::pollGamepad);
    const auto restart = [this] {
        release();
        if (active()) {
            poll_.start();
        } else {
            poll_.stop();
        }
    };
    connect(session, &RunSession::stateChanged, this, restart);
    connect(session, &RunSession::runChanged, this, restart);
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
    if (key->key() == Qt::Key_Shift && event->type() != QEvent::ShortcutOverride) {
        shift_ = event->type() == QEvent::KeyPress;
        send();
        return false;  // it may mean more to others
    }
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

void ManualDrive::pollGamepad() {
    pad_ = gamepad_->read().value_or(DriveInput());
    send();
}

void ManualDrive::release() {
    pressed_.clear();
    shift_ = false;
    pad_ = {};
    send();
}

/// Of keys and gamepad, whichever asks for more.
DriveInput ManualDrive::input() const {
    const auto level = [this](int plus, int minus) {
        return static_cast<double>(pressed_.count(plus)) -
               static_cast<double>(pressed_.count(minus));
    };
    const auto larger = [](double a, double b) { return std::abs(a) >= std::abs(b) ? a : b; };
    return {larger(level(kForward, kBackward), pad_.ahead), larger(level(kLeft, kRight), pad_.left),
            shift_ || pad_.slow};
}

void ManualDrive::send() {
    const DriveInput asked = input();
    if (!session_->hasRun() || asked == sent_) {
        return;
    }
    sent_ = asked;
    const auto& run = session_->settings();
    const double share = asked.slow ? kSlow : 1.0;
    const double turnRate = run.speed / (0.5 * run.mechanism.wheelbase());
    const simcore::run::ManualCommand command{.speed = share * asked.ahead * run.speed,
                                              .turn = share * asked.left * turnRate};
    session_->setManualCommand(command);
    emit commandChanged(command);
}

}  // namespace widgets
