#include "widgets/window/icons.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

namespace widgets {
namespace {

/// An arrow that turns back to the left, in a square of 24 units.
void drawTurnBack(QPainter& painter) {
    QPainterPath path;
    path.moveTo(5, 9);
    path.lineTo(14, 9);
    path.cubicTo(21, 9, 21, 18.5, 14, 18.5);
    path.lineTo(9, 18.5);
    painter.drawPath(path);
    painter.drawPolyline(QPolygonF{{{9.5, 4.5}, {5, 9}, {9.5, 13.5}}});
}

/// An arrow to the left.
void drawBack(QPainter& painter) {
    painter.drawLine(QPointF(20, 12), QPointF(4.5, 12));
    painter.drawPolyline(QPolygonF{{{11, 5.5}, {4.5, 12}, {11, 18.5}}});
}

void draw(Icon icon, QPainter& painter) {
    switch (icon) {
        case Icon::New:
            painter.drawPolygon(QPolygonF{{{6, 3}, {14, 3}, {18, 7}, {18, 21}, {6, 21}}});
            painter.drawPolyline(QPolygonF{{{14, 3}, {14, 7}, {18, 7}}});
            break;
        case Icon::Open:
            painter.drawPolyline(QPolygonF{{{3, 19}, {3, 5}, {9, 5}, {11, 8}, {18, 8}, {18, 11}}});
            painter.drawPolygon(QPolygonF{{{3, 19}, {7, 11}, {22, 11}, {18, 19}}});
            break;
        case Icon::Save:
            painter.drawPolygon(QPolygonF{{{4, 4}, {17, 4}, {20, 7}, {20, 20}, {4, 20}}});
            painter.drawRect(QRectF(8, 4, 7, 5));
            painter.drawRect(QRectF(7.5, 13, 9, 7));
            break;
        case Icon::Undo:
            drawTurnBack(painter);
            break;
        case Icon::Back:
            drawBack(painter);
            break;
        case Icon::Forward:
            painter.translate(24, 0);
            painter.scale(-1, 1);
            drawBack(painter);
            break;
        case Icon::Redo:
            painter.translate(24, 0);
            painter.scale(-1, 1);
            drawTurnBack(painter);
            break;
    }
}

}  // namespace

QIcon lineIcon(Icon icon, const QPalette& palette) {
    QIcon result;
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Disabled}) {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        for (const int size : {16, 20, 24, 32, 48}) {
            QPixmap pixmap(size, size);
            pixmap.fill(Qt::transparent);
            QPainter painter(&pixmap);
            painter.setRenderHint(QPainter::Antialiasing);
            painter.scale(size / 24.0, size / 24.0);
            painter.setPen(QPen(palette.color(group, QPalette::ButtonText), 1.7, Qt::SolidLine,
                                Qt::RoundCap, Qt::RoundJoin));
            draw(icon, painter);
            painter.end();
            result.addPixmap(pixmap, mode);
        }
    }
    return result;
}

}  // namespace widgets
