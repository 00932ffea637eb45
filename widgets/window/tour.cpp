#include "widgets/window/tour.h"

#include <QEvent>
#include <QFrame>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTreeWidget>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/panels/advisor_page.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/window/action_registry.h"
#include "widgets/window/file_commands.h"
#include "widgets/window/main_window.h"

namespace widgets {
namespace {

constexpr const char* kSeen = "tour/seen";
constexpr const char* kRover = "SOLERO";
constexpr int kLook_ms = 150;
constexpr int kMargin = 12;  ///< of the card in the 3-D view [px]

/// A frame around what a step is about: nothing but its edge, so that all below works and shows.
class Ring : public QWidget {
  public:
    explicit Ring(QWidget* parent) : QWidget(parent) {
        setObjectName("tourRing");
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
    }

    void around(const QRect& place) {
        constexpr int kEdge = 3;
        setGeometry(
            place.adjusted(-kEdge, -kEdge, kEdge, kEdge).intersected(parentWidget()->rect()));
        setMask(QRegion(rect()) - QRegion(rect().adjusted(kEdge, kEdge, -kEdge, -kEdge)));
        show();
        raise();
    }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        QPainter(this).fillRect(rect(), palette().color(QPalette::Highlight));
    }
};

bool sameView(const render::CameraPose& a, const render::CameraPose& b) {
    // The driving rover takes both along.
    return (a.eye - a.center - b.eye + b.center).norm() < 1e-6;
}

}  // namespace

Tour::Tour(MainWindow* window) : QObject(window), window_(window) {
    setObjectName("tour");
    makeSteps();
    timer_.setInterval(kLook_ms);
    connect(&timer_, &QTimer::timeout, this, &Tour::look);
    window_->installEventFilter(this);
}

Tour::~Tour() = default;

void Tour::makeSteps() {
    steps_.push_back(
        {tr("Five minutes with SOLERO"),
         tr("This rover climbs steps higher than its wheels, without a motor in its "
            "suspension. The tour drives it, and finds what is wrong with its joints. "
            "<b>Enter</b> goes on, <b>Esc</b> ends it; <i>Help &gt; Tour</i> brings it "
            "back."),
         {},
         {},
         {}});
    addDrivingSteps();
    addAdvisorSteps();
    steps_.push_back({tr("That was it"),
                      tr("<b>Ctrl+Shift+N</b> makes a rover of your own from its main dimensions. "
                         "<b>F1</b> opens the user guide, <b>Ctrl+F1</b> lists the keys."),
                      {},
                      {},
                      {}});
}

void Tour::addDrivingSteps() {
    if (window_->viewport() != nullptr) {
        steps_.push_back({tr("Look around"),
                          tr("Drag in the 3-D view to turn it, drag with the right button to move "
                             "it, turn the wheel to zoom."),
                          {},
                          [this] { return !sameView(camera_, window_->viewport()->camera()); },
                          {}});
    }
    steps_.push_back({tr("Drive"),
                      tr("Press <b>Space</b>: SOLERO drives over rough ground. Arrows show the "
                         "forces of the ground."),
                      "playPauseButton",
                      [this] { return window_->session().endTime() > 0.5; },
                      {}});
    steps_.push_back(
        {tr("Read the slip"),
         tr("Every wheel has a curve, with a sign and a colour of its own. Click into a "
            "plot: the 3-D view shows that instant, the table its values."),
         "plot:0", [this] { return window_->session().hasRun() && !window_->session().isLive(); },
         [this] {
             window_->showPanel("run");
             if (window_->session().state() == RunSession::State::Playing) {
                 window_->session().pause();
             }
         }});
}

void Tour::addAdvisorSteps() {
    steps_.push_back(
        {tr("Over-constrained"),
         tr("The Grübler count says −20: it should not move at all. Yet it drives, for "
            "<b>21 constraints are redundant</b>: inaccurate parts strain each other, "
            "and no statics tell the forces in them."),
         "headline",
         {},
         [this] { window_->showPanel("mobility"); }});
    steps_.push_back({tr("Which joints?"),
                      tr("Click a joint in this list: it is ringed in the 3-D view. The bar is how "
                         "much of it others hold already."),
                      "removableList",
                      [this] {
                          return !window_->scene().highlighted().joints.empty() &&
                                 window_->findChild<QTreeWidget*>("removableList")->currentItem() !=
                                     nullptr;
                      },
                      [this] { window_->showPanel("mobility"); }});
    steps_.push_back({tr("Ask the Advisor"),
                      tr("Press <b>Ctrl+Shift+A</b>. It searches joints to free so that nothing is "
                         "redundant and the rover moves as before."),
                      "pageAdvisor",
                      [this] {
                          const AdvisorSession& advisor = window_->mobility().advisor().session();
                          return advisor.advice() != nullptr && !advisor.isWorking();
                      },
                      {}});
    steps_.push_back(
        {tr("Apply a proposal"),
         tr("Choose one that is not applied yet and press <b>Apply proposal</b>: it becomes the "
            "<i>relaxed</i> model, with nothing redundant. The rover as built stays."),
         "advisorApply",
         [this] {
             return window_->document().undoStack().index() > undoIndex_ &&
                    window_->mobility().advisor().session().appliedProposal() >= 0;
         },
         [this] { window_->showPanel("advisor"); }});
    steps_.push_back({tr("Take it back"),
                      tr("<b>Ctrl+Z</b> undoes it, as every other edit."),
                      {},
                      [this] { return window_->document().undoStack().index() < undoIndex_; },
                      {}});
}

void Tour::makeCard() {
    card_ = new QFrame(window_);
    card_->setObjectName("tourCard");
    card_->setAccessibleName(tr("Tour"));
    card_->setFrameShape(QFrame::StyledPanel);
    card_->setAutoFillBackground(true);
    card_->setBackgroundRole(QPalette::Base);
    card_->setFocusPolicy(Qt::StrongFocus);
    card_->installEventFilter(this);
    title_ = new QLabel;
    title_->setObjectName("tourTitle");
    QFont bold;
    bold.setBold(true);
    title_->setFont(bold);
    text_ = new QLabel;
    text_->setObjectName("tourText");
    text_->setWordWrap(true);
    progress_ = new QLabel;
    progress_->setObjectName("tourProgress");
    progress_->setAccessibleName(tr("Progress of the tour"));
    progress_->setForegroundRole(QPalette::PlaceholderText);
    const auto button = [this](const QString& text, const char* name, auto slot) {
        auto* one = new QPushButton(text);
        one->setObjectName(name);
        // Space is for driving, also while the card has the focus.
        one->setFocusPolicy(Qt::TabFocus);
        connect(one, &QPushButton::clicked, this, slot);
        return one;
    };
    QPushButton* skip = button(tr("&Skip the tour"), "tourSkip", &Tour::end);
    back_ = button(tr("&Back"), "tourBack", &Tour::back);
    next_ = button(tr("&Next"), "tourNextButton", &Tour::next);
    auto* head = new QHBoxLayout;
    head->addWidget(title_, 1);
    head->addWidget(progress_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(skip);
    buttons->addStretch(1);
    buttons->addWidget(back_);
    buttons->addWidget(next_);
    auto* layout = new QVBoxLayout(card_);
    layout->setContentsMargins(12, 10, 12, 10);
    layout->setSpacing(8);
    layout->addLayout(head);
    layout->addWidget(text_);
    layout->addLayout(buttons);
    ring_ = new Ring(window_);
}

bool Tour::start() {
    const auto isRover = [this] { return window_->document().project().rover.name == kRover; };
    if (!isRover()) {
        for (const QString& file : window_->files().exampleFiles()) {
            if (file.endsWith("/solero.rover")) {
                window_->files().openExample(file);
            }
        }
    }
    if (!isRover()) {
        return false;
    }
    QSettings().setValue(kSeen, true);
    if (card_ == nullptr) {
        makeCard();
    }
    const bool ran = isRunning();
    show(0);
    card_->setFocus();
    timer_.start();
    if (!ran) {
        emit runningChanged(true);
    }
    return true;
}

void Tour::offerFirst() {
    const bool untouched =
        window_->document().file().isEmpty() && !window_->document().isModified();
    const bool suits = untouched || window_->document().project().rover.name == kRover;
    if (suits && !QSettings().value(kSeen, false).toBool()) {
        start();
    }
}

void Tour::end() {
    if (!isRunning()) {
        return;
    }
    step_ = -1;
    timer_.stop();
    card_->hide();
    ring_->hide();
    window_->setFocus();
    emit runningChanged(false);
}

void Tour::next() {
    if (isRunning() && step_ + 1 < stepCount()) {
        show(step_ + 1);
    } else {
        end();
    }
}

void Tour::back() {
    if (step_ > 0) {
        show(step_ - 1);
    }
}

void Tour::show(int step) {
    step_ = step;
    const Step& now = steps_[static_cast<std::size_t>(step)];
    if (now.enter) {
        now.enter();
    }
    if (window_->viewport() != nullptr) {
        camera_ = window_->viewport()->camera();
    }
    undoIndex_ = window_->document().undoStack().index();
    done_ = false;
    title_->setText(now.title);
    text_->setText(now.text);
    text_->setAccessibleName(now.text);
    progress_->setText(tr("%1 of %2").arg(step + 1).arg(stepCount()));
    back_->setEnabled(step > 0);
    next_->setText(step + 1 < stepCount() ? tr("&Next") : tr("&Finish"));
    card_->show();
    if (auto* target = window_->findChild<QWidget*>(now.target); !now.target.isEmpty()) {
        for (QWidget* up = target; up != nullptr; up = up->parentWidget()) {
            if (auto* area = qobject_cast<QScrollArea*>(up)) {
                area->ensureWidgetVisible(target);
            }
        }
    }
    look();
}

void Tour::look() {
    const Step& now = steps_[static_cast<std::size_t>(step_)];
    if (!done_ && now.done && now.done()) {
        done_ = true;
        title_->setText(QString(QChar(0x2713)) + " " + now.title);
    }
    next_->setDefault(!now.done || done_);
    placeRing();
    place();
}

void Tour::place() {
    const QWidget* view = window_->centralWidget();
    if (card_ == nullptr || !isRunning() || view == nullptr) {
        return;
    }
    constexpr int kWidthInLines = 25;
    const QRect room(view->mapTo(window_, QPoint(0, 0)), view->size());
    const int width = std::max(
        card_->layout()->minimumSize().width(),
        std::min(room.width() - 2 * kMargin, kWidthInLines * card_->fontMetrics().height()));
    const int height = card_->layout()->heightForWidth(width) + 2 * card_->frameWidth();
    // At the top, over the sky: the rover stands in the middle.
    card_->setGeometry(room.left() + kMargin, room.top() + kMargin, width, height);
    card_->raise();
}

void Tour::placeRing() {
    const Step& now = steps_[static_cast<std::size_t>(step_)];
    const QWidget* target =
        now.target.isEmpty() ? nullptr : window_->findChild<QWidget*>(now.target);
    auto* ring = static_cast<Ring*>(ring_.data());
    // What is scrolled out of its panel cannot be pointed at.
    const QRect seen = target == nullptr ? QRect() : target->visibleRegion().boundingRect();
    if (done_ || seen.isEmpty() || target->window() != window_) {
        ring->hide();
        return;
    }
    ring->around(seen.translated(target->mapTo(window_, QPoint(0, 0))));
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (!isRunning()) {
        return false;
    }
    if (watched == card_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape) {
            end();
            return true;
        }
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            next();
            return true;
        }
    }
    const bool moves = event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest ||
                       event->type() == QEvent::FontChange;
    if (moves && watched == window_) {
        QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection);
    }
    return false;
}

}  // namespace widgets
