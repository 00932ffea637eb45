#include "widgets/panels/motion_page.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>
#include <numbers>

namespace widgets {

using simcore::mobility::Continuation;
using simcore::mobility::Model;
using simcore::mobility::Swing;

namespace {

constexpr int kFrame_ms = 33;
constexpr double kPeriod_ms = 2500.0;

QString rowText(const Swing& swing) {
    const QString text = QString::fromStdString(swing.description);
    return swing.idle ? MotionPage::tr("Idle: %1").arg(text) : text;
}

QString noteOn(const Swing& swing) {
    if (swing.continuation == Continuation::Infinitesimal) {
        return MotionPage::tr(
            "The rover only yields here: constraints that are redundant as drawn "
            "hold after any real step. There is nothing to show.");
    }
    if (swing.idle) {
        return MotionPage::tr(
            "Idle: chassis and wheels stand still. The body that turns is "
            "marked.");
    }
    if (swing.continuation == Continuation::Branch) {
        return MotionPage::tr(
            "Only together with other free motions: the drawn pose is a "
            "branching point.");
    }
    return MotionPage::tr(
        "Loops and wheel contacts stay closed. Largest travel 5 % of the "
        "wheelbase, or 0.5 rad.");
}

}  // namespace

MotionPage::MotionPage(Document* document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      title_(new QLabel),
      list_(new QListWidget),
      note_(new QLabel) {
    setAccessibleName(tr("Free motions"));
    title_->setObjectName("motionTitle");
    title_->setAccessibleName(tr("Number of free motions"));
    list_->setObjectName("motionList");
    list_->setAccessibleName(tr("Free motions"));
    list_->setWordWrap(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMinimumHeight(60);
    list_->setSpacing(2);
    note_->setObjectName("motionNote");
    note_->setAccessibleName(tr("What to know of this motion"));
    note_->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeModels());
    layout->addWidget(makeControls());
    layout->addWidget(list_, 1);
    layout->addWidget(note_);
    timer_.setInterval(kFrame_ms);
    connect(&timer_, &QTimer::timeout, this,
            [this] { showPhase(static_cast<double>(since_.elapsed()) / kPeriod_ms); });
    connect(list_, &QListWidget::currentRowChanged, this, &MotionPage::showSelected);
    connect(document_, &Document::changed, this, [this] {
        stop();
        outdated_ = true;
        if (active_) {
            refresh();
        }
    });
}

QWidget* MotionPage::makeModels() {
    models_ = new QButtonGroup(this);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    title_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    layout->addWidget(title_, 1);
    const std::array<QString, 2> names{tr("As built"), tr("Relaxed")};
    for (int model = 0; model < 2; ++model) {
        auto* button = new QPushButton(names.at(static_cast<std::size_t>(model)));
        button->setCheckable(true);
        button->setFlat(true);
        button->setObjectName(model == 0 ? "motionBuilt" : "motionRelaxed");
        models_->addButton(button, model);
        layout->addWidget(button);
    }
    models_->button(0)->setChecked(true);
    connect(models_, &QButtonGroup::idClicked, this,
            [this](int model) { emit modelChosen(static_cast<Model>(model)); });
    return row;
}

QWidget* MotionPage::makeControls() {
    play_ = new QPushButton(tr("Swing"));
    play_->setObjectName("motionPlay");
    play_->setCheckable(true);
    play_->setAccessibleName(tr("Swing along the free motion"));
    play_->setToolTip(tr("Swing the bodies to and fro along the chosen motion"));
    next_ = new QToolButton;
    next_->setObjectName("motionNext");
    next_->setArrowType(Qt::RightArrow);
    next_->setAccessibleName(tr("Next free motion"));
    next_->setToolTip(next_->accessibleName());
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(play_, 1);
    layout->addWidget(next_);
    connect(play_, &QPushButton::toggled, this, &MotionPage::play);
    connect(next_, &QToolButton::clicked, this, [this] {
        if (list_->count() > 0) {
            list_->setCurrentRow((list_->currentRow() + 1) % list_->count());
        }
    });
    return row;
}

void MotionPage::setModel(Model model) {
    if (model == model_) {
        return;
    }
    model_ = model;
    models_->button(static_cast<int>(model))->setChecked(true);
    stop();
    outdated_ = true;
    if (active_) {
        refresh();
    }
}

void MotionPage::refresh() {
    outdated_ = false;
    const auto& mechanism = document_->derived().mechanism;
    motions_.clear();
    if (mechanism) {
        motions_ = simcore::mobility::freeMotions(*mechanism, model_);
    }
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (const Swing& swing : motions_) {
            list_->addItem(rowText(swing));
        }
        list_->setCurrentRow(motions_.empty() ? -1 : 0);
    }
    showSelected();
}

const Swing* MotionPage::selected() const {
    const int row = list_->currentRow();
    return row < 0 ? nullptr : &motions_.at(static_cast<std::size_t>(row));
}

void MotionPage::showSelected() {
    const Swing* swing = selected();
    const bool swings = swing != nullptr && swing->continuation != Continuation::Infinitesimal;
    if (!swings) {
        stop();
    }
    play_->setEnabled(swings);
    next_->setEnabled(motions_.size() > 1);
    if (swing == nullptr) {
        title_->setText(tr("No free motion"));
        note_->setText(
            tr("The constraints hold every body: the rover cannot move without slipping "
               "or straining."));
    } else {
        title_->setText(
            tr("Free motion %1 of %2").arg(list_->currentRow() + 1).arg(motions_.size()));
        note_->setText(noteOn(*swing));
    }
    since_.start();
    markIdle();
}

void MotionPage::markIdle() {
    const Swing* swing = selected();
    const auto& mechanism = document_->derived().mechanism;
    QStringList joints;
    QString body;
    if (swing != nullptr && swing->idle && mechanism) {
        const int index = mechanism->findBody(swing->body);
        for (const auto& joint : mechanism->joints) {
            if (joint.first == index || joint.second == index) {
                joints << QString::fromStdString(joint.name);
            }
        }
        body = QString::fromStdString(swing->body);
    }
    if (active_) {
        emit marked(joints, body);
    }
}

void MotionPage::showPlaying() {
    const QSignalBlocker quiet(play_);
    play_->setChecked(isPlaying());
    play_->setText(isPlaying() ? tr("Stop") : tr("Swing"));
}

void MotionPage::play(bool on) {
    if (!on) {
        stop();
        return;
    }
    since_.start();
    timer_.start();
    showPlaying();
    showPhase(0.0);
}

void MotionPage::showPhase(double turns) {
    if (const Swing* swing = selected(); swing != nullptr) {
        moved_ = true;
        emit posesShown(swing->at(std::sin(2.0 * std::numbers::pi * turns)));
    }
}

void MotionPage::stop() {
    timer_.stop();
    showPlaying();
    if (moved_) {
        moved_ = false;
        emit ended();
    }
}

void MotionPage::setActive(bool active) {
    if (active == active_) {
        return;
    }
    active_ = active;
    if (!active_) {
        stop();
        emit marked({}, {});
    } else if (outdated_) {
        refresh();
    } else {
        showSelected();
    }
}

}  // namespace widgets
