#pragma once

#include <QWidget>

#include "simcore/project/resolve.h"
#include "widgets/session/run_session.h"

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace widgets {

class TimelineSlider;

/// The actions the bar's buttons stand for. They belong to the window's action registry, which
/// gives them shortcuts and connects them; the bar keeps their icon, text and enabled state right.
struct RunActions {
    QAction* playPause = nullptr;
    QAction* step = nullptr;
    QAction* reset = nullptr;
};

/// What to run and how fast, transport buttons, time, real-time factor and a slider over the
/// recorded time.
class RunBar : public QWidget {
    Q_OBJECT
  public:
    RunBar(RunSession* session, const RunActions& actions, QWidget* parent = nullptr);

    /// Fills the scenario list and the scenario's own controller, engine and friction; keeps the
    /// choice where it still exists.
    void setProject(const simcore::project::Project& project);
    /// Scenario, controller, engine and friction as chosen (empty where it is the scenario's own).
    simcore::run::RunRequest request() const;
    QString scenario() const;
    /// The chosen one, whether or not it is the scenario's own.
    simcore::project::ControllerKind controller() const;
    /// The project's first scenario with its own settings: for a project just opened.
    void chooseFirst();
    void setScenario(const QString& name);
    void setController(simcore::project::ControllerKind kind);
    /// Next faster (+1) or slower (-1) entry of the speed list.
    void changeSpeed(int direction);
    /// A line about the run, until the next state: why it cannot start, that keys drive, ...
    /// @param detail  told beside the text when the mouse rests on it
    void showStatus(const QString& text, const std::string& detail = {});
    /// What a person driving asks for now; nothing asked shows how to drive.
    void showCommand(const simcore::run::ManualCommand& command);

  signals:
    /// The user chose another scenario, controller, engine or friction.
    void requestChanged();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void fixWidths();
    QWidget* makeSettings();
    QWidget* makeTransport();
    void showScenario();
    void updateActions();
    void updateStatus();
    void updateTime();
    const simcore::project::Scenario* chosen() const;
    double scenarioFriction() const;

    RunSession* session_;
    RunActions actions_;
    simcore::project::Project project_;
    QComboBox* scenario_ = nullptr;
    QComboBox* controller_ = nullptr;
    QComboBox* engine_ = nullptr;
    QDoubleSpinBox* friction_ = nullptr;
    QComboBox* speed_ = nullptr;
    TimelineSlider* timeline_ = nullptr;
    QLabel* time_ = nullptr;
    QLabel* rate_ = nullptr;
    QLabel* status_ = nullptr;
};

}  // namespace widgets
