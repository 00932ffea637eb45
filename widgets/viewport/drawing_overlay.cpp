#include "widgets/viewport/drawing_overlay.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/viewport/viewport.h"

namespace widgets {
namespace {

constexpr double kRulerPerLine = 1.45;  ///< breadth of a ruler for the height of text
constexpr double kSmallestGap = 64.0;   ///< between numbered ticks [px]
constexpr double kHandle = 5.5;         ///< radius [px]

/// The smallest of 1, 2, 5 times a power of ten that is not smaller [m].
double roundStep(double atLeast) {
    const double decade = std::pow(10.0, std::floor(std::log10(atLeast)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * decade >= atLeast) {
            return step * decade;
        }
    }
    return 10.0 * decade;
}

QString millimetres(double value) {
    QString text = QString::number(std::round(1e6 * value) / 1e3, 'g', 8);
    return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

QColor shade(const QPalette& palette, QPalette::ColorRole role, float alpha) {
    QColor color = palette.color(role);
    color.setAlphaF(alpha);
    return color;
}

}  // namespace

DrawingOverlay::DrawingOverlay(Viewport* viewport) : QWidget(viewport), viewport_(viewport) {
    setObjectName("drawingOverlay");
    setAccessibleName(tr("Handles and dimensions"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setFocusPolicy(Qt::NoFocus);
}

void DrawingOverlay::setHandles(std::vector<HandleMark> handles) {
    handles_ = std::move(handles);
    update();
}

void DrawingOverlay::setDimensions(std::vector<DimensionLine> dimensions) {
    dimensions_ = std::move(dimensions);
    update();
}

void DrawingOverlay::setNote(const QString& text, const render::Vec3& place, bool refused) {
    note_ = text;
    notePlace_ = place;
    refused_ = refused;
    update();
}

void DrawingOverlay::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Projection projection = viewport_->projection();
    if (projection.isToScale()) {
        paintRulers(painter, projection);
        paintDimensions(painter, projection);
    }
    paintHandles(painter, projection);
    paintNote(painter, projection);
}

void DrawingOverlay::paintRulers(QPainter& painter, const Projection& projection) const {
    static constexpr std::array kAxes{"x", "y", "z"};
    const auto axisOf = [](const render::Vec3& direction) {
        Eigen::Index axis = 0;
        direction.cwiseAbs().maxCoeff(&axis);
        return static_cast<int>(axis);
    };
    const int across = axisOf(projection.right());
    const int upward = axisOf(projection.up());
    const double step = roundStep(kSmallestGap * projection.pixelSize());
    const int ruler = static_cast<int>(kRulerPerLine * fontMetrics().height());
    const QColor paper = shade(palette(), QPalette::Window, 0.86F);
    const QColor ink = palette().color(QPalette::Text);
    QFont face = font();
    face.setPointSizeF(0.8 * face.pointSizeF());
    painter.setFont(face);
    painter.fillRect(QRect(0, height() - ruler, width(), ruler), paper);
    painter.fillRect(QRect(0, 0, ruler, height() - ruler), paper);
    painter.setPen(ink);

    // Values of an axis at the two ends of the picture.
    const auto valueAt = [&](const QPointF& pixel, int axis) {
        return projection.rayThrough(pixel).start[axis];
    };
    const auto ticks = [&](double from, double to, auto&& draw) {
        const auto [low, high] = std::minmax(from, to);
        constexpr int kParts = 5;
        const double fine = step / kParts;
        for (double k = std::ceil(low / fine); k <= std::floor(high / fine); k += 1.0) {
            draw(k * fine, static_cast<long>(k) % kParts == 0);
        }
    };
    const double left = valueAt(QPointF(ruler, 0), across);
    const double right = valueAt(QPointF(width(), 0), across);
    ticks(left, right, [&](double value, bool numbered) {
        const double x = ruler + (value - left) / (right - left) * (width() - ruler);
        painter.drawLine(QPointF(x, height() - ruler),
                         QPointF(x, height() - ruler + (numbered ? 7 : 4)));
        if (numbered) {
            painter.drawText(QRectF(x - 40, height() - ruler + 6, 80, ruler - 6), Qt::AlignCenter,
                             millimetres(value));
        }
    });
    const double top = valueAt(QPointF(0, 0), upward);
    const double bottom = valueAt(QPointF(0, height() - ruler), upward);
    ticks(top, bottom, [&](double value, bool numbered) {
        const double y = (value - top) / (bottom - top) * (height() - ruler);
        painter.drawLine(QPointF(ruler, y), QPointF(ruler - (numbered ? 7 : 4), y));
        if (numbered) {
            painter.save();
            painter.translate(0.4 * ruler, y);
            painter.rotate(-90.0);
            painter.drawText(QRectF(-40, -8, 80, 16), Qt::AlignCenter, millimetres(value));
            painter.restore();
        }
    });
    painter.fillRect(QRect(0, height() - ruler, ruler, ruler), paper);
    painter.drawText(QRectF(0, height() - ruler, ruler, ruler), Qt::AlignCenter,
                     QString("%1%2").arg(kAxes.at(static_cast<std::size_t>(across)),
                                         kAxes.at(static_cast<std::size_t>(upward))));
    painter.drawText(QRectF(width() - 40, height() - ruler - 16, 36, 16),
                     Qt::AlignRight | Qt::AlignVCenter, tr("mm"));
}

void DrawingOverlay::paintDimensions(QPainter& painter, const Projection& projection) const {
    constexpr double kAway = 26.0;  // from what is measured [px]
    for (const DimensionLine& line : dimensions_) {
        const auto a = projection.toPixel(line.from);
        const auto b = projection.toPixel(line.to);
        constexpr double kShortest =
            24.0;  // seen from its end, a length has no room for its number
        if (!a || !b || (*a - *b).manhattanLength() < kShortest) {
            continue;
        }
        const bool vertical = std::abs(a->y() - b->y()) > std::abs(a->x() - b->x());
        const QPointF away = vertical ? QPointF(-kAway, 0.0) : QPointF(0.0, kAway);
        const double level =
            vertical ? std::min(a->x(), b->x()) + away.x() : std::max(a->y(), b->y()) + away.y();
        const QPointF from = vertical ? QPointF(level, a->y()) : QPointF(a->x(), level);
        const QPointF to = vertical ? QPointF(level, b->y()) : QPointF(b->x(), level);
        painter.setPen(QPen(shade(palette(), QPalette::Text, 0.75F), 1.0));
        painter.drawLine(*a, from);
        painter.drawLine(*b, to);
        painter.drawLine(from, to);
        for (const auto& [tip, other] : {std::pair(from, to), std::pair(to, from)}) {
            const QPointF way =
                (other - tip) / std::max(1.0, std::hypot((other - tip).x(), (other - tip).y()));
            const QPointF side(-way.y(), way.x());
            painter.drawLine(tip, tip + 8.0 * way + 3.0 * side);
            painter.drawLine(tip, tip + 8.0 * way - 3.0 * side);
        }
        const QRectF box =
            QRectF(painter.fontMetrics().boundingRect(line.text)).adjusted(-5, -2, 5, 2);
        QRectF label(QPointF(), box.size());
        label.moveCenter(0.5 * (from + to));
        painter.setPen(Qt::NoPen);
        painter.setBrush(shade(palette(), QPalette::Window, 0.86F));
        painter.drawRoundedRect(label, 3, 3);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(label, Qt::AlignCenter, line.text);
    }
}

void DrawingOverlay::paintHandles(QPainter& painter, const Projection& projection) const {
    const QColor accent = palette().color(QPalette::Highlight);
    for (const HandleMark& handle : handles_) {
        const auto at = projection.toPixel(handle.position);
        if (!at) {
            continue;
        }
        const double size = handle.hot ? 1.45 * kHandle : kHandle;
        painter.setPen(QPen(Qt::black, 1.2));
        painter.setBrush(handle.hot ? accent : QColor(255, 255, 255, 225));
        switch (handle.shape) {
            case HandleMark::Shape::CenterOfMass: {
                const QRectF disc(at->x() - 1.5 * size, at->y() - 1.5 * size, 3.0 * size,
                                  3.0 * size);
                painter.drawEllipse(disc);
                painter.setBrush(Qt::black);
                painter.drawPie(disc, 0, 90 * 16);
                painter.drawPie(disc, 180 * 16, 90 * 16);
                break;
            }
            case HandleMark::Shape::Round:
                painter.drawEllipse(*at, size, size);
                break;
            case HandleMark::Shape::Ring:
                painter.drawEllipse(*at, 1.25 * size, 1.25 * size);
                painter.drawEllipse(*at, 0.5 * size, 0.5 * size);
                break;
            case HandleMark::Shape::Square:
                painter.drawRect(QRectF(at->x() - size, at->y() - size, 2.0 * size, 2.0 * size));
                break;
            case HandleMark::Shape::Dot:
                painter.drawEllipse(*at, 0.65 * size, 0.65 * size);
                break;
        }
    }
}

void DrawingOverlay::paintNote(QPainter& painter, const Projection& projection) const {
    const auto at = projection.toPixel(notePlace_);
    if (note_.isEmpty() || !at) {
        return;
    }
    constexpr int kMargin = 6;
    QRectF box = painter.fontMetrics().boundingRect(QRect(0, 0, 420, 400), Qt::TextWordWrap, note_);
    box.adjust(-kMargin, -kMargin, kMargin, kMargin);
    box.moveTopLeft(*at + QPointF(16.0, -16.0 - box.height()));
    // Beside the place, but within the picture.
    box.moveLeft(std::clamp(box.left(), 4.0, std::max(4.0, width() - box.width() - 4.0)));
    box.moveTop(std::clamp(box.top(), 4.0, std::max(4.0, height() - box.height() - 4.0)));
    painter.setPen(QPen(refused_ ? QColor(0xc0, 0x40, 0x30) : palette().color(QPalette::Mid), 1.0));
    painter.setBrush(shade(palette(), QPalette::Window, 0.94F));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(box.adjusted(kMargin, kMargin, -kMargin, -kMargin), Qt::TextWordWrap, note_);
}

}  // namespace widgets
