#pragma once

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/NodeVisitor>
#include <osg/Transform>
#include <stdexcept>
#include <string>
#include <vector>

#include "simcore/base/pose.h"

/// Looking into a scene graph without drawing it.
namespace testsupport {

/// One corner of a drawn triangle.
struct DrawnVertex {
    simcore::Vec3 place;   ///< world [m]
    simcore::Vec3 normal;  ///< world
    osg::Vec4ub color;
};

namespace detail {

template <class Visit>
class Walk : public osg::NodeVisitor {
  public:
    explicit Walk(Visit visit)
        : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN),
          visit_(std::move(visit)) {}

    void apply(osg::Node& node) override {
        if (visit_(node, getNodePath())) {
            traverse(node);
        }
    }

  private:
    Visit visit_;
};

template <class Visit>
void walk(osg::Node& start, Visit visit) {
    Walk<Visit> walker(std::move(visit));
    start.accept(walker);
}

}  // namespace detail

/// First node of this name; null when there is none.
inline osg::Node* findNode(osg::Node& start, const std::string& name) {
    osg::Node* found = nullptr;
    detail::walk(start, [&](osg::Node& node, const osg::NodePath&) {
        if (found == nullptr && node.getName() == name) {
            found = &node;
        }
        return found == nullptr;
    });
    return found;
}

inline simcore::Vec3 toEigen(const osg::Vec3d& v) {
    return {v.x(), v.y(), v.z()};
}

/// Corners of all that is drawn below `start`, in the order they are drawn: three to a triangle,
/// two to a line, one to a point.
inline std::vector<DrawnVertex> verticesBelow(osg::Node& start) {
    std::vector<DrawnVertex> vertices;
    detail::walk(start, [&](osg::Node& node, const osg::NodePath& path) {
        osg::Geometry* geometry = node.asGeometry();
        if (geometry == nullptr) {
            return true;
        }
        const osg::Matrixd toWorld = osg::computeLocalToWorld(path);
        const auto& places = dynamic_cast<const osg::Vec3Array&>(*geometry->getVertexArray());
        const auto* normals = dynamic_cast<const osg::Vec3Array*>(geometry->getNormalArray());
        const auto* colors = dynamic_cast<const osg::Vec4ubArray*>(geometry->getColorArray());
        for (const auto& primitives : geometry->getPrimitiveSetList()) {
            for (unsigned n = 0; n < primitives->getNumIndices(); ++n) {
                const std::size_t i = primitives->index(n);
                DrawnVertex vertex;
                vertex.place = toEigen(osg::Vec3d(places.at(i)) * toWorld);
                vertex.normal = simcore::Vec3::Zero();
                if (normals != nullptr) {
                    const osg::Vec3d normal(normals->at(i));
                    vertex.normal = toEigen(osg::Matrixd::transform3x3(normal, toWorld));
                }
                if (colors != nullptr) {
                    vertex.color = colors->at(colors->size() == 1 ? 0 : i);
                }
                vertices.push_back(vertex);
            }
        }
        return true;
    });
    return vertices;
}

}  // namespace testsupport
