#include "render/geometry/rover_model.h"

#include <Eigen/Geometry>
#include <cmath>

#include "render/geometry/mesh_builder.h"
#include "render/geometry/wheel_model.h"

namespace render {

namespace {

using simcore::mechanism::Mechanism;
using simcore::mechanism::Shape;
using simcore::project::ShapeKind;

Mat3 pitched(double pitch) {
    return Eigen::AngleAxisd(pitch, Vec3::UnitY()).toRotationMatrix();
}

void addShape(MeshBuilder& mesh, const Shape& shape) {
    mesh.setMaterial(materialFor(shape.color));
    switch (shape.kind) {
        case ShapeKind::Box: {
            const double bevel = std::min(0.008, 0.22 * shape.size.minCoeff());
            mesh.box(shape.center, pitched(shape.pitch), shape.size, bevel);
            break;
        }
        case ShapeKind::Cylinder:
            mesh.cylinder(shape.from, shape.to, shape.radius, 0.12 * shape.radius);
            break;
        case ShapeKind::Sphere:
            mesh.sphere(shape.center, shape.radius);
            break;
        case ShapeKind::Bar:
            mesh.bar(shape.from, shape.to, shape.width, shape.height);
            break;
    }
}

/// What stands for a body that has neither shape nor wheel: bars from its centre of mass, or
/// straight between its joints when there are two.
void addLinkage(MeshBuilder& mesh, const Mechanism& mechanism, int body) {
    std::vector<Vec3> points;
    for (const auto& joint : mechanism.joints) {
        if (joint.first == body || joint.second == body) {
            points.push_back(joint.point);
        }
    }
    const double width = 0.035 * mechanism.wheelbase();
    const Vec3 com = mechanism.bodies[static_cast<std::size_t>(body)].com;
    mesh.setMaterial(materialFor("link"));
    if (points.size() == 2) {
        mesh.bar(points[0], points[1], width, width);
    } else {
        for (const Vec3& point : points) {
            mesh.bar(com, point, width, width);
        }
    }
    mesh.setMaterial(materialFor("metal"));
    for (const Vec3& point : points) {
        mesh.sphere(point, 0.7 * width);
    }
}

void extend(Eigen::AlignedBox3d& box, const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::Box: {
            const Vec3 half = pitched(shape.pitch).cwiseAbs() * (0.5 * shape.size);
            box.extend(Vec3(shape.center - half));
            box.extend(Vec3(shape.center + half));
            break;
        }
        case ShapeKind::Sphere:
            box.extend(Vec3(shape.center.array() - shape.radius));
            box.extend(Vec3(shape.center.array() + shape.radius));
            break;
        case ShapeKind::Cylinder:
        case ShapeKind::Bar: {
            const double margin = std::max({shape.radius, 0.5 * shape.width, 0.5 * shape.height});
            for (const Vec3& end : {shape.from, shape.to}) {
                box.extend(Vec3(end.array() - margin));
                box.extend(Vec3(end.array() + margin));
            }
            break;
        }
    }
}

}  // namespace

osg::ref_ptr<osg::Geometry> makeBodyGeometry(const Mechanism& mechanism, int body) {
    MeshBuilder mesh;
    for (const Shape& shape : mechanism.bodies.at(static_cast<std::size_t>(body)).shapes) {
        addShape(mesh, shape);
    }
    for (std::size_t i = 0; i < mechanism.wheels.size(); ++i) {
        if (mechanism.wheels[i].body == body) {
            addWheel(mesh, mechanism.wheels[i], wheelColor(static_cast<int>(i)));
        }
    }
    if (mesh.empty()) {
        addLinkage(mesh, mechanism, body);
    }
    return mesh.build();
}

osg::ref_ptr<osg::Geometry> makeShapeGeometry(const Shape& shape) {
    MeshBuilder mesh;
    addShape(mesh, shape);
    return mesh.build();
}

RoverBounds boundsOf(const Mechanism& mechanism) {
    Eigen::AlignedBox3d box;
    for (const auto& body : mechanism.bodies) {
        for (const Shape& shape : body.shapes) {
            extend(box, shape);
        }
    }
    for (const auto& wheel : mechanism.wheels) {
        const Vec3 reach(wheel.radius, 0.5 * wheel.width, wheel.radius);
        box.extend(Vec3(wheel.center - reach));
        box.extend(Vec3(wheel.center + reach));
    }
    for (const auto& joint : mechanism.joints) {
        box.extend(joint.point);
    }
    if (box.isEmpty()) {
        return {};
    }
    return {box.center(), std::max(0.5 * box.diagonal().norm(), 0.05)};
}

}  // namespace render
