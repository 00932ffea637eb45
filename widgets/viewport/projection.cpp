#include "widgets/viewport/projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace widgets {

using render::Vec3;

Projection::Projection(const render::CameraPose& camera, const QSize& size)
    : camera_(camera),
      size_(size),
      ahead_((camera.center - camera.eye).normalized()),
      right_(ahead_.cross(camera.up).normalized()),
      up_(right_.cross(ahead_)),
      pixelSize_(2.0 * (camera.eye - camera.center).norm() *
                 std::tan(0.5 * render::kFieldOfView * std::numbers::pi / 180.0) /
                 std::max(size.height(), 1)) {}

std::optional<QPointF> Projection::toPixel(const Vec3& point) const {
    const Vec3 to = point - camera_.eye;
    const double depth = to.dot(ahead_);
    if (!(depth > 1e-6)) {
        return std::nullopt;
    }
    const double distance = (camera_.center - camera_.eye).norm();
    const double scale = camera_.orthographic ? 1.0 / pixelSize_ : distance / (depth * pixelSize_);
    return QPointF(0.5 * size_.width() + scale * to.dot(right_),
                   0.5 * size_.height() - scale * to.dot(up_));
}

Projection::Ray Projection::rayThrough(const QPointF& pixel) const {
    const Vec3 aside = (pixel.x() - 0.5 * size_.width()) * pixelSize_ * right_ -
                       (pixel.y() - 0.5 * size_.height()) * pixelSize_ * up_;
    if (camera_.orthographic) {
        return {camera_.eye + aside, ahead_};
    }
    return {camera_.eye, (camera_.center + aside - camera_.eye).normalized()};
}

int Projection::depthAxis() const {
    Eigen::Index axis = 0;
    ahead_.cwiseAbs().maxCoeff(&axis);
    return static_cast<int>(axis);
}

bool Projection::isToScale() const {
    return camera_.orthographic && std::abs(ahead_[depthAxis()]) > 1.0 - 1e-9;
}

}  // namespace widgets
