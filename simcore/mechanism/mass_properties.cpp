#include "simcore/mechanism/mass_properties.h"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "simcore/base/text.h"

namespace simcore::mechanism {
namespace {

Mat3 pointInertia(double mass, const Vec3& r) {
    return mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

Mat3 inertiaOfBox(double mass, const Vec3& size, const Mat3& axes) {
    const Vec3 s = size.cwiseAbs2();
    const Vec3 moments = mass / 12.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y());
    return axes * moments.asDiagonal() * axes.transpose();
}

struct Solid {
    double volume = 0.0;
    Vec3 centroid = Vec3::Zero();
    Mat3 inertiaPerMass = Mat3::Zero();
};

Solid solidOf(const Shape& shape) {
    using project::ShapeKind;
    switch (shape.kind) {
        case ShapeKind::Box: {
            const Mat3 axes = Eigen::AngleAxisd(shape.pitch, Vec3::UnitY()).toRotationMatrix();
            return {shape.size.prod(), shape.center, inertiaOfBox(1.0, shape.size, axes)};
        }
        case ShapeKind::Sphere: {
            const double r = shape.radius;
            return {4.0 / 3.0 * std::numbers::pi * r * r * r, shape.center,
                    0.4 * r * r * Mat3::Identity()};
        }
        case ShapeKind::Cylinder: {
            const Vec3 along = shape.to - shape.from;
            const double length = along.norm();
            return {std::numbers::pi * shape.radius * shape.radius * length,
                    0.5 * (shape.from + shape.to),
                    inertiaOfCylinder(1.0, shape.radius, length, along.normalized())};
        }
        case ShapeKind::Bar: {
            const Vec3 along = shape.to - shape.from;
            const Vec3 x = along.normalized();
            const Vec3 up = std::abs(x.z()) < 0.99 ? Vec3::UnitZ() : Vec3::UnitX();
            const Vec3 y = up.cross(x).normalized();
            Mat3 axes;
            axes << x, y, x.cross(y);
            const Vec3 size(along.norm(), shape.width, shape.height);
            return {size.prod(), 0.5 * (shape.from + shape.to), inertiaOfBox(1.0, size, axes)};
        }
    }
    return {};
}

}  // namespace

MassProperties merged(const MassProperties& a, const MassProperties& b) {
    MassProperties sum;
    sum.mass = a.mass + b.mass;
    if (sum.mass <= 0.0) {
        return a;
    }
    sum.com = (a.mass * a.com + b.mass * b.com) / sum.mass;
    sum.inertia = a.inertia + pointInertia(a.mass, a.com - sum.com) + b.inertia +
                  pointInertia(b.mass, b.com - sum.com);
    return sum;
}

Mat3 inertiaOfShapes(const std::vector<Shape>& shapes, double mass) {
    double volume = 0.0;
    for (const Shape& shape : shapes) {
        volume += solidOf(shape).volume;
    }
    MassProperties total;
    for (const Shape& shape : shapes) {
        const Solid solid = solidOf(shape);
        if (volume > 0.0 && solid.volume > 0.0) {
            const double share = mass * solid.volume / volume;
            total = merged(total, {share, solid.centroid, share * solid.inertiaPerMass});
        }
    }
    return total.inertia;
}

Mat3 inertiaOfCylinder(double mass, double radius, double length, const Vec3& axis) {
    const double along = 0.5 * mass * radius * radius;
    const double across = mass * (3.0 * radius * radius + length * length) / 12.0;
    return across * Mat3::Identity() + (along - across) * axis * axis.transpose();
}

std::string whyNotInertia(const Mat3& inertia) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
    const Vec3& moments = solver.eigenvalues();  // ascending
    if (!(moments.x() > 0.0)) {
        return Text::of("the smallest principal moment of inertia is {:.4g} kg m^2, not positive",
                        moments.x());
    }
    // A thin plate meets the bound exactly; leave room for round-off.
    if (moments.z() > (moments.x() + moments.y()) * (1.0 + 1e-9)) {
        return Text::of(
            "the largest principal moment ({:.4g}) exceeds the sum of the other two ({:.4g} kg "
            "m^2)",
            moments.z(), moments.x() + moments.y());
    }
    return {};
}

}  // namespace simcore::mechanism
