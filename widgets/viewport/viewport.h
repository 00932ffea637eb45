#pragma once

#include <QImage>
#include <QOpenGLWidget>
#include <memory>

#include "render/scene.h"
#include "widgets/viewport/projection.h"

namespace widgets {

class DrawingOverlay;

/// Shows a render::Scene and lets the user look around in it: left drag orbits, middle, right or
/// shift + left drag pans, the wheel zooms, a double click puts the clicked point in the middle, a
/// click picks. Redraws only when asked.
///
/// Scene and viewport live on the GUI thread; after changing the scene call requestRedraw().
class Viewport : public QOpenGLWidget {
    Q_OBJECT
  public:
    explicit Viewport(std::shared_ptr<render::Scene> scene, QWidget* parent = nullptr);
    ~Viewport() override;

    render::Scene& scene() { return *scene_; }

    const render::CameraPose& camera() const { return camera_; }

    bool follows() const { return follow_; }

    Projection projection() const { return {camera_, size()}; }

    /// What is drawn over the picture; owned by the viewport.
    DrawingOverlay& overlay() { return *overlay_; }

    /// The view as it would be shown now; empty when there is no OpenGL.
    QImage grabImage();

    QSize sizeHint() const override { return {800, 600}; }

    QSize minimumSizeHint() const override { return {240, 180}; }

  public slots:
    void requestRedraw();
    void viewFront();
    void viewSide();
    void viewTop();
    void viewIso();
    /// The rover and the ground ahead of it.
    void viewOverview();
    /// Brings the whole rover into view, from the present direction.
    void fit();
    /// Keeps the rover at its place in the picture while it drives.
    void setFollow(bool follow);
    /// The camera stays where it is, whatever the rover does, until it is let go.
    void setHeld(bool held);
    /// Without perspective, front, side and top look exactly along an axis, with rulers.
    void setOrthographic(bool on);

  signals:
    /// Index in the mechanism; `more`: beside what is selected (Ctrl).
    void jointPicked(int joint, bool more = false);
    /// Index in the mechanism; -1: the click hit no rover.
    void bodyPicked(int body, bool more = false);
    void frameDrawn(double milliseconds);

  protected:
    void changeEvent(QEvent* event) override;
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    struct Gl;
    double aspect() const;
    double labelSize() const;
    void straighten();
    void showView(render::View view);
    void followRover();
    render::Pick pickAt(const QPointF& position) const;
    void releaseGl();

    std::shared_ptr<render::Scene> scene_;
    std::unique_ptr<Gl> gl_;
    DrawingOverlay* overlay_ = nullptr;
    render::CameraPose camera_;
    render::Vec3 followed_ = render::Vec3::Zero();  ///< rover's focus the camera last stood to [m]
    bool follow_ = false;
    bool held_ = false;
    bool placed_ = false;  ///< the camera has been put before a rover
    QPointF pressed_, last_;
    bool dragged_ = false;
};

/// True when this platform plugin can show OpenGL widgets (tested once, by making a context).
bool openGlAvailable();

/// Name of what draws OpenGL here, as the driver gives it; empty when nothing does.
QString openGlRenderer();

/// Call before QApplication is made: surface format and context sharing that the viewport needs.
void prepareOpenGl();

/// A Viewport, or a placeholder with a message when OpenGL is not available: test the result with
/// qobject_cast<Viewport*>.
QWidget* makeViewport(std::shared_ptr<render::Scene> scene, QWidget* parent = nullptr);

}  // namespace widgets
