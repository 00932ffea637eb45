#include "widgets/window/drag_editor.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "simcore/project/units.h"
#include "widgets/viewport/drawing_overlay.h"

namespace widgets {

using render::Vec3;
using simcore::project::Dragged;
using simcore::project::DragRequest;
using simcore::project::Handle;
using simcore::project::HandleKind;

namespace {

constexpr double kReach = 11.0;  ///< of the pointer to a handle [px]
constexpr double kSnap = 0.005;  ///< [m]
constexpr double kFine = 1e-4;   ///< without snapping [m]
constexpr std::array kAxes{"x", "y", "z"};

HandleMark::Shape shapeOf(HandleKind kind) {
    switch (kind) {
        case HandleKind::CenterOfMass:
            return HandleMark::Shape::CenterOfMass;
        case HandleKind::Wheel:
            return HandleMark::Shape::Ring;
        case HandleKind::Payload:
            return HandleMark::Shape::Square;
        case HandleKind::Body:
            return HandleMark::Shape::Dot;
        case HandleKind::Joint:
            break;
    }
    return HandleMark::Shape::Round;
}

QString titleOf(const Handle& handle) {
    const QString name = QString::fromStdString(handle.name);
    switch (handle.kind) {
        case HandleKind::CenterOfMass:
            return DragEditor::tr("centre of mass of the rover");
        case HandleKind::Body:
            return DragEditor::tr("centre of mass of %1").arg(name);
        case HandleKind::Joint:
            return DragEditor::tr("joint %1").arg(name);
        case HandleKind::Wheel:
            return DragEditor::tr("wheel %1").arg(name);
        case HandleKind::Payload:
            break;
    }
    return DragEditor::tr("payload %1").arg(name);
}

QString millimetres(double value) {
    const QString text = QString::fromStdString(simcore::project::formatIn(value, "mm", 6));
    return text.startsWith('-') ? QChar(0x2212) + text.mid(1) : text;
}

}  // namespace

DragEditor::DragEditor(Document* document, Viewport* viewport, QObject* parent)
    : QObject(parent),
      document_(document),
      viewport_(viewport) {
    viewport_->installEventFilter(this);
    connect(document_, &Document::changed, this, &DragEditor::refresh);
    connect(document_, &Document::replaced, this, [this] {
        drag_.reset();
        choices_.clear();
    });
}

void DragEditor::setActive(bool active) {
    cancel();
    active_ = active;
    viewport_->setMouseTracking(active);
    viewport_->setHeld(active);  // a picture that moves along cannot be drawn in
    refresh();
}

void DragEditor::setDesignShown(bool shown) {
    designShown_ = shown;
    if (!shown) {
        drag_.reset();
    }
    refresh();
}

void DragEditor::choose(const Handle& handle, int axis, const std::string& parameter) {
    choices_[handle.name][axis] = parameter;
}

void DragEditor::refresh() {
    handles_ = shows() ? handlesOf(document_->project()) : std::vector<Handle>();
    if (hot_ >= static_cast<int>(handles_.size())) {
        hot_ = -1;
    }
    showMarks();
    showDimensions();
    if (!drag_) {
        viewport_->overlay().setNote({}, Vec3::Zero());
    }
}

void DragEditor::showMarks() {
    std::vector<HandleMark> marks;
    for (std::size_t i = 0; i < handles_.size(); ++i) {
        marks.push_back(
            {shapeOf(handles_[i].kind), handles_[i].position, static_cast<int>(i) == hot_});
    }
    // The one in use lies on top.
    std::stable_partition(marks.begin(), marks.end(), [](const auto& mark) { return !mark.hot; });
    viewport_->overlay().setHandles(std::move(marks));
}

void DragEditor::showDimensions() {
    std::vector<DimensionLine> lines;
    const auto& mechanism = document_->derived().mechanism;
    if (shows() && mechanism && mechanism->wheels.size() > 1) {
        const auto& wheels = mechanism->wheels;
        const auto outermost = [&](int axis) {
            return std::minmax_element(
                wheels.begin(), wheels.end(),
                [axis](const auto& a, const auto& b) { return a.center[axis] < b.center[axis]; });
        };
        const auto add = [&](int axis, const QString& text) {
            const auto [low, high] = outermost(axis);
            const double length = high->center[axis] - low->center[axis];
            if (length > 1e-6) {
                const Vec3 foot = -low->radius * Vec3::UnitZ();
                Vec3 from = low->center + foot;
                Vec3 to = high->center + foot;
                // Square to the axis, whichever wheels they are.
                for (int other = 0; other < 3; ++other) {
                    if (other != axis) {
                        from[other] = to[other] = std::min(from[other], to[other]);
                    }
                }
                lines.push_back({from, to, text.arg(millimetres(length))});
            }
        };
        add(0, tr("wheelbase %1 mm"));
        add(1, tr("track %1 mm"));
    }
    viewport_->overlay().setDimensions(std::move(lines));
}

int DragEditor::handleAt(const QPointF& position) const {
    const Projection projection = viewport_->projection();
    int found = -1;
    double best = kReach * kReach;
    for (std::size_t i = 0; i < handles_.size(); ++i) {
        const auto at = projection.toPixel(handles_[i].position);
        if (!at) {
            continue;
        }
        const QPointF way = *at - position;
        double distance = QPointF::dotProduct(way, way);
        // Of several at one place the nearer one, and a centre of mass only when nothing else is
        // meant.
        distance += 1e-3 * (handles_[i].position - viewport_->camera().eye).norm();
        distance += handles_[i].kind == HandleKind::Body ? 9.0 : 0.0;
        if (distance < best) {
            best = distance;
            found = static_cast<int>(i);
        }
    }
    return found;
}

std::optional<Vec3> DragEditor::onPlane(const QPointF& position, const Vec3& through) const {
    const Projection projection = viewport_->projection();
    const int axis = projection.depthAxis();
    const auto [start, way] = projection.rayThrough(position);
    const double along = (through[axis] - start[axis]) / way[axis];
    if (!std::isfinite(along) || along < 0.0) {
        return std::nullopt;
    }
    return Vec3(start + along * way);
}

bool DragEditor::eventFilter(QObject* watched, QEvent* event) {
    if (!shows()) {
        return QObject::eventFilter(watched, event);
    }
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            return press(static_cast<QMouseEvent*>(event));
        case QEvent::MouseMove: {
            auto* mouse = static_cast<QMouseEvent*>(event);
            if (drag_) {
                move(mouse);
                return true;
            }
            if (mouse->buttons() == Qt::NoButton) {
                hover(mouse->position());
            }
            return false;
        }
        case QEvent::MouseButtonRelease:
            if (drag_) {
                release();
                return true;
            }
            return false;
        case QEvent::MouseButtonDblClick:
            return handleAt(static_cast<QMouseEvent*>(event)->position()) >= 0;
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
            if (drag_ && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
                event->accept();
                if (event->type() == QEvent::KeyPress) {
                    cancel();
                }
                return true;
            }
            return false;
        case QEvent::Leave:
            hover(QPointF(-1e4, -1e4));
            return false;
        default:
            return QObject::eventFilter(watched, event);
    }
}

void DragEditor::hover(const QPointF& position) {
    const int under = handleAt(position);
    if (under == hot_) {
        return;
    }
    hot_ = under;
    viewport_->setCursor(under >= 0 ? Qt::SizeAllCursor : Qt::ArrowCursor);
    showMarks();
    if (under < 0) {
        viewport_->overlay().setNote({}, Vec3::Zero());
        return;
    }
    const Handle& handle = handles_[static_cast<std::size_t>(under)];
    QStringList lines{titleOf(handle)};
    const auto parameters = parametersOf(document_->project(), handle);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        QStringList names;
        for (const std::string& name : parameters.at(axis)) {
            names << QString::fromStdString(name);
        }
        const double value = handle.position[static_cast<Eigen::Index>(axis)];
        lines << (names.empty() ? tr("%1 %2 mm").arg(kAxes.at(axis), millimetres(value))
                                : tr("%1 %2 mm, by %3")
                                      .arg(kAxes.at(axis), millimetres(value), names.join(", ")));
    }
    viewport_->overlay().setNote(lines.join('\n'), handle.position);
}

bool DragEditor::press(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        return drag_.has_value();
    }
    const int under = handleAt(event->position());
    if (under < 0) {
        return false;
    }
    hot_ = under;
    const Handle handle = handles_[static_cast<std::size_t>(under)];
    const bool replaces = event->modifiers().testFlag(Qt::AltModifier);
    if (!replaces && !askForParameters(handle, event->globalPosition().toPoint())) {
        return true;
    }
    const auto start = onPlane(event->position(), handle.position);
    if (!start) {
        return true;
    }
    document_->endMerging();
    drag_ = Drag{handle, document_->project(), *start, QString("drag:%1").arg(++drags_), false};
    viewport_->setFocus();
    showMarks();
    return true;
}

/// False when a coordinate of several parameters has been asked for: the drag begins anew then.
bool DragEditor::askForParameters(const Handle& handle, const QPoint& place) {
    const auto parameters = parametersOf(document_->project(), handle);
    const int depth = viewport_->projection().depthAxis();
    for (int axis = 0; axis < 3; ++axis) {
        const auto& names = parameters.at(static_cast<std::size_t>(axis));
        auto& chosen = choices_[handle.name];
        if (axis == depth || names.size() < 2 || chosen.count(axis) > 0) {
            continue;
        }
        QMenu menu;
        menu.setObjectName("parameterChoice");
        menu.addSection(
            tr("%1 of %2 moves by").arg(kAxes.at(static_cast<std::size_t>(axis)), titleOf(handle)));
        for (const std::string& name : names) {
            menu.addAction(QString::fromStdString(name));
        }
        const QAction* action = menu.exec(place);
        if (action != nullptr) {
            chosen[axis] = action->text().remove('&').toStdString();
            viewport_->overlay().setNote(
                tr("%1 will move by %2: drag again")
                    .arg(kAxes.at(static_cast<std::size_t>(axis)), action->text()),
                handle.position);
        }
        return false;
    }
    return true;
}

void DragEditor::move(QMouseEvent* event) {
    const auto now = onPlane(event->position(), drag_->handle.position);
    if (!now) {
        return;
    }
    Vec3 way = *now - drag_->start;
    const int depth = viewport_->projection().depthAxis();
    way[depth] = 0.0;
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        Eigen::Index longest = 0;
        way.cwiseAbs().maxCoeff(&longest);
        way = Vec3(way[longest] * Vec3::Unit(longest));
    }
    const double grid = event->modifiers().testFlag(Qt::ControlModifier) ? kFine : kSnap;
    DragRequest request;
    request.replace = event->modifiers().testFlag(Qt::AltModifier);
    if (const auto chosen = choices_.find(drag_->handle.name); chosen != choices_.end()) {
        request.choice = chosen->second;
    }
    request.to = drag_->handle.position;
    for (int axis = 0; axis < 3; ++axis) {
        // What stays about where it was stays as it was written.
        if (std::abs(way[axis]) > 0.5 * grid) {
            request.to[axis] = std::round((drag_->handle.position[axis] + way[axis]) / grid) * grid;
            request.axes.at(static_cast<std::size_t>(axis)) = true;
        }
    }
    const auto result = dragged(drag_->before, drag_->handle, request);
    if (!result) {
        const auto& problem = result.problems().front();
        viewport_->overlay().setNote(QString::fromStdString(problem.reason + "\n" + problem.remedy),
                                     drag_->handle.position, true);
        return;
    }
    drag_->moved = drag_->moved || !(result->project == drag_->before);
    document_->edit(tr("Move %1").arg(titleOf(drag_->handle)), result->project, drag_->key);
    viewport_->overlay().setNote(noteFor(*result), result->reached);
}

QString DragEditor::noteFor(const Dragged& result) const {
    QStringList lines{titleOf(drag_->handle)};
    for (int axis = 0; axis < 3; ++axis) {
        const double way = result.reached[axis] - drag_->handle.position[axis];
        if (std::abs(way) > 1e-9) {
            const QString sign = way > 0.0 ? "+" : "";
            lines << tr("%1 %2 mm (%3)")
                         .arg(kAxes.at(static_cast<std::size_t>(axis)),
                              millimetres(result.reached[axis]), sign + millimetres(way));
        }
    }
    for (const std::string& name : result.parameters) {
        lines << QString::fromStdString(name) + " = " +
                     millimetres(document_->derived().parameters.at(name)) + " mm";
    }
    return lines.join('\n');
}

void DragEditor::release() {
    const bool moved = drag_->moved;
    const auto element = drag_->handle.element;
    drag_.reset();
    document_->endMerging();
    viewport_->overlay().setNote({}, Vec3::Zero());
    if (!moved) {
        emit elementChosen(element);
    }
}

void DragEditor::cancel() {
    if (!drag_) {
        return;
    }
    const Drag drag = *drag_;
    drag_.reset();
    // Back to what was: a step that changes nothing is none.
    document_->edit(tr("Move %1").arg(titleOf(drag.handle)), drag.before, drag.key);
    document_->endMerging();
    viewport_->overlay().setNote({}, Vec3::Zero());
}

}  // namespace widgets
