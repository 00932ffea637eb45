#include "widgets/plots/way_plot.h"

#include <qcustomplot.h>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/plots/plot_font.h"

namespace widgets {
namespace {

/// What asks for more is drawn cut off.
constexpr double kMostShown = 2.0;
/// A pointer this near to an event names it [px].
constexpr double kEventReach_px = 5.0;

}  // namespace

WayPlot::WayPlot(QWidget* parent)
    : QWidget(parent),
      plot_(new QCustomPlot(this)),
      falls_(plot_->addGraph()),
      climbs_(plot_->addGraph()),
      unheld_(plot_->addGraph()),
      marks_(plot_->addGraph()),
      ground_(new QCPItemStraightLine(plot_)),
      cursor_(new QCPItemStraightLine(plot_)) {
    plot_->setLocale(QLocale::c());  // a decimal point, as everywhere
    plot_->setFocusPolicy(Qt::NoFocus);
    plot_->setAccessibleName(tr("Required friction over the way"));
    plot_->axisRect()->setMinimumMargins(QMargins(44, 5, 10, 18));
    plot_->yAxis->setLabel(tr("μ*"));
    plot_->yAxis->setLabelPadding(3);
    plot_->yAxis->ticker()->setTickCount(4);
    marks_->setLineStyle(QCPGraph::lsNone);
    unheld_->setPen(Qt::NoPen);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(plot_);
    connect(plot_, &QCustomPlot::mousePress, this,
            [this](QMouseEvent* event) { onMouse(event, true); });
    connect(plot_, &QCustomPlot::mouseMove, this,
            [this](QMouseEvent* event) { onMouse(event, event->buttons() & Qt::LeftButton); });
    applyColors();
    applyFont();
}

void WayPlot::show(const std::vector<Point>& points, double ground) {
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    points_ = points;
    double most = ground;
    for (const Point& point : points) {
        if (point.held) {
            most = std::max(most, std::min(point.friction, kMostShown));
        }
    }
    const double top = 1.12 * std::max(most, 0.1);
    for (QCPGraph* graph : {falls_, climbs_, unheld_, marks_}) {
        graph->data()->clear();
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& point = points[i];
        const bool climbsNext = i + 1 < points.size() && points[i + 1].climbs;
        falls_->addData(point.way, point.held ? point.friction : kGap);
        climbs_->addData(point.way,
                         point.held && (point.climbs || climbsNext) ? point.friction : kGap);
        unheld_->addData(point.way, point.held ? kGap : top);
        if (!point.events.isEmpty()) {
            marks_->addData(point.way, 0.05 * top);
        }
    }
    ground_->point1->setCoords(0.0, ground);
    ground_->point2->setCoords(1.0, ground);
    plot_->xAxis->setRange(points.empty() ? 0.0 : points.front().way,
                           points.empty() ? 1.0 : std::max(points.back().way, 1e-3));
    plot_->yAxis->setRange(0.0, top);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void WayPlot::setCursor(double way) {
    cursor_->point1->setCoords(way, 0.0);
    cursor_->point2->setCoords(way, 1.0);
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void WayPlot::setCurrent(bool of) {
    if (current_ != of) {
        current_ = of;
        applyColors();
    }
}

void WayPlot::onMouse(const QMouseEvent* event, bool pressed) {
    if (!plot_->axisRect()->rect().contains(event->pos())) {
        return;
    }
    if (pressed) {
        emit wayChosen(plot_->xAxis->pixelToCoord(event->position().x()));
    } else {
        showEvents(event);
    }
}

void WayPlot::showEvents(const QMouseEvent* event) {
    QStringList near;
    for (const Point& point : points_) {
        const double away = plot_->xAxis->coordToPixel(point.way) - event->position().x();
        if (!point.events.isEmpty() && std::abs(away) < kEventReach_px) {
            near << point.events;
        }
    }
    QToolTip::showText(event->globalPosition().toPoint(), near.join('\n'), plot_);
}

void WayPlot::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        applyColors();
    } else if (event->type() == QEvent::FontChange) {
        applyFont();
    }
    QWidget::changeEvent(event);
}

void WayPlot::applyFont() {
    constexpr int kLines = 5;
    setMinimumHeight(kLines * fontMetrics().height() + 7);
    setPlotFont(*plot_, font());
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void WayPlot::applyColors() {
    const auto faded = [](QColor color, float alpha) {
        color.setAlphaF(alpha);
        return color;
    };
    const QColor text = palette().color(QPalette::Text);
    const QColor curve =
        current_ ? palette().color(QPalette::Highlight) : palette().color(QPalette::Mid);
    plot_->setBackground(palette().color(QPalette::Base));
    for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
        axis->setTickLabelColor(text);
        axis->setLabelColor(text);
        axis->setBasePen(faded(text, 0.5F));
        axis->setTickPen(faded(text, 0.5F));
        axis->setSubTickPen(QPen(Qt::NoPen));
        axis->grid()->setPen(faded(text, 0.14F));
        axis->grid()->setZeroLinePen(faded(text, 0.5F));
    }
    falls_->setPen(QPen(faded(curve, 0.45F), 1.0));
    climbs_->setPen(QPen(curve, 2.0));
    unheld_->setBrush(QBrush(text, Qt::BDiagPattern));
    marks_->setPen(QPen(text, 1.0));
    marks_->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangle, text, text, 5));
    ground_->setPen(QPen(text, 1.0, Qt::DashLine));
    cursor_->setPen(QPen(faded(text, 0.75F), 1.0));
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace widgets
