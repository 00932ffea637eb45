#include "render/look/sky.h"

#include <algorithm>
#include <cstdint>
#include <osg/Depth>
#include <osg/Geode>
#include <osg/Geometry>
#include <random>
#include <utility>
#include <vector>

#include "render/look/shaders.h"

namespace render {

osg::ref_ptr<osg::Node> makeSky() {
    osg::ref_ptr<osg::Geometry> quad = new osg::Geometry;
    quad->setUseDisplayList(false);
    quad->setUseVertexBufferObjects(true);
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        corners->push_back(osg::Vec3(static_cast<float>(x), static_cast<float>(y), 0.0F));
    }
    quad->setVertexArray(corners);
    quad->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));
    quad->setCullingActive(false);
    osg::StateSet& state = *quad->getOrCreateStateSet();
    state.setAttributeAndModes(makeSkyProgram());
    state.setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 1.0, 1.0, false));
    state.setRenderBinDetails(5, "RenderBin");
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(quad);
    geode->setCullingActive(false);
    return geode;
}

osg::ref_ptr<osg::Texture2D> makeNoiseTexture() {
    constexpr int kSize = 256;
    std::mt19937 generator(7);
    std::vector<float> sum(kSize * kSize, 0.0F);
    float weight = 0.5F;
    for (int cells = 16; cells <= kSize; cells *= 2, weight *= 0.72F) {
        std::vector<float> lattice(static_cast<std::size_t>(cells) * cells);
        for (float& value : lattice) {
            value = static_cast<float>(generator() >> 8) / static_cast<float>(1U << 24) - 0.5F;
        }
        const auto at = [&](int x, int y) {
            return lattice[static_cast<std::size_t>(y % cells) * cells + x % cells];
        };
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                const float fx = static_cast<float>(x * cells) / kSize;
                const float fy = static_cast<float>(y * cells) / kSize;
                const int ix = static_cast<int>(fx), iy = static_cast<int>(fy);
                float u = fx - static_cast<float>(ix), v = fy - static_cast<float>(iy);
                u = u * u * (3.0F - 2.0F * u);
                v = v * v * (3.0F - 2.0F * v);
                const float low = at(ix, iy) * (1.0F - u) + at(ix + 1, iy) * u;
                const float high = at(ix, iy + 1) * (1.0F - u) + at(ix + 1, iy + 1) * u;
                sum[static_cast<std::size_t>(y) * kSize + x] +=
                    weight * (low * (1.0F - v) + high * v);
            }
        }
    }
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kSize, kSize, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    for (std::size_t i = 0; i < sum.size(); ++i) {
        image->data()[i] =
            static_cast<std::uint8_t>(std::clamp(127.5F + 170.0F * sum[i], 0.0F, 255.0F));
    }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
    // Not between two sizes: with software rendering that costs a tenth of the frame.
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

}  // namespace render
