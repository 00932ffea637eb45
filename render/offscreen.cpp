#define GL_GLEXT_PROTOTYPES
#define EGL_EGLEXT_PROTOTYPES
#include "render/offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

#include <cstring>
#include <osg/Image>
#include <osgDB/WriteFile>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>
#include <stdexcept>

#include "simcore/base/text.h"

namespace render {

namespace {

/// A frame buffer object with colour, and depth with stencil.
class Target {
  public:
    Target(int width, int height, int samples) {
        glGenFramebuffers(1, &frame_);
        glBindFramebuffer(GL_FRAMEBUFFER, frame_);
        attach(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0, width, height, samples);
        attach(depth_, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, width, height, samples);
        complete_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }

    ~Target() {
        glDeleteFramebuffers(1, &frame_);
        glDeleteRenderbuffers(1, &color_);
        glDeleteRenderbuffers(1, &depth_);
    }

    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    GLuint id() const { return frame_; }

    bool complete() const { return complete_; }

  private:
    static void attach(GLuint& buffer, GLenum format, GLenum place, int width, int height,
                       int samples) {
        glGenRenderbuffers(1, &buffer);
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    }

    GLuint frame_ = 0, color_ = 0, depth_ = 0;
    bool complete_ = false;
};

simcore::Problem noOpenGl(const std::string& reason) {
    return {simcore::Severity::Critical, simcore::Text::of("picture"), reason,
            simcore::Text::of("Install an OpenGL driver with EGL, e.g. Mesa's software renderer.")};
}

}  // namespace

struct OffscreenRenderer::Impl {
    int width = 0, height = 0, samples = 0;
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE;
    std::string name;
    std::unique_ptr<Target> drawn, resolved;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window;
    osg::ref_ptr<osgViewer::Viewer> viewer;

    /// Empty when there is a context now, else the reason.
    std::string makeContext();
    std::string makeTargets();
    void makeViewer();

    void makeCurrent() const { eglMakeCurrent(display, surface, surface, context); }

    ~Impl();
};

std::string OffscreenRenderer::Impl::makeContext() {
    const auto getDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (getDisplay == nullptr) {
        return simcore::Text::of("This machine's EGL has no platform displays.");
    }
    display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
        return simcore::Text::of("EGL's surfaceless platform is not available.");
    }
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_SURFACE_TYPE,
                             EGL_PBUFFER_BIT,
                             EGL_RENDERABLE_TYPE,
                             EGL_OPENGL_BIT,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &found) != EGL_TRUE || found == 0) {
        return simcore::Text::of("EGL offers no configuration for OpenGL.");
    }
    const EGLint size[] = {EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    surface = eglCreatePbufferSurface(display, config, size);
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (context == EGL_NO_CONTEXT ||
        eglMakeCurrent(display, surface, surface, context) != EGL_TRUE) {
        return simcore::Text::of("No OpenGL context could be made.");
    }
    name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return {};
}

std::string OffscreenRenderer::Impl::makeTargets() {
    drawn = std::make_unique<Target>(width, height, samples);
    if (samples > 0) {
        resolved = std::make_unique<Target>(width, height, 0);
    }
    const bool complete = drawn->complete() && (resolved == nullptr || resolved->complete());
    return complete ? std::string()
                    : simcore::Text::of("The frame buffer for the picture could not be made.");
}

void OffscreenRenderer::Impl::makeViewer() {
    window = new osgViewer::GraphicsWindowEmbedded(0, 0, width, height);
    window->setDefaultFboId(drawn->id());
    viewer = new osgViewer::Viewer;
    viewer->setThreadingModel(osgViewer::Viewer::SingleThreaded);
    viewer->setLightingMode(osg::View::NO_LIGHT);
    viewer->setKeyEventSetsDone(0);
    viewer->setReleaseContextAtEndOfFrameHint(false);
    osg::Camera& camera = *viewer->getCamera();
    camera.setGraphicsContext(window);
    camera.setDrawBuffer(GL_COLOR_ATTACHMENT0);
    camera.setReadBuffer(GL_COLOR_ATTACHMENT0);
    viewer->realize();
}

OffscreenRenderer::Impl::~Impl() {
    if (context != EGL_NO_CONTEXT) {
        makeCurrent();
        if (viewer != nullptr) {
            if (viewer->getSceneData() != nullptr) {
                viewer->getSceneData()->releaseGLObjects(window->getState());
            }
            viewer->setSceneData(nullptr);
            viewer->getCamera()->releaseGLObjects(window->getState());
            viewer->getCamera()->setGraphicsContext(nullptr);
            const unsigned id = window->getState()->getContextID();
            osg::flushAllDeletedGLObjects(id);
            osg::discardAllGLObjects(id);
            window->close();
        }
        viewer = nullptr;
        window = nullptr;
        drawn.reset();
        resolved.reset();
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
    if (surface != EGL_NO_SURFACE) {
        eglDestroySurface(display, surface);
    }
}

OffscreenRenderer::OffscreenRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

OffscreenRenderer::~OffscreenRenderer() = default;

simcore::Result<std::unique_ptr<OffscreenRenderer>> OffscreenRenderer::create(int width, int height,
                                                                              int samples) {
    if (width <= 0 || height <= 0 || samples < 0) {
        throw std::invalid_argument("A picture needs a positive size.");
    }
    auto impl = std::make_unique<Impl>();
    impl->width = width;
    impl->height = height;
    impl->samples = samples;
    std::string reason = impl->makeContext();
    if (reason.empty()) {
        reason = impl->makeTargets();
    }
    if (!reason.empty()) {
        return noOpenGl(reason);
    }
    impl->makeViewer();
    return std::unique_ptr<OffscreenRenderer>(new OffscreenRenderer(std::move(impl)));
}

const std::string& OffscreenRenderer::rendererName() const {
    return impl_->name;
}

double OffscreenRenderer::aspect() const {
    return static_cast<double>(impl_->width) / impl_->height;
}

void OffscreenRenderer::drawOnly(Scene& scene, const CameraPose& pose) {
    impl_->makeCurrent();
    osgViewer::Viewer& viewer = *impl_->viewer;
    if (viewer.getSceneData() != scene.root()) {
        if (viewer.getSceneData() != nullptr) {
            viewer.getSceneData()->releaseGLObjects(impl_->window->getState());
        }
        viewer.setSceneData(scene.root());
    }
    setupCamera(*viewer.getCamera(), pose, impl_->width, impl_->height);
    viewer.frame();
    glFinish();
}

Image OffscreenRenderer::draw(Scene& scene, const CameraPose& pose) {
    drawOnly(scene, pose);
    const int width = impl_->width, height = impl_->height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->drawn->id());
    if (impl_->resolved != nullptr) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, impl_->resolved->id());
        glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                          GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, impl_->resolved->id());
    }
    const std::size_t row = static_cast<std::size_t>(width) * 4;
    std::vector<std::uint8_t> upward(row * static_cast<std::size_t>(height));
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upward.data());
    Image image{width, height, std::vector<std::uint8_t>(upward.size())};
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        std::memcpy(&image.rgba[y * row], &upward[(static_cast<std::size_t>(height) - 1 - y) * row],
                    row);
    }
    return image;
}

simcore::Problems writePng(const Image& image, const std::filesystem::path& file) {
    osg::ref_ptr<osg::Image> rgb = new osg::Image;
    rgb->allocateImage(image.width, image.height, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::size_t from = 4 * (static_cast<std::size_t>(y) * image.width + x);
            std::memcpy(rgb->data(x, image.height - 1 - y), &image.rgba[from], 3);
        }
    }
    if (!osgDB::writeImageFile(*rgb, file.string())) {
        return {{simcore::Severity::Critical, file.string(),
                 simcore::Text::of("The picture could not be written."),
                 simcore::Text::of("Check that the folder exists and can be written, and that the "
                                   "name ends in .png.")}};
    }
    return {};
}

}  // namespace render
