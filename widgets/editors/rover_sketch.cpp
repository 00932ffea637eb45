#include "widgets/editors/rover_sketch.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace widgets {

using simcore::Vec3;
using simcore::mechanism::Body;
using simcore::mechanism::Joint;
using simcore::mechanism::Mechanism;
using simcore::mechanism::Shape;
using simcore::project::ShapeKind;

namespace {

/// The near half: right side and middle, so that pairs are not drawn twice.
bool isNear(double y) {
    return y < 1e-6;
}

struct Projection {
    double scale = 1.0;
    double left = 0.0;
    double bottom = 0.0;

    QPointF operator()(const Vec3& p) const {
        return {left + scale * p.x(), bottom - scale * p.z()};
    }
};

/// Fits everything into the area; x forward to the right, the ground at the bottom.
Projection fitted(const Mechanism& mechanism, const QRectF& area) {
    double low = 1e9;
    double high = -1e9;
    double top = 1e-3;
    const auto include = [&](const Vec3& p, double reach) {
        low = std::min(low, p.x() - reach);
        high = std::max(high, p.x() + reach);
        top = std::max(top, p.z() + reach);
    };
    for (const auto& wheel : mechanism.wheels) {
        include(wheel.center, wheel.radius);
    }
    for (const Body& body : mechanism.bodies) {
        for (const Shape& shape : body.shapes) {
            if (shape.kind == ShapeKind::Box || shape.kind == ShapeKind::Sphere) {
                include(shape.center,
                        shape.kind == ShapeKind::Box ? shape.size.x() / 2.0 : shape.radius);
            } else {
                include(shape.from, 0.0);
                include(shape.to, 0.0);
            }
        }
    }
    Projection projection;
    projection.scale = std::min(area.width() / std::max(high - low, 1e-3), area.height() / top);
    projection.left = area.center().x() - projection.scale * (low + high) / 2.0;
    projection.bottom = area.bottom();
    return projection;
}

void drawShape(QPainter& painter, const Shape& shape, const Projection& to, const QColor& line,
               const QColor& fill) {
    switch (shape.kind) {
        case ShapeKind::Box: {
            painter.save();
            painter.translate(to(shape.center));
            painter.rotate(shape.pitch * 180.0 / 3.14159265358979);
            const QSizeF size(shape.size.x() * to.scale, shape.size.z() * to.scale);
            painter.setPen(QPen(line, 1.0));
            painter.setBrush(fill);
            painter.drawRect(QRectF(QPointF(-size.width() / 2.0, -size.height() / 2.0), size));
            painter.restore();
            break;
        }
        case ShapeKind::Bar: {
            const double thick = std::max(1.5, shape.height * to.scale);
            painter.setPen(QPen(line, thick, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(to(shape.from), to(shape.to));
            break;
        }
        case ShapeKind::Cylinder: {
            const double along =
                std::hypot(shape.to.x() - shape.from.x(), shape.to.z() - shape.from.z());
            painter.setPen(QPen(line, std::max(1.0, 2.0 * shape.radius * to.scale)));
            if (along > shape.radius) {
                painter.drawLine(to(shape.from), to(shape.to));
            }
            break;
        }
        case ShapeKind::Sphere:
            painter.setPen(QPen(line, 1.0));
            painter.setBrush(fill);
            painter.drawEllipse(to(shape.center), shape.radius * to.scale, shape.radius * to.scale);
            break;
    }
}

void draw(QPainter& painter, const Mechanism& mechanism, const QRectF& area,
          const QPalette& palette) {
    painter.setRenderHint(QPainter::Antialiasing);
    const Projection to = fitted(mechanism, area);
    const QColor text = palette.color(QPalette::WindowText);
    const QColor accent = palette.color(QPalette::Highlight);
    QColor pale = text;
    pale.setAlphaF(0.35F);
    QColor hull = text;
    hull.setAlphaF(0.12F);
    painter.setPen(QPen(pale, 1.0));
    painter.drawLine(QPointF(area.left(), area.bottom()), QPointF(area.right(), area.bottom()));
    for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
        const bool chassis = static_cast<int>(i) == mechanism.chassis;
        for (const Shape& shape : mechanism.bodies[i].shapes) {
            const bool box = shape.kind == ShapeKind::Box || shape.kind == ShapeKind::Sphere;
            const double y = box ? shape.center.y() : std::min(shape.from.y(), shape.to.y());
            if (isNear(y)) {
                drawShape(painter, shape, to, chassis || box ? pale : accent, hull);
            }
        }
    }
    for (const auto& wheel : mechanism.wheels) {
        if (isNear(wheel.center.y())) {
            painter.setPen(QPen(text, 1.5));
            painter.setBrush(palette.color(QPalette::Base));
            const double radius = wheel.radius * to.scale;
            painter.drawEllipse(to(wheel.center), radius, radius);
            painter.drawEllipse(to(wheel.center), radius * 0.2, radius * 0.2);
        }
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(text);
    for (const Joint& joint : mechanism.joints) {
        const bool axle =
            std::any_of(mechanism.wheels.begin(), mechanism.wheels.end(), [&](const auto& wheel) {
                return mechanism.joints[static_cast<std::size_t>(wheel.axle)].name == joint.name;
            });
        if (!axle && isNear(joint.point.y())) {
            painter.drawEllipse(to(joint.point), 2.2, 2.2);
        }
    }
}

}  // namespace

RoverSketch::RoverSketch(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("The rover from the side"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void RoverSketch::setMechanism(const std::optional<Mechanism>& mechanism) {
    known_ = mechanism.has_value();
    if (mechanism) {
        mechanism_ = mechanism;
    }
    update();
}

QPixmap RoverSketch::picture(const Mechanism& mechanism, QSize size, const QPalette& palette,
                             double pixelRatio) {
    QPixmap pixmap(size * pixelRatio);
    pixmap.setDevicePixelRatio(pixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    draw(painter, mechanism, QRectF(QPointF(4, 4), QSizeF(size.width() - 8, size.height() - 10)),
         palette);
    return pixmap;
}

void RoverSketch::paintEvent(QPaintEvent* /*event*/) {
    if (!mechanism_) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(rect(), 4.0, 4.0);
    // As a whole, so that what lies behind does not shine through when it is pale.
    painter.setOpacity(known_ ? 1.0 : 0.35);
    painter.drawPixmap(
        12, 8, picture(*mechanism_, size() - QSize(24, 16), palette(), devicePixelRatioF()));
}

}  // namespace widgets
