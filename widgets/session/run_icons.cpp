#include "widgets/session/run_icons.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

namespace widgets {
namespace {

/// The symbol in a square of 24 units.
void draw(RunIcon icon, QPainter& painter, const QColor& color) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    switch (icon) {
        case RunIcon::Play:
            painter.drawPolygon(QPolygonF{{{7, 4}, {20, 12}, {7, 20}}});
            break;
        case RunIcon::Pause:
            painter.drawRoundedRect(QRectF(6, 4, 4.5, 16), 1, 1);
            painter.drawRoundedRect(QRectF(13.5, 4, 4.5, 16), 1, 1);
            break;
        case RunIcon::Step:
            painter.drawRoundedRect(QRectF(5, 4, 3.5, 16), 1, 1);
            painter.drawPolygon(QPolygonF{{{10.5, 4.5}, {21, 12}, {10.5, 19.5}}});
            break;
        case RunIcon::Reset: {
            // An arrow that goes round anticlockwise: back to the start.
            QPainterPath arc;
            arc.arcMoveTo(QRectF(4.5, 5, 15, 15), 130);
            arc.arcTo(QRectF(4.5, 5, 15, 15), 130, 300);
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(color, 2.4, Qt::SolidLine, Qt::FlatCap));
            painter.drawPath(arc);
            painter.setPen(Qt::NoPen);
            painter.setBrush(color);
            painter.drawPolygon(QPolygonF{{{3.5, 2.5}, {3.5, 10.5}, {11.5, 9}}});
            break;
        }
    }
}

}  // namespace

QIcon runIcon(RunIcon icon, const QPalette& palette) {
    QIcon result;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Disabled}) {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        for (const int size : {16, 20, 24, 32, 48}) {
            QPixmap pixmap(size, size);
            pixmap.fill(Qt::transparent);
            QPainter painter(&pixmap);
            painter.setRenderHint(QPainter::Antialiasing);
            painter.scale(size / 24.0, size / 24.0);
            draw(icon, painter, palette.color(group, QPalette::ButtonText));
            painter.end();
            result.addPixmap(pixmap, mode);
        }
    }
    return result;
}

}  // namespace widgets
