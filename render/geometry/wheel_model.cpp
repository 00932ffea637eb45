#include "render/geometry/wheel_model.h"

#include <cmath>
#include <numbers>

namespace render {

namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr int kSpokes = 6;

/// A wheel under construction: the frame and sizes its pieces share.
struct WheelShape {
    Vec3 center, axis, u, v;
    double radius, half;  ///< half = half the width

    Vec3 out(double angle) const { return std::cos(angle) * u + std::sin(angle) * v; }

    Mat3 axesAt(double angle) const {
        Mat3 axes;
        axes << out(angle), axis.cross(out(angle)), axis;
        return axes;
    }
};

void addTyre(MeshBuilder& mesh, const WheelShape& w, int grousers) {
    const bool smooth = grousers <= 0;
    const int ribs = smooth ? 30 : grousers;
    const double depth = (smooth ? 0.035 : 0.075) * w.radius;
    const double tread = w.radius - depth, inner = 0.74 * w.radius;
    const double shoulder = std::min(0.10 * w.radius, 0.4 * w.half);
    mesh.setMaterial(materialFor("tyre"));
    mesh.lathe(w.center, w.axis,
               {{-w.half + 0.5 * shoulder, inner},
                {-w.half, inner + 0.4 * shoulder},
                {-w.half, tread - shoulder},
                {-w.half + 0.3 * shoulder, tread - 0.3 * shoulder},
                {-w.half + shoulder, tread},
                {w.half - shoulder, tread},
                {w.half - 0.3 * shoulder, tread - 0.3 * shoulder},
                {w.half, tread - shoulder},
                {w.half, inner + 0.4 * shoulder},
                {w.half - 0.5 * shoulder, inner}},
               64);
    const double length = kFullTurn * w.radius / ribs;
    for (int i = 0; i < ribs; ++i) {
        const double angle = kFullTurn * (i + 0.5) / ribs;
        const double height = depth + 0.5 * shoulder;
        mesh.box(w.center + (w.radius - 0.5 * height) * w.out(angle), w.axesAt(angle),
                 Vec3(height, (smooth ? 0.62 : 0.34) * length, 1.92 * w.half), 0.25 * depth);
    }
}

void addRim(MeshBuilder& mesh, const WheelShape& w) {
    const double outer = 0.76 * w.radius, inner = 0.68 * w.radius;
    const double face = 0.90 * w.half;
    mesh.setMaterial({osg::Vec4ub(196, 200, 206, 255), 0.30F, 0.8F});
    mesh.lathe(w.center, w.axis,
               {{face, inner},
                {-face, inner},
                {-face, outer - 0.02 * w.radius},
                {-face + 0.02 * w.radius, outer}},
               64);
    mesh.lathe(w.center, w.axis,
               {{face - 0.02 * w.radius, outer}, {face, outer - 0.02 * w.radius}, {face, inner}},
               64);
    const Rgb white = *parseColor("white");
    for (int i = 0; i < kSpokes; ++i) {
        const double angle = kFullTurn * i / kSpokes;
        if (i == 0) {
            mesh.setMaterial(painted(white, 0.4F));
        } else {
            mesh.setMaterial({osg::Vec4ub(150, 155, 162, 255), 0.34F, 0.7F});
        }
        const double from = 0.14 * w.radius, to = inner + 0.01 * w.radius;
        mesh.box(w.center + 0.5 * (from + to) * w.out(angle), w.axesAt(angle),
                 Vec3(to - from, (i == 0 ? 0.17 : 0.12) * w.radius, 0.9 * w.half), 0.03 * w.radius);
    }
}

void addHub(MeshBuilder& mesh, const WheelShape& w) {
    mesh.setMaterial(materialFor("link_dark"));
    mesh.cylinder(w.center - 0.86 * w.half * w.axis, w.center + 0.86 * w.half * w.axis,
                  0.23 * w.radius, 0.04 * w.radius);
    mesh.setMaterial(materialFor("metal"));
    mesh.cylinder(w.center - 1.02 * w.half * w.axis, w.center + 1.02 * w.half * w.axis,
                  0.10 * w.radius, 0.02 * w.radius);
}

/// Ring on the side walls, with a gap of white at the painted spoke.
void addMarks(MeshBuilder& mesh, const WheelShape& w, const Rgb& ring) {
    constexpr int kSteps = 72;
    constexpr double kGap = 0.16;  // rad, each side of the painted spoke
    const double inner = 0.785 * w.radius, outer = 0.845 * w.radius;
    const Material wheelColor = painted(ring, 0.5F);
    const Material mark = painted(*parseColor("white"), 0.5F);
    for (const double side : {-1.0, 1.0}) {
        const Vec3 face = w.center + side * 1.012 * w.half * w.axis;
        for (int i = 0; i < kSteps; ++i) {
            const double a = kFullTurn * i / kSteps, b = kFullTurn * (i + 1) / kSteps;
            const double middle = std::remainder(0.5 * (a + b), kFullTurn);
            mesh.setMaterial(std::abs(middle) < kGap ? mark : wheelColor);
            mesh.quad({face + inner * w.out(a), face + outer * w.out(a), face + outer * w.out(b),
                       face + inner * w.out(b)},
                      Vec3(side * w.axis));
        }
    }
}

}  // namespace

void addWheel(MeshBuilder& mesh, const simcore::mechanism::Wheel& wheel, const Rgb& ring) {
    const auto [u, v] = perpendiculars(wheel.axis);
    const WheelShape shape{wheel.center, wheel.axis, u, v, wheel.radius, 0.5 * wheel.width};
    addTyre(mesh, shape, wheel.grousers);
    addRim(mesh, shape);
    addHub(mesh, shape);
    addMarks(mesh, shape, ring);
}

}  // namespace render
