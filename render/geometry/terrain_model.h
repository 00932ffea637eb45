#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "simcore/terrain/terrain.h"

namespace render {

struct Ground {
    osg::ref_ptr<osg::Group> root;
    osg::ref_ptr<osg::Node> measured;  ///< the part of root that carries the metric grid
};

/// The ground: the very triangles of the terrain, smooth over creases of less than 30 deg, in a
/// plain surrounding at z = 0 that reaches to the horizon and is not part of the terrain. With a
/// null terrain, the surrounding alone.
Ground makeGround(const simcore::terrain::Terrain* terrain);

}  // namespace render
