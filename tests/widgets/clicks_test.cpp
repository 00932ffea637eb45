// How many clicks the main tasks take, from a window that was just opened. Tables of docs/studio.md
// say the same.
#include <QComboBox>
#include <QDockWidget>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QUndoStack>
#include <optional>

#include <gmock/gmock.h>

#include "simcore/project/names.h"
#include "tests/support/dialogs.h"
#include "tests/support/studio.h"
#include "widgets/panels/advisor_page.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/plots/export_dialog.h"
#include "widgets/session/experiment.h"
#include "widgets/session/run_bar.h"

using testsupport::onNext;
using testsupport::waitUntil;

namespace {

/// Counts presses of the mouse on widgets; a double click is two.
class Clicks : public QObject {
  public:
    Clicks() { qApp->installEventFilter(this); }

    int count() const { return count_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if ((event->type() != QEvent::MouseButtonPress &&
             event->type() != QEvent::MouseButtonDblClick) ||
            !watched->isWidgetType()) {
            return false;
        }
        // Those that nobody takes go on to the parents, with the time that they had.
        const auto time = static_cast<QMouseEvent*>(event)->timestamp();
        count_ += time != last_ ? 1 : 0;
        last_ = time;
        return false;
    }

  private:
    std::optional<quint64> last_;
    int count_ = 0;
};

class ClicksTest : public testsupport::StudioTest {
  protected:
    ClicksTest() { window->session().setSpeedFactor(0.0); }

    void clickTab(const QString& title) {
        for (QTabBar* bar : window->findChildren<QTabBar*>()) {
            for (int i = 0; i < bar->count(); ++i) {
                if (bar->isVisible() && bar->tabText(i) == title) {
                    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
                    return;
                }
            }
        }
        FAIL() << title.toStdString();
    }

    void click(const QString& name) { QTest::mouseClick(find(name), Qt::LeftButton); }
};

}  // namespace

TEST_F(ClicksTest, ARockerBogieFromTheTemplatesTakesADoubleClick) {
    window->document().undoStack().setClean();
    Clicks clicks;
    onNext<QDialog>([](QDialog* dialog) {
        auto* list = dialog->findChild<QListWidget*>();
        ASSERT_NE(list, nullptr);
        const auto found = list->findItems("Rocker-bogie", Qt::MatchExactly);
        ASSERT_EQ(found.size(), 1);
        const QPoint at = list->visualItemRect(found.front()).center();
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, at);
    });
    press(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_THAT(window->document().project().rover.name, testing::HasSubstr("Rocker-bogie"));
    EXPECT_LE(clicks.count(), 3);
}

TEST_F(ClicksTest, ARunWithItsSlipTakesOne) {
    Clicks clicks;
    click("playPauseButton");
    ASSERT_TRUE(waitUntil([&] { return window->session().endTime() > 0.5; }));
    EXPECT_EQ(find<QComboBox>("quantity:0")->currentData().toString(), "slip_abs");
    EXPECT_EQ(clicks.count(), 1);
    window->session().pause();
}

TEST_F(ClicksTest, AdviceIsAppliedWithThree) {
    window->document().undoStack().setClean();
    ASSERT_TRUE(window->document().open(testsupport::projectFile("rocker_bogie")).empty());
    Clicks clicks;
    clickTab(find<QDockWidget>("problemsDock")->windowTitle());
    click("fix:hyperstatic");
    auto& advisor = window->mobility().advisor().session();
    ASSERT_TRUE(
        waitUntil([&] { return advisor.advice() != nullptr && !advisor.isWorking(); }, 60000));
    click("advisorApply");
    EXPECT_EQ(window->document().derived().relaxed.redundant, 0);
    EXPECT_LE(clicks.count(), 3);
}

TEST_F(ClicksTest, TwoControllersAreComparedWithTwo) {
    Clicks clicks;
    clickTab("Compare");
    click("experimentStart");
    ASSERT_TRUE(waitUntil([&] { return window->experiment().rival() != nullptr; }));
    EXPECT_EQ(clicks.count(), 2);
    window->session().pause();
}

TEST_F(ClicksTest, ARunIsExportedWithThree) {
    const QTemporaryDir folder;
    ASSERT_TRUE(window->playPause());
    ASSERT_TRUE(waitUntil([&] { return window->session().endTime() > 0.2; }));
    window->session().pause();
    Clicks clicks;
    testsupport::onNext<widgets::ExportDialog>([&](widgets::ExportDialog* dialog) {
        testsupport::chooseFile(folder.filePath("run.csv"));
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportWrite"), Qt::LeftButton);
    });
    click("exportCsv");
    EXPECT_TRUE(QFile::exists(folder.filePath("run.csv")));
    EXPECT_LE(clicks.count(), 3);
}
