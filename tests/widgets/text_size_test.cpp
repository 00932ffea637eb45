// Text of another size in the real window: everywhere, at once, and kept.
#include <qcustomplot.h>
#include <QDockWidget>
#include <QLabel>
#include <QSettings>
#include <QTreeWidget>

#include <gmock/gmock.h>

#include "tests/support/studio.h"
#include "widgets/window/text_size.h"

namespace {

class TextSizeTest : public testsupport::StudioTest {
  protected:
    ~TextSizeTest() override { window->setTextSize(100); }

    static double sizeOf(const QWidget* widget) { return widget->font().pointSizeF(); }
};

}  // namespace

TEST(TextSizes, StepThroughTheListAndStopAtItsEnds) {
    EXPECT_EQ(widgets::steppedTextSize(100, 1), 110);
    EXPECT_EQ(widgets::steppedTextSize(100, -1), 90);
    EXPECT_EQ(widgets::steppedTextSize(200, 1), 200);
    EXPECT_EQ(widgets::steppedTextSize(80, -1), 80);
    EXPECT_EQ(widgets::steppedTextSize(131, 0), 125);
    EXPECT_EQ(widgets::steppedTextSize(-5, 0), 80);
}

TEST_F(TextSizeTest, KeysChangeTextOfPanelsPlotsAndTitlesAtOnce) {
    auto* tree = find<QTreeWidget>("partsTree");
    auto* verdict = find<QLabel>("headline");
    auto* dock = find<QDockWidget>("roverDock");
    auto* plot = find<QCustomPlot>("plot:0");
    auto* friction = find<QLabel>("staticsFriction");
    auto* row = find<QTreeWidget>("staticsWheels");
    const double base = sizeOf(tree);
    const double large = sizeOf(friction);
    const int badge = static_cast<int>(window->scene().quality().labelSize);
    for (int i = 0; i < 4; ++i) {
        press(Qt::Key_Plus, Qt::ControlModifier);
    }
    QTest::qWait(50);
    EXPECT_EQ(window->textSize(), 175);
    for (const QWidget* widget : std::initializer_list<QWidget*>{tree, verdict, dock, row}) {
        EXPECT_NEAR(sizeOf(widget), 1.75 * base, 0.3) << widget->objectName().toStdString();
    }
    EXPECT_NEAR(plot->xAxis->tickLabelFont().pointSizeF(), 1.75 * base, 0.3);
    EXPECT_NEAR(plot->yAxis->labelFont().pointSizeF(), 1.75 * base, 0.3);
    EXPECT_NEAR(sizeOf(friction), 1.75 * large, 0.5);
    if (window->viewport() != nullptr) {
        EXPECT_GT(window->scene().quality().labelSize, 1.5 * badge);
    }
    press(Qt::Key_Minus, Qt::ControlModifier);
    EXPECT_EQ(window->textSize(), 150);
    press(Qt::Key_0, Qt::ControlModifier);
    QTest::qWait(50);
    EXPECT_NEAR(sizeOf(tree), base, 1e-9);
    EXPECT_NEAR(sizeOf(friction), large, 1e-9);
}

TEST_F(TextSizeTest, TheSizeIsKeptForTheNextStart) {
    window->setTextSize(125);
    window->document().undoStack().setClean();
    window->close();
    widgets::MainWindow next;
    next.restoreLayout();
    EXPECT_EQ(next.textSize(), 125);
    EXPECT_TRUE(next.actions().at("textLarger")->isEnabled());
    next.setTextSize(200);
    EXPECT_FALSE(next.actions().at("textLarger")->isEnabled());
    QSettings().remove("window");
}

// Whoever needs large text can still get at everything of the window on a small screen.
TEST_F(TextSizeTest, TheWindowFitsASmallScreenWithLargerText) {
    window->setTextSize(125);
    QTest::qWait(50);
    EXPECT_LE(window->minimumSizeHint().width(), 1280);
    EXPECT_LE(window->minimumSizeHint().height(), 800);
}
