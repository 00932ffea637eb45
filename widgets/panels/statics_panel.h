#pragma once

#include <QWidget>

#include "widgets/session/statics_session.h"

class QLabel;
class QSlider;
class QToolButton;

namespace widgets {

class WayPlot;
class WheelTable;

/// What the ground must give the rover on its way over the scenario's obstacle: friction required,
/// loads and torques of the wheels, at a place that a slider chooses.
class StaticsPanel : public QWidget {
    Q_OBJECT
  public:
    explicit StaticsPanel(StaticsSession* session, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void showFrictionLarge();
    QWidget* makeHeadline();
    QWidget* makeWay();
    QWidget* makeDetails();
    void showFindings();
    void showPlot();
    void showPlace();
    void showVerdict();
    void showNotes();
    void setVerdict(const QString& level, const QString& text);

    StaticsSession* session_;
    QLabel* unavailable_ = nullptr;
    QWidget* content_ = nullptr;
    QLabel* friction_ = nullptr;
    QLabel* verdict_ = nullptr;
    QLabel* limit_ = nullptr;
    WayPlot* plot_ = nullptr;
    QSlider* place_ = nullptr;
    QLabel* where_ = nullptr;
    QToolButton* hardest_ = nullptr;
    WheelTable* wheels_ = nullptr;
    QLabel* equal_ = nullptr;
    QLabel* tipOver_ = nullptr;
    QLabel* notes_ = nullptr;
    QLabel* whole_ = nullptr;
    const StaticsFindings* plotted_ = nullptr;  ///< only compared
};

}  // namespace widgets
