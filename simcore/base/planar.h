#pragma once

#include <algorithm>

#include <Eigen/Core>

/// Geometry in a plane.
namespace simcore {

/// Positive when b is to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Point of the piece a-b that is nearest to 0, as a share of the way from a.
inline double nearestShare(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = b - a;
    const double length2 = along.squaredNorm();
    return length2 > 0.0 ? std::clamp(-a.dot(along) / length2, 0.0, 1.0) : 0.0;
}

}  // namespace simcore
