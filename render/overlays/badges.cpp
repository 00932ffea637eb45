#include "render/overlays/badges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <osg/Geometry>
#include <osg/Point>
#include <osg/PointSprite>
#include <osg/Texture2D>

#include "render/geometry/mesh_builder.h"
#include "render/look/shaders.h"

namespace render {

namespace {

constexpr int kTile = 64;
constexpr int kDigits = 8;
constexpr int kTextureUnit = 3;

using Point = Eigen::Vector2d;
using Stroke = std::vector<Point>;

/// Arc of an ellipse, angles in degrees from +x, counter-clockwise.
Stroke arc(const Point& center, double rx, double ry, double from, double to) {
    Stroke stroke;
    for (int i = 0; i <= 16; ++i) {
        const double a = (from + (to - from) * i / 16) * std::numbers::pi / 180.0;
        stroke.emplace_back(center.x() + rx * std::cos(a), center.y() + ry * std::sin(a));
    }
    return stroke;
}

/// The lines of a digit; x in -0.6..0.6, y (up) in -1..1.
std::vector<Stroke> strokesOf(int digit) {
    switch (digit) {
        case 0:
            return {arc({0, 0}, 0.58, 1.0, 0, 360)};
        case 1:
            return {{{-0.38, 0.62}, {0.08, 1.0}, {0.08, -1.0}}};
        case 2: {
            Stroke top = arc({0, 0.45}, 0.56, 0.55, 165, -38);
            top.emplace_back(-0.56, -1.0);
            top.emplace_back(0.6, -1.0);
            return {top};
        }
        case 3:
            return {arc({0, 0.5}, 0.5, 0.5, 150, -90), arc({0, -0.46}, 0.58, 0.54, 90, -155)};
        case 4:
            return {{{0.28, -1.0}, {0.28, 1.0}, {-0.62, -0.42}, {0.66, -0.42}}};
        case 5: {
            Stroke bowl = arc({0, -0.36}, 0.58, 0.64, 128, -150);
            bowl.insert(bowl.begin(), {{0.5, 1.0}, {-0.42, 1.0}, {-0.5, 0.06}});
            return {bowl};
        }
        case 6:
            return {arc({0, -0.4}, 0.58, 0.6, 0, 360), arc({0.5, -0.3}, 1.08, 1.35, 108, 176)};
        default:
            return {{{-0.58, 1.0}, {0.58, 1.0}, {-0.2, -1.0}}};
    }
}

double distanceTo(const std::vector<Stroke>& strokes, const Point& p) {
    double nearest = 10.0;
    for (const Stroke& stroke : strokes) {
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
            const Point along = stroke[i + 1] - stroke[i];
            const double t = std::clamp((p - stroke[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (p - stroke[i] - t * along).norm());
        }
    }
    return nearest;
}

/// All digits side by side: white on a dark disc with a light rim.
osg::ref_ptr<osg::Texture2D> makeGlyphs() {
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(kTile * kDigits, kTile, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int digit = 0; digit < kDigits; ++digit) {
        const std::vector<Stroke> strokes = strokesOf(digit);
        for (int y = 0; y < kTile; ++y) {
            for (int x = 0; x < kTile; ++x) {
                // Row 0 is the top: point sprites count downwards.
                const Point p((x + 0.5) * 2.0 / kTile - 1.0, 1.0 - (y + 0.5) * 2.0 / kTile);
                const double soft = 2.5 / kTile;
                const auto inside = [&](double d) { return std::clamp(0.5 - d / soft, 0.0, 1.0); };
                const double ink = inside((distanceTo(strokes, p / 0.46) - 0.17) * 0.46);
                const double rim = 1.0 - inside(p.norm() - 0.82);
                const double white = std::max(ink, rim);
                const Point dark(0.10, 0.13);
                std::uint8_t* texel = image->data(digit * kTile + x, y);
                const auto byte = [](double v) {
                    return static_cast<std::uint8_t>(std::lround(255.0 * v));
                };
                texel[0] = byte(dark.x() + (1.0 - dark.x()) * white);
                texel[1] = byte(dark.y() + (1.0 - dark.y()) * white);
                texel[2] = byte(0.20 + 0.80 * white);
                texel[3] = byte(inside(p.norm() - 0.95));
            }
        }
    }
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    return texture;
}

}  // namespace

BadgeNode::BadgeNode() {
    osg::StateSet& state = *geode_->getOrCreateStateSet();
    state.setAttributeAndModes(makeBadgeProgram());
    state.setTextureAttribute(kTextureUnit, makeGlyphs());
    state.addUniform(new osg::Uniform("glyphs", kTextureUnit));
    state.setTextureAttributeAndModes(kTextureUnit, new osg::PointSprite);
    makeBlended(state, 30, false);
}

void BadgeNode::set(const std::vector<Badge>& badges, float size) {
    geode_->removeDrawables(0, geode_->getNumDrawables());
    if (badges.empty()) {
        return;
    }
    osg::ref_ptr<osg::Vec3Array> places = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4ubArray> glyphs = new osg::Vec4ubArray;
    for (const Badge& badge : badges) {
        places->push_back(toOsg(badge.place));
        const int digit = std::clamp(badge.digit, 0, kDigits - 1);
        glyphs->push_back(osg::Vec4ub(static_cast<std::uint8_t>(digit), 0, 0, 255));
    }
    glyphs->setNormalize(true);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(places);
    geometry->setColorArray(glyphs, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_POINTS, 0, static_cast<int>(places->size())));
    geode_->addDrawable(geometry);
    geode_->getOrCreateStateSet()->setAttribute(new osg::Point(size));
}

}  // namespace render
