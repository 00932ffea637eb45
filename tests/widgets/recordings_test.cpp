// Recordings in the real window: saved during and after a run, opened, looked at, run again.
#include <QComboBox>
#include <QDir>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QProgressDialog>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QThread>
#include <QToolButton>
#include <fstream>

#include <gmock/gmock.h>

#include "simcore/io/project_file.h"
#include "simcore/io/recording.h"
#include "simcore/io/recording_chunks.h"
#include "simcore/io/recording_header.h"
#include "simcore/io/replay.h"
#include "simcore/run/sampler.h"
#include "tests/support/dialogs.h"
#include "tests/support/studio.h"
#include "widgets/plots/plot_panel.h"
#include "widgets/session/run_bar.h"
#include "widgets/session/timeline_slider.h"
#include "widgets/window/background.h"
#include "widgets/window/recording_commands.h"

using simcore::io::RecordingReader;
using testing::HasSubstr;
using testsupport::answerNextBox;
using testsupport::bytesOf;
using testsupport::chooseFile;
using testsupport::onNext;
using testsupport::projectFile;
using testsupport::waitUntil;
using State = widgets::RunSession::State;

namespace {

class RecordingsTest : public testsupport::StudioTest {
  protected:
    RecordingsTest() : file(folder.filePath("run.roverrec")) {
        window->runBar().setScenario("flat");
        session().setSpeedFactor(0.0);
    }

    widgets::RunSession& session() { return window->session(); }

    std::string status() { return find<QLabel>("runStatus")->text().toStdString(); }

    void driveFor(double seconds) {
        press(Qt::Key_Space);
        ASSERT_TRUE(waitUntil([&] { return session().endTime() >= seconds; }));
        press(Qt::Key_Space);
        ASSERT_TRUE(waitUntil([&] { return session().state() == State::Paused; }));
    }

    /// A recording as `roversim` makes it, of a project and a request.
    void record(const simcore::project::Project& project, simcore::run::RunRequest request) {
        using namespace simcore;
        ASSERT_TRUE(io::carryFiles(project, request).empty());
        auto prepared = run::prepareRun(project, request);
        ASSERT_TRUE(prepared) << toString(prepared.problems());
        run::Simulation simulation(std::move(prepared).value());
        auto writer = io::RecordingWriter::create(
            file.toStdString(),
            io::recordingHeader(project, request, simulation.settings(), "ode", "mine.rover"));
        ASSERT_TRUE(writer) << toString(writer.problems());
        run::Sampler sampler(simulation.settings().mechanism);
        sampler.start(simulation.snapshot());
        std::vector<std::vector<double>> rows;
        std::vector<std::shared_ptr<const run::Snapshot>> frames;
        const auto pass = [&] {
            sampler.moveTo(rows, frames);
            (*writer)->add(rows, frames);
            rows.clear();
            frames.clear();
        };
        while (!simulation.finished()) {
            simulation.step();
            sampler.take(simulation.snapshot());
            pass();
        }
        sampler.finish(simulation.snapshot());
        pass();
        (*writer)->add(io::HashMark{simulation.snapshot().step, simulation.report().stateHash});
        ASSERT_TRUE((*writer)->finish(simulation.report()));
        hash = simulation.report().stateHash;
    }

    void recordSolero(double duration = 1.5) {
        simcore::run::RunRequest request;
        request.scenario = "rough-3d";
        request.duration = duration;
        request.friction = 0.55;
        request.seed = 4;
        request.assignments = {{"wheel_radius", "8 cm"}};
        record(window->document().project(), request);
    }

    /// Writes the recording anew, each chunk as `change` gives it.
    template <class Change>
    void repack(Change change) {
        using namespace simcore::io;
        const std::string old = bytesOf(file);
        std::string bytes(kRecordingMagic);
        for (std::size_t at = kRecordingMagic.size(); at < old.size();) {
            const auto head = readHead(std::string_view(old).substr(at, kChunkHeadSize));
            ASSERT_TRUE(head);
            bytes += change(*head, old.substr(at, kChunkHeadSize + head->stored));
            at += kChunkHeadSize + head->stored;
        }
        std::ofstream(file.toStdString(), std::ios::binary) << bytes;
    }

    /// The same for the rows of a table.
    template <class Change>
    void repackTable(const simcore::io::ChunkTag& tag, Change change) {
        using namespace simcore::io;
        repack([&](const ChunkHead& head, const std::string& chunk) {
            if (head.tag != tag) {
                return chunk;
            }
            Table table = unpackTable(head, chunk.substr(kChunkHeadSize)).value();
            change(table);
            return packTable(tag, table);
        });
    }

    simcore::io::ReplayResult replayOf(const QString& recording) {
        auto reader = RecordingReader::open(recording.toStdString());
        EXPECT_TRUE(reader && reader.problems().empty()) << toString(reader.problems());
        auto replayed = simcore::io::replay(**reader);
        EXPECT_TRUE(replayed) << toString(replayed.problems());
        return *replayed;
    }

    QTemporaryDir folder;
    QString file;
    std::string hash;
};

}  // namespace

TEST_F(RecordingsTest, APausedRunIsSavedByItsKeyAndIsTheSameRunAgain) {
    EXPECT_FALSE(window->actions().at("saveRecording")->isEnabled());
    driveFor(1.0);
    const std::string now = session().report().stateHash;
    chooseFile(folder.filePath("run"));  // the ending is added
    press(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_TRUE(QFile::exists(file));
    const auto again = replayOf(file);
    EXPECT_TRUE(again.same());
    EXPECT_EQ(again.found, now);
    EXPECT_EQ(again.steps, session().report().steps);
    EXPECT_THAT(window->files().recentFiles(), testing::Contains(file));
    // The run goes on after it.
    const double before = session().endTime();
    press(Qt::Key_Space);
    EXPECT_TRUE(waitUntil([&] { return session().endTime() > before + 0.2; }));
}

TEST_F(RecordingsTest, ARunIsSavedWhileItPlays) {
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return session().endTime() > 0.5; }));
    ASSERT_EQ(session().state(), State::Playing);
    ASSERT_TRUE(window->recordings().saveTo(file));
    EXPECT_TRUE(replayOf(file).same());
    EXPECT_GT(replayOf(file).steps, 200);
}

// With the keys of a person at their steps.
TEST_F(RecordingsTest, ADriveByHandIsTheSameRunAgain) {
    auto* controller = find<QComboBox>("controller");
    controller->setFocus();
    QTest::keyClick(controller, Qt::Key_End);
    press(Qt::Key_Space);
    ASSERT_EQ(session().state(), State::Playing);
    window->viewport()->setFocus();
    QTest::keyPress(window->viewport(), Qt::Key_W);
    ASSERT_TRUE(waitUntil([&] { return session().shown()->speed > 0.05; }));
    QTest::keyPress(window->viewport(), Qt::Key_A);
    const double turned = session().endTime();
    ASSERT_TRUE(waitUntil([&] { return session().endTime() > turned + 0.5; }));
    QTest::keyRelease(window->viewport(), Qt::Key_W);
    QTest::keyRelease(window->viewport(), Qt::Key_A);
    session().pause();
    ASSERT_TRUE(window->recordings().saveTo(file));
    const auto reader = RecordingReader::open(file.toStdString());
    EXPECT_GE((*reader)->commands().size(), 3U);
    EXPECT_TRUE(replayOf(file).same());
}

// The ending is added after the dialog, which asked about another name.
TEST_F(RecordingsTest, NothingIsReplacedUnasked) {
    driveFor(0.2);
    std::ofstream(file.toStdString()) << "precious";
    QString said;
    answerNextBox(QMessageBox::No, &said);
    chooseFile(folder.filePath("run"));
    window->recordings().save();
    EXPECT_THAT(said.toStdString(), HasSubstr("run.roverrec"));
    EXPECT_EQ(bytesOf(file), "precious");
    answerNextBox(QMessageBox::Yes);
    chooseFile(folder.filePath("run"));
    window->recordings().save();
    EXPECT_TRUE(replayOf(file).same());
    // Nor is what stands beside a table.
    const QString beside = folder.filePath("table.json");
    std::ofstream(beside.toStdString()) << "precious";
    answerNextBox(QMessageBox::No, &said);
    chooseFile(folder.filePath("table.csv"));
    window->plots().exportCsv();
    EXPECT_THAT(said.toStdString(), HasSubstr("table.json"));
    EXPECT_EQ(bytesOf(beside), "precious");
    EXPECT_FALSE(QFile::exists(folder.filePath("table.csv")));
    answerNextBox(QMessageBox::Yes);
    chooseFile(folder.filePath("table.csv"));
    window->plots().exportCsv();
    EXPECT_THAT(bytesOf(beside), HasSubstr("state_hash"));
}

TEST_F(RecordingsTest, AFailedSaveIsExplained) {
    driveFor(0.2);
    QString said;
    answerNextBox(QMessageBox::Ok, &said);
    EXPECT_FALSE(window->recordings().saveTo("/proc/none/run.roverrec"));
    EXPECT_THAT(said.toStdString(), HasSubstr("/proc/none/run.roverrec"));
    EXPECT_EQ(session().state(), State::Paused);
}

// Closing with a run that was not saved does not ask, and leaves nothing behind.
TEST_F(RecordingsTest, NothingIsLeftOfARunThatWasNotSaved) {
    driveFor(0.5);
    const QDir cache(QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/runs");
    EXPECT_TRUE(cache.exists());
    EXPECT_TRUE(cache.isEmpty());
    window->close();
    EXPECT_FALSE(window->isVisible());
}

TEST_F(RecordingsTest, AnOpenedRecordingIsShownAsAfterItsRun) {
    recordSolero();
    chooseFile(file);
    press(Qt::Key_O, Qt::ControlModifier | Qt::ShiftModifier);
    ASSERT_NE(session().recorded(), nullptr);
    EXPECT_EQ(session().state(), State::Finished);
    EXPECT_FALSE(session().isStale());
    EXPECT_NEAR(session().endTime(), 1.5, 0.01);
    EXPECT_THAT(status(), HasSubstr("Recording: Time is up"));
    EXPECT_THAT(window->windowTitle().toStdString(), HasSubstr("run.roverrec"));
    // The rover as recorded, in a project without a file.
    EXPECT_TRUE(window->document().file().isEmpty());
    EXPECT_FALSE(window->document().isModified());
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.08);
    EXPECT_EQ(window->runBar().scenario(), "rough-3d");
    EXPECT_FALSE(window->runBar().request().friction.has_value());
    // 3-D view, with the whole way behind it.
    const auto* end = session().shown();
    EXPECT_LT((window->scene().bodyPose(0).position - end->bodies[0].position).norm(), 1e-9);
    EXPECT_GT(window->scene().trailLength(), 5);
    EXPECT_TRUE(waitUntil([&] { return window->plots().hint().isEmpty(); }));
    EXPECT_EQ(session().recording().rows.size(), 151U);
    // Time line and keys look back, and nothing is run.
    auto* line = find<widgets::TimelineSlider>("timeline");
    QTest::mouseClick(line, Qt::LeftButton, {}, QPoint(line->width() / 2, line->height() / 2));
    EXPECT_NEAR(session().shownTime(), 0.75, 0.1);
    const double middle = session().shownTime();
    window->viewport()->setFocus();
    QTest::keyClick(window->viewport(), Qt::Key_Left);
    EXPECT_NEAR(session().shownTime(), middle - 0.02, 1e-6);
    press(Qt::Key_Backspace);
    EXPECT_EQ(session().shownTime(), 0.0);
    press(Qt::Key_End, Qt::ControlModifier);
    EXPECT_TRUE(session().isLive());
    QTest::keyClick(window->viewport(), Qt::Key_Right);
    EXPECT_NE(session().recorded(), nullptr);
    EXPECT_EQ(session().state(), State::Finished);
    // The table of it.
    const QString csv = folder.filePath("run.csv");
    const auto written = session().exportCsv(csv);
    ASSERT_TRUE(written) << toString(written.problems());
    EXPECT_THAT(bytesOf(folder.filePath("run.json")), HasSubstr(hash));
}

// Play makes a new run of the same: the request is in the project now.
TEST_F(RecordingsTest, PlayMakesANewRunOfTheRecordedOne) {
    recordSolero(0.6);
    ASSERT_TRUE(window->open(file));
    press(Qt::Key_Space);
    EXPECT_EQ(session().recorded(), nullptr);
    ASSERT_TRUE(waitUntil([&] { return session().state() == State::Finished; }));
    EXPECT_EQ(session().report().stateHash, hash);
    // And that can be saved in its turn.
    const QString copy = folder.filePath("copy.roverrec");
    ASSERT_TRUE(window->recordings().saveTo(copy));
    EXPECT_EQ(replayOf(copy).found, hash);
}

TEST_F(RecordingsTest, AnEditOfAnOpenedRecordingShowsTheDesign) {
    recordSolero(0.4);
    ASSERT_TRUE(window->open(file));
    type(parameter("wheel_radius"), "75");
    EXPECT_TRUE(session().isStale());
    press(Qt::Key_Space);
    EXPECT_EQ(session().recorded(), nullptr);
    EXPECT_DOUBLE_EQ(session().settings().mechanism.wheels.front().radius, 0.075);
}

TEST_F(RecordingsTest, RunAgainSaysWhetherItIsTheSame) {
    EXPECT_FALSE(window->actions().at("runAgain")->isEnabled());
    recordSolero(0.6);
    ASSERT_TRUE(window->open(file));
    QString said;
    answerNextBox(QMessageBox::Ok, &said);
    press(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_THAT(said.toStdString(), HasSubstr("The same run"));
    EXPECT_THAT(said.toStdString(), HasSubstr(hash));
    EXPECT_NE(session().recorded(), nullptr);
    repackTable(simcore::io::kMarksChunk, [](simcore::io::Table& marks) {
        marks.back()[2] = marks.back()[2] == 0.0 ? 1.0 : 0.0;
    });
    ASSERT_TRUE(window->open(file));
    answerNextBox(QMessageBox::Ok, &said);
    window->recordings().runAgain();
    EXPECT_THAT(said.toStdString(), HasSubstr("Another run"));
    EXPECT_THAT(said.toStdString(), HasSubstr(hash.substr(0, 8)));
    EXPECT_THAT(said.toStdString(), HasSubstr(hash + " came out"));
}

// Its numbers would take any memory.
TEST_F(RecordingsTest, MoreNumbersThanItsRoverHasAreRefused) {
    recordSolero(0.4);
    const std::string good = bytesOf(file);
    const auto change = [&](const auto& how) {
        std::ofstream(file.toStdString(), std::ios::binary) << good;
        auto header = (*RecordingReader::open(file.toStdString()))->header();
        how(header);
        repack([&](const simcore::io::ChunkHead& head, const std::string& chunk) {
            return head.tag == simcore::io::kHeaderChunk
                       ? simcore::io::packText(head.tag, simcore::io::formatHeader(header))
                       : chunk;
        });
        return widgets::loadRecording(file.toStdString());
    };
    using Header = simcore::io::RecordingHeader;
    EXPECT_TRUE(change([](const Header&) {}));
    for (const auto& refused :
         {change([](Header& header) { header.size.joints = 9000; }), change([](Header& header) {
              const auto last = header.channels.back();
              header.channels.resize(5 * header.channels.size(), last);
          })}) {
        ASSERT_FALSE(refused);
        EXPECT_THAT(toString(refused.problems()), HasSubstr("of another rover"));
    }
}

// The ground comes from the recording: its files are gone.
TEST_F(RecordingsTest, TheGroundOfAnOpenedRecordingNeedsNoFile) {
    auto project = simcore::io::loadProject(projectFile("terrains").toStdString());
    ASSERT_TRUE(project);
    const QDir mine(folder.path());
    ASSERT_TRUE(mine.mkdir("mine"));
    const QString ground = folder.filePath("mine/ground.png");
    ASSERT_TRUE(QFile::copy(QString(ROVER_SOURCE_DIR) + "/assets/terrains/dunes.png", ground));
    auto changed = *project;
    for (auto& scenario : changed.scenarios) {
        if (scenario.name == "image") {
            scenario.terrain.file = "ground.png";
        }
    }
    simcore::run::RunRequest request;
    request.scenario = "image";
    request.duration = 0.4;
    request.files.folder = folder.filePath("mine").toStdString();
    record(changed, request);
    ASSERT_TRUE(QFile::remove(ground));
    ASSERT_TRUE(window->open(file));
    EXPECT_NE(session().settings().terrain, nullptr);
    EXPECT_FALSE(hasCritical(window->document().derived().problems))
        << toString(window->document().derived().problems);
    press(Qt::Key_Space);
    ASSERT_TRUE(waitUntil([&] { return session().state() == State::Finished; }));
    EXPECT_EQ(session().report().stateHash, hash);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
              (QStringList{"mine", "run.roverrec"}));
}

// A recording without its ground still shows what was driven.
TEST_F(RecordingsTest, WithoutItsGroundARecordingIsShownAndItSaysSo) {
    auto project = simcore::io::loadProject(projectFile("terrains").toStdString());
    simcore::run::RunRequest request;
    request.scenario = "image";
    request.duration = 0.4;
    request.files.folder = QFileInfo(projectFile("terrains")).absolutePath().toStdString();
    record(*project, request);
    std::string bytes = bytesOf(file);
    const std::size_t part = bytes.find("FILE");
    ASSERT_NE(part, std::string::npos);
    bytes[part + 60] = static_cast<char>(bytes[part + 60] ^ 1);
    std::ofstream(file.toStdString(), std::ios::binary) << bytes;
    QString said;
    answerNextBox(QMessageBox::Ok, &said);
    ASSERT_TRUE(window->open(file));
    EXPECT_THAT(said.toStdString(), HasSubstr("the ground cannot be shown"));
    EXPECT_NEAR(session().endTime(), 0.4, 0.01);
}

TEST_F(RecordingsTest, ACutRecordingOpensUpToWhereItIsWholeAndSaysSo) {
    recordSolero(4.0);
    const std::string bytes = bytesOf(file);
    const QString cut = folder.filePath("cut.roverrec.part");
    std::ofstream(cut.toStdString(), std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    QString said;
    answerNextBox(QMessageBox::Ok, &said);
    ASSERT_TRUE(window->open(cut));
    EXPECT_THAT(said.toStdString(), HasSubstr("interrupted or is damaged"));
    EXPECT_THAT(status(), HasSubstr("incomplete: up to"));
    EXPECT_GT(session().endTime(), 1.0);
    EXPECT_LT(session().endTime(), 3.5);
}

TEST_F(RecordingsTest, WhatIsNoRecordingIsExplainedAndEverythingStays) {
    driveFor(0.2);
    std::ofstream(file.toStdString()) << "no recording";
    QString said;
    answerNextBox(QMessageBox::Ok, &said);
    EXPECT_FALSE(window->open(file));
    EXPECT_THAT(said.toStdString(), HasSubstr("not a recording"));
    EXPECT_TRUE(session().hasRun());
    EXPECT_EQ(window->document().file(), projectFile("solero"));
    // Unsaved changes are asked after first.
    recordSolero(0.2);
    type(parameter("wheel_radius"), "90");
    answerNextBox(QMessageBox::Cancel);
    EXPECT_FALSE(window->open(file));
    EXPECT_DOUBLE_EQ(parameterValue("wheel_radius"), 0.09);
}

// Longer than memory is to hold: kept whole, evenly at a coarser resolution, with its very end.
TEST_F(RecordingsTest, ALongRecordingIsThinnedWhileItIsRead) {
    recordSolero(3.0);
    const auto loaded =
        widgets::loadRecording(file.toStdString(), {}, widgets::RecordingStore(100, 30));
    ASSERT_TRUE(loaded) << toString(loaded.problems());
    const auto& rows = (*loaded)->store.recording().rows;
    EXPECT_LE(rows.size(), 100U);
    EXPECT_GE(rows.size(), 50U);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        ASSERT_NEAR(rows[i][0] - rows[i - 1][0], 0.04, 1e-9);
    }
    EXPECT_LE((*loaded)->store.recording().frames.size(), 30U);
    EXPECT_NEAR((*loaded)->last->time, 3.0, 1e-9);
    // Reading may be stopped.
    const auto stopped = widgets::loadRecording(file.toStdString(), [](double) { return false; });
    ASSERT_TRUE(stopped);
    EXPECT_EQ(*stopped, nullptr);
    // Also among many frames without rows: an interrupted recording may end with them.
    repackTable(simcore::io::kFramesChunk, [](simcore::io::Table& frames) {
        frames.insert(frames.end(), 5000, simcore::io::Table::value_type(frames.back()));
    });
    const auto callsUntil = [&](int most) {
        int asked = 0;
        const auto read =
            widgets::loadRecording(file.toStdString(), [&](double) { return ++asked < most; });
        EXPECT_EQ(read && *read == nullptr, asked == most);
        return asked;
    };
    const int all = callsUntil(1000000);
    EXPECT_GE(all, 10);
    for (int most = 1; most <= all; ++most) {
        EXPECT_EQ(callsUntil(most), most);
    }
}

// A run is not refused because its recording is.
TEST_F(RecordingsTest, GroundThatIsTooLargeToBeCarriedIsDrivenOn) {
    auto project = simcore::io::loadProject(projectFile("terrains").toStdString());
    ASSERT_TRUE(project);
    auto changed = *project;
    simcore::run::RunRequest request;
    request.scenario = "image";
    request.duration = 0.2;
    request.files.folder = folder.path().toStdString();
    for (auto& scenario : changed.scenarios) {
        if (scenario.name != "image") {
            continue;
        }
        auto image = scenario.terrain;
        scenario.terrain = {};
        scenario.terrain.kind = simcore::project::TerrainKind::Sum;
        for (const char* name : {"a.png", "b.png", "c.png"}) {
            const QString path = folder.filePath(name);
            ASSERT_TRUE(
                QFile::copy(QString(ROVER_SOURCE_DIR) + "/assets/terrains/dunes.png", path));
            // What follows the image is not looked at.
            ASSERT_TRUE(QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner));
            ASSERT_TRUE(QFile::resize(path, 180LL << 20));
            image.file = name;
            scenario.terrain.terrains.push_back(image);
        }
    }
    simcore::Problems told;
    QObject::connect(&session(), &widgets::RunSession::recordingFailed,
                     [&](const simcore::Problems& problems) { told = problems; });
    const auto problems = session().prepare(changed, request, "");
    EXPECT_FALSE(hasCritical(problems)) << toString(problems);
    EXPECT_THAT(toString(problems), HasSubstr("540 MiB together"));
    EXPECT_THAT(toString(told), HasSubstr("540 MiB together"));
    session().play();
    ASSERT_TRUE(waitUntil([&] { return session().state() == State::Finished; }));
    const auto copy = session().copyRun();
    ASSERT_FALSE(copy);
    EXPECT_THAT(toString(copy.problems()), HasSubstr("540 MiB together"));
}

// A window that is busy shows how far it is, takes no other input, and can be told to stop.
TEST_F(RecordingsTest, LongWorkShowsItsProgressAndCanBeStopped) {
    bool shown = false;
    onNext<QProgressDialog>([&](QProgressDialog* dialog) {
        shown = true;
        EXPECT_EQ(dialog->labelText(), "Working");
        auto* cancel = dialog->findChild<QPushButton*>();
        ASSERT_NE(cancel, nullptr);
        QTest::mouseClick(cancel, Qt::LeftButton);
    });
    bool stopped = false;
    widgets::workInBackground(window.get(), "Working", [&](const widgets::GoOn& goOn) {
        EXPECT_NE(QThread::currentThread(), QApplication::instance()->thread());
        for (int i = 0; i < 2000 && !stopped; ++i) {
            stopped = !goOn(i / 2000.0);
            QThread::msleep(10);
        }
    });
    EXPECT_TRUE(shown);
    EXPECT_TRUE(stopped);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    const auto fail = [](const widgets::GoOn&) { throw std::runtime_error("why"); };
    EXPECT_THROW(widgets::workInBackground(window.get(), "Failing", fail), std::runtime_error);
}

TEST_F(RecordingsTest, ARecordingMayBeDroppedOnTheWindow) {
    recordSolero(0.4);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window.get(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window.get(), &drop);
    EXPECT_NE(session().recorded(), nullptr);
}
