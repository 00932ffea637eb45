#include "widgets/plots/wheel_marks.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "render/palette.h"

namespace widgets {
namespace {

constexpr double kMarkSize = 8.0;
constexpr int kHeight = 14;  ///< of a sample [pixel]

QPixmap emptySample(int width) {
    constexpr double kScale = 2.0;  // sharp on dense screens, too
    QPixmap pixmap(QSize(width, kHeight) * kScale);
    pixmap.setDevicePixelRatio(kScale);
    pixmap.fill(Qt::transparent);
    return pixmap;
}

/// A regular polygon, or a star when every second corner is nearer.
QPainterPath regular(int corners, double radius, double inner, double turn) {
    QPolygonF polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn + 2.0 * std::numbers::pi * i / corners;
        const double r = i % 2 == 0 ? radius : inner;
        polygon << QPointF(r * std::sin(angle), -r * std::cos(angle));
    }
    polygon << polygon.front();
    QPainterPath path;
    path.addPolygon(polygon);
    return path;
}

}  // namespace

std::vector<WheelMark> wheelMarks(const std::vector<std::string>& names) {
    std::vector<std::string> kinds;
    std::vector<WheelMark> marks;
    for (const std::string& name : names) {
        std::string kind;
        bool right = false;
        std::istringstream words(name);
        for (std::string word; std::getline(words, word, '_');) {
            right = right || word == "right";
            kind += (word == "left" || word == "right" ? "*" : word) + "_";
        }
        auto found = std::find(kinds.begin(), kinds.end(), kind);
        if (found == kinds.end()) {
            found = kinds.insert(kinds.end(), kind);
        }
        marks.push_back({static_cast<int>(found - kinds.begin()), right});
    }
    return marks;
}

QPainterPath markOutline(int shape, double size) {
    const double r = 0.5 * size;
    constexpr double kPi = std::numbers::pi;
    switch (shape % 6) {
        case 0: {
            QPainterPath disc;
            disc.addEllipse(QPointF(0.0, 0.0), 0.9 * r, 0.9 * r);
            return disc;
        }
        case 1:
            return regular(4, 1.15 * r, 1.15 * r, kPi / 4.0);  // square
        case 2:
            return regular(3, 1.2 * r, 1.2 * r, 0.0);  // triangle
        case 3:
            return regular(4, 1.2 * r, 1.2 * r, 0.0);  // diamond
        case 4:
            return regular(3, 1.2 * r, 1.2 * r, kPi);  // triangle on its tip
        default:
            return regular(10, 1.3 * r, 0.55 * r, 0.0);  // star
    }
}

QColor wheelCurveColor(int wheel) {
    const render::Rgb color = render::wheelColor(wheel);
    return {color.r, color.g, color.b};
}

void paintWheelSample(QPainter& painter, const QPointF& place, double width, int wheel,
                      const WheelMark& mark, const QColor& paper) {
    const QColor color = wheelCurveColor(wheel);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(place, place + QPointF(width, 0.0));
    painter.translate(place + QPointF(0.5 * width, 0.0));
    painter.setBrush(mark.hollow ? paper : color);
    painter.drawPath(markOutline(mark.shape, kMarkSize));
    painter.restore();
}

QPixmap wheelSample(int wheel, const WheelMark& mark, const QColor& paper, int width) {
    QPixmap pixmap = emptySample(width);
    QPainter painter(&pixmap);
    paintWheelSample(painter, QPointF(0.0, 0.5 * kHeight), width, wheel, mark, paper);
    return pixmap;
}

QIcon wheelIcon(int wheel, const WheelMark& mark, const QColor& paper) {
    QIcon icon;
    icon.addPixmap(wheelSample(wheel, mark, paper, kWheelSampleWidth), QIcon::Normal, QIcon::On);
    QPixmap off = emptySample(kWheelSampleWidth);
    QPainter painter(&off);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(0.4);
    painter.translate(0.5 * kWheelSampleWidth, 0.5 * kHeight);
    painter.setPen(QPen(wheelCurveColor(wheel), 1.5));
    painter.drawPath(markOutline(mark.shape, kMarkSize));
    painter.end();
    icon.addPixmap(off, QIcon::Normal, QIcon::Off);
    return icon;
}

}  // namespace widgets
