#include "simcore/run/run_worker.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "tests/support/fake_run.h"
#include "tests/support/wait.h"

namespace simcore::run {
namespace {

using namespace std::chrono_literals;
using test_support::fakeRun;
using test_support::fakeStepper;

struct Drained {
    std::vector<std::vector<double>> rows;
    std::vector<std::shared_ptr<const Snapshot>> frames;

    void take(RunWorker& worker) {
        std::vector<std::vector<double>> moreRows;
        std::vector<std::shared_ptr<const Snapshot>> moreFrames;
        worker.drain(moreRows, moreFrames);
        rows.insert(rows.end(), moreRows.begin(), moreRows.end());
        frames.insert(frames.end(), moreFrames.begin(), moreFrames.end());
    }
};

using testsupport::waitUntil;

bool waitFinished(RunWorker& worker) {
    return waitUntil([&] { return worker.state() == WorkerState::Finished; });
}

/// Hash of the run stepped in this thread, without any worker.
RunReport steppedHere(const ResolvedRun& run) {
    const auto stepper = fakeStepper()(run);
    while (!stepper->finished()) {
        stepper->step();
    }
    return stepper->report();
}

TEST(RunWorker, StandsAtItsStartWhenMade) {
    RunWorker worker(fakeRun(), fakeStepper());
    EXPECT_EQ(worker.state(), WorkerState::Paused);
    ASSERT_NE(worker.latest(), nullptr);
    EXPECT_EQ(worker.latest()->time, 0.0);
    EXPECT_EQ(worker.latest()->wheels.size(), 6u);
    Drained drained;
    drained.take(worker);
    EXPECT_EQ(drained.rows.size(), 1u);
    EXPECT_EQ(drained.frames.size(), 1u);
}

TEST(RunWorker, SameHashAtAnySpeedAndWithPauses) {
    const ResolvedRun run = fakeRun(1.0);
    const RunReport expected = steppedHere(run);
    for (const double factor : {0.0, 3.0, 20.0}) {
        RunWorker worker(run, fakeStepper());
        worker.setSpeedFactor(factor);
        worker.play();
        for (int i = 0; i < 5; ++i) {
            worker.pause();
            worker.play();
        }
        ASSERT_TRUE(waitFinished(worker));
        EXPECT_EQ(worker.report().stateHash, expected.stateHash) << "factor " << factor;
        EXPECT_EQ(worker.report().steps, expected.steps);
        EXPECT_EQ(worker.report().stopReason, StopReason::Completed);
    }
}

TEST(RunWorker, ResetStartsTheSameRunAgain) {
    const ResolvedRun run = fakeRun(0.5);
    RunWorker worker(run, fakeStepper());
    worker.setSpeedFactor(0.0);
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    Drained first;
    first.take(worker);
    const std::string hash = worker.report().stateHash;

    worker.reset();
    EXPECT_EQ(worker.state(), WorkerState::Paused);
    EXPECT_EQ(worker.latest()->time, 0.0);
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    Drained second;
    second.take(worker);
    EXPECT_EQ(worker.report().stateHash, hash);
    EXPECT_EQ(second.rows, first.rows);
}

TEST(RunWorker, ResetDropsWhatWasNotDrained) {
    RunWorker worker(fakeRun(0.5), fakeStepper());
    worker.setSpeedFactor(0.0);
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    worker.reset();
    Drained drained;
    drained.take(worker);
    ASSERT_EQ(drained.rows.size(), 1u);
    EXPECT_EQ(drained.rows[0][0], 0.0);
    EXPECT_EQ(drained.frames.size(), 1u);
}

TEST(RunWorker, PauseIsAHandshake) {
    RunWorker worker(fakeRun(1e6), fakeStepper());
    worker.setSpeedFactor(0.0);
    worker.play();
    EXPECT_EQ(worker.state(), WorkerState::Playing);
    ASSERT_TRUE(waitUntil([&] { return worker.latest()->step > 10; }));
    worker.pause();
    // From here on nothing may move.
    EXPECT_EQ(worker.state(), WorkerState::Paused);
    const long step = worker.latest()->step;
    std::this_thread::sleep_for(30ms);
    EXPECT_EQ(worker.latest()->step, step);
    EXPECT_EQ(worker.report().steps, step);
}

TEST(RunWorker, StepOnceMakesOneStepAndPauses) {
    RunWorker worker(fakeRun(), fakeStepper());
    worker.stepOnce();
    EXPECT_EQ(worker.latest()->step, 1);
    worker.stepOnce();
    EXPECT_EQ(worker.latest()->step, 2);
    EXPECT_EQ(worker.state(), WorkerState::Paused);
}

TEST(RunWorker, SamplesRowsEvery10msAndFramesEvery20ms) {
    RunWorker worker(fakeRun(2.0), fakeStepper());
    worker.setSpeedFactor(0.0);
    worker.play();
    Drained drained;
    ASSERT_TRUE(waitUntil([&] {
        const bool finished = worker.state() == WorkerState::Finished;
        drained.take(worker);
        return finished;
    }));
    ASSERT_EQ(drained.rows.size(), 201u);
    ASSERT_EQ(drained.frames.size(), 101u);
    for (std::size_t i = 0; i < drained.rows.size(); ++i) {
        EXPECT_NEAR(drained.rows[i][0], 0.01 * static_cast<double>(i), 1e-9);
        EXPECT_EQ(drained.rows[i].size(), makeChannels(worker.settings().mechanism).size());
    }
    for (std::size_t i = 0; i < drained.frames.size(); ++i) {
        EXPECT_NEAR(drained.frames[i]->time, 0.02 * static_cast<double>(i), 1e-9);
    }
}

TEST(RunWorker, TheEndIsRecordedEvenBetweenPeriods) {
    ResolvedRun run = fakeRun(0.106);
    RunWorker worker(run, fakeStepper());
    worker.setSpeedFactor(0.0);
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    Drained drained;
    drained.take(worker);
    EXPECT_NEAR(drained.rows.back()[0], 0.106, 1e-12);
    EXPECT_NEAR(drained.frames.back()->time, 0.106, 1e-12);
}

TEST(RunWorker, StepsLongerThanThePeriodAreAllRecorded) {
    ResolvedRun run = fakeRun(0.5);
    run.step = 0.05;
    RunWorker worker(run, fakeStepper());
    worker.setSpeedFactor(0.0);
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    Drained drained;
    drained.take(worker);
    EXPECT_EQ(drained.rows.size(), 11u);
}

TEST(RunWorker, RealTimeIsPacedByTheClock) {
    RunWorker worker(fakeRun(0.4), fakeStepper());
    const auto begin = std::chrono::steady_clock::now();
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    // It may be late on a busy machine, never early.
    EXPECT_GE(wall.count(), 0.39);
    EXPECT_GT(worker.realTimeFactor(), 0.0);
    EXPECT_LT(worker.realTimeFactor(), 1.1);
}

TEST(RunWorker, AfterALagItGoesOnInsteadOfSprinting) {
    // One step takes half a second: the clock has to be set anew, so that the rest takes its own
    // 0.4 s as if nothing had happened.
    RunWorker worker(fakeRun(0.6), fakeStepper([](long step) {
                         if (step == 100) {
                             std::this_thread::sleep_for(500ms);
                         }
                     }));
    const auto begin = std::chrono::steady_clock::now();
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
    EXPECT_GE(wall.count(), 0.2 + 0.5 + 0.39);
}

TEST(RunWorker, AnExceptionEndsTheRunAndKeepsTheData) {
    RunWorker worker(fakeRun(), fakeStepper([](long step) {
                         if (step == 100) {
                             throw std::runtime_error("wheel front went non-finite");
                         }
                     }));
    worker.setSpeedFactor(0.0);
    worker.play();
    ASSERT_TRUE(waitFinished(worker));
    const RunReport report = worker.report();
    EXPECT_FALSE(report.completed);
    EXPECT_EQ(report.stopReason, StopReason::Stopped);
    EXPECT_EQ(report.stopDetail, "wheel front went non-finite");
    EXPECT_EQ(report.steps, 99);
    Drained drained;
    drained.take(worker);
    EXPECT_EQ(drained.rows.size(), 20u);
    worker.play();  // ignored, no deadlock
    worker.stepOnce();
    EXPECT_EQ(worker.state(), WorkerState::Finished);
    worker.reset();
    EXPECT_EQ(worker.state(), WorkerState::Paused);
    EXPECT_TRUE(worker.report().stopDetail.empty());
}

TEST(RunWorker, FailureToMakeTheSimulationIsReported) {
    RunWorker worker(fakeRun(), [](const ResolvedRun&) -> std::unique_ptr<Stepper> {
        throw std::runtime_error("no engine");
    });
    EXPECT_EQ(worker.state(), WorkerState::Finished);
    EXPECT_EQ(worker.report().stopDetail, "no engine");
    ASSERT_NE(worker.latest(), nullptr);
}

TEST(RunWorker, TheSimulationLivesOnOneThreadOnly) {
    std::mutex mutex;
    std::vector<std::thread::id> ids;
    const auto note = [&] {
        const std::lock_guard lock(mutex);
        ids.push_back(std::this_thread::get_id());
    };

    class Noting final : public Stepper {
      public:
        Noting(std::unique_ptr<Stepper> inner, std::function<void()> note)
            : inner_(std::move(inner)),
              note_(std::move(note)) {
            note_();
        }

        ~Noting() override { note_(); }

        void reset() override { note_(), inner_->reset(); }

        void step() override { note_(), inner_->step(); }

        bool finished() const override { return inner_->finished(); }

        void setManualCommand(const ManualCommand& c) override { inner_->setManualCommand(c); }

        const Snapshot& snapshot() const override { return inner_->snapshot(); }

        RunReport report() const override { return note_(), inner_->report(); }

      private:
        std::unique_ptr<Stepper> inner_;
        std::function<void()> note_;
    };

    {
        RunWorker worker(fakeRun(), [&](const ResolvedRun& run) {
            return std::make_unique<Noting>(fakeStepper()(run), note);
        });
        worker.stepOnce();
        worker.reset();
        EXPECT_EQ(worker.report().steps, 0);
    }
    ASSERT_GE(ids.size(), 5u);
    for (const std::thread::id id : ids) {
        EXPECT_EQ(id, ids.front());
        EXPECT_NE(id, std::this_thread::get_id());
    }
}

TEST(RunWorker, ManualCommandReachesTheSimulationAndSurvivesReset) {
    ResolvedRun run = fakeRun();
    run.controller = project::ControllerKind::Manual;
    RunWorker worker(run, fakeStepper());
    worker.setManualCommand({.speed = 0.25, .turn = 0.0});
    worker.stepOnce();
    EXPECT_EQ(worker.latest()->speed, 0.25);
    worker.reset();
    worker.stepOnce();
    EXPECT_EQ(worker.latest()->speed, 0.25);
}

TEST(RunWorker, IsDestroyedWhilePlaying) {
    for (int i = 0; i < 20; ++i) {
        RunWorker worker(fakeRun(1e6), fakeStepper());
        worker.setSpeedFactor(i % 2 == 0 ? 0.0 : 1.0);
        worker.play();
    }
}

TEST(RunWorker, RefusesNonsenseSpeedFactors) {
    RunWorker worker(fakeRun(), fakeStepper());
    EXPECT_THROW(worker.setSpeedFactor(-1.0), std::invalid_argument);
    EXPECT_THROW(worker.setSpeedFactor(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace simcore::run
