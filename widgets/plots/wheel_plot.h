#pragma once

#include <QColor>
#include <QPixmap>
#include <QString>
#include <optional>
#include <vector>

#include "simcore/run/simulation.h"
#include "widgets/plots/wheel_marks.h"

class QCPItemStraightLine;
class QCPGraph;
class QCPItemText;
class QCustomPlot;
class QPainter;
class QPalette;
class QRect;
class QWidget;

namespace widgets {

/// How a channel is shown: its name and its unit on the screen.
struct ShownQuantity {
    QString quantity;        ///< as channels name it
    QString label;           ///< "Torque (applied)"
    QString unit;            ///< on screen: "deg" where the channel has "rad"
    double factor = 1.0;     ///< from the channel's unit to the one on screen
    bool ofChassis = false;  ///< one curve, not one a wheel
};

/// "N*m" as people write it on paper: with a middle dot.
QString prettyUnit(const QString& unit);

/// The quantities of wheels, then those of the chassis, that the channels of a run offer, once
/// each.
std::vector<ShownQuantity> quantitiesIn(const std::vector<simcore::run::Channel>& channels);

/// Line style of a run's curves: 0 is the run on show.
Qt::PenStyle lineStyle(int style);

/// A piece of such a line, for legends.
QPixmap lineSample(int style, const QColor& color);

/// A run whose curves a plot has.
struct PlottedRun {
    const std::vector<simcore::run::Channel>* channels = nullptr;
    int style = 0;
};

/// One plot of one quantity, for every run a curve for every wheel, or one for the chassis. Wraps
/// the plotting library.
class WheelPlot {
  public:
    explicit WheelPlot(QWidget* parent);

    QCustomPlot* widget() const { return plot_; }

    const ShownQuantity& quantity() const { return quantity_; }

    /// Makes the curves of `wheels` for this quantity, without data.
    void start(const ShownQuantity& quantity, const std::vector<std::string>& wheels,
               const std::vector<PlottedRun>& runs);
    /// Appends rows of a run from `first` on.
    void append(std::size_t run, const simcore::run::Recording& recording, std::size_t first);
    void clearData(std::size_t run);
    void setWheelShown(int wheel, bool shown);
    /// Shows this time window; the value axis fits the curves in it.
    void setWindow(double from, double to);
    /// Vertical lines: the instant on show, the one under the mouse, and the one that differences
    /// are taken to.
    void setMarks(double shownTime, std::optional<double> mouseTime,
                  std::optional<double> reference);
    void setHint(const QString& text);
    QString hint() const;
    void applyColors(const QPalette& palette);
    void applyFont(const QFont& font);
    void replot();
    /// The same plot in light colours.
    void paint(QPainter& painter, const QRect& place);
    /// Time at a position of the widget [s]; nothing outside the axes.
    std::optional<double> timeAt(double x, double y) const;

  private:
    void placeMarks(double from, double to);
    void colorChassisCurves(const QColor& color);
    void colorMarks(const QColor& paper);
    void setColors(const QColor& text, const QColor& background, const QColor& grid);

    QCustomPlot* plot_;
    QCPItemStraightLine* shown_;
    QCPItemStraightLine* mouse_;
    QCPItemStraightLine* reference_;
    QCPItemText* hint_;
    ShownQuantity quantity_;
    /// Least and largest value of a curve between two times; least above largest: there is none.
    std::pair<double, double> valuesIn(std::size_t curve, double from, double to) const;

    std::size_t objects_ = 0;                                     ///< curves a run
    std::vector<std::vector<std::pair<double, double>>> blocks_;  ///< of every curve
    std::vector<int> columns_;       ///< channel of every curve, run by run
    std::vector<QCPGraph*> curves_;  ///< run by run
    std::vector<QCPGraph*> marks_;   ///< on the curves, which lie below all of them
    std::vector<WheelMark> signs_;   ///< of the wheels; none for the chassis
    QColor text_, background_, grid_;
};

}  // namespace widgets
