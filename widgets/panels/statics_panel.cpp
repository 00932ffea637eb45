#include "widgets/panels/statics_panel.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>
#include <numbers>

#include "widgets/panels/statics_text.h"
#include "widgets/panels/wheel_table.h"
#include "widgets/plots/way_plot.h"

namespace widgets {

using simcore::statics::Traverse;
using simcore::statics::TraverseSample;

namespace {

constexpr int kPageSamples = 10;

QString eventsOf(const TraverseSample& sample) {
    QStringList events;
    for (const std::string& event : sample.events) {
        events << QString::fromStdString(event);
    }
    return events.join(", ");
}

/// The least friction under the rover's wheels.
double groundFriction(const StaticsFindings& findings, const TraverseSample& sample) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& contact : rollingAlong(sample.pose, findings.rollsBack())) {
        least =
            std::min(least, groundAt(*findings.run, contact.point.x(), contact.point.y()).friction);
    }
    return std::isfinite(least) ? least : findings.run->friction;
}

QLabel* sentenceLabel(const QString& objectName, const QString& accessibleName) {
    auto* label = new QLabel;
    label->setObjectName(objectName);
    label->setAccessibleName(accessibleName);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

StaticsPanel::StaticsPanel(StaticsSession* session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      unavailable_(new QLabel),
      content_(new QWidget) {
    setAccessibleName(tr("Statics"));
    unavailable_->setObjectName("staticsUnavailable");
    unavailable_->setAccessibleName(tr("Why there are no statics"));
    unavailable_->setWordWrap(true);
    unavailable_->setAlignment(Qt::AlignCenter);
    unavailable_->setMargin(12);
    auto* layout = new QVBoxLayout(content_);
    layout->setContentsMargins(8, 6, 8, 0);
    layout->setSpacing(4);
    layout->addWidget(makeHeadline());
    layout->addWidget(makeWay());
    layout->addWidget(makeDetails(), 1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(content_, 1);
    outer->addWidget(unavailable_, 1);
    connect(session_, &StaticsSession::findingsChanged, this, &StaticsPanel::showFindings);
    connect(session_, &StaticsSession::shownChanged, this, &StaticsPanel::showPlace);
    showFindings();
}

QWidget* StaticsPanel::makeHeadline() {
    friction_ = new QLabel;
    friction_->setObjectName("staticsFriction");
    friction_->setAccessibleName(tr("Required friction"));
    friction_->setToolTip(
        tr("The least friction with which some torques within the motors' limits hold the rover "
           "here: the largest T/N of the wheels, made as small as the balances allow. These come "
           "from virtual work and say what equations 2 and 3 of Lamon et al. 2004 say"));
    showFrictionLarge();
    auto* caption = new QLabel(tr("required friction"));
    verdict_ = new QLabel;
    verdict_->setObjectName("staticsVerdict");
    verdict_->setAccessibleName(tr("Whether the ground gives enough friction"));
    verdict_->setWordWrap(true);
    auto* number = new QVBoxLayout;
    number->setSpacing(0);
    number->addWidget(friction_);
    number->addWidget(caption);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    layout->addLayout(number);
    layout->addWidget(verdict_, 1);
    return row;
}

void StaticsPanel::showFrictionLarge() {
    // That of a label beside it: after a style sheet this panel's own is not up to date.
    QFont large = QApplication::font();
    large.setPointSizeF(1.7 * large.pointSizeF());
    large.setBold(true);
    friction_->setFont(large);
}

void StaticsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange && friction_ != nullptr) {
        // Style sheets give labels their fonts after this.
        QMetaObject::invokeMethod(this, &StaticsPanel::showFrictionLarge, Qt::QueuedConnection);
    }
    QWidget::changeEvent(event);
}

QWidget* StaticsPanel::makeWay() {
    plot_ = new WayPlot;
    plot_->setObjectName("staticsPlot");
    plot_->setAccessibleName(tr("Required friction over the way"));
    place_ = new QSlider(Qt::Horizontal);
    place_->setObjectName("staticsPlace");
    place_->setAccessibleName(tr("Place on the way"));
    place_->setToolTip(tr("Drive the rover along the obstacle; arrow keys, Home and End too"));
    place_->setPageStep(kPageSamples);
    where_ = new QLabel;
    where_->setObjectName("staticsWhere");
    where_->setAccessibleName(tr("Way and x of the chassis"));
    where_->setToolTip(tr("Way that the wheels have rolled, and x of the chassis' origin"));
    hardest_ = new QToolButton;
    hardest_->setObjectName("staticsHardest");
    hardest_->setText(tr("Hardest place"));
    hardest_->setAccessibleName(hardest_->text());
    hardest_->setToolTip(tr("Where the way asks for the most friction, also after edits"));
    auto* line = new QHBoxLayout;
    line->addWidget(where_, 1);
    line->addWidget(hardest_);
    auto* way = new QWidget;
    auto* layout = new QVBoxLayout(way);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(plot_);
    layout->addWidget(place_);
    layout->addLayout(line);
    connect(place_, &QSlider::valueChanged, session_, &StaticsSession::setPlace);
    connect(plot_, &WayPlot::wayChosen, session_, &StaticsSession::setWay);
    connect(hardest_, &QToolButton::clicked, session_, &StaticsSession::goToHardest);
    return way;
}

QWidget* StaticsPanel::makeDetails() {
    limit_ = sentenceLabel("staticsLimit", tr("Wheels that limit"));
    wheels_ = new WheelTable;
    equal_ = sentenceLabel("staticsEqual", tr("Equal torques"));
    equal_->setToolTip(tr("All wheels have the same torque, whatever they carry"));
    tipOver_ = sentenceLabel("staticsTipOver", tr("Tip-over angle"));
    tipOver_->setToolTip(
        tr("Least turn about a line between two wheels until the centre of mass is above it"));
    notes_ = sentenceLabel("staticsNotes", tr("What to know of this place"));
    whole_ = sentenceLabel("staticsWhole", tr("The whole way"));
    auto* details = new QWidget;
    auto* layout = new QVBoxLayout(details);
    layout->setContentsMargins(0, 0, 0, 2);
    layout->setSpacing(0);
    layout->addWidget(limit_);
    layout->addSpacing(4);
    layout->addWidget(wheels_);
    layout->addSpacing(4);
    layout->addWidget(notes_);
    layout->addWidget(equal_);
    layout->addWidget(tipOver_);
    layout->addWidget(whole_);
    layout->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setObjectName("staticsDetails");
    scroll->setAccessibleName(tr("Wheels and notes"));
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(details);
    return scroll;
}

void StaticsPanel::showFindings() {
    const StaticsFindings* failure = session_->failure();
    const bool available = session_->current() != nullptr;
    content_->setVisible(available);
    unavailable_->setVisible(!available);
    if (!available) {
        unavailable_->setText(failure != nullptr ? failureSentence(*failure)
                                                 : tr("Working out how the rover stands..."));
        return;
    }
    if (session_->isWorking()) {
        whole_->setText(tr("Working out the way..."));
    } else if (session_->way() != nullptr) {
        whole_->setText(waySentence(*session_->way()));
    }
    plot_->setCurrent(session_->way() == session_->current());
    place_->setEnabled(session_->way() != nullptr);
    hardest_->setEnabled(session_->way() != nullptr);
    showPlot();
    showPlace();
}

void StaticsPanel::showPlot() {
    const StaticsFindings* way = session_->way();
    if (way != nullptr && way == plotted_) {
        return;
    }
    plotted_ = way;
    std::vector<WayPlot::Point> points;
    if (way != nullptr) {
        for (const TraverseSample& sample : way->traverse.samples) {
            points.push_back({sample.way, sample.study.frictionRequired, sample.climbs,
                              sample.study.feasible, eventsOf(sample)});
        }
        const QSignalBlocker quiet(place_);
        place_->setRange(0, static_cast<int>(points.size()) - 1);
    }
    plot_->show(points, session_->current()->run->friction);
}

void StaticsPanel::showPlace() {
    const TraverseSample* sample = session_->shown();
    if (sample == nullptr) {
        return;
    }
    {
        const QSignalBlocker quiet(place_);
        place_->setValue(session_->place());
    }
    const StaticsFindings& findings = *session_->current();
    const auto chassis = static_cast<std::size_t>(findings.run->mechanism.chassis);
    where_->setText(tr("way %1 m, x %2 m")
                        .arg(numberText(sample->way, 3),
                             numberText(sample->pose.bodies[chassis].position.x(), 3)));
    plot_->setCursor(sample->way);
    wheels_->show(*findings.run, *sample, findings.rollsBack());
    showVerdict();
    showNotes();
}

void StaticsPanel::showVerdict() {
    const TraverseSample& sample = *session_->shown();
    const double ground = groundFriction(*session_->current(), sample);
    const double required = sample.study.frictionRequired;
    limit_->setText(limitSentence(sample.study));
    limit_->setVisible(sample.study.feasible);
    if (!sample.study.feasible) {
        friction_->setText(tr("μ* –"));
        setVerdict("bad", sample.pose.bodiesTouching.empty() ? tr("Nothing holds the rover")
                                                             : tr("The rover sits on its body"));
        return;
    }
    friction_->setText(frictionText(required));
    if (required <= ground) {
        setVerdict("good", tr("Enough:\nthe ground gives %1").arg(numberText(ground, 2)));
    } else {
        setVerdict("bad", tr("Not enough:\nthe ground gives %1").arg(numberText(ground, 2)));
    }
}

void StaticsPanel::setVerdict(const QString& level, const QString& text) {
    verdict_->setText(text);
    if (verdict_->property("level") != level) {
        verdict_->setProperty("level", level);
        // A changed property shows only after the style is applied anew.
        verdict_->style()->unpolish(verdict_);
        verdict_->style()->polish(verdict_);
    }
}

void StaticsPanel::showNotes() {
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const TraverseSample& sample = *session_->shown();
    QStringList notes;
    if (!sample.events.empty()) {
        notes << tr("Here: %1.").arg(eventsOf(sample));
    }
    notes << flagSentences(sample.study.flags);
    notes_->setText(notes.join('\n'));
    notes_->setVisible(!notes.isEmpty());
    equal_->setText(equalSentence(sample.study));
    equal_->setVisible(sample.study.equalTorque.has_value());
    tipOver_->setText(
        tr("Tip-over angle %1°.").arg(numberText(sample.study.tipOver * kDegrees, 1)));
}

}  // namespace widgets
