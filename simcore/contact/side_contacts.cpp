#include "simcore/contact/side_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "simcore/base/planar.h"

namespace simcore::contact {
namespace {

using Eigen::Vector2d;

// Faces turned further than this from the axle are the rim's.
constexpr double kFacing = std::numbers::pi / 4.0;
// Deeper contacts are left out [m]: 2.5 m/s for a step of 2 ms (assumed).
constexpr double kDeepest = 0.005;
// Of points equally deep, as all are of a wall that runs along the wheel, the ones furthest from
// both middle lines of the side count: so the wall holds the wheel with long levers. Worth this
// much depth [m], far below any that matters.
constexpr double kLever = 1e-8;

/// Calls visit(point) with where the piece a-b crosses the circle round 0.
template <class Visit>
void visitCrossings(const Vector2d& a, const Vector2d& b, double radius, Visit&& visit) {
    const Vector2d along = b - a;
    const double length2 = along.squaredNorm();
    const double middle = a.dot(along);
    const double root2 = middle * middle - length2 * (a.squaredNorm() - radius * radius);
    if (!(length2 > 0.0) || !(root2 > 0.0)) {
        return;
    }
    for (const double sign : {-1.0, 1.0}) {
        const double share = (-middle + sign * std::sqrt(root2)) / length2;
        if (share > 0.0 && share < 1.0) {
            visit(Vector2d(a + share * along));
        }
    }
}

bool inside(const std::array<Vector2d, 3>& triangle, const Vector2d& point) {
    std::array<double, 3> side{};
    for (std::size_t k = 0; k < 3; ++k) {
        side[k] = cross(triangle[(k + 1) % 3] - triangle[k], point - triangle[k]);
    }
    return (side[0] >= 0.0 && side[1] >= 0.0 && side[2] >= 0.0) ||
           (side[0] <= 0.0 && side[1] <= 0.0 && side[2] <= 0.0);
}

double distanceToOrigin(const std::array<Vector2d, 3>& triangle) {
    if (inside(triangle, Vector2d::Zero())) {
        return 0.0;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector2d& a = triangle[k];
        const Vector2d& b = triangle[(k + 1) % 3];
        nearest = std::min(nearest, (a + nearestShare(a, b) * (b - a)).norm());
    }
    return nearest;
}

}  // namespace

SideContactFinder::SideContactFinder() {
    constexpr std::size_t kRoom = 256;
    facets_.reserve(kRoom);
    contacts_.reserve(8);
}

const std::vector<SideContact>& SideContactFinder::find(const terrain::Terrain& terrain,
                                                        const Cylinder& wheel, double margin) {
    contacts_.clear();
    sides_ = {};
    const Vec3 reach =
        wheel.radius *
            (Vec3::Ones() - wheel.axis.cwiseProduct(wheel.axis)).cwiseMax(0.0).cwiseSqrt() +
        (wheel.halfWidth + margin) * wheel.axis.cwiseAbs();
    terrain.facing(wheel.center - reach, wheel.center + reach, wheel.axis, kFacing, facets_);
    for (const terrain::Facet& facet : facets_) {
        touch(facet, wheel, margin);
    }
    for (const Side& side : sides_) {
        for (const Quarter& quarter : side.quarters) {
            if (quarter.touches && quarter.deepest.depth < side.reach) {
                contacts_.push_back(quarter.deepest);
            }
        }
    }
    return contacts_;
}

// Over the part of the triangle that lies within the circle, seen along the axle, the depth is a
// linear function: largest at a corner of that part or where the circle is deepest.
void SideContactFinder::touch(const terrain::Facet& facet, const Cylinder& wheel, double margin) {
    const bool onAxisSide = facet.normal.dot(wheel.axis) < 0.0;
    Side& side = sides_[onAxisSide ? 0 : 1];
    const Vec3 out = onAxisSide ? wheel.axis : Vec3(-wheel.axis);
    const Vec3 up = wheel.forward.cross(wheel.axis);
    const Vector2d slope(facet.normal.dot(wheel.forward), facet.normal.dot(up));
    const double facing = -facet.normal.dot(out);
    const double offset = facet.normal.dot(facet.corners[0] - wheel.center);
    const auto add = [&](const Vector2d& at) {
        // Distance from the wheel's middle to the face, along `out`.
        const double along = (slope.dot(at) - offset) / facing;
        const double depth = (wheel.halfWidth - along) * facing;
        if (along < 0.0 || depth <= -margin || depth > kDeepest) {
            return;
        }
        Quarter& quarter = side.quarters[(at.x() < 0.0 ? 1U : 0U) + (at.y() < 0.0 ? 2U : 0U)];
        const double rank =
            depth + kLever * std::abs(at.x() * at.y()) / (wheel.radius * wheel.radius);
        if (!quarter.touches || rank > quarter.rank) {
            quarter = {true,
                       rank,
                       {wheel.center + along * out + at.x() * wheel.forward + at.y() * up,
                        facet.normal, depth, onAxisSide}};
        }
    };

    std::array<Vector2d, 3> triangle;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 arm = facet.corners[k] - wheel.center;
        triangle[k] = {arm.dot(wheel.forward), arm.dot(up)};
    }
    side.reach = std::max(side.reach, wheel.radius - distanceToOrigin(triangle));
    for (std::size_t k = 0; k < 3; ++k) {
        if (triangle[k].norm() <= wheel.radius) {
            add(triangle[k]);
        }
        visitCrossings(triangle[k], triangle[(k + 1) % 3], wheel.radius, add);
    }
    const auto addOnRim = [&](const Vector2d& direction) {
        const Vector2d point = wheel.radius * direction;
        if (inside(triangle, point)) {
            add(point);
        }
    };
    if (slope.norm() > 1e-9) {
        addOnRim(-slope.normalized());
    }
    // Where a face runs exactly along the wheel every point is as deep.
    const double half = std::numbers::sqrt2 / 2.0;
    for (const double x : {-half, half}) {
        for (const double y : {-half, half}) {
            addOnRim({x, y});
        }
    }
}

}  // namespace simcore::contact
