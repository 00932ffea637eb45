#pragma once

#include <osg/Vec4ub>
#include <string_view>

#include "render/palette.h"

namespace render {

/// Colour and finish of a surface.
struct Material {
    osg::Vec4ub color = osg::Vec4ub(200, 200, 200, 255);  ///< sRGB
    float roughness = 0.6F;                               ///< 0 mirror .. 1 matt
    float metal = 0.0F;                                   ///< 0 paint .. 1 bare metal
};

/// The finish that goes with a palette name; a painted surface for "#rrggbb" and unknown names.
Material materialFor(std::string_view color);
Material painted(const Rgb& color, float roughness = 0.5F);

}  // namespace render
