#include "widgets/plots/wheel_plot.h"

#include <qcustomplot.h>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/palette.h"
#include "widgets/plots/channel_titles.h"

namespace widgets {
namespace {

/// Points whose least and largest value are kept, so that a range need not look at each.
constexpr int kBlock = 128;
constexpr double kEmpty = std::numeric_limits<double>::infinity();

QColor colorOf(int wheel) {
    const render::Rgb color = render::wheelColor(wheel);
    return {color.r, color.g, color.b};
}

}  // namespace

QString prettyUnit(const QString& unit) {
    return QString(unit).replace('*', QChar(0x00B7));
}

Qt::PenStyle lineStyle(int style) {
    constexpr std::array kStyles{Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine,
                                 Qt::DashDotDotLine};
    return kStyles.at(static_cast<std::size_t>(style) % kStyles.size());
}

QPixmap lineSample(int style, const QColor& color) {
    constexpr int kWidth = 30;
    constexpr int kHeight = 12;
    constexpr double kScale = 2.0;
    QPixmap pixmap(QSize(kWidth, kHeight) * kScale);
    pixmap.setDevicePixelRatio(kScale);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setPen(QPen(color, 1.5, lineStyle(style)));
    painter.drawLine(QPointF(0.0, 0.5 * kHeight), QPointF(kWidth, 0.5 * kHeight));
    return pixmap;
}

namespace {

void addQuantities(const std::vector<simcore::run::Channel>& channels,
                   simcore::run::ChannelGroup group, std::vector<ShownQuantity>& quantities) {
    for (const simcore::run::Channel& channel : channels) {
        if (channel.group != group) {
            continue;
        }
        const QString name = QString::fromStdString(channel.quantity);
        const bool known = std::any_of(quantities.begin(), quantities.end(),
                                       [&](const auto& q) { return q.quantity == name; });
        if (known) {
            continue;
        }
        ShownQuantity shown{name, channelTitle(channel.label), QString::fromStdString(channel.unit),
                            1.0, group == simcore::run::ChannelGroup::Chassis};
        if (shown.unit == "rad") {
            shown.unit = "deg";
            shown.factor = 180.0 / std::numbers::pi;
        }
        quantities.push_back(shown);
    }
}

}  // namespace

std::vector<ShownQuantity> quantitiesIn(const std::vector<simcore::run::Channel>& channels) {
    std::vector<ShownQuantity> quantities;
    addQuantities(channels, simcore::run::ChannelGroup::Wheel, quantities);
    addQuantities(channels, simcore::run::ChannelGroup::Chassis, quantities);
    return quantities;
}

WheelPlot::WheelPlot(QWidget* parent)
    : plot_(new QCustomPlot(parent)),
      shown_(new QCPItemStraightLine(plot_)),
      mouse_(new QCPItemStraightLine(plot_)),
      reference_(new QCPItemStraightLine(plot_)),
      hint_(new QCPItemText(plot_)) {
    plot_->setMinimumSize(200, 110);
    plot_->setLocale(QLocale::c());  // a decimal point, as everywhere
    plot_->setMouseTracking(true);
    plot_->setNoAntialiasingOnDrag(true);
    plot_->setPlottingHint(QCP::phFastPolylines);
    plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot_->axisRect()->setRangeDrag(Qt::Horizontal);
    plot_->axisRect()->setRangeZoom(Qt::Horizontal);
    plot_->axisRect()->setMinimumMargins(QMargins(48, 6, 8, 20));
    plot_->xAxis->setLabel(QObject::tr("time [s]"));
    plot_->xAxis->setLabelPadding(1);
    plot_->yAxis->setLabelPadding(3);
    plot_->yAxis->ticker()->setTickCount(4);
    plot_->yAxis->setNumberPrecision(4);
    plot_->yAxis->setNumberFormat("gb");
    for (QCPItemStraightLine* line : {shown_, mouse_, reference_}) {
        line->point1->setCoords(0.0, 0.0);
        line->point2->setCoords(0.0, 1.0);
    }
    mouse_->setVisible(false);
    reference_->setVisible(false);
    hint_->position->setType(QCPItemPosition::ptAxisRectRatio);
    hint_->position->setCoords(0.5, 0.5);
    hint_->setPositionAlignment(Qt::AlignCenter);
    setWindow(0.0, 10.0);
}

void WheelPlot::start(const ShownQuantity& quantity, const std::vector<std::string>& wheels,
                      const std::vector<PlottedRun>& runs) {
    quantity_ = quantity;
    plot_->clearGraphs();
    columns_.clear();
    blocks_.clear();
    const std::vector<std::string> objects =
        quantity.ofChassis ? std::vector<std::string>{"chassis"} : wheels;
    objects_ = objects.size();
    for (const PlottedRun& run : runs) {
        for (std::size_t i = 0; i < objects.size(); ++i) {
            columns_.push_back(simcore::run::findChannel(
                *run.channels, quantity.quantity.toStdString(), objects[i]));
            blocks_.emplace_back();
            QCPGraph* graph = plot_->addGraph();
            // One pixel: wider antialiased lines are drawn many times slower.
            graph->setPen(QPen(quantity.ofChassis ? text_ : colorOf(static_cast<int>(i)), 1.0,
                               lineStyle(run.style)));
            graph->setName(QString::fromStdString(objects[i]));
            graph->setAdaptiveSampling(true);
        }
    }
    plot_->yAxis->setLabel(quantity.unit == "-" ? QString() : prettyUnit(quantity.unit));
    plot_->setAccessibleName(QObject::tr("%1 over time").arg(quantity.label));
}

void WheelPlot::append(std::size_t run, const simcore::run::Recording& recording,
                       std::size_t first) {
    for (std::size_t i = run * objects_; i < (run + 1) * objects_; ++i) {
        if (columns_.at(i) < 0) {
            continue;
        }
        const auto column = static_cast<std::size_t>(columns_[i]);
        const auto data = plot_->graph(static_cast<int>(i))->data();
        for (std::size_t row = first; row < recording.rows.size(); ++row) {
            const double value = recording.rows[row][column] * quantity_.factor;
            if (data->size() % kBlock == 0) {
                blocks_.at(i).emplace_back(kEmpty, -kEmpty);
            }
            // Appended in the order of time, so the container sorts nothing.
            data->add(QCPGraphData(recording.rows[row][0], value));
            auto& [least, most] = blocks_[i].back();
            least = std::fmin(least, value);  // passes over what is missing
            most = std::fmax(most, value);
        }
    }
}

std::pair<double, double> WheelPlot::valuesIn(int graph, double from, double to) const {
    const auto data = plot_->graph(graph)->data();
    const auto begin = data->findBegin(from, false);
    const auto end = data->findEnd(to, false);
    double least = kEmpty, most = -kEmpty;
    const auto& blocks = blocks_.at(static_cast<std::size_t>(graph));
    for (auto point = begin; point < end;) {
        const int at = static_cast<int>(point - data->constBegin());
        if (at % kBlock == 0 && end - point >= kBlock) {
            const auto& [low, high] = blocks[static_cast<std::size_t>(at / kBlock)];
            least = std::min(least, low);
            most = std::max(most, high);
            point += kBlock;
        } else {
            least = std::fmin(least, point->value);
            most = std::fmax(most, point->value);
            ++point;
        }
    }
    return {least, most};
}

void WheelPlot::clearData(std::size_t run) {
    for (std::size_t i = run * objects_; i < (run + 1) * objects_; ++i) {
        plot_->graph(static_cast<int>(i))->data()->clear();
        blocks_[i].clear();
    }
}

void WheelPlot::setWheelShown(int wheel, bool shown) {
    if (quantity_.ofChassis) {
        return;
    }
    for (int i = wheel; i < plot_->graphCount(); i += static_cast<int>(objects_)) {
        plot_->graph(i)->setVisible(shown);
    }
}

void WheelPlot::setWindow(double from, double to) {
    plot_->xAxis->setRange(from, to);
    bool any = false;
    QCPRange range;
    for (int i = 0; i < plot_->graphCount(); ++i) {
        if (!plot_->graph(i)->visible()) {
            continue;
        }
        const auto [least, most] = valuesIn(i, from, to);
        if (least <= most) {
            const QCPRange one(least, most);
            range = any ? range.expanded(one) : one;
            any = true;
        }
    }
    if (!any) {
        range = QCPRange(0.0, 1.0);
    }
    // Zero is always to be seen: a magnified flat line would look like an event.
    range.expand(0.0);
    const double smallest = quantity_.unit == "m" ? 0.01 : 0.5;
    if (range.size() < smallest) {
        range.upper = range.lower + smallest;
    }
    const double margin = 0.06 * range.size();
    plot_->yAxis->setRange(range.lower < 0.0 ? range.lower - margin : -0.5 * margin,
                           range.upper + margin);
}

void WheelPlot::setMarks(double shownTime, std::optional<double> mouseTime,
                         std::optional<double> reference) {
    const auto place = [](QCPItemStraightLine* line, double time) {
        line->point1->setCoords(time, 0.0);
        line->point2->setCoords(time, 1.0);
    };
    place(shown_, shownTime);
    place(mouse_, mouseTime.value_or(0.0));
    mouse_->setVisible(mouseTime.has_value());
    place(reference_, reference.value_or(0.0));
    reference_->setVisible(reference.has_value());
}

QString WheelPlot::hint() const {
    return hint_->visible() ? hint_->text() : QString();
}

void WheelPlot::setHint(const QString& text) {
    hint_->setText(text);
    hint_->setVisible(!text.isEmpty());
    shown_->setVisible(text.isEmpty());
}

void WheelPlot::applyColors(const QPalette& palette) {
    text_ = palette.color(QPalette::Text);
    background_ = palette.color(QPalette::Base);
    grid_ = text_;
    grid_.setAlphaF(0.14F);
    setColors(text_, background_, grid_);
    colorChassisCurves(text_);
    shown_->setPen(QPen(palette.color(QPalette::Highlight), 1.0));
    QColor mouse = palette.color(QPalette::Text);
    mouse.setAlphaF(0.6F);
    mouse_->setPen(QPen(mouse, 1.0, Qt::DashLine));
    reference_->setPen(QPen(palette.color(QPalette::Highlight), 1.0, Qt::DashLine));
    hint_->setColor(palette.color(QPalette::PlaceholderText));
}

void WheelPlot::setColors(const QColor& text, const QColor& background, const QColor& grid) {
    plot_->setBackground(background);
    QColor axis = text;
    axis.setAlphaF(0.5F);
    for (QCPAxis* one : {plot_->xAxis, plot_->yAxis}) {
        one->setTickLabelColor(text);
        one->setLabelColor(text);
        one->setBasePen(QPen(axis));
        one->setTickPen(QPen(axis));
        one->setSubTickPen(QPen(Qt::NoPen));
        one->grid()->setPen(QPen(grid));
        one->grid()->setZeroLinePen(QPen(axis));
    }
}

void WheelPlot::colorChassisCurves(const QColor& color) {
    for (int i = 0; quantity_.ofChassis && i < plot_->graphCount(); ++i) {
        QPen pen = plot_->graph(i)->pen();
        pen.setColor(color);
        plot_->graph(i)->setPen(pen);
    }
}

void WheelPlot::replot() {
    plot_->replot(QCustomPlot::rpQueuedReplot);
}

void WheelPlot::paint(QPainter& painter, const QRect& place) {
    const bool marks = shown_->visible();
    const bool mouse = mouse_->visible();
    const bool reference = reference_->visible();
    setColors(Qt::black, Qt::white, QColor(0, 0, 0, 36));
    colorChassisCurves(Qt::black);
    shown_->setVisible(false);
    mouse_->setVisible(false);
    reference_->setVisible(false);
    // Two steps, for QCustomPlot paints from the origin in whatever device it is given.
    QPicture picture;
    QCPPainter recorder(&picture);
    plot_->toPainter(&recorder, place.width(), place.height());
    recorder.end();
    painter.drawPicture(place.topLeft(), picture);
    shown_->setVisible(marks);
    mouse_->setVisible(mouse);
    reference_->setVisible(reference);
    setColors(text_, background_, grid_);
    colorChassisCurves(text_);
}

std::optional<double> WheelPlot::timeAt(double x, double y) const {
    if (!plot_->axisRect()->rect().contains(QPoint(static_cast<int>(x), static_cast<int>(y)))) {
        return std::nullopt;
    }
    return plot_->xAxis->pixelToCoord(x);
}

}  // namespace widgets
