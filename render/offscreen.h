#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/scene.h"
#include "simcore/base/result.h"

/// Pictures without a window: no X server, no Qt.
namespace render {

/// 8-bit RGBA, rows from the top.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// Draws scenes into memory with EGL's surfaceless platform. One thread makes, uses and destroys
/// it; scenes drawn with it must be gone, or never drawn again, when it is destroyed.
class OffscreenRenderer {
  public:
    /// `samples` 0 or 4 for multisampling. Fails when the machine has no EGL or OpenGL 2.1.
    static simcore::Result<std::unique_ptr<OffscreenRenderer>> create(int width, int height,
                                                                      int samples = 0);
    ~OffscreenRenderer();
    OffscreenRenderer(const OffscreenRenderer&) = delete;
    OffscreenRenderer& operator=(const OffscreenRenderer&) = delete;

    Image draw(Scene& scene, const CameraPose& camera);
    /// Draws without reading the pixels back, and waits until they are there: to measure.
    void drawOnly(Scene& scene, const CameraPose& camera);
    /// GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
    const std::string& rendererName() const;
    double aspect() const;

  private:
    struct Impl;
    explicit OffscreenRenderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// Writes a PNG file (8-bit RGB); the problems when that fails.
simcore::Problems writePng(const Image& image, const std::filesystem::path& file);

}  // namespace render
