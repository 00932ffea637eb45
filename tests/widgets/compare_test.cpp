// Runs beside one another in the real window: kept ones, and two controllers on one scenario.
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTreeWidget>

#include <set>

#include <gmock/gmock.h>
#include <qcustomplot.h>

#include "simcore/io/recording.h"
#include "simcore/io/replay.h"
#include "tests/support/dialogs.h"
#include "tests/support/studio.h"
#include "widgets/panels/compare_panel.h"
#include "widgets/panels/compare_text.h"
#include "widgets/plots/plot_panel.h"
#include "widgets/session/experiment.h"
#include "widgets/session/run_bar.h"
#include "widgets/window/recording_commands.h"

using simcore::experiment::Outcome;
using simcore::project::ControllerKind;
using testing::HasSubstr;
using testsupport::waitUntil;
using widgets::RunSession;
using State = RunSession::State;

namespace {

class CompareTest : public testsupport::StudioTest {
  protected:
    CompareTest() {
        shortenScenarios();
        window->runBar().setScenario("flat");
        window->plots().setQuantity(0, "slip_abs");
        find<QComboBox>("engine")->setCurrentIndex(1);
        session().setSpeedFactor(0.0);
        press(Qt::Key_X, Qt::ControlModifier | Qt::ShiftModifier);
    }

    RunSession& session() { return window->session(); }

    widgets::RunLibrary& library() { return window->library(); }

    void shortenScenarios() {
        auto next = window->document().project();
        for (auto& scenario : next.scenarios) {
            scenario.run.duration = 1.5;
        }
        window->document().edit("Shorten", next);
    }

    bool driveToTheEnd() {
        press(Qt::Key_Space);
        return waitUntil([&] { return session().state() == State::Finished; });
    }

    bool bothEnd() {
        return waitUntil([&] { return window->experiment().verdict().has_value(); });
    }

    QTreeWidget* runList() { return find<QTreeWidget>("runList"); }

    /// Graphs that are lines; marks on them are graphs of their own.
    int curves() {
        int count = 0;
        for (int i = 0; i < plot()->graphCount(); ++i) {
            count += plot()->graph(i)->lineStyle() != QCPGraph::lsNone ? 1 : 0;
        }
        return count;
    }

    QCustomPlot* plot() { return find<QCustomPlot>("plot:0"); }

    /// Clicks the box of a run's line.
    void clickBox(int line, int column) {
        QTreeWidgetItem* item = runList()->topLevelItem(line);
        const QRect cell = runList()->visualItemRect(item);
        const int x = runList()->columnViewportPosition(column) + 8;
        QTest::mouseClick(runList()->viewport(), Qt::LeftButton, {}, QPoint(x, cell.center().y()));
    }
};

Outcome outcome(double slip, double energy, bool completed = true, double endY = 0.0) {
    Outcome o;
    o.slipAbs = o.slipLoaded = slip;
    o.energy = energy;
    o.completed = completed;
    o.stopReason = completed ? "completed" : "stuck";
    o.endY = endY;
    return o;
}

widgets::VerdictText textOf(const Outcome& first, const Outcome& second) {
    return widgets::verdictText(first, second, simcore::experiment::judge(first, second), "A", "B");
}

}  // namespace

TEST(VerdictTextTest, SaysWhoSlipsLessAndWhyOthersCannotBeCompared) {
    using widgets::VerdictLevel;
    EXPECT_EQ(textOf(outcome(0.1, 5.0), outcome(0.2, 4.0)).headline,
              "A slips less: 100 against 200 mm");
    EXPECT_THAT(textOf(outcome(0.1, 5.0), outcome(0.2, 4.0)).details.toStdString(),
                HasSubstr("Energy: B has 20 % less (4.0 against 5.0 J)."));
    EXPECT_EQ(textOf(outcome(0.1, 5.0), outcome(0.1004, 5.0)).headline, "Both slip alike");
    EXPECT_EQ(textOf(outcome(0.1, 5.0, false), outcome(0.2, 4.0)).headline, "Only B gets there");
    EXPECT_EQ(textOf(outcome(0.1, 5.0, false), outcome(0.2, 4.0)).level, VerdictLevel::Bad);
    EXPECT_EQ(textOf(outcome(0.1, 5.0, false), outcome(0.2, 4.0, false)).headline,
              "Neither gets there");
    EXPECT_EQ(textOf(outcome(0.1, 5.0), outcome(0.2, 4.0, true, 0.2)).level, VerdictLevel::Warning);
}

TEST_F(CompareTest, AKeptRunStandsBesideTheNextOne) {
    EXPECT_TRUE(find<QLabel>("compareHint")->isVisible());
    ASSERT_TRUE(driveToTheEnd());
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_EQ(library().runs().size(), 1U);
    const auto& kept = library().runs().front().session->recording();
    ASSERT_EQ(kept.rows.size(), session().recording().rows.size());
    EXPECT_EQ(kept.rows.back()[1], session().recording().rows.back()[1]);
    EXPECT_EQ(library().runs().front().name.toStdString(), "Speed control, flat, μ 0.70, Reduced");

    window->runBar().setController(ControllerKind::Torque);
    ASSERT_TRUE(driveToTheEnd());
    EXPECT_EQ(runList()->topLevelItemCount(), 2);
    auto* table = find<QTableWidget>("compareTable");
    ASSERT_EQ(table->columnCount(), 2);
    EXPECT_EQ(table->horizontalHeaderItem(0)->text().section('\n', 0, 0), "Torque control");
    EXPECT_EQ(table->horizontalHeaderItem(1)->text().section('\n', 0, 0), "Speed control");
    EXPECT_EQ(table->item(0, 1)->text(), "completed");
    // Energy [J], as the report has it.
    EXPECT_EQ(table->item(5, 0)->text(), QString::number(session().report().energy, 'f', 1));
    QTest::mouseClick(find<QPushButton>("copyTable"), Qt::LeftButton);
    const QStringList lines = QApplication::clipboard()->text().split('\n');
    ASSERT_EQ(lines.size(), 10);
    EXPECT_EQ(lines[3].section('\t', 0, 0), "Slip [mm]");
    EXPECT_EQ(lines[3].count('\t'), 2);
}

// Kept, saved, added again: the same numbers; the file makes the same run again.
TEST_F(CompareTest, AKeptRunIsSavedAsARecordingAndARecordingIsHeldBesideTheRun) {
    using simcore::io::RecordingReader;
    ASSERT_TRUE(driveToTheEnd());
    press(Qt::Key_K, Qt::ControlModifier);
    const auto rows = session().recording().rows;
    window->runBar().setController(ControllerKind::Torque);
    ASSERT_TRUE(driveToTheEnd());
    const QTemporaryDir folder;
    const QString file = folder.filePath("kept.roverrec");
    const auto click = [&](int line) {
        QTest::mouseClick(runList()->viewport(), Qt::LeftButton, {},
                          runList()->visualItemRect(runList()->topLevelItem(line)).center());
    };
    const auto saveTo = [&](const QString& name) {
        testsupport::chooseFile(name);
        QTest::mouseClick(find<QPushButton>("saveRun"), Qt::LeftButton);
    };
    click(1);
    saveTo(file);
    ASSERT_TRUE(QFile::exists(file));
    auto reader = RecordingReader::open(file.toStdString());
    ASSERT_TRUE(reader);
    const auto replayed = simcore::io::replay(**reader);
    ASSERT_TRUE(replayed);
    EXPECT_TRUE(replayed->same());
    // The run on show is saved by the same button.
    click(0);
    saveTo(folder.filePath("shown.roverrec"));
    EXPECT_TRUE(QFile::exists(folder.filePath("shown.roverrec")));

    // Back beside the run on show, with curves, a column, and the mark of another design.
    click(1);
    QTest::mouseClick(find<QPushButton>("removeRun"), Qt::LeftButton);
    ASSERT_TRUE(library().runs().empty());
    const int controller = static_cast<int>(session().settings().controller);
    testsupport::chooseFile(file);
    QTest::mouseClick(find<QPushButton>("addRecording"), Qt::LeftButton);
    ASSERT_EQ(library().runs().size(), 1U);
    EXPECT_EQ(static_cast<int>(session().settings().controller), controller);
    const auto& held = library().runs().front().session->recording().rows;
    ASSERT_EQ(held.size(), rows.size());
    EXPECT_EQ(held.back()[0], rows.back()[0]);
    EXPECT_EQ(held.back()[1], rows.back()[1]);
    EXPECT_EQ(find<QTableWidget>("compareTable")->columnCount(), 2);
    EXPECT_EQ(runList()->topLevelItemCount(), 2);
    // As a ghost it moves along with the instant on show.
    library().setGhost(library().runs().front().id);
    session().scrub(0.5);
    EXPECT_NEAR(library().ghostRun()->instantNear(session().shownTime())->time, 0.5, 0.03);

    // It can be saved once more: a copy of the file, to the byte.
    click(1);
    saveTo(folder.filePath("again.roverrec"));
    EXPECT_EQ(testsupport::bytesOf(folder.filePath("again.roverrec")), testsupport::bytesOf(file));

    // An opened recording can be kept, and saved from there.
    window->document().undoStack().setClean();
    ASSERT_TRUE(window->recordings().openFile(file));
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_EQ(library().runs().size(), 1U);
    click(1);
    saveTo(folder.filePath("third.roverrec"));
    EXPECT_EQ(testsupport::bytesOf(folder.filePath("third.roverrec")), testsupport::bytesOf(file));

    // What cannot be read says so and changes nothing.
    testsupport::answerNextBox(QMessageBox::Ok);
    EXPECT_FALSE(window->recordings().addFile(folder.filePath("none.roverrec")));
    EXPECT_EQ(library().runs().size(), 1U);
}

TEST_F(CompareTest, RunsOutOfSightAreSaid) {
    ASSERT_TRUE(driveToTheEnd());
    auto* aside = find<QLabel>("compareAside");
    EXPECT_FALSE(aside->isVisible());
    for (int i = 0; i < 4; ++i) {
        press(Qt::Key_K, Qt::ControlModifier);
    }
    auto* bar = find<QTableWidget>("compareTable")->horizontalScrollBar();
    ASSERT_TRUE(waitUntil([&] { return bar->maximum() > 0; }));
    EXPECT_TRUE(aside->isVisible());
    EXPECT_THAT(aside->text().toStdString(), HasSubstr("to the right"));
    bar->setValue(bar->maximum());
    EXPECT_THAT(aside->text().toStdString(), HasSubstr("to the left"));
}

TEST_F(CompareTest, CurvesOfKeptRunsCanBeShownAndHidden) {
    ASSERT_TRUE(driveToTheEnd());
    press(Qt::Key_K, Qt::ControlModifier);
    ASSERT_TRUE(waitUntil([&] { return curves() == 12; }));
    EXPECT_EQ(plot()->graph(0)->pen().style(), Qt::SolidLine);
    EXPECT_EQ(plot()->graph(6)->pen().style(), Qt::DashLine);
    EXPECT_EQ(plot()->graph(6)->dataCount(), plot()->graph(0)->dataCount());
    // Every curve wears the sign of its wheel: a few marks, the same in both runs.
    ASSERT_EQ(plot()->graphCount(), 24);
    for (int i = 12; i < 24; ++i) {
        QTest::qWait(0);
        EXPECT_GE(plot()->graph(i)->dataCount(), 2);
        EXPECT_LE(plot()->graph(i)->dataCount(), 6);
        EXPECT_EQ(plot()->graph(i)->scatterStyle().customPath(),
                  plot()->graph(12 + i % 6)->scatterStyle().customPath());
    }
    EXPECT_FALSE(find<QLabel>("runLegend")->pixmap().isNull());
    clickBox(1, 1);
    ASSERT_TRUE(waitUntil([&] { return curves() == 6; }));
    EXPECT_TRUE(find<QLabel>("runLegend")->pixmap().isNull());
    // Hiding a wheel hides it in all runs.
    clickBox(1, 1);
    ASSERT_TRUE(waitUntil([&] { return curves() == 12; }));
    window->plots().setWheelShown(2, false);
    EXPECT_FALSE(plot()->graph(2)->visible());
    EXPECT_FALSE(plot()->graph(8)->visible());
    EXPECT_TRUE(plot()->graph(7)->visible());
}

// Of any time window, with blocks of points begun and ended anywhere: by looking at every point.
TEST_F(CompareTest, TheValueAxisFitsTheVisibleCurvesOfAllRuns) {
    ASSERT_TRUE(driveToTheEnd());
    press(Qt::Key_K, Qt::ControlModifier);
    window->plots().setQuantity(0, "torque_applied");
    window->plots().setWheelShown(0, false);
    for (const auto& [from, to] :
         {std::pair(0.0, 1.5), std::pair(0.013, 1.49), std::pair(0.2, 0.4), std::pair(1.28, 1.3)}) {
        plot()->xAxis->setRange(from, to);
        const QCPRange seen = plot()->xAxis->range();
        double least = 0.0, most = 0.0;  // zero is always shown
        for (int i = 0; i < plot()->graphCount(); ++i) {
            for (const auto& point : *plot()->graph(i)->data()) {
                if (plot()->graph(i)->visible() && seen.contains(point.key)) {
                    least = std::min(least, point.value);
                    most = std::max(most, point.value);
                }
            }
        }
        const double size = std::max(most - least, 0.5);
        EXPECT_NEAR(plot()->yAxis->range().upper, least + size + 0.06 * size, 1e-9) << from;
        EXPECT_NEAR(plot()->yAxis->range().lower, least < 0.0 ? least - 0.06 * size : -0.03 * size,
                    1e-9)
            << from;
    }
}

TEST_F(CompareTest, QuantitiesOfTheChassisAreOneCurveARun) {
    ASSERT_TRUE(driveToTheEnd());
    press(Qt::Key_K, Qt::ControlModifier);
    window->plots().setQuantity(0, "speed");
    ASSERT_EQ(curves(), 2);
    EXPECT_GT(plot()->graph(0)->dataCount(), 100);
    const auto& row = session().recording().rows.back();
    const int channel =
        simcore::run::findChannel(session().recording().channels, "speed", "chassis");
    EXPECT_DOUBLE_EQ(plot()->graph(0)->data()->at(plot()->graph(0)->dataCount() - 1)->value,
                     row.at(static_cast<std::size_t>(channel)));
}

TEST_F(CompareTest, AMarkedInstantMakesTheTableTellChanges) {
    ASSERT_TRUE(driveToTheEnd());
    window->plots().setQuantity(0, "distance");
    const auto pixelAt = [&](double time) {
        return QPoint(static_cast<int>(plot()->xAxis->coordToPixel(time)),
                      plot()->axisRect()->center().y());
    };
    ASSERT_TRUE(waitUntil([&] { return plot()->xAxis->range().upper < 1.6; }));
    QTest::mouseClick(plot(), Qt::LeftButton, Qt::ShiftModifier, pixelAt(0.75));
    QTest::mouseClick(plot(), Qt::LeftButton, {}, pixelAt(1.25));
    const auto& recording = session().recording();
    const int channel = simcore::run::findChannel(recording.channels, "distance", "chassis");
    const auto at = [&](double time) {
        return recording.rows.at(static_cast<std::size_t>(std::lround(100.0 * time)))
            .at(static_cast<std::size_t>(channel));
    };
    QLabel* cell = nullptr;
    for (QLabel* label : window->plots().findChildren<QLabel*>()) {
        cell = label->accessibleName() == "Rover, plot 1" ? label : cell;
    }
    ASSERT_NE(cell, nullptr);
    EXPECT_TRUE(waitUntil([&] {
        return std::abs(cell->text().toDouble() - (at(1.25) - at(0.75))) < 0.003;
    })) << cell->text().toStdString();
    QTest::mouseClick(plot(), Qt::LeftButton, Qt::ShiftModifier, pixelAt(0.3));
    QTest::mouseMove(plot(), pixelAt(1.25));
    EXPECT_TRUE(waitUntil([&] { return std::abs(cell->text().toDouble() - at(1.25)) < 0.003; }))
        << cell->text().toStdString();
}

TEST_F(CompareTest, AnEditMarksKeptRunsAsOlderAndUndoTakesTheMarkAway) {
    ASSERT_TRUE(driveToTheEnd());
    press(Qt::Key_K, Qt::ControlModifier);
    EXPECT_FALSE(library().runs().front().stale);
    type(parameter("wheel_radius"), "8 cm");
    EXPECT_TRUE(library().runs().front().stale);
    EXPECT_THAT(runList()->topLevelItem(1)->text(0).toStdString(), HasSubstr("older design"));
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(library().runs().front().stale);
}

TEST_F(CompareTest, RemovesKeptRunsAndForgetsThemWithTheProject) {
    ASSERT_TRUE(driveToTheEnd());
    for (int i = 0; i < 5; ++i) {
        press(Qt::Key_K, Qt::ControlModifier);
    }
    // The oldest went; the styles of those that stay differ.
    ASSERT_EQ(library().runs().size(), 4U);
    std::set<int> styles;
    for (const auto& run : library().runs()) {
        styles.insert(run.style);
    }
    EXPECT_EQ(styles.size(), 4U);
    runList()->setCurrentItem(runList()->topLevelItem(2));
    QTest::mouseClick(find<QPushButton>("removeRun"), Qt::LeftButton);
    EXPECT_EQ(library().runs().size(), 3U);
    window->document().undoStack().setClean();
    window->document().createNew();
    EXPECT_TRUE(library().runs().empty());
}

TEST_F(CompareTest, TwoControllersDriveSideBySideAndTheVerdictComes) {
    EXPECT_EQ(find<QLabel>("experimentFirst")->text(), "Speed control");
    window->compare().setRival(ControllerKind::Torque);
    QTest::mouseClick(find<QPushButton>("experimentStart"), Qt::LeftButton);
    ASSERT_NE(window->experiment().rival(), nullptr);
    EXPECT_EQ(window->experiment().rival()->settings().controller, ControllerKind::Torque);
    ASSERT_TRUE(bothEnd());
    EXPECT_TRUE(window->scene().hasGhost());
    EXPECT_TRUE(find<QLabel>("compareVerdict")->isVisible());
    EXPECT_FALSE(find<QLabel>("compareVerdict")->text().isEmpty());
    EXPECT_EQ(curves(), 12);

    // The same two runs, made one after the other without a window.
    simcore::run::RunRequest request = window->runBar().request();
    const auto outcomes = simcore::experiment::driveEach(
        window->document().project(), request, {ControllerKind::Speed, ControllerKind::Torque});
    ASSERT_TRUE(outcomes);
    EXPECT_EQ(outcomes->at(0).slipAbs, widgets::outcomeOf(session()).slipAbs);
    EXPECT_EQ(outcomes->at(1).slipAbs, widgets::outcomeOf(*window->experiment().rival()).slipAbs);
}

TEST_F(CompareTest, TheRivalPausesScrubsAndStartsAgainWithTheRunOnShow) {
    session().setSpeedFactor(1.0);
    window->compare().setRival(ControllerKind::Torque);
    press(Qt::Key_K, Qt::ControlModifier | Qt::ShiftModifier);
    const RunSession* rival = window->experiment().rival();
    ASSERT_NE(rival, nullptr);
    ASSERT_TRUE(waitUntil([&] { return rival->endTime() > 0.2 && session().endTime() > 0.2; }));
    press(Qt::Key_Space);
    EXPECT_EQ(session().state(), State::Paused);
    EXPECT_EQ(rival->state(), State::Paused);
    press(Qt::Key_Backspace);
    EXPECT_EQ(rival->endTime(), 0.0);
    session().setSpeedFactor(0.0);
    press(Qt::Key_Space);
    ASSERT_TRUE(bothEnd());
    // Again from the start: the same numbers.
    const double slip = widgets::outcomeOf(*rival).slipAbs;
    press(Qt::Key_Space);
    ASSERT_TRUE(bothEnd());
    EXPECT_EQ(widgets::outcomeOf(*rival).slipAbs, slip);

    // Another run ends the experiment; the rival stays as a kept run.
    window->runBar().setController(ControllerKind::Hybrid);
    ASSERT_TRUE(driveToTheEnd());
    EXPECT_EQ(window->experiment().rival(), nullptr);
    EXPECT_FALSE(find<QLabel>("compareVerdict")->isVisible());
    EXPECT_EQ(library().runs().size(), 1U);
}

TEST_F(CompareTest, AControllerIsNeverHeldAgainstItself) {
    window->compare().setRival(ControllerKind::Hybrid);
    window->runBar().setController(ControllerKind::Hybrid);
    EXPECT_NE(window->compare().rival(), ControllerKind::Hybrid);
}

TEST_F(CompareTest, AScenarioThatCannotRunSaysSoAndStartsNothing) {
    auto next = window->document().project();
    for (auto& scenario : next.scenarios) {
        scenario.run.step = 0.5;
    }
    window->document().edit("Break", next);
    QTest::mouseClick(find<QPushButton>("experimentStart"), Qt::LeftButton);
    EXPECT_EQ(window->experiment().rival(), nullptr);
    EXPECT_TRUE(library().runs().empty());
    EXPECT_EQ(session().state(), State::Empty);
    EXPECT_THAT(find<QLabel>("runStatus")->text().toStdString(), HasSubstr("Cannot run"));
}
