#include "widgets/session/run_bar.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QStandardItemModel>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <cmath>
#include <numbers>

#include "simcore/project/names.h"
#include "widgets/session/run_icons.h"
#include "widgets/session/run_titles.h"
#include "widgets/session/timeline_slider.h"

namespace widgets {

using simcore::project::ControllerKind;
using simcore::project::EngineKind;
using simcore::run::RunReport;
using simcore::run::StopReason;

namespace {

constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 0.0};  // 0 = as fast as it goes

QString outcome(const RunReport& report) {
    const QString numbers = RunBar::tr("%1 m driven, slip %2 m, %3 J")
                                .arg(report.distance, 0, 'f', 2)
                                .arg(report.slipAbs, 0, 'f', 3)
                                .arg(report.energy, 0, 'f', 0);
    switch (report.stopReason) {
        case StopReason::Completed:
            return RunBar::tr("Completed: %1").arg(numbers);
        case StopReason::TimeUp:
            return RunBar::tr("Time is up: %1").arg(numbers);
        case StopReason::Stuck:
            return RunBar::tr("Stuck: %1").arg(numbers);
        case StopReason::NonFinite:
        case StopReason::SingularPose:
            return RunBar::tr("Stopped, the simulation failed: %1")
                .arg(QString::fromStdString(report.stopDetail));
        case StopReason::Running:
        case StopReason::Stopped:
            break;
    }
    return report.stopDetail.empty() ? RunBar::tr("Stopped: %1").arg(numbers)
                                     : QString::fromStdString(report.stopDetail);
}

QString recordingText(const RecordedRun& run) {
    const double end = run.last->time;
    if (!run.complete) {
        return RunBar::tr("Recording, incomplete: up to %1 s").arg(end, 0, 'f', 2);
    }
    return run.report.stopReason == StopReason::Running
               ? RunBar::tr("Recording of the first %1 s of a run").arg(end, 0, 'f', 2)
               : RunBar::tr("Recording: %1").arg(outcome(run.report));
}

/// A label whose text may be longer than its place: it goes on in a second line, and what is too
/// long for two is shown up to there.
class ElidedLabel : public QLabel {
  public:
    QSize minimumSizeHint() const override { return {0, 2 * fontMetrics().lineSpacing()}; }

  protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        const QRect place = contentsRect();
        QPainter painter(this);
        style()->drawItemText(&painter, place, static_cast<int>(alignment()), palette(),
                              isEnabled(), shown(place.width()), foregroundRole());
    }

  private:
    QString shown(int width) const {
        const QFontMetrics metrics = fontMetrics();
        if (metrics.horizontalAdvance(text()) <= width) {
            return text();
        }
        QString first;
        for (const QString& word : text().split(' ')) {
            const QString longer = first.isEmpty() ? word : first + ' ' + word;
            if (metrics.horizontalAdvance(longer) > width) {
                break;
            }
            first = longer;
        }
        const QString rest = text().mid(first.size()).trimmed();
        return (first.isEmpty() ? QString() : first + '\n') +
               metrics.elidedText(rest, Qt::ElideRight, width);
    }
};

constexpr int kLeastEditor = 70;  ///< [px]

QToolButton* transportButton(QAction* action) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setAutoRaise(true);
    button->setIconSize({20, 20});
    button->setObjectName(action->objectName() + "Button");
    button->setAccessibleName(action->text());
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

/// Enough for the widest text it will hold, so that nothing jumps while numbers change.
void fixWidth(QLabel* label, const QString& widest) {
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 4);
}

}  // namespace

RunBar::RunBar(RunSession* session, const RunActions& actions, QWidget* parent)
    : QWidget(parent),
      session_(session),
      actions_(actions) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    layout->addWidget(makeSettings());
    layout->addWidget(makeTransport());
    connect(session_, &RunSession::stateChanged, this, [this] {
        updateActions();
        updateStatus();
        updateTime();
    });
    connect(session_, &RunSession::staleChanged, this, [this] {
        updateActions();
        updateStatus();
    });
    connect(session_, &RunSession::runChanged, this, [this] {
        updateActions();
        updateStatus();
        updateTime();
    });
    connect(session_, &RunSession::snapshotChanged, this, &RunBar::updateTime);
    connect(session_, &RunSession::dataReplaced, this, &RunBar::updateTime);
    connect(session_, &RunSession::finished, this, &RunBar::updateStatus);
    connect(session_, &RunSession::speedFactorChanged, this, [this](double factor) {
        const QSignalBlocker quiet(speed_);
        speed_->setCurrentIndex(speed_->findData(factor));
    });
    updateActions();
    updateStatus();
    updateTime();
}

QWidget* RunBar::makeSettings() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    const auto add = [&](const QString& text, QWidget* editor) {
        auto* label = new QLabel(text);
        label->setBuddy(editor);
        editor->setAccessibleName(text);
        // In a narrow window long names are cut, not the window's edge.
        editor->setMinimumWidth(kLeastEditor);
        layout->addWidget(label);
        layout->addWidget(editor);
        layout->addSpacing(8);
    };
    scenario_ = new QComboBox;
    scenario_->setObjectName("scenario");
    scenario_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    scenario_->setMinimumContentsLength(12);
    add(tr("Scenario"), scenario_);
    controller_ = new QComboBox;
    controller_->setObjectName("controller");
    for (const std::string& name : simcore::project::allNames<ControllerKind>()) {
        const auto kind = *simcore::project::fromName<ControllerKind>(name);
        controller_->addItem(controllerTitle(kind), static_cast<int>(kind));
        if (kind == ControllerKind::EqualTorque || kind == ControllerKind::Torque) {
            controller_->setItemData(
                controller_->count() - 1,
                tr("Shares a common torque by the wheels' loads: equation 4 of Lamon et al. 2004"),
                Qt::ToolTipRole);
        }
    }
    add(tr("Controller"), controller_);
    engine_ = new QComboBox;
    engine_->setObjectName("engine");
    for (const std::string& name : simcore::project::allNames<EngineKind>()) {
        const auto kind = *simcore::project::fromName<EngineKind>(name);
        engine_->addItem(engineTitle(kind), static_cast<int>(kind));
    }
    engine_->setToolTip(
        tr("ODE: Open Dynamics Engine, friction by boxes. Reduced: free rates only, Coulomb's "
           "cone, several times faster"));
    add(tr("Engine"), engine_);
    friction_ = new QDoubleSpinBox;
    friction_->setObjectName("friction");
    friction_->setRange(0.0, 5.0);
    friction_->setDecimals(2);
    friction_->setSingleStep(0.05);
    friction_->setKeyboardTracking(false);
    friction_->setToolTip(tr("Coulomb coefficient between wheel and ground"));
    add(tr("Friction"), friction_);
    status_ = new ElidedLabel;
    status_->setObjectName("runStatus");
    status_->setAccessibleName(tr("State of the run"));
    status_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    status_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    layout->addWidget(status_, 1);

    connect(scenario_, &QComboBox::activated, this, [this] {
        showScenario();
        emit requestChanged();
    });
    connect(controller_, &QComboBox::activated, this, &RunBar::requestChanged);
    connect(engine_, &QComboBox::activated, this, &RunBar::requestChanged);
    connect(friction_, &QDoubleSpinBox::valueChanged, this, &RunBar::requestChanged);
    // Typed and confirmed: the next Space drives.
    connect(friction_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, friction_,
            &QWidget::clearFocus, Qt::QueuedConnection);
    return row;
}

QWidget* RunBar::makeTransport() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(transportButton(actions_.playPause));
    layout->addWidget(transportButton(actions_.step));
    layout->addWidget(transportButton(actions_.reset));
    timeline_ = new TimelineSlider;
    timeline_->setObjectName("timeline");
    timeline_->setAccessibleName(tr("Time shown"));
    timeline_->setToolTip(tr("Drag to look at any instant of the run"));
    layout->addWidget(timeline_, 1);
    speed_ = new QComboBox;
    speed_->setObjectName("speed");
    for (const double factor : kSpeeds) {
        speed_->addItem(factor == 0.0 ? tr("fastest") : QString("%1 x").arg(factor), factor);
    }
    speed_->setCurrentIndex(speed_->findData(session_->speedFactor()));
    speed_->setToolTip(tr("Playback speed; never changes the numbers (+ and - keys)"));
    speed_->setAccessibleName(tr("Playback speed"));
    layout->addWidget(speed_);
    time_ = new QLabel;
    time_->setAccessibleName(tr("Time"));
    time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(time_);
    rate_ = new QLabel;
    rate_->setAccessibleName(tr("Real-time factor"));
    rate_->setToolTip(tr("Simulated time over clock time"));
    rate_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    fixWidths();
    layout->addWidget(rate_);
    connect(speed_, &QComboBox::activated, this,
            [this] { session_->setSpeedFactor(speed_->currentData().toDouble()); });
    connect(timeline_, &TimelineSlider::timeChosen, session_, &RunSession::scrub);
    return row;
}

const simcore::project::Scenario* RunBar::chosen() const {
    for (const auto& scenario : project_.scenarios) {
        if (scenario.name == scenario_->currentText().toStdString()) {
            return &scenario;
        }
    }
    return nullptr;
}

double RunBar::scenarioFriction() const {
    const auto* scenario = chosen();
    if (scenario == nullptr) {
        return 0.0;
    }
    const auto parameters = simcore::project::evaluateParameters(project_.rover);
    const auto value = simcore::project::evaluate(
        scenario->soil.friction, parameters ? *parameters : simcore::project::ParameterValues{},
        "friction");
    return value ? *value : 0.0;
}

void RunBar::setProject(const simcore::project::Project& project) {
    const auto before = request();
    const bool otherScenarios = project.scenarios != project_.scenarios;
    project_ = project;
    if (!otherScenarios) {
        return;
    }
    const QString kept = scenario_->currentText();
    {
        const QSignalBlocker quiet(scenario_);
        scenario_->clear();
        for (const auto& scenario : project.scenarios) {
            scenario_->addItem(QString::fromStdString(scenario.name));
            scenario_->setItemData(scenario_->count() - 1,
                                   QString::fromStdString(scenario.description), Qt::ToolTipRole);
        }
        const int at = scenario_->findText(kept);
        scenario_->setCurrentIndex(std::max(at, project.scenarios.empty() ? -1 : 0));
    }
    showScenario();
    // What the user chose on top stays.
    if (scenario_->currentText() == kept) {
        if (before.controller) {
            controller_->setCurrentIndex(
                controller_->findData(static_cast<int>(*before.controller)));
        }
        if (before.engine) {
            engine_->setCurrentIndex(engine_->findData(static_cast<int>(*before.engine)));
        }
        if (before.friction) {
            const QSignalBlocker quiet(friction_);
            friction_->setValue(*before.friction);
        }
    }
}

void RunBar::showScenario() {
    const auto* scenario = chosen();
    controller_->setEnabled(scenario != nullptr);
    engine_->setEnabled(scenario != nullptr);
    friction_->setEnabled(scenario != nullptr);
    if (scenario == nullptr) {
        return;
    }
    scenario_->setToolTip(QString::fromStdString(scenario->description));
    controller_->setCurrentIndex(
        controller_->findData(static_cast<int>(scenario->controller.kind)));
    engine_->setCurrentIndex(engine_->findData(static_cast<int>(scenario->run.engine)));
    const QSignalBlocker quiet(friction_);
    friction_->setValue(scenarioFriction());
}

ControllerKind RunBar::controller() const {
    return static_cast<ControllerKind>(controller_->currentData().toInt());
}

simcore::run::RunRequest RunBar::request() const {
    simcore::run::RunRequest request;
    request.scenario = scenario_->currentText().toStdString();
    const auto* scenario = chosen();
    if (scenario == nullptr) {
        return request;
    }
    const ControllerKind kind = controller();
    if (kind != scenario->controller.kind) {
        request.controller = kind;
    }
    const auto engine = static_cast<EngineKind>(engine_->currentData().toInt());
    if (engine != scenario->run.engine) {
        request.engine = engine;
    }
    // The field shows two decimals; the scenario's own value may have more.
    if (std::abs(friction_->value() - scenarioFriction()) > 0.005) {
        request.friction = friction_->value();
    }
    return request;
}

QString RunBar::scenario() const {
    return scenario_->currentText();
}

void RunBar::chooseFirst() {
    scenario_->setCurrentIndex(scenario_->count() > 0 ? 0 : -1);
    showScenario();
    emit requestChanged();
}

void RunBar::setScenario(const QString& name) {
    const int at = scenario_->findText(name);
    if (at >= 0 && at != scenario_->currentIndex()) {
        scenario_->setCurrentIndex(at);
        showScenario();
        emit requestChanged();
    }
}

void RunBar::setController(ControllerKind kind) {
    const int at = controller_->findData(static_cast<int>(kind));
    if (at != controller_->currentIndex()) {
        controller_->setCurrentIndex(at);
        emit requestChanged();
    }
}

void RunBar::changeSpeed(int direction) {
    const int next = std::clamp(speed_->currentIndex() + direction, 0, speed_->count() - 1);
    speed_->setCurrentIndex(next);
    session_->setSpeedFactor(speed_->currentData().toDouble());
}

void RunBar::showStatus(const QString& text, const std::string& detail) {
    status_->setText(text);
    status_->setToolTip(detail.empty() ? text : text + "\n" + QString::fromStdString(detail));
}

void RunBar::showCommand(const simcore::run::ManualCommand& command) {
    if (session_->state() != RunSession::State::Playing ||
        command == simcore::run::ManualCommand{}) {
        updateStatus();
        return;
    }
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    const auto part = [](double value, const QString& plus, const QString& minus) {
        return value == 0.0 ? QString()
                            : (value > 0.0 ? plus : minus).arg(std::abs(value), 0, 'g', 3);
    };
    QStringList asked{
        part(command.speed, tr("ahead %1 m/s"), tr("back %1 m/s")),
        part(command.turn * kDegrees, tr("left %1 \u00b0/s"), tr("right %1 \u00b0/s"))};
    asked.removeAll(QString());
    showStatus(tr("Driving: %1").arg(asked.join(", ")));
}

void RunBar::updateActions() {
    const RunSession::State state = session_->state();
    const bool playing = state == RunSession::State::Playing;
    actions_.playPause->setIcon(runIcon(playing ? RunIcon::Pause : RunIcon::Play, palette()));
    actions_.playPause->setText(playing ? tr("&Pause") : tr("&Play"));
    actions_.step->setIcon(runIcon(RunIcon::Step, palette()));
    actions_.reset->setIcon(runIcon(RunIcon::Reset, palette()));
    actions_.step->setEnabled(!playing);
    actions_.reset->setEnabled(session_->hasRun() && state != RunSession::State::Ready);
}

void RunBar::updateStatus() {
    const RunSession::State state = session_->state();
    if (session_->isStale() && state != RunSession::State::Empty &&
        state != RunSession::State::Ready) {
        showStatus(tr("Edited since this run: play starts a new one"));
        return;
    }
    switch (state) {
        case RunSession::State::Empty:
        case RunSession::State::Ready:
            showStatus(tr("Ready: press Space to drive"));
            break;
        case RunSession::State::Playing:
            showStatus(session_->settings().controller == ControllerKind::Manual
                           ? tr("Drive with W A S D, arrow keys or gamepad")
                           : tr("Running"));
            break;
        case RunSession::State::Paused:
            showStatus(tr("Paused"));
            break;
        case RunSession::State::Finished: {
            const RecordedRun* const recorded = session_->recorded();
            const RunReport report = recorded != nullptr ? recorded->report : session_->report();
            showStatus(recorded != nullptr ? recordingText(*recorded) : outcome(report),
                       report.stopReason == StopReason::Stuck ? report.stopDetail : std::string());
            break;
        }
    }
}

void RunBar::updateTime() {
    const double end = session_->endTime();
    const QSignalBlocker quiet(timeline_);
    timeline_->setEnabled(session_->hasRun());
    timeline_->setRange(0, static_cast<int>(std::lround(1e3 * end)));
    if (!timeline_->isSliderDown()) {
        timeline_->setValue(static_cast<int>(std::lround(1e3 * session_->shownTime())));
    }
    time_->setText(session_->isLive()
                       ? tr("%1 s").arg(end, 0, 'f', 2)
                       : tr("%1 / %2 s").arg(session_->shownTime(), 0, 'f', 2).arg(end, 0, 'f', 2));
    const bool playing = session_->state() == RunSession::State::Playing;
    rate_->setText(playing ? tr("RTF %1").arg(session_->realTimeFactor(), 0, 'f', 2)
                           : tr("RTF %1").arg(QChar(0x2013)));
}

void RunBar::fixWidths() {
    fixWidth(time_, "000.00 / 000.00 s");
    fixWidth(rate_, tr("RTF %1").arg("00.00"));
}

void RunBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        updateActions();
    } else if (event->type() == QEvent::FontChange && rate_ != nullptr) {
        fixWidths();
    }
    QWidget::changeEvent(event);
}

}  // namespace widgets
