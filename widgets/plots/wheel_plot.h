#pragma once

#include <QColor>
#include <QString>
#include <optional>
#include <vector>

#include "simcore/run/simulation.h"

class QCPItemStraightLine;
class QCPItemText;
class QCustomPlot;
class QPainter;
class QPalette;
class QRect;
class QWidget;

namespace widgets {

/// How a channel is shown: its name and its unit on the screen.
struct ShownQuantity {
    QString quantity;     ///< as channels name it
    QString label;        ///< "Torque (applied)"
    QString unit;         ///< on screen: "deg" where the channel has "rad"
    double factor = 1.0;  ///< from the channel's unit to the one on screen
};

/// "N*m" as people write it on paper: with a middle dot.
QString prettyUnit(const QString& unit);

/// The wheel quantities that the channels of a run offer, once each.
std::vector<ShownQuantity> quantitiesIn(const std::vector<simcore::run::Channel>& channels);

/// One plot of one quantity, a curve for every wheel. Wraps the plotting library.
class WheelPlot {
  public:
    explicit WheelPlot(QWidget* parent);

    QCustomPlot* widget() const { return plot_; }

    const ShownQuantity& quantity() const { return quantity_; }

    /// Makes the curves of `wheels` for this quantity, without data.
    void start(const ShownQuantity& quantity, const std::vector<simcore::run::Channel>& channels,
               const std::vector<std::string>& wheels);
    /// Appends rows from `first` on.
    void append(const simcore::run::Recording& recording, std::size_t first);
    void clearData();
    void setWheelShown(int wheel, bool shown);
    /// Shows this time window; the value axis fits the curves in it.
    void setWindow(double from, double to);
    /// Vertical lines: the instant on show, and the one under the mouse.
    void setMarks(double shownTime, std::optional<double> mouseTime);
    void setHint(const QString& text);
    QString hint() const;
    void applyColors(const QPalette& palette);
    void replot();
    /// The same plot in light colours.
    void paint(QPainter& painter, const QRect& place);
    /// Time at a position of the widget [s]; nothing outside the axes.
    std::optional<double> timeAt(double x, double y) const;

  private:
    void setColors(const QColor& text, const QColor& background, const QColor& grid);

    QCustomPlot* plot_;
    QCPItemStraightLine* shown_;
    QCPItemStraightLine* mouse_;
    QCPItemText* hint_;
    ShownQuantity quantity_;
    std::vector<int> columns_;  ///< channel of every wheel's curve
    QColor text_, background_, grid_;
};

}  // namespace widgets
