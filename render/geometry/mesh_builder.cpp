#include "render/geometry/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace render {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kCreaseCosine = 0.766;  // 40 deg

int segmentsFor(double radius) {
    return radius < 0.012 ? 14 : radius < 0.03 ? 20 : radius < 0.08 ? 32 : 48;
}

}  // namespace

std::pair<Vec3, Vec3> perpendiculars(const Vec3& axis) {
    const Vec3 helper = std::abs(axis.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
    const Vec3 u = helper.cross(axis).normalized();
    return {u, axis.cross(u)};
}

unsigned MeshBuilder::vertex(const Vec3& position, const Vec3& normal) {
    const auto index = static_cast<unsigned>(vertices_->size());
    vertices_->push_back(toOsg(position));
    normals_->push_back(toOsg(normal));
    colors_->push_back(material_.color);
    finish_->push_back(osg::Vec2(material_.roughness, material_.metal));
    return index;
}

void MeshBuilder::triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
    const bool flip = (b - a).cross(c - a).dot(normal) < 0.0;
    for (const Vec3* corner : {&a, flip ? &c : &b, flip ? &b : &c}) {
        corners_->push_back(vertex(*corner, normal));
    }
}

void MeshBuilder::quad(const std::array<Vec3, 4>& p, const std::array<Vec3, 4>& n) {
    const Vec3 face = (p[2] - p[0]).cross(p[3] - p[1]);
    const bool flip = face.dot(n[0] + n[1] + n[2] + n[3]) < 0.0;
    const unsigned first = vertex(p[0], n[0]);
    for (std::size_t i = 1; i < 4; ++i) {
        vertex(p[i], n[i]);
    }
    const std::array<unsigned, 6> order = flip ? std::array<unsigned, 6>{0, 2, 1, 0, 3, 2}
                                               : std::array<unsigned, 6>{0, 1, 2, 0, 2, 3};
    for (const unsigned i : order) {
        corners_->push_back(first + i);
    }
}

void MeshBuilder::quad(const std::array<Vec3, 4>& corners, const Vec3& normal) {
    quad(corners, {normal, normal, normal, normal});
}

void MeshBuilder::box(const Vec3& center, const Mat3& axes, const Vec3& size, double bevel) {
    const Vec3 half = 0.5 * size;
    const double b = std::min(bevel, 0.45 * size.minCoeff());
    // Point of face `i` (at sign s) towards the edges with j (t) and k (u).
    const auto point = [&](int i, double s, int j, double t, int k, double u) {
        Vec3 local;
        local[i] = s * half[i];
        local[j] = t * (half[j] - b);
        local[k] = u * (half[k] - b);
        return Vec3(center + axes * local);
    };
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        for (const double s : {-1.0, 1.0}) {
            const Vec3 normal = s * axes.col(i);
            quad({point(i, s, j, -1, k, -1), point(i, s, j, 1, k, -1), point(i, s, j, 1, k, 1),
                  point(i, s, j, -1, k, 1)},
                 normal);
            for (const double t : {-1.0, 1.0}) {
                const Vec3 other = t * axes.col(j);
                quad({point(i, s, j, t, k, -1), point(i, s, j, t, k, 1), point(j, t, i, s, k, 1),
                      point(j, t, i, s, k, -1)},
                     {normal, normal, other, other});
            }
        }
    }
    for (const double s : {-1.0, 1.0}) {
        for (const double t : {-1.0, 1.0}) {
            for (const double u : {-1.0, 1.0}) {
                triangle(point(0, s, 1, t, 2, u), point(1, t, 2, u, 0, s), point(2, u, 0, s, 1, t),
                         (axes * Vec3(s, t, u)).normalized());
            }
        }
    }
}

void MeshBuilder::bar(const Vec3& from, const Vec3& to, double width, double height) {
    const Vec3 along = to - from;
    const double length = along.norm();
    if (length <= 0.0) {
        return;
    }
    const Vec3 ex = along / length;
    // Across and horizontal; an upright bar is as wide along y.
    Vec3 ey = Vec3::UnitZ().cross(ex);
    ey = ey.norm() < 1e-6 ? Vec3::UnitY() : ey.normalized();
    Mat3 axes;
    axes << ex, ey, ex.cross(ey);
    box(0.5 * (from + to), axes, Vec3(length, width, height), 0.18 * std::min(width, height));
}

void MeshBuilder::cylinder(const Vec3& from, const Vec3& to, double radius, double bevel) {
    const double length = (to - from).norm();
    if (length <= 0.0 || radius <= 0.0) {
        return;
    }
    const double b = std::min({bevel, 0.4 * length, 0.5 * radius});
    lathe(from, (to - from) / length,
          {{0, 0},
           {0, radius - b},
           {b, radius},
           {length - b, radius},
           {length, radius - b},
           {length, 0}},
          segmentsFor(radius));
}

void MeshBuilder::cone(const Vec3& base, const Vec3& tip, double radius) {
    const double length = (tip - base).norm();
    if (length > 0.0) {
        lathe(base, (tip - base) / length, {{0, 0}, {0, radius}, {length, 0}}, 24);
    }
}

void MeshBuilder::sphere(const Vec3& center, double radius) {
    std::vector<ProfilePoint> arc;
    constexpr int kSteps = 16;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = std::numbers::pi * i / kSteps;
        arc.push_back({-radius * std::cos(angle), radius * std::sin(angle)});
    }
    lathe(center, Vec3::UnitZ(), arc, 32);
}

void MeshBuilder::torus(const Vec3& center, const Vec3& axis, double radius, double tube) {
    std::vector<ProfilePoint> circle;
    constexpr int kSteps = 12;
    for (int i = 0; i <= kSteps; ++i) {
        const double angle = kTurn * i / kSteps;
        circle.push_back({-tube * std::cos(angle), radius + tube * std::sin(angle)});
    }
    lathe(center, axis, circle, 48);
}

void MeshBuilder::lathe(const Vec3& origin, const Vec3& axis,
                        const std::vector<ProfilePoint>& profile, int segments) {
    const auto [u, v] = perpendiculars(axis);
    const std::size_t pieces = profile.size() - 1;
    std::vector<Eigen::Vector2d> flat(pieces);  // normals in (along, radius)
    for (std::size_t i = 0; i < pieces; ++i) {
        const Eigen::Vector2d way(profile[i + 1].along - profile[i].along,
                                  profile[i + 1].radius - profile[i].radius);
        flat[i] = way.norm() > 0.0
                      ? Eigen::Vector2d(Eigen::Vector2d(-way.y(), way.x()).normalized())
                      : Eigen::Vector2d(0.0, 1.0);
    }
    const auto blended = [&](std::size_t piece, bool atEnd) -> Eigen::Vector2d {
        const bool open = atEnd ? piece + 1 >= pieces : piece == 0;
        if (open) {
            return flat[piece];
        }
        const Eigen::Vector2d& neighbour = flat[atEnd ? piece + 1 : piece - 1];
        return neighbour.dot(flat[piece]) > kCreaseCosine ? (neighbour + flat[piece]).normalized()
                                                          : flat[piece];
    };
    for (std::size_t i = 0; i < pieces; ++i) {
        const std::array<ProfilePoint, 2> ends = {profile[i], profile[i + 1]};
        const std::array<Eigen::Vector2d, 2> normals = {blended(i, false), blended(i, true)};
        for (int s = 0; s < segments; ++s) {
            std::array<Vec3, 4> p, n;
            for (std::size_t corner = 0; corner < 4; ++corner) {
                const std::size_t end = corner == 1 || corner == 2 ? 1 : 0;
                const double angle = kTurn * (s + (corner >= 2 ? 1 : 0)) / segments;
                const Vec3 out = std::cos(angle) * u + std::sin(angle) * v;
                p[corner] = origin + ends[end].along * axis + ends[end].radius * out;
                n[corner] = normals[end].x() * axis + normals[end].y() * out;
            }
            quad(p, n);
        }
    }
}

osg::ref_ptr<osg::Geometry> MeshBuilder::build() {
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(vertices_);
    geometry->setNormalArray(normals_, osg::Array::BIND_PER_VERTEX);
    colors_->setNormalize(true);
    geometry->setColorArray(colors_, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(0, finish_, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(corners_);
    vertices_ = new osg::Vec3Array;
    normals_ = new osg::Vec3Array;
    colors_ = new osg::Vec4ubArray;
    finish_ = new osg::Vec2Array;
    corners_ = new osg::DrawElementsUInt(GL_TRIANGLES);
    return geometry;
}

}  // namespace render
