// A run recorded by its worker, and saved while it goes and after.
#include "simcore/io/run_recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <thread>

#include "simcore/io/run_report_json.h"
#include "tests/support/fake_run.h"
#include "tests/support/wait.h"

namespace simcore::io {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using run::RunWorker;
using run::WorkerState;
using ::testing::HasSubstr;

using testsupport::waitUntil;

/// Fails at a step, and cannot tell what it was then.
class Broken final : public run::Stepper {
  public:
    static constexpr long kLast = 2000;

    explicit Broken(std::unique_ptr<run::Stepper> inner) : inner_(std::move(inner)) {}

    void reset() override { inner_->reset(); }

    void step() override {
        broken_ = inner_->snapshot().step == kLast;
        if (broken_) {
            throw std::runtime_error("broken");
        }
        inner_->step();
    }

    bool finished() const override { return inner_->finished(); }

    void setManualCommand(const run::ManualCommand& c) override { inner_->setManualCommand(c); }

    const run::Snapshot& snapshot() const override { return inner_->snapshot(); }

    run::RunReport report() const override {
        return broken_ ? throw std::runtime_error("broken") : inner_->report();
    }

  private:
    std::unique_ptr<run::Stepper> inner_;
    bool broken_ = false;
};

class RunRecorderTest : public ::testing::Test {
  protected:
    RunRecorderTest()
        : folder(fs::path(::testing::TempDir()) /
                 (std::string("rover_run_") +
                  ::testing::UnitTest::GetInstance()->current_test_info()->name())),
          cache(folder / "cache" / "runs"),
          file(folder / "run.roverrec") {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }

    ~RunRecorderTest() override {
        worker.reset();
        fs::remove_all(folder);
    }

    void start(double duration, std::uint64_t keepFree = 0,
               const run::StepperFactory& factory = test_support::fakeStepper()) {
        run::ResolvedRun run = test_support::fakeRun(duration);
        run.controller = project::ControllerKind::Manual;
        header.request.scenario = run.scenario;
        header.channels = run::makeChannels(run.mechanism);
        header.size = {1, 6, 0};
        auto made = std::make_unique<RunRecorder>(cache, header, keepFree);
        recorder = made.get();
        worker = std::make_unique<RunWorker>(run, factory, std::move(made));
        worker->setSpeedFactor(0.0);
    }

    void playToTheEnd() {
        worker->play();
        ASSERT_TRUE(waitUntil([&] { return worker->state() == WorkerState::Finished; }));
    }

    Result<RunCopy> copy() {
        std::optional<Result<RunCopy>> made;
        worker->betweenSteps([&](const run::RunReport& report) { made = recorder->copy(report); });
        return std::move(*made);
    }

    std::unique_ptr<RecordingReader> saved() {
        const auto made = copy();
        EXPECT_TRUE(made) << toString(made.problems());
        const auto written = made->save(file);
        EXPECT_TRUE(written) << toString(written.problems());
        auto reader = RecordingReader::open(file);
        EXPECT_TRUE(reader && reader.problems().empty()) << toString(reader.problems());
        return std::move(reader).value();
    }

    /// Every row that the worker gave is in the recording, and no other.
    void expectAllRows(RecordingReader& reader) {
        std::vector<std::vector<double>> rows, read;
        std::vector<std::shared_ptr<const run::Snapshot>> frames;
        worker->drain(rows, frames);
        for (std::size_t block = 0; block < reader.rowBlockCount(); ++block) {
            auto some = reader.rowBlock(block);
            ASSERT_TRUE(some);
            std::move(some.value().begin(), some.value().end(), std::back_inserter(read));
        }
        ASSERT_EQ(read.size(), rows.size());
        EXPECT_EQ(read.front().front(), rows.front().front());
        EXPECT_EQ(read.back().front(), rows.back().front());
        ASSERT_EQ(reader.frameCount(), frames.size());
        EXPECT_EQ(reader.frame(frames.size() - 1)->time, frames.back()->time);
    }

    fs::path folder, cache, file;
    RecordingHeader header;
    RunRecorder* recorder = nullptr;
    std::unique_ptr<RunWorker> worker;
};

TEST_F(RunRecorderTest, AFinishedRunIsSavedWhole) {
    header.projectText = "{\"any\": \"text\"}";
    header.request.files.carried = std::make_shared<const project::CarriedFiles>(
        project::CarriedFiles{{"../ground.png", "bytes"}});
    start(9.0);
    playToTheEnd();
    const auto reader = saved();
    EXPECT_TRUE(reader->complete());
    EXPECT_EQ(reader->header().engine, "fake");
    EXPECT_EQ(reader->header().projectText, header.projectText);
    EXPECT_THAT(reader->reportText(), HasSubstr("completed"));
    const auto files = reader->readFiles();
    ASSERT_TRUE(files && files->carried);
    EXPECT_EQ(files->carried->at("../ground.png"), "bytes");
    // At least the end; between, one when 2.56 s more are written. The fake run does it all at
    // once.
    ASSERT_GE(reader->marks().size(), 2U);
    EXPECT_EQ(reader->marks().back().stateHash, worker->report().stateHash);
    EXPECT_EQ(reader->marks().back().step, worker->report().steps);
    expectAllRows(*reader);
}

// Saved at any instant, the file is a whole recording up to there, with the hash of that instant.
TEST_F(RunRecorderTest, ARunIsSavedWhileItGoes) {
    start(1e5);
    worker->play();
    long steps = 0;
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(waitUntil([&] { return worker->latest()->step > steps + 1000; }));
        const auto reader = saved();
        EXPECT_TRUE(reader->complete());
        EXPECT_GT(reader->marks().back().step, steps);
        steps = reader->marks().back().step;
        EXPECT_NEAR(0.01 * static_cast<double>(reader->rowCount() - 1), 0.002 * steps, 0.02);
        EXPECT_EQ(parseReport(reader->reportText()).stopReason, run::StopReason::Running);
    }
    worker->pause();
    expectAllRows(*saved());
}

TEST_F(RunRecorderTest, CommandsAreRecordedAtTheirSteps) {
    start(10.0);
    worker->setManualCommand({0.1, 0.0});
    worker->stepOnce();
    worker->stepOnce();
    worker->setManualCommand({0.1, 0.0});  // the same again is none
    worker->setManualCommand({0.05, -0.2});
    worker->stepOnce();
    const auto commands = saved()->commands();
    ASSERT_EQ(commands.size(), 2U);
    EXPECT_EQ(commands[0].step, 0);
    EXPECT_EQ(commands[1].step, 2);
    EXPECT_EQ(commands[1].command, (run::ManualCommand{0.05, -0.2}));
    // What is held down at a reset is in force from the start of the new run.
    worker->reset();
    worker->stepOnce();
    const auto again = saved()->commands();
    ASSERT_EQ(again.size(), 1U);
    EXPECT_EQ(again[0].step, 0);
    EXPECT_EQ(again[0].command.speed, 0.05);
}

TEST_F(RunRecorderTest, ResetBeginsTheRecordingAnew) {
    start(6.0);
    playToTheEnd();
    const auto before = copy();
    worker->reset();
    worker->stepOnce();
    const auto reader = saved();
    EXPECT_EQ(reader->marks().size(), 1U);
    EXPECT_EQ(reader->marks().back().step, 1);
    // A copy made before still has the run it was made of.
    ASSERT_TRUE(before);
    ASSERT_TRUE(before->save(file));
    EXPECT_EQ((*RecordingReader::open(file))->marks().back().step, 3000);
}

// Nothing is left, however the program ends: the file has no name.
TEST_F(RunRecorderTest, TheFileHasNoName) {
    start(6.0);
    playToTheEnd();
    EXPECT_TRUE(fs::is_directory(cache));
    EXPECT_TRUE(fs::is_empty(cache));
}

// A full disk, played by a limit of the file size.
TEST_F(RunRecorderTest, AFullDiskEndsTheRecordingButNotTheRun) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{60000, old.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    start(9.0);
    playToTheEnd();
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    EXPECT_EQ(worker->report().stopReason, run::StopReason::Completed);
    EXPECT_TRUE(recorder->failed());
    const auto failed = copy();
    ASSERT_FALSE(failed);
    EXPECT_THAT(toString(failed.problems()), HasSubstr("it was given up"));
    // The next run is another chance.
    worker->reset();
    EXPECT_FALSE(recorder->failed());
    playToTheEnd();
    EXPECT_EQ(saved()->marks().back().step, 4500);
}

TEST_F(RunRecorderTest, ACopyOutlivesARecordingThatIsGivenUp) {
    std::signal(SIGXFSZ, SIG_IGN);
    start(1e5);
    worker->play();
    ASSERT_TRUE(waitUntil([&] { return worker->latest()->step > 5000; }));
    worker->pause();
    const long steps = worker->latest()->step;
    const auto made = copy();
    ASSERT_TRUE(made);
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{1, old.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    worker->play();
    const bool failed = waitUntil([&] { return recorder->failed(); });
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    ASSERT_TRUE(failed);
    worker->pause();
    const auto written = made->save(file);
    ASSERT_TRUE(written) << toString(written.problems());
    const auto reader = RecordingReader::open(file);
    ASSERT_TRUE(reader && reader.problems().empty()) << toString(reader.problems());
    EXPECT_TRUE((*reader)->complete());
    EXPECT_EQ((*reader)->marks().back().step, steps);
}

// A run that fails may have no hash to mark it with; what it did until then is kept.
TEST_F(RunRecorderTest, ARunThatFailsIsSavedUpToThere) {
    start(9.0, 0, [](const run::ResolvedRun& run) {
        return std::make_unique<Broken>(test_support::fakeStepper()(run));
    });
    playToTheEnd();
    EXPECT_EQ(worker->report().stopDetail, "broken");
    const auto reader = saved();
    EXPECT_THAT(reader->reportText(), HasSubstr("broken"));
    expectAllRows(*reader);
}

TEST_F(RunRecorderTest, SomeOfTheDiskStaysFree) {
    start(9.0, std::uint64_t{1} << 62U);
    playToTheEnd();
    EXPECT_TRUE(recorder->failed());
    EXPECT_THAT(toString(copy().problems()), HasSubstr("of the disk are free"));
}

TEST_F(RunRecorderTest, AFolderThatCannotBeMadeIsAProblemOfSavingOnly) {
    std::ofstream(folder / "cache") << "a file in the way";
    start(3.0);
    playToTheEnd();
    EXPECT_EQ(worker->report().stopReason, run::StopReason::Completed);
    EXPECT_THAT(toString(copy().problems()), HasSubstr("no file can be made"));
}

// The file that is there stays until the new one is whole; of one that does not become whole
// nothing is left.
TEST_F(RunRecorderTest, AFailedSaveChangesNothing) {
    start(20.0);
    playToTheEnd();
    const auto made = copy();
    ASSERT_TRUE(made);
    std::ofstream(file) << "old";
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
    const rlimit small{30000, old.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto full = made->save(file);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    EXPECT_FALSE(full);
    EXPECT_FALSE(made->save(folder / "missing" / "run.roverrec"));
    const auto stopped = made->save(file, [](double) { return false; });
    ASSERT_TRUE(stopped);
    EXPECT_FALSE(*stopped);
    // Within the files of the ground, too.
    header.request.files.carried = std::make_shared<const project::CarriedFiles>(
        project::CarriedFiles{{"ground.png", std::string(20U << 20U, '\0')}});
    start(1.0);
    int asked = 0;
    const auto stoppedInFiles = copy()->save(file, [&](double) { return ++asked < 5; });
    ASSERT_TRUE(stoppedInFiles);
    EXPECT_FALSE(*stoppedInFiles);
    EXPECT_EQ(asked, 5);
    header.projectText = std::string(10U << 20U, ' ');
    start(1.0);
    EXPECT_THAT(toString(copy()->save(file).problems()), HasSubstr("the project's text is longer"));
    EXPECT_EQ(fs::file_size(file), 3U);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);  // file and cache
}

TEST(RunReportJson, ReadsWhatItWrites) {
    const auto stepper = test_support::fakeStepper()(test_support::fakeRun(1.0));
    while (!stepper->finished()) {
        stepper->step();
    }
    run::RunReport report = stepper->report();
    report.stopDetail = "a detail";
    report.loopErrorMax = 0.25;
    report.solverMessages = 3;
    report.energy = 1.5;
    report.bodies = {{"chassis", 0.25, 30.0}};
    EXPECT_EQ(toJson(parseReport(toJson(report).dump())), toJson(report));
    for (const char* text : {"", "[]", "{\"steps\": \"many\", \"wheels\": [3, {}]}", "{\"dt\":"}) {
        EXPECT_EQ(parseReport(text).steps, 0) << text;
    }
}

}  // namespace
}  // namespace simcore::io
