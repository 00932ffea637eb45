#pragma once

#include <QObject>
#include <map>
#include <optional>

#include "simcore/project/handles.h"
#include "widgets/document/document.h"
#include "widgets/viewport/viewport.h"

namespace widgets {

/// Moves parts of the rover with the mouse in the 3-D view: handles on joints, wheels, payloads and
/// centres of mass, in the plane of the axes that is seen best. A drag is one step of undo; Escape
/// takes it back. Coordinates snap to 5 mm, not with Ctrl; Shift keeps to one axis; with Alt
/// expressions become numbers.
class DragEditor : public QObject {
    Q_OBJECT
  public:
    DragEditor(Document* document, Viewport* viewport, QObject* parent = nullptr);

    bool isActive() const { return active_; }

    bool isDragging() const { return drag_.has_value(); }

    void setActive(bool active);
    /// The rover is drawn as designed: only then the handles are where they are shown.
    void setDesignShown(bool shown);

    const std::vector<simcore::project::Handle>& handles() const { return handles_; }

    /// Which parameter a coordinate of several is to move, when asked; for tests in place of the
    /// menu.
    void choose(const simcore::project::Handle& handle, int axis, const std::string& parameter);

  signals:
    /// A handle was clicked.
    void elementChosen(simcore::project::ElementRef element);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Drag {
        simcore::project::Handle handle;
        simcore::project::Project before;
        render::Vec3 start;  ///< where the plane was taken hold of
        QString key;
        bool moved = false;
    };

    bool shows() const { return active_ && designShown_; }

    void refresh();
    void showMarks();
    void showDimensions();
    void hover(const QPointF& position);
    bool press(QMouseEvent* event);
    void move(QMouseEvent* event);
    void release();
    void cancel();
    bool askForParameters(const simcore::project::Handle& handle, const QPoint& place);
    int handleAt(const QPointF& position) const;
    std::optional<render::Vec3> onPlane(const QPointF& position, const render::Vec3& through) const;
    QString noteFor(const simcore::project::Dragged& result) const;

    Document* document_;
    Viewport* viewport_;
    std::vector<simcore::project::Handle> handles_;
    int hot_ = -1;
    bool active_ = false;
    bool designShown_ = true;
    std::optional<Drag> drag_;
    int drags_ = 0;
    /// By name of the handle: parameters chosen for its axes.
    std::map<std::string, std::map<int, std::string>> choices_;
};

}  // namespace widgets
