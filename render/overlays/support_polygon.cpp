#include "render/overlays/support_polygon.h"

#include <algorithm>
#include <numeric>

namespace render {

namespace {

/// Twice the signed area of the triangle: positive when a, b, c turn left [m^2].
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

std::vector<int> convexHull(const std::vector<Eigen::Vector2d>& points) {
    const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return at(a).x() != at(b).x() ? at(a).x() < at(b).x() : at(a).y() < at(b).y();
    });
    std::vector<int> hull;
    const auto sweep = [&](auto begin, auto end) {
        const std::size_t base = hull.size();
        for (auto it = begin; it != end; ++it) {
            while (hull.size() >= base + 2 &&
                   turn(at(hull[hull.size() - 2]), at(hull.back()), at(*it)) <= 1e-12) {
                hull.pop_back();
            }
            hull.push_back(*it);
        }
        if (!hull.empty()) {
            hull.pop_back();  // the next sweep starts with it
        }
    };
    sweep(order.begin(), order.end());
    sweep(order.rbegin(), order.rend());
    return hull;
}

bool contains(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point) {
    if (polygon.size() < 3) {
        return false;
    }
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        if (turn(polygon[i], polygon[(i + 1) % polygon.size()], point) < 0.0) {
            return false;
        }
    }
    return true;
}

}  // namespace render
