#pragma once

#include <Eigen/Core>
#include <vector>

namespace render {

/// Indices of the points on the convex hull, counter-clockwise, collinear points left out; fewer
/// than three when the points span no area. Andrew's monotone chain (1979).
std::vector<int> convexHull(const std::vector<Eigen::Vector2d>& points);

/// True inside or on the border of a counter-clockwise convex polygon.
bool contains(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point);

}  // namespace render
