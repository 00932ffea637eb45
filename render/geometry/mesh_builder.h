#pragma once

#include <osg/Geometry>
#include <osg/ref_ptr>
#include <vector>

#include "render/look/materials.h"
#include "simcore/base/pose.h"

namespace render {

using simcore::Mat3;
using simcore::Vec3;

/// One point of a profile that is turned about an axis.
struct ProfilePoint {
    double along = 0.0;   ///< along the axis [m]
    double radius = 0.0;  ///< from the axis [m]
};

/// Collects coloured triangles and makes one geometry of them. All lengths [m].
class MeshBuilder {
  public:
    void setMaterial(const Material& material) { material_ = material; }

    /// Faces are turned so that they look along the mean normal.
    void triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal);
    void quad(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& normals);
    void quad(const std::array<Vec3, 4>& corners, const Vec3& normal);

    /// Box with rounded-looking chamfers. Columns of `axes` are its unit edge directions.
    void box(const Vec3& center, const Mat3& axes, const Vec3& size, double bevel);
    /// Box from one point to another; `width` horizontal, `height` across both.
    void bar(const Vec3& from, const Vec3& to, double width, double height);
    void cylinder(const Vec3& from, const Vec3& to, double radius, double bevel);
    void cone(const Vec3& base, const Vec3& tip, double radius);
    void sphere(const Vec3& center, double radius);
    /// Turns the profile about the axis through `origin`. The surface lies to the left of the way
    /// along the profile (radius up, axis to the right); creases over 40 deg stay sharp.
    void lathe(const Vec3& origin, const Vec3& axis, const std::vector<ProfilePoint>& profile,
               int segments);
    void torus(const Vec3& center, const Vec3& axis, double radius, double tube);

    bool empty() const { return vertices_->empty(); }

    /// The geometry; the builder is empty afterwards.
    osg::ref_ptr<osg::Geometry> build();

  private:
    /// Index of the new vertex.
    unsigned vertex(const Vec3& position, const Vec3& normal);

    Material material_;
    osg::ref_ptr<osg::Vec3Array> vertices_ = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> normals_ = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4ubArray> colors_ = new osg::Vec4ubArray;
    osg::ref_ptr<osg::Vec2Array> finish_ = new osg::Vec2Array;
    osg::ref_ptr<osg::DrawElementsUInt> corners_ = new osg::DrawElementsUInt(GL_TRIANGLES);
};

/// Unit vectors that make a right-handed frame with the unit `axis` as third.
std::pair<Vec3, Vec3> perpendiculars(const Vec3& axis);

inline osg::Vec3 toOsg(const Vec3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace render
