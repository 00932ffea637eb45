#pragma once

#include <QWidget>
#include <vector>

class QCPGraph;
class QCPItemStraightLine;
class QCustomPlot;
class QMouseEvent;

namespace widgets {

/// The friction required over the way: solid where the rover climbs, pale where it goes down by
/// itself, marked where no torques hold it. With the ground's friction, events and a cursor.
class WayPlot : public QWidget {
    Q_OBJECT
  public:
    struct Point {
        double way = 0.0;       ///< [m]
        double friction = 0.0;  ///< required [-]
        bool climbs = false;
        bool held = true;  ///< some torques hold the rover
        QString events;    ///< empty: none
    };

    explicit WayPlot(QWidget* parent = nullptr);

    /// @param ground  friction that there is [-]
    void show(const std::vector<Point>& points, double ground);
    /// @param of  the curve is of what is shown now, not of what was before an edit
    void setCursor(double way);
    void setCurrent(bool of);

  signals:
    /// The user pointed at a place of the way [m].
    void wayChosen(double way);

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void applyColors();
    void applyFont();
    void onMouse(const QMouseEvent* event, bool pressed);
    void showEvents(const QMouseEvent* event);

    QCustomPlot* plot_;
    QCPGraph* falls_;
    QCPGraph* climbs_;
    QCPGraph* unheld_;
    QCPGraph* marks_;
    QCPItemStraightLine* ground_;
    QCPItemStraightLine* cursor_;
    std::vector<Point> points_;
    bool current_ = true;
};

}  // namespace widgets
