#pragma once

#include <osg/Matrixd>
#include <osg/Node>
#include <osg/ref_ptr>

#include "render/scene.h"

/// Nodes drawn over the rover, made anew for each instant. Lit ones expect the surface program.
namespace render {

/// Quartered ball at the centre of mass and a line down to the ground at `groundZ` [m].
osg::ref_ptr<osg::Node> makeCenterOfMass(const Vec3& com, double groundZ, double size);

/// Translucent hull of the touching wheels' contact points; null when they span no area.
osg::ref_ptr<osg::Node> makeSupportPolygon(const simcore::run::Snapshot& snapshot,
                                           Scene::Support state);
Scene::Support supportOf(const simcore::run::Snapshot& snapshot);

/// Arrows from the contact points along the ground's forces; `scale` [m/N].
osg::ref_ptr<osg::Node> makeForces(const simcore::run::Snapshot& snapshot, double scale,
                                   double thickness);

/// World axes at the origin, `length` [m] each.
osg::ref_ptr<osg::Node> makeAxes(double length);

/// Ring around a pin; `axis` unit.
osg::ref_ptr<osg::Node> makeRing(const Vec3& center, const Vec3& axis, double radius);

/// A shape in amber on top of where it stands in its body, and through whatever hides it.
osg::ref_ptr<osg::Node> makeShapeMark(const simcore::mechanism::Shape& shape,
                                      const osg::Matrixd& body);

/// Arrow with a shaft of this thickness [m].
class MeshBuilder;
void addArrow(MeshBuilder& mesh, const Vec3& from, const Vec3& to, double thickness);

}  // namespace render
