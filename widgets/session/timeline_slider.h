#pragma once

#include <QSlider>

namespace widgets {

/// A slider over the recorded time [ms]: a click goes straight to the place clicked.
class TimelineSlider : public QSlider {
    Q_OBJECT
  public:
    explicit TimelineSlider(QWidget* parent = nullptr);

  signals:
    /// The user (not the program) chose a time.
    void timeChosen(double seconds);

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void chooseAt(double x);
};

}  // namespace widgets
