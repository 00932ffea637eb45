#include "widgets/viewport/viewport.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>
#include <QWheelEvent>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

#include "widgets/viewport/drawing_overlay.h"

namespace widgets {
namespace {

using render::CameraPose;
using render::Vec3;

/// What a drag over the whole height of the picture turns the view by [rad], assumed.
constexpr double kTurnPerHeight = 3.5;
constexpr double kZoomPerNotch = 0.88;
constexpr double kLowest = 0.03;           ///< the eye stays this far above the horizon [rad]
constexpr double kNearest = 0.15;          ///< [m]
constexpr double kFarthest = 60.0;         ///< [m]
constexpr double kPickReachPixels = 12.0;  ///< assumed: a finger's care with a mouse

/// The name of what draws; empty when no OpenGL context can be made.
const QString& rendererName() {
    static const QString name = [] {
        QOpenGLContext context;
        QOffscreenSurface surface;
        surface.create();
        // Qt's "offscreen" platform makes contexts but cannot show OpenGL widgets.
        const QString platform = QGuiApplication::platformName();
        const bool showsGl = platform != "offscreen" && platform != "minimal" && platform != "vnc";
        if (!showsGl || !context.create() || !context.makeCurrent(&surface)) {
            return QString();
        }
        const auto* text = context.functions()->glGetString(GL_RENDERER);
        context.doneCurrent();
        return QString::fromLatin1(reinterpret_cast<const char*>(text));
    }();
    return name;
}

bool drawsInSoftware() {
    const QString& name = rendererName();
    return name.contains("llvmpipe") || name.contains("softpipe") || name.contains("swrast");
}

}  // namespace

struct Viewport::Gl {
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window;
    osg::ref_ptr<osgViewer::Viewer> viewer;
};

Viewport::Viewport(std::shared_ptr<render::Scene> scene, QWidget* parent)
    : QOpenGLWidget(parent),
      scene_(std::move(scene)),
      gl_(std::make_unique<Gl>()) {
    setFocusPolicy(Qt::StrongFocus);
    setObjectName("viewport");
    setAccessibleName(tr("3D view"));
    gl_->viewer = new osgViewer::Viewer;
    gl_->viewer->setThreadingModel(osgViewer::Viewer::SingleThreaded);
    gl_->viewer->setKeyEventSetsDone(0);
    gl_->viewer->setReleaseContextAtEndOfFrameHint(false);
    gl_->viewer->setLightingMode(osg::View::NO_LIGHT);
    overlay_ = new DrawingOverlay(this);
    camera_ = scene_->view(render::View::Iso, 1.5);
    followed_ = scene_->focus();
}

Viewport::~Viewport() {
    releaseGl();
}

void Viewport::releaseGl() {
    if (gl_->window == nullptr || context() == nullptr) {
        return;
    }
    disconnect(context(), &QOpenGLContext::aboutToBeDestroyed, this, nullptr);
    makeCurrent();
    if (scene_ != nullptr) {
        scene_->root()->releaseGLObjects(gl_->window->getState());
    }
    gl_->viewer->setSceneData(nullptr);
    gl_->viewer->getCamera()->releaseGLObjects(gl_->window->getState());
    gl_->viewer->getCamera()->setGraphicsContext(nullptr);
    const unsigned id = gl_->window->getState()->getContextID();
    osg::flushAllDeletedGLObjects(id);
    osg::discardAllGLObjects(id);
    gl_->window->close();
    gl_->window = nullptr;
    doneCurrent();
}

void Viewport::initializeGL() {
    // May run again after the widget changed its window: each context gets a graphics window.
    const double ratio = devicePixelRatioF();
    gl_->window = new osgViewer::GraphicsWindowEmbedded(0, 0, static_cast<int>(width() * ratio),
                                                        static_cast<int>(height() * ratio));
    osg::Camera& camera = *gl_->viewer->getCamera();
    camera.setGraphicsContext(gl_->window);
    camera.setDrawBuffer(GL_COLOR_ATTACHMENT0);
    camera.setReadBuffer(GL_COLOR_ATTACHMENT0);
    gl_->viewer->setSceneData(scene_->root());
    gl_->viewer->realize();
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::releaseGl,
            Qt::DirectConnection);
    render::Quality quality;
    quality.pixelRatio = ratio;
    quality.labelSize = labelSize();
    if (!drawsInSoftware()) {
        quality.shadowSize = 2048;
        quality.shadowTaps = 4;
    }
    scene_->setQuality(quality);
}

/// A number at a joint is as high as other text, in its disc.
double Viewport::labelSize() const {
    constexpr double kDiscPerLine = 1.45;
    return kDiscPerLine * fontMetrics().height();
}

void Viewport::changeEvent(QEvent* event) {
    if (event->type() == QEvent::FontChange) {
        render::Quality quality = scene_->quality();
        quality.labelSize = labelSize();
        scene_->setQuality(quality);
        requestRedraw();
    }
    QOpenGLWidget::changeEvent(event);
}

void Viewport::resizeGL(int width, int height) {
    overlay_->setGeometry(0, 0, width, height);
    if (gl_->window == nullptr) {
        return;
    }
    const double ratio = devicePixelRatioF();
    gl_->window->resized(0, 0, static_cast<int>(width * ratio), static_cast<int>(height * ratio));
    if (!placed_) {
        viewOverview();
        placed_ = true;
    }
}

void Viewport::paintGL() {
    if (gl_->window == nullptr) {
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    const double ratio = devicePixelRatioF();
    // Qt makes new frame buffers when the widget moves to another window.
    gl_->window->setDefaultFboId(defaultFramebufferObject());
    render::setupCamera(*gl_->viewer->getCamera(), camera_,
                        std::max(1, static_cast<int>(width() * ratio)),
                        std::max(1, static_cast<int>(height() * ratio)));
    gl_->viewer->frame();
    emit frameDrawn(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
            .count());
}

QImage Viewport::grabImage() {
    return isValid() ? grabFramebuffer() : QImage();
}

double Viewport::aspect() const {
    return static_cast<double>(std::max(width(), 1)) / std::max(height(), 1);
}

void Viewport::requestRedraw() {
    if (follow_ && !held_) {
        followRover();
    }
    update();
}

void Viewport::followRover() {
    const Vec3 move = scene_->focus() - followed_;
    camera_.eye += move;
    camera_.center += move;
    followed_ = scene_->focus();
}

void Viewport::showView(render::View view) {
    const bool orthographic = camera_.orthographic;
    camera_ = scene_->view(view, aspect());
    camera_.orthographic = orthographic;
    if (orthographic && (view == render::View::Front || view == render::View::Side)) {
        straighten();
    }
    followed_ = scene_->focus();
    update();
}

void Viewport::viewFront() {
    showView(render::View::Front);
}

void Viewport::viewSide() {
    showView(render::View::Side);
}

void Viewport::viewTop() {
    showView(render::View::Top);
}

void Viewport::viewIso() {
    showView(render::View::Iso);
}

void Viewport::viewOverview() {
    showView(render::View::Overview);
}

void Viewport::fit() {
    camera_ = scene_->fitted(camera_, aspect());
    followed_ = scene_->focus();
    update();
}

void Viewport::setHeld(bool held) {
    held_ = held;
    followed_ = scene_->focus();
}

void Viewport::straighten() {
    Vec3 back = camera_.eye - camera_.center;
    const double distance = back.norm();
    back.z() = 0.0;
    camera_.eye = camera_.center + distance * back.normalized();
}

void Viewport::setOrthographic(bool on) {
    camera_.orthographic = on;
    update();
}

void Viewport::setFollow(bool follow) {
    follow_ = follow;
    followed_ = scene_->focus();
    if (follow) {
        // Wherever the rover has gone meanwhile, it is to be seen.
        const Vec3 move = scene_->focus() - camera_.center;
        camera_.eye += move;
        camera_.center += move;
    }
    update();
}

namespace {

/// Turns the eye about the centre: `right` about the vertical, `up` over the horizon [rad].
CameraPose orbited(CameraPose camera, double right, double up) {
    const Vec3 back = camera.eye - camera.center;
    const double distance = back.norm();
    // Looking straight down, the direction of "up" tells where the eye comes from.
    Vec3 flat(back.x(), back.y(), 0.0);
    if (flat.norm() < 1e-3 * distance) {
        flat = -Vec3(camera.up.x(), camera.up.y(), 0.0);
    }
    const double azimuth = std::atan2(flat.y(), flat.x()) - right;
    const double elevation =
        std::clamp(std::asin(std::clamp(back.z() / distance, -1.0, 1.0)) + up, kLowest, 1.55);
    camera.eye = camera.center + distance * Vec3(std::cos(elevation) * std::cos(azimuth),
                                                 std::cos(elevation) * std::sin(azimuth),
                                                 std::sin(elevation));
    camera.up = Vec3::UnitZ();
    return camera;
}

}  // namespace

render::Pick Viewport::pickAt(const QPointF& position) const {
    const Projection picture = projection();
    const auto [start, way] = picture.rayThrough(position);
    return scene_->pick(start, start + 100.0 * way, kPickReachPixels * picture.pixelSize());
}

void Viewport::mousePressEvent(QMouseEvent* event) {
    pressed_ = last_ = event->position();
    dragged_ = false;
    event->accept();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) {
        return;
    }
    const QPointF move = event->position() - last_;
    last_ = event->position();
    if ((event->position() - pressed_).manhattanLength() > 4) {
        dragged_ = true;
    }
    if (!dragged_) {
        return;
    }
    const bool orbits = event->buttons().testFlag(Qt::LeftButton) &&
                        !event->modifiers().testFlag(Qt::ShiftModifier);
    if (orbits) {
        const double turn = kTurnPerHeight / std::max(height(), 1);
        camera_ = orbited(camera_, move.x() * turn, move.y() * turn);
    } else {
        const Projection picture = projection();
        const Vec3 shift =
            picture.pixelSize() * (-move.x() * picture.right() + move.y() * picture.up());
        camera_.eye += shift;
        camera_.center += shift;
    }
    update();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
    if (dragged_ || event->button() != Qt::LeftButton) {
        return;
    }
    const render::Pick pick = pickAt(event->position());
    const bool more = event->modifiers().testFlag(Qt::ControlModifier);
    if (pick.joint >= 0) {
        emit jointPicked(pick.joint, more);
    } else {
        emit bodyPicked(pick.body, more);
    }
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
    // The release that follows must not pick again.
    dragged_ = true;
    const render::Pick pick = pickAt(event->position());
    if (pick.point) {
        const Vec3 move = *pick.point - camera_.center;
        camera_.eye += move;
        camera_.center += move;
        update();
    }
}

void Viewport::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    const Vec3 back = camera_.eye - camera_.center;
    const double distance =
        std::clamp(back.norm() * std::pow(kZoomPerNotch, notches), kNearest, kFarthest);
    camera_.eye = camera_.center + back.normalized() * distance;
    update();
    event->accept();
}

bool openGlAvailable() {
    return !rendererName().isEmpty();
}

QString openGlRenderer() {
    return rendererName();
}

void prepareOpenGl() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    // Debian's OpenSceneGraph draws with OpenGL 2; a core profile refuses every call.
    format.setVersion(2, 1);
    format.setProfile(QSurfaceFormat::CompatibilityProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    QSurfaceFormat::setDefaultFormat(format);
    // One context for the widget's life, wherever its window goes.
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

QWidget* makeViewport(std::shared_ptr<render::Scene> scene, QWidget* parent) {
    if (openGlAvailable()) {
        auto* viewport = new Viewport(std::move(scene), parent);
        if (!drawsInSoftware()) {
            QSurfaceFormat format = QSurfaceFormat::defaultFormat();
            format.setSamples(4);
            viewport->setFormat(format);
        }
        return viewport;
    }
    auto* placeholder = new QLabel(
        QCoreApplication::translate("widgets::Viewport",
                                    "<h3>No 3D view</h3><p>OpenGL is not available here. Editing, "
                                    "mobility, runs, plots and export work without it.</p>"
                                    "<p>To see the rover, install an OpenGL driver; on Debian "
                                    "<tt>libgl1-mesa-dri</tt> draws without a graphics card.</p>"),
        parent);
    placeholder->setAlignment(Qt::AlignCenter);
    placeholder->setWordWrap(true);
    placeholder->setMargin(32);
    placeholder->setMinimumSize(240, 180);
    placeholder->setAccessibleName(
        QCoreApplication::translate("widgets::Viewport", "3D view not available"));
    return placeholder;
}

}  // namespace widgets
