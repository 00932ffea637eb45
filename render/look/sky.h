#pragma once

#include <osg/Node>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace render {

/// The sky behind everything.
osg::ref_ptr<osg::Node> makeSky();

/// A tileable grey noise, mean 0.5: grains of the soil. The same on every machine.
osg::ref_ptr<osg::Texture2D> makeNoiseTexture();

}  // namespace render
