#include "render/overlays/overlay_nodes.h"

#include <cmath>
#include <numbers>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/MatrixTransform>
#include <osg/PolygonOffset>

#include "render/geometry/mesh_builder.h"
#include "render/geometry/rover_model.h"
#include "render/look/shaders.h"
#include "render/overlays/support_polygon.h"

namespace render {

namespace {

using simcore::run::Snapshot;

constexpr int kBuriedBin = 7;  // after the solid things and the sky

osg::ref_ptr<osg::Geode> makeGeode(MeshBuilder& mesh) {
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(mesh.build());
    return geode;
}

/// Puts a solid node before the rover, still hiding its own far side.
void bringForward(osg::Node& node) {
    osg::StateSet& state = *node.getOrCreateStateSet();
    state.setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 0.02));
    state.setRenderBinDetails(20, "RenderBin");
}

void addQuarteredBall(MeshBuilder& mesh, const Vec3& center, double radius) {
    constexpr int kSteps = 8;  // per octant
    const auto at = [](int azimuth, int elevation) {
        const double a = 0.5 * std::numbers::pi * azimuth / kSteps;
        const double e = 0.5 * std::numbers::pi * elevation / kSteps;
        return Vec3(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
    };
    for (int i = 0; i < 4 * kSteps; ++i) {
        for (int j = -kSteps; j < kSteps; ++j) {
            const bool dark = ((i / kSteps) + (j < 0 ? 1 : 0)) % 2 == 0;
            mesh.setMaterial(painted(dark ? Rgb{24, 26, 30} : Rgb{250, 206, 40}, 0.4F));
            const std::array<Vec3, 4> n = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            mesh.quad({center + radius * n[0], center + radius * n[1], center + radius * n[2],
                       center + radius * n[3]},
                      n);
        }
    }
}

}  // namespace

void addArrow(MeshBuilder& mesh, const Vec3& from, const Vec3& to, double thickness) {
    const double length = (to - from).norm();
    if (length < 1e-6) {
        return;
    }
    const double head = std::min(3.6 * thickness, 0.7 * length);
    const Vec3 neck = to - head / length * (to - from);
    mesh.cylinder(from, neck, 0.5 * thickness, 0.0);
    mesh.cone(neck, to, 1.35 * thickness);
}

osg::ref_ptr<osg::Node> makeCenterOfMass(const Vec3& com, double groundZ, double size) {
    MeshBuilder mesh;
    addQuarteredBall(mesh, com, size);
    if (std::isfinite(groundZ) && groundZ < com.z() - size) {
        mesh.setMaterial(painted({250, 206, 40}));
        const Vec3 foot(com.x(), com.y(), groundZ);
        mesh.cylinder(foot, com, 0.10 * size, 0.0);
        mesh.cylinder(foot, foot + Vec3(0, 0, 0.08 * size), 0.6 * size, 0.0);
    }
    osg::ref_ptr<osg::Geode> geode = makeGeode(mesh);
    bringForward(*geode);
    return geode;
}

Scene::Support supportOf(const Snapshot& snapshot) {
    std::vector<Eigen::Vector2d> points;
    for (const auto& wheel : snapshot.wheels) {
        if (wheel.touching) {
            points.emplace_back(wheel.contactPoint.head<2>());
        }
    }
    std::vector<Eigen::Vector2d> hull;
    for (const int i : convexHull(points)) {
        hull.push_back(points[static_cast<std::size_t>(i)]);
    }
    if (hull.size() < 3) {
        return Scene::Support::None;
    }
    return contains(hull, snapshot.centerOfMass.head<2>()) ? Scene::Support::Inside
                                                           : Scene::Support::Outside;
}

osg::ref_ptr<osg::Node> makeSupportPolygon(const Snapshot& snapshot, Scene::Support state) {
    if (state == Scene::Support::None) {
        return nullptr;
    }
    std::vector<Eigen::Vector2d> flat;
    std::vector<Vec3> places;
    for (const auto& wheel : snapshot.wheels) {
        if (wheel.touching) {
            flat.emplace_back(wheel.contactPoint.head<2>());
            places.push_back(wheel.contactPoint);
        }
    }
    const std::vector<int> hull = convexHull(flat);
    const auto at = [&](std::size_t i) {
        return places[static_cast<std::size_t>(hull[i % hull.size()])];
    };
    const Rgb color = state == Scene::Support::Inside ? Rgb{0, 190, 140} : Rgb{226, 30, 30};
    MeshBuilder mesh;
    mesh.setMaterial({osg::Vec4ub(color.r, color.g, color.b, 82), 1.0F, 0.0F});
    for (std::size_t i = 1; i + 1 < hull.size(); ++i) {
        mesh.triangle(at(0), at(i), at(i + 1), Vec3::UnitZ());
    }
    mesh.setMaterial({osg::Vec4ub(color.r, color.g, color.b, 235), 1.0F, 0.0F});
    for (std::size_t i = 0; i < hull.size(); ++i) {
        mesh.cylinder(at(i), at(i + 1), 0.004, 0.0);
    }
    osg::ref_ptr<osg::Geode> geode = makeGeode(mesh);
    osg::StateSet& stateSet = *geode->getOrCreateStateSet();
    stateSet.setAttributeAndModes(makeFlatProgram(),
                                  osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
    makeBlended(stateSet, 11, false);
    return geode;
}

osg::ref_ptr<osg::Node> makeForces(const Snapshot& snapshot, double scale, double thickness) {
    MeshBuilder mesh;
    for (std::size_t i = 0; i < snapshot.wheels.size(); ++i) {
        const auto& wheel = snapshot.wheels[i];
        if (wheel.touching && wheel.force.allFinite()) {
            mesh.setMaterial(painted(wheelColor(static_cast<int>(i)), 0.5F));
            addArrow(mesh, wheel.contactPoint, wheel.contactPoint + scale * wheel.force, thickness);
        }
    }
    if (mesh.empty()) {
        return nullptr;
    }
    osg::ref_ptr<osg::Geode> geode = makeGeode(mesh);
    bringForward(*geode);
    return geode;
}

osg::ref_ptr<osg::Node> makeAxes(double length) {
    MeshBuilder mesh;
    constexpr std::array<Rgb, 3> kColors = {{{214, 48, 40}, {48, 160, 60}, {44, 92, 214}}};
    const double thickness = 0.045 * length;
    for (int i = 0; i < 3; ++i) {
        mesh.setMaterial(painted(kColors[static_cast<std::size_t>(i)], 0.4F));
        addArrow(mesh, Vec3::Zero(), length * Vec3::Unit(i), thickness);
    }
    mesh.setMaterial(materialFor("white"));
    mesh.sphere(Vec3::Zero(), 0.9 * thickness);
    return makeGeode(mesh);
}

osg::ref_ptr<osg::Node> makeRing(const Vec3& center, const Vec3& axis, double radius) {
    MeshBuilder mesh;
    mesh.setMaterial(painted({255, 150, 20}, 0.4F));
    mesh.torus(center, axis, radius, 0.11 * radius);
    osg::ref_ptr<osg::Geode> geode = makeGeode(mesh);
    bringForward(*geode);
    geode->getOrCreateStateSet()->addUniform(new osg::Uniform(uniform::kHighlight, 1.0F));
    return geode;
}

osg::ref_ptr<osg::Node> makeShapeMark(const simcore::mechanism::Shape& shape,
                                      const osg::Matrixd& body) {
    osg::ref_ptr<osg::Geode> seen = new osg::Geode;
    osg::ref_ptr<osg::Geode> buried = new osg::Geode;
    osg::ref_ptr<osg::MatrixTransform> mark = new osg::MatrixTransform(body);
    const osg::ref_ptr<osg::Geometry> geometry = makeShapeGeometry(shape);
    for (const auto& geode : {seen, buried}) {
        geode->addDrawable(geometry);
        mark->addChild(geode);
    }
    // Over the body's own picture of it.
    mark->getOrCreateStateSet()->setAttributeAndModes(new osg::PolygonOffset(-1.0F, -1.0F));
    seen->getOrCreateStateSet()->addUniform(new osg::Uniform(uniform::kHighlight, 1.0F));
    osg::StateSet& through = *buried->getOrCreateStateSet();
    through.setDefine("BURIED");
    makeBlended(through, kBuriedBin, true);
    through.setAttributeAndModes(new osg::Depth(osg::Depth::GREATER, 0.0, 1.0, false));
    through.setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
    return mark;
}

}  // namespace render
