#include "widgets/plots/wheel_plot.h"

#include <qcustomplot.h>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "widgets/plots/channel_titles.h"
#include "widgets/plots/plot_font.h"

namespace widgets {
namespace {

/// Numbers with a minus sign, as everywhere else in the window.
class SignedTicker final : public QCPAxisTicker {
  protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
        const QString text = QCPAxisTicker::getTickLabel(tick, locale, format, precision);
        return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
    }
};

/// Points whose least and largest value are kept, so that a range need not look at each.
constexpr int kBlock = 128;
constexpr double kEmpty = std::numeric_limits<double>::infinity();
constexpr double kMarkSize = 7.0;  ///< [pixel]
constexpr double kMarkGap = 16.0;  ///< from one wheel's mark to the next one's [pixel]
constexpr int kMarksInWindow = 5;  ///< a curve has about so many

/// 1, 2 or 5 times a power of ten, not less than `least`.
double roundStep(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) {
            return factor * power;
        }
    }
    return 10.0 * power;
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
    plot_->yAxis->setTicker(QSharedPointer<SignedTicker>::create());
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
    curves_.clear();
    marks_.clear();
    signs_ = quantity.ofChassis ? std::vector<WheelMark>{} : wheelMarks(wheels);
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
            graph->setPen(QPen(quantity.ofChassis ? text_ : wheelCurveColor(static_cast<int>(i)),
                               1.0, lineStyle(run.style)));
            graph->setName(QString::fromStdString(objects[i]));
            graph->setAdaptiveSampling(true);
            curves_.push_back(graph);
        }
    }
    for (std::size_t i = 0; !quantity.ofChassis && i < curves_.size(); ++i) {
        QCPGraph* graph = plot_->addGraph();
        graph->setName(curves_[i]->name());
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setAdaptiveSampling(false);
        marks_.push_back(graph);
    }
    colorMarks(background_);
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
        const auto data = curves_.at(i)->data();
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

std::pair<double, double> WheelPlot::valuesIn(std::size_t curve, double from, double to) const {
    const auto data = curves_.at(curve)->data();
    const auto begin = data->findBegin(from, false);
    const auto end = data->findEnd(to, false);
    double least = kEmpty, most = -kEmpty;
    const auto& blocks = blocks_.at(curve);
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
        curves_.at(i)->data()->clear();
        blocks_.at(i).clear();
        if (!marks_.empty()) {
            marks_.at(i)->data()->clear();
        }
    }
}

void WheelPlot::setWheelShown(int wheel, bool shown) {
    if (quantity_.ofChassis) {
        return;
    }
    for (std::size_t i = static_cast<std::size_t>(wheel); i < curves_.size(); i += objects_) {
        curves_[i]->setVisible(shown);
        marks_.at(i)->setVisible(shown);
    }
}

void WheelPlot::setWindow(double from, double to) {
    constexpr int kLinesPerTick = 4;
    constexpr int kMostTicks = 6;
    plot_->xAxis->ticker()->setTickCount(
        std::clamp(plot_->axisRect()->width() / (kLinesPerTick * plot_->fontMetrics().height()), 2,
                   kMostTicks));
    plot_->xAxis->setRange(from, to);
    bool any = false;
    QCPRange range;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
        if (!curves_[i]->visible()) {
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
    placeMarks(from, to);
}

/// At fixed instants, so that marks stay on their curves as the window moves on, and at others for
/// every curve, so that they do not cover one another where curves run together.
void WheelPlot::placeMarks(double from, double to) {
    // Not so many that those of all wheels are a band in a narrow plot.
    const double width = std::max(plot_->axisRect()->width(), 1);
    const double room = kMarkGap * static_cast<double>(objects_) / width;
    const double step = roundStep((to - from) * std::max(1.0 / kMarksInWindow, room));
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const auto data = curves_[i]->data();
        auto marks = marks_[i]->data();
        marks->clear();
        if (data->isEmpty()) {
            continue;
        }
        const double last = std::prev(data->constEnd())->key;
        const double shift =
            step * (static_cast<double>(i % objects_) + 0.5) / static_cast<double>(objects_);
        for (double k = std::ceil((from - shift) / step); k * step + shift <= std::min(to, last);
             k += 1.0) {
            const auto point = data->findBegin(k * step + shift, false);
            if (point != data->constEnd() && std::isfinite(point->value)) {
                marks->add(*point);
            }
        }
    }
}

void WheelPlot::colorMarks(const QColor& paper) {
    for (std::size_t i = 0; i < marks_.size(); ++i) {
        const WheelMark& sign = signs_.at(i % objects_);
        const QColor color = wheelCurveColor(static_cast<int>(i % objects_));
        marks_[i]->setScatterStyle(QCPScatterStyle(markOutline(sign.shape, kMarkSize),
                                                   QPen(color, 1.2), sign.hollow ? paper : color,
                                                   kMarkSize));
    }
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
    colorMarks(background_);
    shown_->setPen(QPen(palette.color(QPalette::Highlight), 1.0));
    QColor mouse = palette.color(QPalette::Text);
    mouse.setAlphaF(0.6F);
    mouse_->setPen(QPen(mouse, 1.0, Qt::DashLine));
    reference_->setPen(QPen(palette.color(QPalette::Highlight), 1.0, Qt::DashLine));
    hint_->setColor(palette.color(QPalette::PlaceholderText));
}

void WheelPlot::applyFont(const QFont& font) {
    setPlotFont(*plot_, font);
    hint_->setFont(font);
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
    for (QCPGraph* curve : curves_) {
        if (quantity_.ofChassis) {
            QPen pen = curve->pen();
            pen.setColor(color);
            curve->setPen(pen);
        }
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
    colorMarks(Qt::white);
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
    colorMarks(background_);
}

std::optional<double> WheelPlot::timeAt(double x, double y) const {
    if (!plot_->axisRect()->rect().contains(QPoint(static_cast<int>(x), static_cast<int>(y)))) {
        return std::nullopt;
    }
    return plot_->xAxis->pixelToCoord(x);
}

}  // namespace widgets
