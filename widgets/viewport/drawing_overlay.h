#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "render/scene.h"
#include "widgets/viewport/projection.h"

namespace widgets {

class Viewport;

/// Something to take hold of, drawn over the picture.
struct HandleMark {
    enum class Shape { CenterOfMass, Round, Ring, Square, Dot };

    Shape shape = Shape::Round;
    render::Vec3 position = render::Vec3::Zero();  ///< world [m]
    bool hot = false;                              ///< under the pointer, or held
};

/// A length between two places, with its number.
struct DimensionLine {
    render::Vec3 from = render::Vec3::Zero();  ///< world [m]
    render::Vec3 to = render::Vec3::Zero();
    QString text;
};

/// Drawn over the 3-D view: handles, dimensions, a note at the pointer; rulers where the view is to
/// scale. Takes no mouse events.
class DrawingOverlay : public QWidget {
    Q_OBJECT
  public:
    explicit DrawingOverlay(Viewport* viewport);

    void setHandles(std::vector<HandleMark> handles);
    void setDimensions(std::vector<DimensionLine> dimensions);
    /// Text beside a place of the world; empty: none.
    void setNote(const QString& text, const render::Vec3& place, bool refused = false);

    QString note() const { return note_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paintRulers(QPainter& painter, const Projection& projection) const;
    void paintDimensions(QPainter& painter, const Projection& projection) const;
    void paintHandles(QPainter& painter, const Projection& projection) const;
    void paintNote(QPainter& painter, const Projection& projection) const;

    Viewport* viewport_;
    std::vector<HandleMark> handles_;
    std::vector<DimensionLine> dimensions_;
    QString note_;
    render::Vec3 notePlace_ = render::Vec3::Zero();
    bool refused_ = false;
};

}  // namespace widgets
