#include "render/look/materials.h"

namespace render {

Material painted(const Rgb& color, float roughness) {
    return {osg::Vec4ub(color.r, color.g, color.b, 255), roughness, 0.0F};
}

Material materialFor(std::string_view color) {
    constexpr Rgb kUnknown{190, 194, 198};
    Material material = painted(parseColor(color).value_or(kUnknown), 0.45F);
    if (color == "metal") {
        material.roughness = 0.32F;
        material.metal = 0.85F;
    } else if (color == "link") {
        material.roughness = 0.38F;
        material.metal = 0.6F;
    } else if (color == "solar") {
        material.roughness = 0.16F;
    } else if (color == "tyre") {
        material.roughness = 0.85F;
    }
    return material;
}

}  // namespace render
