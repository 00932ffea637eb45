#pragma once

#include <osg/Geode>
#include <osg/ref_ptr>
#include <vector>

#include "simcore/mechanism/mechanism.h"
#include "simcore/run/snapshot.h"

namespace render {

/// Where the rover has been: its centre of mass on the ground below, and every wheel's contact.
class Trail {
  public:
    Trail();

    osg::Geode* node() { return geode_; }

    void clear();
    /// Appends when the rover has moved on; cuts off what lies at or after a time that jumped back.
    void record(const simcore::run::Snapshot& snapshot);

    int length() const { return static_cast<int>(points_.size()); }

    /// Makes the lines anew, `width` pixels wide.
    void draw(float width);

  private:
    struct Entry {
        double time;
        simcore::Vec3 center;
        std::vector<simcore::Vec3> contacts;
        std::vector<bool> touching;
    };

    std::vector<Entry> points_;
    osg::ref_ptr<osg::Geode> geode_ = new osg::Geode;
};

}  // namespace render
