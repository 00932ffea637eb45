#pragma once

#include <osg/Geode>
#include <osg/ref_ptr>
#include <vector>

#include "simcore/mechanism/mechanism.h"
#include "simcore/run/snapshot.h"

namespace render {

/// Where the rover has been up to the instant on show: its centre of mass and every wheel's
/// contact. What was seen of a run is kept when one looks back in time.
class Trail {
  public:
    Trail();

    osg::Geode* node() { return geode_; }

    void clear();
    /// Ends the trail at this instant, which becomes part of it unless the rover is known to have
    /// been there.
    void record(const simcore::run::Snapshot& snapshot);

    int length() const { return static_cast<int>(shown_); }

    /// Makes the lines anew, `width` pixels wide.
    void draw(float width);

  private:
    struct Entry {
        double time;
        simcore::Vec3 center;
        std::vector<simcore::Vec3> contacts;
        std::vector<bool> touching;
    };

    std::vector<Entry> points_;  ///< by time
    std::size_t shown_ = 0;      ///< points up to the instant on show
    osg::ref_ptr<osg::Geode> geode_ = new osg::Geode;
};

}  // namespace render
