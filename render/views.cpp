#include <algorithm>
#include <cmath>
#include <numbers>
#include <osg/Camera>

#include "render/scene.h"

namespace render {

namespace {

constexpr double kNear = 0.05, kFar = 150.0;  // [m]

/// Distance at which a ball of this radius fills the picture, with a margin [m].
double fittingDistance(double radius, double aspect) {
    const double half = 0.5 * kFieldOfView * std::numbers::pi / 180.0;
    const double narrow = aspect < 1.0 ? std::atan(std::tan(half) * aspect) : half;
    return 0.92 * radius / std::sin(narrow);
}

osg::Vec3d toOsgDouble(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

CameraPose Scene::view(View view, double aspect) const {
    CameraPose camera;
    camera.center = focus();
    Vec3 back;
    switch (view) {
        case View::Front:
            back = Vec3(1.0, 0.0, 0.08);
            break;
        case View::Side:
            back = Vec3(0.0, -1.0, 0.08);
            break;
        case View::Top:
            back = Vec3(0.0, 0.0, 1.0);
            camera.up = Vec3::UnitX();
            break;
        case View::Iso:
            back = Vec3(0.62, -1.0, 0.46);
            break;
        case View::Overview:
            back = Vec3(-0.22, -1.0, 0.44);
            break;
    }
    camera.eye = camera.center + back.normalized();
    camera = fitted(camera, aspect);
    if (view == View::Overview) {
        // The rover stands in the rear half of the picture, the obstacles before it; in a narrow
        // picture there is less room for them.
        constexpr double kFarther = 1.25;
        const double half = 0.5 * kFieldOfView * std::numbers::pi / 180.0;
        const double room =
            kFarther * fittingDistance(focusRadius(), aspect) * std::tan(half) * aspect -
            focusRadius();
        const double shift = std::clamp(room, 0.0, 0.9 * focusRadius());
        const Vec3 ahead(shift, 0.0, -shift / 9.0);
        camera.center += ahead;
        camera.eye = camera.center + kFarther * (camera.eye + ahead - camera.center);
    }
    return camera;
}

CameraPose Scene::fitted(const CameraPose& camera, double aspect) const {
    CameraPose result = camera;
    const Vec3 back = (camera.eye - camera.center).normalized();
    result.center = focus();
    result.eye = result.center + fittingDistance(focusRadius(), aspect) * back;
    return result;
}

void setupCamera(osg::Camera& camera, const CameraPose& pose, int width, int height) {
    camera.setViewport(0, 0, width, height);
    camera.setViewMatrixAsLookAt(toOsgDouble(pose.eye), toOsgDouble(pose.center),
                                 toOsgDouble(pose.up));
    const double aspect = static_cast<double>(width) / height;
    if (pose.orthographic) {
        const double half = (pose.center - pose.eye).norm() *
                            std::tan(0.5 * kFieldOfView * std::numbers::pi / 180.0);
        camera.setProjectionMatrixAsOrtho(-half * aspect, half * aspect, -half, half, kNear, kFar);
    } else {
        camera.setProjectionMatrixAsPerspective(kFieldOfView, aspect, kNear, kFar);
    }
    camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera.setCullingMode(camera.getCullingMode() & ~osg::CullSettings::SMALL_FEATURE_CULLING);
    camera.setClearColor(osg::Vec4(0.5F, 0.5F, 0.5F, 1.0F));
}

}  // namespace render
