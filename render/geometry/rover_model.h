#pragma once

#include <osg/Geometry>
#include <osg/ref_ptr>
#include <vector>

#include "simcore/mechanism/mechanism.h"

namespace render {

/// Geometry of one body, rover frame at the drawn pose: its shapes and wheels; a body without
/// either shows as bars between its joints. Empty geometry: nothing to show.
osg::ref_ptr<osg::Geometry> makeBodyGeometry(const simcore::mechanism::Mechanism& mechanism,
                                             int body);

/// Of one shape of a body, in the same frame.
osg::ref_ptr<osg::Geometry> makeShapeGeometry(const simcore::mechanism::Shape& shape);

/// A ball around what is drawn of the rover.
struct RoverBounds {
    simcore::Vec3 center = simcore::Vec3::Zero();  ///< rover frame, drawn pose [m]
    double radius = 0.5;                           ///< [m]
};

RoverBounds boundsOf(const simcore::mechanism::Mechanism& mechanism);

}  // namespace render
