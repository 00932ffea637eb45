// Advice in the problems panel of the real window: seen, followed, hidden and shown again.
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>

#include <gmock/gmock.h>

#include "tests/support/studio.h"
#include "widgets/panels/problems_panel.h"

using testing::HasSubstr;
using testsupport::waitUntil;

namespace {

class AdviceTest : public testsupport::StudioTest {
  protected:
    AdviceTest() {
        QSettings().remove("problems/hidden");
        auto next = window->document().project();
        for (auto& scenario : next.scenarios) {
            if (scenario.name == "flat") {
                scenario.run.step = 0.01;
                scenario.controller.speed = 0.5;
            }
        }
        window->document().edit("Hasten", next);
        press(Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    }

    ~AdviceTest() override { QSettings().remove("problems/hidden"); }

    QTreeWidget* list() { return find<QTreeWidget>("problemList"); }

    int count() { return window->findChild<widgets::ProblemsPanel*>()->count(); }

    /// Right-clicks the first line and takes the only entry of its menu.
    void takeMenu() {
        QTimer::singleShot(200, window.get(), [] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            ASSERT_NE(menu, nullptr);
            ASSERT_EQ(menu->actions().size(), 1);
            QTest::mouseClick(menu, Qt::LeftButton, {},
                              menu->actionGeometry(menu->actions().front()).center());
        });
        const QPoint at = list()->visualItemRect(list()->topLevelItem(0)).center();
        emit list()->customContextMenuRequested(at);
    }
};

}  // namespace

TEST_F(AdviceTest, TheFixIsOneStepThatUndoTakesBack) {
    ASSERT_EQ(count(), 1);
    EXPECT_THAT(list()->topLevelItem(0)->child(0)->text(0).toStdString(),
                HasSubstr("5.00 mm in a step"));
    const auto before = window->document().project();
    QTest::mouseClick(find<QPushButton>("fix:step"), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return count() == 0; }));
    EXPECT_THAT(window->document().undoStack().undoText().toStdString(), HasSubstr("Step of 1 ms"));
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window->document().project(), before);
    EXPECT_EQ(count(), 1);
}

TEST_F(AdviceTest, AKindCanBeHiddenAndShownAgain) {
    takeMenu();
    ASSERT_TRUE(waitUntil([&] { return count() == 0; }));
    auto* hidden = find<QToolButton>("hiddenKinds");
    EXPECT_TRUE(hidden->isVisible());
    EXPECT_EQ(hidden->text(), "1 kind of advice hidden");
    // Also in the next window.
    EXPECT_EQ(QSettings().value("problems/hidden").toStringList(), QStringList{"step"});
    hidden->menu()->actions().front()->trigger();
    EXPECT_EQ(count(), 1);
    EXPECT_FALSE(hidden->isVisible());
}

// The rocker-bogie that nobody has relaxed: one button leads to the Advisor at work.
TEST_F(AdviceTest, RedundantConstraintsLeadToTheAdvisor) {
    window->document().undoStack().setClean();
    ASSERT_TRUE(window->document().open(testsupport::projectFile("rocker_bogie")).empty());
    QTest::mouseClick(find<QPushButton>("fix:hyperstatic"), Qt::LeftButton);
    EXPECT_TRUE(waitUntil([&] { return find<QWidget>("advisorText")->isVisible(); }));
}

TEST_F(AdviceTest, ChoosingAdviceSelectsItsPart) {
    const QPoint at = list()->visualItemRect(list()->topLevelItem(0)).center();
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, at);
    EXPECT_THAT(list()->currentItem()->text(0).toStdString(), HasSubstr("flat"));
}

// Found beside the window while the panel is on show; an edit drops it, and the next one finds
// anew.
TEST_F(AdviceTest, GroundTooSlipperyForAStepIsToldAMomentLater) {
    auto next = window->document().project();
    next.scenarios.erase(
        std::remove_if(next.scenarios.begin(), next.scenarios.end(),
                       [](const auto& scenario) { return scenario.name != "step"; }),
        next.scenarios.end());
    next.scenarios.front().soil.friction = 0.3;
    window->document().edit("Spill oil", next);
    EXPECT_EQ(count(), 0);
    ASSERT_TRUE(waitUntil([&] { return count() == 1; }));
    EXPECT_EQ(list()->topLevelItem(0)->text(0), "scenario step");
    EXPECT_THAT(list()->topLevelItem(0)->child(0)->text(0).toStdString(),
                HasSubstr("and the ground gives 0.30"));
    next.scenarios.front().soil.friction = 0.9;
    window->document().edit("Clean up", next);
    EXPECT_EQ(count(), 0);
    QTest::qWait(3000);
    EXPECT_EQ(count(), 0);
}
