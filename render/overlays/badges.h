#pragma once

#include <osg/Geode>
#include <osg/ref_ptr>
#include <vector>

#include "simcore/base/pose.h"

namespace render {

/// A digit in a disc at a place, always facing the viewer.
struct Badge {
    simcore::Vec3 place = simcore::Vec3::Zero();  ///< world [m]
    int digit = 0;                                ///< 0..7
};

/// Draws the badges, `size` pixels across, over everything else.
class BadgeNode {
  public:
    BadgeNode();

    osg::Geode* node() { return geode_; }

    void set(const std::vector<Badge>& badges, float size);

  private:
    osg::ref_ptr<osg::Geode> geode_ = new osg::Geode;
};

}  // namespace render
