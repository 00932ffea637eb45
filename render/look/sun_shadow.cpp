#include "render/look/sun_shadow.h"

#include <cmath>
#include <osg/CullFace>
#include <osg/PolygonOffset>

#include "render/geometry/mesh_builder.h"
#include "render/look/shaders.h"

namespace render {

SunShadow::SunShadow(int size)
    : matrix_(new osg::Uniform(uniform::kShadowMatrix, osg::Matrixf())),
      texel_(new osg::Uniform(uniform::kShadowTexel, 1.0F / static_cast<float>(size))) {
    camera_->setName("sun");
    camera_->setRenderOrder(osg::Camera::PRE_RENDER);
    camera_->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera_->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera_->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera_->setCullingMode(osg::CullSettings::NO_CULLING);
    camera_->setClearMask(GL_DEPTH_BUFFER_BIT);
    osg::StateSet& state = *camera_->getOrCreateStateSet();
    constexpr auto kForce = osg::StateAttribute::OVERRIDE | osg::StateAttribute::PROTECTED;
    state.setAttributeAndModes(makeDepthProgram(), osg::StateAttribute::ON | kForce);
    state.setAttributeAndModes(new osg::PolygonOffset(1.1F, 4.0F),
                               osg::StateAttribute::ON | kForce);
    makeTexture(size);
}

void SunShadow::makeTexture(int size) {
    texture_ = new osg::Texture2D;
    texture_->setTextureSize(size, size);
    texture_->setInternalFormat(GL_DEPTH_COMPONENT24);
    texture_->setSourceFormat(GL_DEPTH_COMPONENT);
    texture_->setSourceType(GL_UNSIGNED_INT);
    texture_->setShadowComparison(true);
    texture_->setShadowCompareFunc(osg::Texture::LEQUAL);
    texture_->setShadowTextureMode(osg::Texture::LUMINANCE);
    texture_->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture_->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture_->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture_->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    camera_->detach(osg::Camera::DEPTH_BUFFER);
    camera_->attach(osg::Camera::DEPTH_BUFFER, texture_.get());
    camera_->setViewport(0, 0, size, size);
    camera_->setRenderingCache(nullptr);  // makes the frame buffer anew
    texel_->set(1.0F / static_cast<float>(size));
}

void SunShadow::attach(osg::StateSet& receivers) {
    receivers_ = &receivers;
    receivers.setTextureAttribute(kShadowUnit, texture_);
    receivers.addUniform(new osg::Uniform(uniform::kShadowMap, kShadowUnit));
    receivers.addUniform(matrix_);
    receivers.addUniform(texel_);
}

void SunShadow::setEnabled(osg::StateSet& receivers, bool enabled, bool fourTaps) {
    camera_->setNodeMask(enabled ? ~0U : 0U);
    for (const auto& [define, on] : {std::pair{"SHADOWS", enabled}, std::pair{"PCF", fourTaps}}) {
        if (on) {
            receivers.setDefine(define);
        } else {
            receivers.removeDefine(define);
        }
    }
}

void SunShadow::resize(int size) {
    if (texture_->getTextureWidth() != size) {
        makeTexture(size);
        if (receivers_ != nullptr) {
            receivers_->setTextureAttribute(kShadowUnit, texture_);
        }
    }
}

void SunShadow::cover(const simcore::Vec3& center, double radius) {
    const osg::Vec3d sun = sunDirection();
    const double size = texture_->getTextureWidth();
    osg::Matrixd view = osg::Matrixd::lookAt(osg::Vec3d(), -sun, osg::Vec3d(1, 0, 0));
    // Moving by whole texels keeps the shadow's edge still while the rover drives.
    const double texel = 2.0 * radius / size;
    osg::Vec3d middle = osg::Vec3d(toOsg(center)) * view;
    middle.x() = std::floor(middle.x() / texel) * texel;
    middle.y() = std::floor(middle.y() / texel) * texel;
    const double depth = radius + 4.0;  // ground may lie well below the rover's ball
    const osg::Matrixd projection =
        osg::Matrixd::ortho(middle.x() - radius, middle.x() + radius, middle.y() - radius,
                            middle.y() + radius, -middle.z() - depth, -middle.z() + depth);
    camera_->setViewMatrix(view);
    camera_->setProjectionMatrix(projection);
    matrix_->set(osg::Matrixf(view * projection * osg::Matrixd::translate(1, 1, 1) *
                              osg::Matrixd::scale(0.5, 0.5, 0.5)));
}

}  // namespace render
