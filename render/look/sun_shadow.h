#pragma once

#include <osg/Camera>
#include <osg/StateSet>
#include <osg/Texture2D>
#include <osg/Uniform>
#include <osg/ref_ptr>

#include "simcore/base/pose.h"

namespace render {

/// The sun's shadow map, drawn before the picture. It covers a square around the rover; things
/// outside are lit.
class SunShadow {
  public:
    explicit SunShadow(int size);

    /// The node that draws the map: put it in the scene, with the casters below it.
    osg::Camera* camera() { return camera_; }

    /// Sets map, matrix and the SHADOWS define for what receives.
    void attach(osg::StateSet& receivers);
    void setEnabled(osg::StateSet& receivers, bool enabled, bool fourTaps);
    void resize(int size);
    /// Covers a ball [m].
    void cover(const simcore::Vec3& center, double radius);

  private:
    void makeTexture(int size);

    osg::ref_ptr<osg::Camera> camera_ = new osg::Camera;
    osg::ref_ptr<osg::Texture2D> texture_;
    osg::ref_ptr<osg::StateSet> receivers_;
    osg::ref_ptr<osg::Uniform> matrix_;
    osg::ref_ptr<osg::Uniform> texel_;
};

}  // namespace render
