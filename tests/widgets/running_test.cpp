// Driving in the real window: play, pause, step, scrub, reset, plots and export.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolButton>

#include <gmock/gmock.h>

#include "simcore/io/csv.h"
#include "simcore/run/sampler.h"
#include "tests/support/dialogs.h"
#include "tests/support/studio.h"
#include "widgets/plots/export_dialog.h"
#include "widgets/plots/plot_panel.h"
#include "widgets/session/run_bar.h"
#include "widgets/session/timeline_slider.h"

using simcore::run::RunRequest;
using simcore::run::Simulation;
using testsupport::waitUntil;
using State = widgets::RunSession::State;

namespace {

/// Seconds of simulated time the tests drive.
constexpr double kDrive = 1.5;

class RunningTest : public testsupport::StudioTest {
  protected:
    RunningTest() { window->runBar().setScenario("flat"); }

    widgets::RunSession& session() { return window->session(); }

    bool driveFor(double seconds) {
        session().setSpeedFactor(0.0);
        press(Qt::Key_Space);
        const bool reached = waitUntil([&] { return session().endTime() >= seconds; });
        press(Qt::Key_Space);
        return reached && waitUntil([&] { return session().state() == State::Paused; });
    }

    bool plotsShowWholeRun() const {
        return window->plots().window().second == window->session().recording().rows.back()[0];
    }

    /// Makes the scenario end by itself soon.
    void shortenScenario(double duration) {
        auto next = window->document().project();
        for (auto& scenario : next.scenarios) {
            scenario.run.duration = duration;
        }
        window->document().edit("Shorten", next);
    }

    /// Pixels of a plot in about the colour of a wheel.
    int pixelsOf(const QString& plot, const QColor& color) {
        const QImage image = find<QWidget>(plot)->grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const QColor p = image.pixelColor(x, y);
                const int distance = std::abs(p.red() - color.red()) +
                                     std::abs(p.green() - color.green()) +
                                     std::abs(p.blue() - color.blue());
                count += distance < 60 ? 1 : 0;
            }
        }
        return count;
    }
};

}  // namespace

TEST_F(RunningTest, SpacePlaysAndPausesAndTimeAdvances) {
    ASSERT_EQ(session().state(), State::Empty);
    EXPECT_FALSE(window->plots().hint().isEmpty());
    press(Qt::Key_Space);
    EXPECT_EQ(session().state(), State::Playing);
    ASSERT_TRUE(waitUntil([&] { return session().endTime() > 0.2; }));
    EXPECT_TRUE(waitUntil([&] { return window->plots().hint().isEmpty(); }));
    press(Qt::Key_Space);
    EXPECT_EQ(session().state(), State::Paused);
    const double stopped = session().endTime();
    QTest::qWait(150);
    EXPECT_DOUBLE_EQ(session().endTime(), stopped);
    EXPECT_GT(session().recording().rows.size(), 10U);
}

// A number typed and confirmed leaves the keyboard in its line: Space must drive all the same.
TEST_F(RunningTest, SpaceDrivesRightAfterANumberWasTyped) {
    widgets::QuantityField* field = parameter("wheel_radius");
    type(field, "8 cm");
    ASSERT_TRUE(field->hasFocus());
    QTest::keyClick(field, Qt::Key_Space);
    EXPECT_EQ(session().state(), State::Playing);
    EXPECT_DOUBLE_EQ(session().settings().mechanism.wheels.front().radius, 0.08);
    ASSERT_TRUE(waitUntil([&] { return session().endTime() > 0.02; }));
    QTest::keyClick(field, Qt::Key_Space);
    EXPECT_EQ(session().state(), State::Paused);
    QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.07);
    // Within a text it is a blank.
    QTest::mouseClick(field, Qt::LeftButton);
    field->selectAll();
    QTest::keyClicks(field, "8 cm");
    EXPECT_EQ(field->text(), "8 cm");

    auto* friction = find<QDoubleSpinBox>("friction");
    QTest::mouseClick(friction, Qt::LeftButton);
    friction->selectAll();
    QTest::keyClicks(friction, "0.5");
    QTest::keyClick(friction, Qt::Key_Return);
    QTest::qWait(20);
    EXPECT_FALSE(friction->hasFocus());
}

TEST_F(RunningTest, SceneShowsTheInstantOnShow) {
    ASSERT_TRUE(driveFor(kDrive));
    const auto* shown = session().shown();
    for (std::size_t i = 0; i < shown->bodies.size(); ++i) {
        EXPECT_LT(
            (window->scene().bodyPose(static_cast<int>(i)).position - shown->bodies[i].position)
                .norm(),
            1e-9);
    }
}

TEST_F(RunningTest, ScrubbingMovesTheSceneBackAndTheEndComesAgain) {
    ASSERT_TRUE(driveFor(kDrive));
    const double end = session().endTime();
    auto* timeline = find<widgets::TimelineSlider>("timeline");
    QTest::mouseClick(timeline, Qt::LeftButton, {},
                      QPoint(timeline->width() / 2, timeline->height() / 2));
    EXPECT_NEAR(session().shownTime(), 0.5 * end, 0.05 * end);
    EXPECT_FALSE(session().isLive());
    const auto pose = session().shown()->bodies.front().position;
    EXPECT_LT((window->scene().bodyPose(0).position - pose).norm(), 1e-9);
    const double before = session().shownTime();
    window->viewport()->setFocus();
    QTest::keyClick(window->viewport(), Qt::Key_Left);
    EXPECT_LT(session().shownTime(), before);
    press(Qt::Key_End, Qt::ControlModifier);
    EXPECT_TRUE(session().isLive());
    EXPECT_DOUBLE_EQ(session().shownTime(), end);
}

TEST_F(RunningTest, StepAdvancesByOneEngineStep) {
    window->viewport()->setFocus();
    QTest::keyClick(window->viewport(), Qt::Key_Right);
    ASSERT_TRUE(session().hasRun());
    EXPECT_EQ(session().shown()->step, 1);
    EXPECT_NEAR(session().endTime(), session().settings().step, 1e-12);
}

TEST_F(RunningTest, ResetGivesTheSameRunAgainBitForBit) {
    shortenScenario(kDrive);
    session().setSpeedFactor(0.0);
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return session().state() == State::Finished; }));
    const std::string hash = session().report().stateHash;
    press(Qt::Key_Backspace);
    EXPECT_EQ(session().state(), State::Ready);
    EXPECT_DOUBLE_EQ(session().endTime(), 0.0);
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return session().state() == State::Finished; }));
    EXPECT_EQ(session().report().stateHash, hash);

    // The same without a window.
    RunRequest request;
    request.scenario = "flat";
    auto run = simcore::run::prepareRun(window->document().project(), request);
    ASSERT_TRUE(run.ok());
    Simulation simulation(*run);
    while (!simulation.finished()) {
        simulation.step();
    }
    EXPECT_EQ(simulation.report().stateHash, hash);
}

TEST_F(RunningTest, EditMakesTheRunStaleAndPlayStartsANewOne) {
    ASSERT_TRUE(driveFor(0.3));
    type(parameter("wheel_radius"), "80");
    EXPECT_TRUE(session().isStale());
    EXPECT_THAT(find<QLabel>("runStatus")->text().toStdString(), testing::HasSubstr("Edited"));
    // The design is on show, at its place.
    EXPECT_LT(window->scene().bodyPose(0).position.norm(), 1e-12);
    ASSERT_TRUE(driveFor(0.3));
    EXPECT_FALSE(session().isStale());
    EXPECT_DOUBLE_EQ(session().settings().mechanism.wheels.front().radius, 0.08);
}

TEST_F(RunningTest, WhatTheBarAsksForReachesTheRun) {
    auto* controller = find<QComboBox>("controller");
    controller->setFocus();
    QTest::keyClick(controller, Qt::Key_Down);
    auto* engine = find<QComboBox>("engine");
    engine->setFocus();
    QTest::keyClick(engine, Qt::Key_Down);
    auto* friction = find<QWidget>("friction");
    QTest::keyClick(friction, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(friction, "0.45");
    QTest::keyClick(friction, Qt::Key_Return);
    ASSERT_TRUE(driveFor(0.1));
    EXPECT_EQ(session().settings().controller, simcore::project::ControllerKind::Synchronised);
    EXPECT_EQ(session().settings().engine, simcore::project::EngineKind::Reduced);
    EXPECT_EQ(session().report().engine, "reduced");
    EXPECT_DOUBLE_EQ(session().settings().friction, 0.45);
}

TEST_F(RunningTest, ManualKeysDriveOnlyAManualRun) {
    window->runBar().setScenario("flat");
    auto* controller = find<QComboBox>("controller");
    controller->setFocus();
    QTest::keyClick(controller, Qt::Key_End);
    session().setSpeedFactor(0.0);
    press(Qt::Key_Space);
    ASSERT_EQ(session().state(), State::Playing);
    ASSERT_EQ(session().settings().controller, simcore::project::ControllerKind::Manual);
    window->viewport()->setFocus();
    QTest::keyPress(window->viewport(), Qt::Key_W);
    EXPECT_TRUE(waitUntil([&] { return session().shown()->speed > 0.05; }));
    QTest::keyRelease(window->viewport(), Qt::Key_W);
    EXPECT_TRUE(waitUntil([&] { return session().shown()->speed < 0.02; }));
}

// Shift drives slowly; the run panel says what is asked, and how to drive when nothing is.
TEST_F(RunningTest, ShiftDrivesSlowlyAndTheBarSaysSo) {
    window->runBar().setScenario("flat");
    auto* controller = find<QComboBox>("controller");
    controller->setFocus();
    QTest::keyClick(controller, Qt::Key_End);
    session().setSpeedFactor(0.0);
    press(Qt::Key_Space);
    ASSERT_EQ(session().state(), State::Playing);
    window->viewport()->setFocus();
    const auto status = [&] { return find<QLabel>("runStatus")->text().toStdString(); };
    EXPECT_THAT(status(), testing::HasSubstr("W A S D"));
    QTest::keyPress(window->viewport(), Qt::Key_Shift);
    QTest::keyPress(window->viewport(), Qt::Key_W, Qt::ShiftModifier);
    EXPECT_THAT(status(), testing::HasSubstr("ahead 0.0333 m/s"));
    const double wanted = session().settings().speed / 3.0;
    EXPECT_TRUE(waitUntil([&] { return std::abs(session().shown()->speed - wanted) < 0.003; }));
    QTest::keyRelease(window->viewport(), Qt::Key_Shift);
    QTest::keyPress(window->viewport(), Qt::Key_D);
    EXPECT_THAT(status(), testing::HasSubstr("ahead 0.1 m/s, right"));
    QTest::keyRelease(window->viewport(), Qt::Key_W);
    QTest::keyRelease(window->viewport(), Qt::Key_D);
    EXPECT_THAT(status(), testing::HasSubstr("W A S D"));
}

// A steered rover has more bodies and joints in a run than in the design: a click on what is shown
// leads to its own part.
TEST_F(RunningTest, SteeredRoverIsPickedByWhatIsShown) {
    ASSERT_TRUE(window->document().open(testsupport::projectFile("rocker_bogie_steered")).empty());
    window->runBar().setScenario("circle");
    ASSERT_TRUE(driveFor(0.2));
    const auto& mechanism = session().settings().mechanism;
    EXPECT_NE(mechanism.joints.size(), window->document().derived().mechanism->joints.size());
    for (const char* name : {"left_rear_steering", "left_middle_axle"}) {
        emit window->viewport()->jointPicked(mechanism.findJoint(name));
        const auto shown = find<QLineEdit>("property:name")->text().toStdString();
        EXPECT_EQ(shown, "{side}" + std::string(name).substr(4));
    }
}

TEST_F(RunningTest, ProblemsStopARunBeforeItStarts) {
    auto next = window->document().project();
    for (auto& scenario : next.scenarios) {
        scenario.terrain.kind = simcore::project::TerrainKind::Stairs;
        scenario.terrain.height = -1.0;
    }
    window->document().edit("Break", next);
    EXPECT_FALSE(window->playPause());
    EXPECT_EQ(session().state(), State::Empty);
    EXPECT_THAT(find<QLabel>("runStatus")->text().toStdString(), testing::HasSubstr("Problems"));
}

TEST_F(RunningTest, HiddenWheelsLeaveThePlot) {
    window->plots().setQuantity(0, "normal_force");
    ASSERT_TRUE(driveFor(kDrive));
    const QColor front(0, 114, 178);
    EXPECT_TRUE(waitUntil([&] { return pixelsOf("plot:0", front) > 30; }));
    for (QToolButton* toggle : window->findChildren<QToolButton*>("wheelToggle")) {
        if (toggle->text() == "front") {
            QTest::mouseClick(toggle, Qt::LeftButton);
        }
    }
    EXPECT_TRUE(waitUntil([&] { return pixelsOf("plot:0", front) < 5; }));
}

TEST_F(RunningTest, WheelZoomFreesTheWindowAndFitBringsItBack) {
    ASSERT_TRUE(driveFor(kDrive));
    ASSERT_TRUE(waitUntil([&] { return plotsShowWholeRun(); }));
    auto* plot = find<QWidget>("plot:0");
    const auto whole = window->plots().window();
    const QPointF at(plot->width() / 2.0, plot->height() / 2.0);
    QWheelEvent zoom(at, plot->mapToGlobal(at), {}, QPoint(0, 240), Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(plot, &zoom);
    QTest::qWait(200);
    const auto zoomed = window->plots().window();
    EXPECT_LT(zoomed.second - zoomed.first, 0.9 * (whole.second - whole.first));
    QTest::mouseClick(find<QWidget>("fit"), Qt::LeftButton);
    EXPECT_TRUE(waitUntil([&] { return plotsShowWholeRun(); }));
}

TEST_F(RunningTest, ClickInAPlotScrubsToThatTime) {
    ASSERT_TRUE(driveFor(kDrive));
    ASSERT_TRUE(waitUntil([&] { return plotsShowWholeRun(); }));
    auto* plot = find<QWidget>("plot:1");
    // The axes follow at the next drawing.
    plot->repaint();
    QTest::mouseClick(plot, Qt::LeftButton, {}, QPoint(plot->width() / 2, plot->height() / 2));
    EXPECT_FALSE(session().isLive());
    EXPECT_NEAR(session().shownTime(), 0.5 * session().endTime(), 0.25 * session().endTime());
}

TEST_F(RunningTest, ExportedCsvIsWhatAHeadlessRunWrites) {
    shortenScenario(kDrive);
    session().setSpeedFactor(0.0);
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return session().state() == State::Finished; }));
    const QTemporaryDir folder;
    const QString file = folder.filePath("gui.csv");
    ASSERT_TRUE(session().exportCsv(file).ok());

    RunRequest request;
    request.scenario = "flat";
    auto run = simcore::run::prepareRun(window->document().project(), request);
    ASSERT_TRUE(run.ok());
    simcore::run::RunWorker worker(*run);
    worker.setSpeedFactor(0.0);
    worker.play();
    ASSERT_TRUE(waitUntil([&] { return worker.state() == simcore::run::WorkerState::Finished; }));
    simcore::run::Recording recording;
    recording.channels = simcore::run::makeChannels(run->mechanism);
    worker.drain(recording.rows, recording.frames);
    const QString other = folder.filePath("headless.csv");
    ASSERT_TRUE(simcore::io::saveCsv(recording, *run, worker.report(), session().origin(),
                                     other.toStdString())
                    .ok());
    QFile a(file), b(other);
    ASSERT_TRUE(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    const QByteArray bytes = a.readAll();
    EXPECT_GT(bytes.size(), 10000);
    EXPECT_EQ(bytes, b.readAll());
}

// The dialog over the plots: what they show is ticked; searching, ticking and the range count.
TEST_F(RunningTest, ChosenChannelsOfTheVisibleTimeAreExported) {
    ASSERT_TRUE(driveFor(1.2));
    window->plots().setPlotCount(1);
    window->plots().setQuantity(0, "normal_force");
    const QTemporaryDir folder;
    const QString file = folder.filePath("part.csv");
    auto* plot = find<QWidget>("plot:0");
    plot->repaint();
    // Two cursors: one marked with Shift, one where a click put the run.
    QTest::mouseClick(plot, Qt::LeftButton, Qt::ShiftModifier,
                      QPoint(plot->width() / 3, plot->height() / 2));
    QTest::mouseClick(plot, Qt::LeftButton, {}, QPoint(plot->width() / 2, plot->height() / 2));
    const double to = session().shownTime();
    QString size;
    testsupport::onNext<widgets::ExportDialog>([&](widgets::ExportDialog* dialog) {
        const auto wheels = session().settings().mechanism.wheels.size();
        EXPECT_EQ(dialog->cut().channels.size(), wheels);
        auto* search = dialog->findChild<QLineEdit*>("exportSearch");
        QTest::keyClicks(search, "pitch");
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportNone"), Qt::LeftButton);
        EXPECT_EQ(dialog->cut().channels.size(), wheels);  // only those the search shows
        search->clear();
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportNone"), Qt::LeftButton);
        EXPECT_FALSE(dialog->findChild<QPushButton*>("exportWrite")->isEnabled());
        QTest::keyClicks(search, "torque applied front");
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportAll"), Qt::LeftButton);
        EXPECT_EQ(dialog->findChild<QComboBox*>("exportRange")->currentIndex(), 1);
        size = dialog->findChild<QLabel*>("exportSize")->text();
        testsupport::chooseFile(file);
        QTest::mouseClick(dialog->findChild<QPushButton*>("exportWrite"), Qt::LeftButton);
    });
    QTest::mouseClick(find<QPushButton>("exportCsv"), Qt::LeftButton);
    std::ifstream table(file.toStdString());
    std::string header, row, last;
    std::getline(table, header);
    EXPECT_EQ(header,
              "time [s],torque_applied_front [N*m],torque_applied_bogie_left_front [N*m],"
              "torque_applied_bogie_right_front [N*m]");
    int rows = 0;
    double first = -1.0;
    while (std::getline(table, row)) {
        first = rows++ == 0 ? std::stod(row) : first;
        last = row;
    }
    EXPECT_GT(first, 0.0);
    EXPECT_LE(std::stod(last), to + 1e-6);
    EXPECT_GE(std::stod(last), to - 0.011);
    EXPECT_EQ(size, QString("4 columns with the time, %1 rows").arg(rows));
}

TEST_F(RunningTest, PlotPicturesAreWrittenInThreeFormats) {
    ASSERT_TRUE(driveFor(0.5));
    const QTemporaryDir folder;
    for (const char* ending : {".png", ".svg", ".pdf"}) {
        const QString file = folder.filePath(QString("plots") + ending);
        EXPECT_TRUE(window->plots().savePicture(file).empty()) << ending;
        EXPECT_GT(QFileInfo(file).size(), 2000) << ending;
    }
    EXPECT_FALSE(window->plots().savePicture(folder.filePath("plots.xyz")).empty());
    EXPECT_FALSE(window->plots().savePicture("/nonexistent/plots.png").empty());
}

TEST_F(RunningTest, FasterAndSlowerKeysChangePlaybackOnly) {
    const double before = session().speedFactor();
    press(Qt::Key_Plus);
    EXPECT_GT(session().speedFactor(), before);
    press(Qt::Key_Minus);
    EXPECT_DOUBLE_EQ(session().speedFactor(), before);
}
