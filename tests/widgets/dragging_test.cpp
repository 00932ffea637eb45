// Moving parts of the rover with the mouse in the 3-D view of the real window.
#include <QAction>

#include <gmock/gmock.h>

#include "simcore/io/project_file.h"
#include "tests/support/studio.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/session/statics_session.h"
#include "widgets/viewport/drawing_overlay.h"
#include "widgets/window/drag_editor.h"

using render::Vec3;
using simcore::project::Handle;
using simcore::project::HandleKind;
using testing::HasSubstr;
using testsupport::waitUntil;

namespace {

class DraggingTest : public testsupport::StudioTest {
  protected:
    DraggingTest() {
        if (view() == nullptr) {
            return;
        }
        window->actions().at("orthographic")->setChecked(true);
        press(Qt::Key_2, Qt::ControlModifier);  // from the right side
        press(Qt::Key_M);
    }

    widgets::Viewport* view() { return window->viewport(); }

    widgets::DragEditor& editor() { return *window->dragEditor(); }

    Handle handle(HandleKind kind, const std::string& name) {
        for (const Handle& one : editor().handles()) {
            if (one.kind == kind && (one.name == name || kind == HandleKind::CenterOfMass)) {
                return one;
            }
        }
        ADD_FAILURE() << "no handle " << name;
        return {};
    }

    QPoint pixel(const Vec3& place) { return view()->projection().toPixel(place)->toPoint(); }

    void moveMouse(const QPoint& at, Qt::MouseButtons buttons,
                   Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QMouseEvent move(QEvent::MouseMove, at, view()->mapToGlobal(at), Qt::NoButton, buttons,
                         modifiers);
        QApplication::sendEvent(view(), &move);
    }

    /// Takes hold of a handle and moves it by a way in the world, without letting go.
    void take(const Handle& what, const Vec3& way,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const QPoint from = pixel(what.position);
        const QPoint to = pixel(what.position + way);
        moveMouse(from, Qt::NoButton);
        QTest::mousePress(view(), Qt::LeftButton, modifiers, from);
        for (int i = 1; i <= 4; ++i) {
            moveMouse(from + (to - from) * i / 4, Qt::LeftButton, modifiers);
        }
    }

    void letGo(const Handle& what, const Vec3& way) {
        QTest::mouseRelease(view(), Qt::LeftButton, {}, pixel(what.position + way));
    }

    std::string text() const { return simcore::io::formatProject(window->document().project()); }

    Vec3 centreOfMass() const { return window->document().derived().mechanism->centerOfMass(); }
};

}  // namespace

TEST_F(DraggingTest, AWheelMovesByItsParameterAndOneUndoTakesItBack) {
    const std::string before = text();
    const double x = parameterValue("front_wheel_x");
    const Handle front = handle(HandleKind::Wheel, "front");
    take(front, {0.04, 0.0, 0.0});
    EXPECT_NEAR(parameterValue("front_wheel_x"), x + 0.04, 0.006);
    // Snapped to 5 mm.
    const double reached = window->document().derived().mechanism->wheels[0].center.x();
    EXPECT_NEAR(std::remainder(reached, 0.005), 0.0, 1e-9);
    EXPECT_THAT(view()->overlay().note().toStdString(), HasSubstr("front_wheel_x"));
    letGo(front, {0.04, 0.0, 0.0});
    EXPECT_EQ(window->document().undoStack().count(), 1);
    EXPECT_EQ(window->document().undoStack().undoText(), "Move wheel front");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(text(), before);
}

TEST_F(DraggingTest, EscapeTakesADragBack) {
    const std::string before = text();
    const Handle front = handle(HandleKind::Wheel, "front");
    take(front, {0.05, 0.0, 0.0});
    EXPECT_NE(text(), before);
    QTest::keyClick(view(), Qt::Key_Escape);
    EXPECT_EQ(text(), before);
    EXPECT_FALSE(editor().isDragging());
    EXPECT_EQ(window->document().undoStack().count(), 0);
    letGo(front, {0.05, 0.0, 0.0});
    EXPECT_EQ(text(), before);
}

TEST_F(DraggingTest, TheCentreOfMassIsDraggedAndMassStays) {
    const Handle com = handle(HandleKind::CenterOfMass, "");
    const double mass = window->document().derived().mechanism->mass();
    take(com, {-0.03, 0.0, 0.02});
    EXPECT_NEAR(centreOfMass().x(), com.position.x() - 0.03, 0.006);
    EXPECT_NEAR(centreOfMass().z(), com.position.z() + 0.02, 0.006);
    EXPECT_NEAR(centreOfMass().y(), com.position.y(), 1e-12);
    EXPECT_EQ(window->document().derived().mechanism->mass(), mass);
    letGo(com, {-0.03, 0.0, 0.02});
    EXPECT_EQ(window->document().undoStack().count(), 1);
}

// While one drags, the statics of the new design come.
TEST_F(DraggingTest, RequiredFrictionFollowsTheCentreOfMass) {
    press(Qt::Key_T, Qt::ControlModifier);
    ASSERT_TRUE(waitUntil([&] { return window->statics().shown() != nullptr; }));
    ASSERT_TRUE(waitUntil([&] { return !window->statics().isWorking(); }, 60000));
    const double rear = window->statics().shown()->study.wheels.back().normal;
    const Handle com = handle(HandleKind::CenterOfMass, "");
    take(com, {-0.08, 0.0, 0.0});
    EXPECT_TRUE(editor().isDragging());
    EXPECT_TRUE(waitUntil(
        [&] { return window->statics().shown()->study.wheels.back().normal > rear + 1.0; }));
    letGo(com, {-0.08, 0.0, 0.0});
}

TEST_F(DraggingTest, ShiftKeepsToOneAxisAndControlDoesNotSnap) {
    const Handle com = handle(HandleKind::CenterOfMass, "");
    take(com, {0.043, 0.0, 0.01}, Qt::ShiftModifier | Qt::ControlModifier);
    EXPECT_NEAR(centreOfMass().z(), com.position.z(), 1e-12);
    EXPECT_NEAR(centreOfMass().x(), com.position.x() + 0.043,
                2.0 * view()->projection().pixelSize());
    QTest::keyClick(view(), Qt::Key_Escape);
}

TEST_F(DraggingTest, MirroredPartsStaySymmetric) {
    const Handle wheel = handle(HandleKind::Wheel, "bogie_right_front");
    take(wheel, {0.0, 0.0, 0.02}, Qt::AltModifier);
    const auto& wheels = window->document().derived().mechanism->wheels;
    EXPECT_NEAR(wheels[1].center.z(), wheels[3].center.z(), 1e-12);
    EXPECT_GT(wheels[3].center.z(), wheel.position.z() + 0.01);
    QTest::keyClick(view(), Qt::Key_Escape);
}

TEST_F(DraggingTest, AClickOnAHandleSelectsItsPart) {
    const Handle front = handle(HandleKind::Wheel, "front");
    moveMouse(pixel(front.position), Qt::NoButton);
    EXPECT_THAT(view()->overlay().note().toStdString(), HasSubstr("wheel front"));
    QTest::mouseClick(view(), Qt::LeftButton, {}, pixel(front.position));
    EXPECT_EQ(window->document().undoStack().count(), 0);
    EXPECT_EQ(window->findChild<widgets::PartsTree*>()->selected(), front.element);
}

TEST_F(DraggingTest, HandlesGoWhileARunIsShownAndWithTheMode) {
    EXPECT_FALSE(editor().handles().empty());
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return window->session().endTime() > 0.05; }));
    EXPECT_TRUE(editor().handles().empty());
    press(Qt::Key_Space);
    press(Qt::Key_B, Qt::ControlModifier);
    EXPECT_FALSE(editor().handles().empty());
    press(Qt::Key_M);
    EXPECT_TRUE(editor().handles().empty());
    // Dragging looks around again.
    const auto camera = view()->camera();
    const QPoint middle(view()->width() / 2, view()->height() / 2);
    QTest::mousePress(view(), Qt::LeftButton, {}, middle);
    moveMouse(middle + QPoint(60, 20), Qt::LeftButton);
    QTest::mouseRelease(view(), Qt::LeftButton, {}, middle + QPoint(60, 20));
    EXPECT_GT((view()->camera().eye - camera.eye).norm(), 0.05);
}

TEST_F(DraggingTest, WithoutPerspectiveLengthsCanBeReadOff) {
    ASSERT_TRUE(view()->projection().isToScale());
    const auto& wheels = window->document().derived().mechanism->wheels;
    const QPoint front = pixel(wheels.front().center);
    const QPoint rear = pixel(wheels.back().center);
    const double length = view()->projection().pixelSize() * (front.x() - rear.x());
    EXPECT_NEAR(length, wheels.front().center.x() - wheels.back().center.x(),
                2.0 * view()->projection().pixelSize());
    // A ray through a pixel meets what is drawn there.
    const auto ray = view()->projection().rayThrough(front);
    const Vec3 to = wheels.front().center - ray.start;
    EXPECT_LT((to - to.dot(ray.way) * ray.way).norm(), 2.0 * view()->projection().pixelSize());
    window->actions().at("orthographic")->setChecked(false);
    EXPECT_FALSE(view()->projection().isToScale());
    const QPoint drawn = pixel(wheels.front().center);
    const auto again = view()->projection().rayThrough(drawn);
    const Vec3 back = wheels.front().center - again.start;
    EXPECT_LT((back - back.dot(again.way) * again.way).norm(),
              2.0 * view()->projection().pixelSize());
}
