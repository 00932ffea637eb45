#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <vector>

#include "render/scene.h"

class QFrame;
class QLabel;
class QPushButton;

namespace widgets {

class MainWindow;

/// Five minutes through the window on SOLERO: look around, drive, read the slip, see what is
/// over-constrained, let the Advisor free it. A card over the 3-D view says what to do, a frame
/// shows where; the window works as always, and the card sees when it was done.
class Tour : public QObject {
    Q_OBJECT
  public:
    /// `window` outlives it and has all its panels.
    explicit Tour(MainWindow* window);
    ~Tour() override;

    /// Begins at the first step. Opens SOLERO if another rover is open, and asks about unsaved
    /// changes then. False when the user kept the other rover, or SOLERO is not installed.
    bool start();
    /// Begins when nobody has seen the tour here yet, and the window shows nothing but an untouched
    /// or SOLERO's project.
    void offerFirst();
    void end();
    void next();
    void back();

    bool isRunning() const { return step_ >= 0; }

    /// From 0; -1: it does not run.
    int step() const { return step_; }

    int stepCount() const { return static_cast<int>(steps_.size()); }

    /// What the present step asks for has been done.
    bool isStepDone() const { return done_; }

  signals:
    void runningChanged(bool running);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Step {
        QString title;
        QString text;
        QString target;              ///< object name of what the frame is around; may be empty
        std::function<bool()> done;  ///< none: nothing is to be done
        std::function<void()> enter = {};
    };

    void makeSteps();
    void addDrivingSteps();
    void addAdvisorSteps();
    void makeCard();
    void show(int step);
    void look();
    void place();
    void placeRing();

    MainWindow* window_;
    std::vector<Step> steps_;
    int step_ = -1;
    bool done_ = false;
    QTimer timer_;
    QPointer<QFrame> card_;
    QPointer<QWidget> ring_;
    QLabel* title_ = nullptr;
    QLabel* text_ = nullptr;
    QLabel* progress_ = nullptr;
    QPushButton* next_ = nullptr;
    QPushButton* back_ = nullptr;
    render::CameraPose camera_;  ///< when the step began
    int undoIndex_ = 0;          ///< when the step began
};

}  // namespace widgets
