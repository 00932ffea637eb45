// The tour in the real window, done as a user does it; when it comes and how it is left.
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTreeWidget>
#include <QUndoStack>

#include <gmock/gmock.h>

#include "simcore/io/project_file.h"
#include "tests/support/dialogs.h"
#include "tests/support/studio.h"
#include "widgets/panels/advisor_page.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/window/tour.h"

using testsupport::waitUntil;

namespace {

class TourTest : public testsupport::StudioTest {
  protected:
    TourTest() { QSettings().remove("tour"); }

    ~TourTest() override { QSettings().remove("tour"); }

    widgets::Tour& tour() { return window->tour(); }

    bool becomesDone() {
        return waitUntil([&] { return tour().isStepDone(); });
    }

    void next() {
        const int before = tour().step();
        QTest::mouseClick(find<QPushButton>("tourNextButton"), Qt::LeftButton);
        EXPECT_EQ(tour().step(), before + 1);
    }

    std::string bytes() { return simcore::io::formatProject(window->document().project()); }

    widgets::AdvisorSession& advisor() { return window->mobility().advisor().session(); }
};

}  // namespace

TEST_F(TourTest, LeadsFromALookAroundToExactJointsAndBack) {
    ASSERT_NE(window->viewport(), nullptr);
    const std::string before = bytes();
    press(Qt::Key_F1, Qt::ShiftModifier);
    ASSERT_TRUE(tour().isRunning());
    auto* card = find<QFrame>("tourCard");
    EXPECT_TRUE(card->isVisible());
    EXPECT_TRUE(card->hasFocus());
    // Nothing to do but read: Enter goes on.
    QTest::keyClick(card, Qt::Key_Return);
    ASSERT_EQ(tour().step(), 1);

    EXPECT_FALSE(tour().isStepDone());
    const QPoint middle = window->viewport()->rect().center() + QPoint(0, 120);
    QTest::mousePress(window->viewport(), Qt::LeftButton, {}, middle);
    for (int i = 1; i <= 5; ++i) {
        QTest::mouseMove(window->viewport(), middle + QPoint(12 * i, 0));
        QTest::qWait(5);
    }
    QTest::mouseRelease(window->viewport(), Qt::LeftButton, {}, middle + QPoint(60, 0));
    EXPECT_TRUE(becomesDone());
    next();

    // The frame is around the button that does the same.
    EXPECT_TRUE(find("tourRing")->isVisible());
    const QRect ring = find("tourRing")->geometry();
    auto* play = find("playPauseButton");
    EXPECT_TRUE(ring.contains(QRect(play->mapTo(window.get(), QPoint(0, 0)), play->size())));
    press(Qt::Key_Space);
    EXPECT_TRUE(becomesDone());
    // As long as it takes for curves to be where the plot is clicked.
    ASSERT_TRUE(waitUntil([&] { return window->session().endTime() > 6.0; }, 60000));
    next();

    EXPECT_FALSE(tour().isStepDone());
    QTest::mouseClick(find("plot:0"), Qt::LeftButton, {},
                      find("plot:0")->rect().center() / 2 + QPoint(40, 20));
    EXPECT_TRUE(becomesDone());
    next();

    EXPECT_THAT(find<QLabel>("headline")->text().toStdString(), testing::HasSubstr("21 redundant"));
    next();

    auto* list = find<QTreeWidget>("removableList");
    EXPECT_FALSE(tour().isStepDone());
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualItemRect(list->topLevelItem(0)).center());
    EXPECT_TRUE(becomesDone());
    next();

    press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(waitUntil([&] { return tour().isStepDone(); }, 60000));
    ASSERT_FALSE(advisor().advice()->proposals.empty());
    next();

    auto* proposals = find<QTreeWidget>("advisorList");
    const int applied = advisor().appliedProposal();
    proposals->setCurrentItem(proposals->topLevelItem(applied == 0 ? 1 : 0));
    EXPECT_FALSE(tour().isStepDone());
    QTest::mouseClick(find<QPushButton>("advisorApply"), Qt::LeftButton);
    EXPECT_TRUE(becomesDone());
    EXPECT_EQ(window->document().derived().relaxed.redundant, 0);
    EXPECT_NE(bytes(), before);
    next();

    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(becomesDone());
    EXPECT_EQ(bytes(), before);
    next();

    EXPECT_EQ(tour().step(), tour().stepCount() - 1);
    EXPECT_EQ(find<QPushButton>("tourNextButton")->text().remove('&'), "Finish");
    QTest::mouseClick(find<QPushButton>("tourNextButton"), Qt::LeftButton);
    EXPECT_FALSE(tour().isRunning());
    EXPECT_FALSE(card->isVisible());
    EXPECT_FALSE(find("tourRing")->isVisible());
}

TEST_F(TourTest, OneKeyEndsItAndTheKeyboardIsEnough) {
    press(Qt::Key_F1, Qt::ShiftModifier);
    auto* card = find<QFrame>("tourCard");
    // Whoever does nothing gets on all the same.
    for (int i = 0; i + 1 < tour().stepCount(); ++i) {
        press(Qt::Key_Return, Qt::ControlModifier);
        EXPECT_EQ(tour().step(), i + 1);
    }
    press(Qt::Key_Return, Qt::ControlModifier);
    EXPECT_FALSE(tour().isRunning());
    press(Qt::Key_F1, Qt::ShiftModifier);
    ASSERT_TRUE(tour().isRunning());
    QTest::keyClick(card, Qt::Key_Escape);
    EXPECT_FALSE(tour().isRunning());
    EXPECT_FALSE(window->actions().at("tourNext")->isEnabled());
    press(Qt::Key_F1, Qt::ShiftModifier);
    press(Qt::Key_F1, Qt::ShiftModifier);
    EXPECT_FALSE(tour().isRunning());
}

TEST_F(TourTest, ComesOnceByItselfAndNotToOtherRovers) {
    window->document().undoStack().setClean();
    ASSERT_TRUE(window->document().open(testsupport::projectFile("shrimp")).empty());
    tour().offerFirst();
    EXPECT_FALSE(tour().isRunning());
    window->document().createNew();
    tour().offerFirst();
    ASSERT_TRUE(tour().isRunning());
    EXPECT_EQ(window->document().project().rover.name, "SOLERO");
    EXPECT_TRUE(window->document().file().isEmpty());  // a copy of the example
    tour().end();
    tour().offerFirst();
    EXPECT_FALSE(tour().isRunning());
}

TEST_F(TourTest, UnsavedWorkIsAskedForAndMayBeKept) {
    window->document().undoStack().setClean();
    ASSERT_TRUE(window->document().open(testsupport::projectFile("shrimp")).empty());
    auto next = window->document().project();
    next.rover.bodies.front().mass = 7.25;
    window->document().edit("Load", next);
    testsupport::answerNextBox(QMessageBox::Cancel);
    EXPECT_FALSE(tour().start());
    EXPECT_FALSE(tour().isRunning());
    EXPECT_EQ(window->document().project(), next);
}

// The card stays over the 3-D view, whole, whatever the window's and the text's size.
TEST_F(TourTest, TheCardStaysOverTheView) {
    press(Qt::Key_F1, Qt::ShiftModifier);
    auto* card = find<QFrame>("tourCard");
    for (const QSize size : {QSize(1280, 800), QSize(1600, 1000)}) {
        window->resize(size);
        QTest::qWait(300);
        const QWidget* view = window->centralWidget();
        const QRect room(view->mapTo(window.get(), QPoint(0, 0)), view->size());
        EXPECT_TRUE(room.contains(card->geometry()));
    }
    auto* text = find<QLabel>("tourText");
    EXPECT_GE(text->height(), text->heightForWidth(text->width()));
}
