#pragma once

#include <QPointF>
#include <QSize>
#include <optional>

#include "render/scene.h"

namespace widgets {

/// From the world to the pixels of a picture and back.
class Projection {
  public:
    /// @param size  of the picture in logical pixels
    Projection(const render::CameraPose& camera, const QSize& size);

    struct Ray {
        render::Vec3 start;
        render::Vec3 way;  ///< unit
    };

    /// Nothing for what is behind the eye.
    std::optional<QPointF> toPixel(const render::Vec3& point) const;
    Ray rayThrough(const QPointF& pixel) const;

    /// Length at the centre of view that one pixel covers [m].
    double pixelSize() const { return pixelSize_; }

    const render::Vec3& ahead() const { return ahead_; }

    const render::Vec3& right() const { return right_; }

    const render::Vec3& up() const { return up_; }

    /// The axis of the world, 0 to 2, that is looked along most.
    int depthAxis() const;
    /// It is looked along exactly, without perspective: lengths can be read off.
    bool isToScale() const;

  private:
    render::CameraPose camera_;
    QSize size_;
    render::Vec3 ahead_, right_, up_;
    double pixelSize_;
};

}  // namespace widgets
