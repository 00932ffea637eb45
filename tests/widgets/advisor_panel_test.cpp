// The Advisor and the free motions in the real window: search, apply and undo, cancel, edits; how a
// motion is shown.
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>

#include <gmock/gmock.h>

#include "simcore/io/project_file.h"
#include "tests/support/projects.h"
#include "tests/support/studio.h"
#include "widgets/editors/parts_tree.h"
#include "widgets/panels/advisor_page.h"
#include "widgets/panels/mobility_panel.h"
#include "widgets/panels/motion_page.h"

using simcore::mobility::AdviceEnd;
using simcore::mobility::Model;
using testsupport::waitUntil;

namespace {

class AdvisorPanelTest : public testsupport::StudioTest {
  protected:
    widgets::AdvisorSession& session() { return window->mobility().advisor().session(); }

    widgets::MotionPage& motions() { return window->mobility().motions(); }

    /// Opens a shipped project without the relaxed model that it has.
    void openBare(const QString& name) {
        auto loaded = simcore::io::loadProject(testsupport::projectFile(name).toStdString());
        ASSERT_TRUE(loaded.ok());
        simcore::project::Project project = std::move(loaded).value();
        testsupport::clearRelaxed(project);
        window->document().openProject(std::move(project), {});
    }

    void advise() {
        press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_TRUE(session().isWorking());
        ASSERT_TRUE(waitUntil([&] { return !session().isWorking(); }, 60000));
    }

    std::string bytes() const { return simcore::io::formatProject(window->document().project()); }

    QString relaxedRedundant() { return cell(5, 1); }

    QString cell(int row, int model) {
        QString text = find<QLabel>(QString("mobility:%1:%2").arg(row).arg(model))->text();
        return text.remove("<b>").remove("</b>");
    }

    QTreeWidget* list() { return find<QTreeWidget>("advisorList"); }

    QPushButton* button(const QString& name) { return find<QPushButton>(name); }

    std::string text(const QString& label) { return find<QLabel>(label)->text().toStdString(); }

    void editRover() {
        auto next = window->document().project();
        next.rover.bodies.front().mass = 7.25;
        window->document().edit("Load", next);
    }

    void expectApplyAndUndo(const QString& name) {
        SCOPED_TRACE(name.toStdString());
        openBare(name);
        const std::string before = bytes();
        const QString redundant = relaxedRedundant();
        EXPECT_NE(redundant, "0");
        advise();
        ASSERT_GT(list()->topLevelItemCount(), 0);
        EXPECT_EQ(window->mobility().advisor().selected(), 0);
        const int steps = window->document().undoStack().count();
        QTest::mouseClick(button("advisorApply"), Qt::LeftButton);
        EXPECT_EQ(relaxedRedundant(), "0");
        EXPECT_EQ(window->document().undoStack().count(), steps + 1);
        EXPECT_EQ(window->document().undoStack().undoText(), "Apply proposal 1");
        // The advice is as good as before, and says what is applied.
        EXPECT_FALSE(session().isStale());
        EXPECT_EQ(session().appliedProposal(), 0);
        EXPECT_FALSE(button("advisorApply")->isEnabled());
        press(Qt::Key_Z, Qt::ControlModifier);
        EXPECT_EQ(bytes(), before);
        EXPECT_EQ(relaxedRedundant(), redundant);
        EXPECT_TRUE(button("advisorApply")->isEnabled());
    }

    /// Distance of the picture's bodies from the drawn pose, the most [m].
    double moved() {
        double most = 0.0;
        for (std::size_t i = 0; i < mechanism().bodies.size(); ++i) {
            const auto& com = mechanism().bodies[i].com;
            most =
                std::max(most, (window->scene().bodyPose(static_cast<int>(i)) * com - com).norm());
        }
        return most;
    }

    /// Largest gap of any pin in the picture [m].
    double gap() {
        double most = 0.0;
        for (const auto& joint : mechanism().joints) {
            most = std::max(most, (window->scene().bodyPose(joint.first) * joint.point -
                                   window->scene().bodyPose(joint.second) * joint.point)
                                      .norm());
        }
        return most;
    }

    const simcore::mechanism::Mechanism& mechanism() {
        return *window->document().derived().mechanism;
    }

    void showMotions() { press(Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier); }
};

}  // namespace

TEST_F(AdvisorPanelTest, SoleroBecomesExactAndUndoGivesTheSameBytesBack) {
    expectApplyAndUndo("solero");
}

TEST_F(AdvisorPanelTest, RockerBogieBecomesExactAndUndoGivesTheSameBytesBack) {
    expectApplyAndUndo("rocker_bogie");
    // Nothing symmetric is exact there; the list says on which side.
    const QTreeWidgetItem* first = list()->topLevelItem(0);
    QStringList changes;
    for (int i = 0; i < first->childCount(); ++i) {
        changes << first->child(i)->text(0);
    }
    EXPECT_THAT(changes.join('\n').toStdString(), testing::HasSubstr("left only"));
    EXPECT_THAT(text("advisorText"), testing::HasSubstr("one side only"));
}

TEST_F(AdvisorPanelTest, ProposalsSayWhatChangesAndWhatItGives) {
    openBare("solero");
    EXPECT_FALSE(list()->isVisible());
    advise();
    EXPECT_TRUE(list()->isVisible());
    const auto& advice = *session().advice();
    ASSERT_EQ(list()->topLevelItemCount(), static_cast<int>(advice.proposals.size()));
    for (int i = 0; i < list()->topLevelItemCount(); ++i) {
        const auto& proposal = advice.proposals[static_cast<std::size_t>(i)];
        EXPECT_EQ(list()->topLevelItem(i)->text(1), QString::number(proposal.cost));
        EXPECT_EQ(list()->topLevelItem(i)->childCount(), static_cast<int>(proposal.changes.size()));
    }
    EXPECT_THAT(text("advisorVerdict"), testing::HasSubstr("exact sets of joints"));
    EXPECT_THAT(text("advisorCounts"), testing::HasSubstr("redundant 21 → <b>0</b>"));
    EXPECT_THAT(text("advisorCounts"), testing::HasSubstr("Grübler −20 → <b>1</b>"));
}

TEST_F(AdvisorPanelTest, SelectedProposalIsMarkedAndAChosenJointIsSelectedEverywhere) {
    openBare("solero");
    advise();
    list()->setCurrentItem(list()->topLevelItem(1));
    const auto& proposal = session().advice()->proposals[1];
    std::size_t joints = 0;
    std::size_t contacts = 0;
    for (const auto& change : proposal.changes) {
        (change.wheel >= 0 ? contacts : joints) += change.copies.size();
    }
    EXPECT_EQ(window->scene().markedJoints().size(), joints);
    EXPECT_EQ(window->scene().markedBodies().size(), contacts);
    QTreeWidgetItem* change = list()->topLevelItem(1)->child(0);
    ASSERT_TRUE(list()->topLevelItem(1)->isExpanded());
    list()->setCurrentItem(change);
    const auto& chosen = proposal.changes.front();
    ASSERT_FALSE(window->scene().highlighted().joints.empty());
    EXPECT_EQ(window->scene().highlighted().joints.front(),
              mechanism().findJoint(chosen.copies.front()));
    const auto* tree = window->findChild<widgets::PartsTree*>();
    EXPECT_EQ(tree->selected().kind, simcore::project::ElementKind::Joint);
    EXPECT_EQ(tree->selected().index, chosen.joint);
    // Another panel is about something else.
    window->showPanel("mass");
    EXPECT_TRUE(waitUntil([&] { return window->scene().markedJoints().empty(); }));
}

TEST_F(AdvisorPanelTest, ExactRoverIsToldSo) {
    ASSERT_TRUE(window->document()
                    .open(QString(ROVER_SOURCE_DIR) + "/assets/mechanisms/stewart_platform.rover")
                    .size() < 2U);
    advise();
    EXPECT_EQ(text("advisorVerdict"), "Exact as built");
    EXPECT_FALSE(list()->isVisible());
    EXPECT_FALSE(button("advisorApply")->isVisible());
}

TEST_F(AdvisorPanelTest, TimeThatRanOutIsToldAndALongerSearchIsOffered) {
    openBare("solero");
    window->showPanel("advisor");
    session().start(0.0);
    ASSERT_TRUE(waitUntil([&] { return !session().isWorking(); }));
    ASSERT_EQ(session().advice()->end, AdviceEnd::TimeUp);
    EXPECT_THAT(text("advisorText"), testing::HasSubstr("time limit"));
    EXPECT_EQ(button("advisorStart")->text(), "Search longer");
}

TEST_F(AdvisorPanelTest, CancelEndsTheSearchAndTheWindowLivesMeanwhile) {
    openBare("solero");
    press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(session().isWorking());
    EXPECT_TRUE(find<QProgressBar>("advisorProgress")->isVisible());
    EXPECT_FALSE(button("advisorStart")->isVisible());
    QTest::mouseClick(button("advisorCancel"), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return !session().isWorking(); }, 5000));
    EXPECT_EQ(session().advice()->end, AdviceEnd::Cancelled);
    EXPECT_FALSE(find<QProgressBar>("advisorProgress")->isVisible());
    EXPECT_TRUE(button("advisorStart")->isEnabled());
}

TEST_F(AdvisorPanelTest, EditEndsTheSearch) {
    openBare("solero");
    press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(session().isWorking());
    editRover();
    EXPECT_FALSE(session().isWorking());
    EXPECT_THAT(text("advisorVerdict"), testing::HasSubstr("the search has ended"));
    QTest::qWait(500);  // what the search may still say is of no use
    EXPECT_EQ(session().advice(), nullptr);
}

TEST_F(AdvisorPanelTest, EditMakesAdviceStaleAndUndoFreshAgain) {
    openBare("rocker_bogie");
    advise();
    ASSERT_GT(list()->topLevelItemCount(), 0);
    editRover();
    EXPECT_TRUE(session().isStale());
    EXPECT_FALSE(button("advisorApply")->isEnabled());
    EXPECT_THAT(text("advisorVerdict"), testing::HasSubstr("before it was edited"));
    EXPECT_TRUE(window->scene().markedBodies().empty());
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(session().isStale());
    EXPECT_TRUE(button("advisorApply")->isEnabled());
    // Another project has nothing to do with it.
    openBare("solero");
    EXPECT_EQ(session().advice(), nullptr);
    EXPECT_EQ(list()->topLevelItemCount(), 0);
}

TEST_F(AdvisorPanelTest, SwingMovesTheBodiesAndKeepsLoopsClosed) {
    showMotions();
    ASSERT_EQ(motions().motions().size(), 1U);
    EXPECT_EQ(text("motionTitle"), "Free motion 1 of 1");
    EXPECT_LT(moved(), 1e-12);
    QTest::mouseClick(button("motionPlay"), Qt::LeftButton);
    EXPECT_TRUE(motions().isPlaying());
    EXPECT_EQ(button("motionPlay")->text(), "Stop");
    EXPECT_TRUE(waitUntil([&] { return moved() > 1e-3; }));
    double most = 0.0;
    for (double turns = 0.0; turns < 1.0; turns += 0.013) {
        motions().showPhase(turns);
        most = std::max(most, moved());
        EXPECT_LT(gap(), 1e-3);
    }
    EXPECT_NEAR(most, 0.05 * mechanism().wheelbase(), 0.01 * mechanism().wheelbase());
    QTest::mouseClick(button("motionPlay"), Qt::LeftButton);
    EXPECT_FALSE(motions().isPlaying());
    EXPECT_LT(moved(), 1e-12);
}

TEST_F(AdvisorPanelTest, SwingEndsWithEditsRunsAndOtherPanels) {
    auto* play = button("motionPlay");
    const auto swing = [&] {
        showMotions();
        QTest::mouseClick(play, Qt::LeftButton);
        ASSERT_TRUE(motions().isPlaying());
        motions().showPhase(0.25);
        ASSERT_GT(moved(), 0.01);
    };
    swing();
    editRover();
    EXPECT_FALSE(motions().isPlaying());
    EXPECT_FALSE(play->isChecked());
    EXPECT_LT(moved(), 1e-12);
    swing();
    press(Qt::Key_M, Qt::ControlModifier);  // the same dock, but its first page
    EXPECT_FALSE(motions().isPlaying());
    EXPECT_LT(moved(), 1e-12);
    swing();
    window->showPanel("mass");
    EXPECT_TRUE(waitUntil([&] { return !motions().isPlaying(); }));
    EXPECT_LT(moved(), 1e-12);
    swing();
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return window->session().endTime() > 0.05; }));
    press(Qt::Key_Space);
    EXPECT_FALSE(motions().isPlaying());
    const auto& run = window->session().shown()->bodies.front().position;
    EXPECT_LT((window->scene().bodyPose(0).position - run).norm(), 1e-9);
    // A swing is of the design; the run is on show again after it.
    swing();
    QTest::mouseClick(play, Qt::LeftButton);
    EXPECT_LT((window->scene().bodyPose(0).position - run).norm(), 1e-9);
}

TEST_F(AdvisorPanelTest, IdleFreedomsAreListedAndTheirBodyIsMarked) {
    openBare("rocker_bogie_bar");
    showMotions();
    auto* list = find<QListWidget>("motionList");
    ASSERT_EQ(list->count(), 3);
    EXPECT_TRUE(window->scene().markedBodies().empty());
    for (const int row : {1, 2}) {
        list->setCurrentRow(row);
        EXPECT_THAT(list->item(row)->text().toStdString(), testing::StartsWith("Idle: "));
        const int body =
            mechanism().findBody(motions().motions()[static_cast<std::size_t>(row)].body);
        EXPECT_EQ(window->scene().markedBodies(), std::vector<int>{body});
        EXPECT_EQ(window->scene().markedJoints().size(), 2U);
        QTest::mouseClick(button("motionPlay"), Qt::LeftButton);
        motions().showPhase(0.25);
        EXPECT_GT(
            window->scene().bodyPose(body).rotation.angularDistance(Eigen::Quaterniond::Identity()),
            0.4);
        EXPECT_LT(gap(), 1e-3);
        motions().stop();
    }
    EXPECT_TRUE(find<QToolButton>("motionNext")->isEnabled());
    QTest::mouseClick(find<QToolButton>("motionNext"), Qt::LeftButton);
    EXPECT_EQ(list->currentRow(), 0);
}

TEST_F(AdvisorPanelTest, ModelIsThatOfThePanel) {
    showMotions();
    QTest::mouseClick(button("motionRelaxed"), Qt::LeftButton);
    EXPECT_EQ(window->mobility().model(), Model::Relaxed);
    EXPECT_EQ(motions().motions().size(), 1U);
    window->mobility().setModel(Model::Built);
    EXPECT_TRUE(button("motionBuilt")->isChecked());
}

TEST_F(AdvisorPanelTest, ClosingTheWindowDuringASearchEndsIt) {
    openBare("solero");
    press(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(session().isWorking());
    window->document().undoStack().setClean();
    window->close();
    window = std::make_unique<widgets::MainWindow>();  // the old one is gone, with its thread
    SUCCEED();
}

TEST_F(AdvisorPanelTest, EveryWidgetHasANameForReaders) {
    for (const char* name :
         {"advisorVerdict", "advisorText", "advisorCancel", "advisorProgress", "advisorList",
          "advisorCounts", "motionTitle", "motionList", "motionNote", "motionPlay", "motionNext"}) {
        EXPECT_FALSE(find<QWidget>(name)->accessibleName().isEmpty()) << name;
    }
    for (const char* name : {"advisorStart", "advisorApply", "pageCounts", "pageAdvisor",
                             "pageMotions", "motionBuilt", "motionRelaxed"}) {
        EXPECT_FALSE(button(name)->text().isEmpty()) << name;
    }
}
