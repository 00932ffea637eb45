// The 3D view in the real window: orbit, pan, zoom, views, picking.
#include <gmock/gmock.h>

#include "tests/support/studio.h"
#include "widgets/editors/property_panel.h"

using render::Vec3;
using testsupport::waitUntil;

namespace {

class ViewportTest : public testsupport::StudioTest {
  protected:
    widgets::Viewport* view() { return window->viewport(); }

    void drag(Qt::MouseButton button, const QPoint& by) {
        const QPoint start(view()->width() / 2, view()->height() / 2);
        QTest::mousePress(view(), button, {}, start);
        for (int i = 1; i <= 5; ++i) {
            const QPoint at = start + by * i / 5;
            QMouseEvent move(QEvent::MouseMove, at, view()->mapToGlobal(at), Qt::NoButton, button,
                             Qt::NoModifier);
            QApplication::sendEvent(view(), &move);
        }
        QTest::mouseRelease(view(), button, {}, start + by);
    }

    static double distance(const render::CameraPose& camera) {
        return (camera.eye - camera.center).norm();
    }

    /// Where a world point is drawn, in the widget.
    QPoint project(const Vec3& point) {
        const auto& camera = view()->camera();
        const Vec3 ahead = (camera.center - camera.eye).normalized();
        const Vec3 right = ahead.cross(camera.up).normalized();
        const Vec3 up = right.cross(ahead);
        const Vec3 to = point - camera.eye;
        const double scale = 0.5 * view()->height() /
                             std::tan(0.5 * render::kFieldOfView * M_PI / 180.0) / to.dot(ahead);
        return {static_cast<int>(0.5 * view()->width() + scale * to.dot(right)),
                static_cast<int>(0.5 * view()->height() - scale * to.dot(up))};
    }
};

}  // namespace

TEST_F(ViewportTest, LeftDragOrbitsAtTheSameDistance) {
    const auto before = view()->camera();
    drag(Qt::LeftButton, {80, 20});
    const auto& after = view()->camera();
    EXPECT_GT((after.eye - before.eye).norm(), 0.1);
    EXPECT_LT((after.center - before.center).norm(), 1e-9);
    EXPECT_NEAR(distance(after), distance(before), 1e-9);
}

TEST_F(ViewportTest, RightDragPansWithoutTurning) {
    const auto before = view()->camera();
    drag(Qt::RightButton, {60, 30});
    const auto& after = view()->camera();
    EXPECT_GT((after.center - before.center).norm(), 0.02);
    EXPECT_LT(((after.eye - after.center) - (before.eye - before.center)).norm(), 1e-9);
}

TEST_F(ViewportTest, WheelZoomsIn) {
    const double before = distance(view()->camera());
    const QPointF at(view()->width() / 2.0, view()->height() / 2.0);
    QWheelEvent zoom(at, view()->mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(view(), &zoom);
    EXPECT_LT(distance(view()->camera()), 0.9 * before);
}

TEST_F(ViewportTest, StandardViewsLookFromWhereTheySay) {
    const auto direction = [&] {
        const auto& camera = view()->camera();
        return Vec3((camera.eye - camera.center).normalized());
    };
    press(Qt::Key_1, Qt::ControlModifier);
    EXPECT_GT(direction().x(), 0.98);
    press(Qt::Key_2, Qt::ControlModifier);
    EXPECT_LT(direction().y(), -0.98);
    press(Qt::Key_3, Qt::ControlModifier);
    EXPECT_GT(direction().z(), 0.98);
    press(Qt::Key_F);
    EXPECT_LT((view()->camera().center - window->scene().focus()).norm(), 1e-9);
}

TEST_F(ViewportTest, ClickOnAJointSelectsIt) {
    press(Qt::Key_2, Qt::ControlModifier);
    const auto& mechanism = *window->document().derived().mechanism;
    const auto& joint =
        mechanism.joints[static_cast<std::size_t>(mechanism.findJoint("rear_axle"))];
    QTest::mouseClick(view(), Qt::LeftButton, {}, project(joint.point));
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    ASSERT_GE(panel->element().index, 0);
    EXPECT_EQ(nameOf(window->document().project(), panel->element()), "rear_axle");
}

TEST_F(ViewportTest, ClickOnTheSkyClearsTheSelection) {
    press(Qt::Key_2, Qt::ControlModifier);
    QTest::mouseClick(view(), Qt::LeftButton, {}, QPoint(10, 10));
    auto* panel = window->findChild<widgets::PropertyPanel*>();
    EXPECT_LT(panel->element().index, 0);
}

TEST_F(ViewportTest, FollowKeepsTheDrivingRoverAtItsPlace) {
    window->runBar();
    press(Qt::Key_F);
    window->session().setSpeedFactor(0.0);
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return window->session().shown()->distance > 0.3; }, 60000));
    press(Qt::Key_Space);
    const Vec3 offset = view()->camera().center - window->scene().focus();
    EXPECT_LT(offset.norm(), 0.02);
}

TEST_F(ViewportTest, PictureIsNotEmptyAndDrawingAgainChangesNothing) {
    const QImage first = view()->grabImage();
    const QImage second = view()->grabImage();
    ASSERT_FALSE(first.isNull());
    EXPECT_EQ(first, second);
    std::set<QRgb> colors;
    for (int x = 0; x < first.width(); x += 7) {
        for (int y = 0; y < first.height(); y += 7) {
            colors.insert(first.pixel(x, y));
        }
    }
    EXPECT_GT(colors.size(), 100U);
}

TEST_F(ViewportTest, FloatingTheWindowKeepsThePicture) {
    const QImage before = view()->grabImage();
    window->hide();
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    EXPECT_EQ(view()->grabImage().size(), before.size());
}
