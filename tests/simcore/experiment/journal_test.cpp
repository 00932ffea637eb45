#include "simcore/io/experiment_journal.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "tests/support/projects.h"

using namespace simcore;
using namespace simcore::experiment;

namespace {

class JournalTest : public testing::Test {
  protected:
    JournalTest() {
        std::filesystem::remove_all(folder_);
        plan_.frictions = {0.5};
        plan_.controllers = {project::ControllerKind::Speed};
    }

    ~JournalTest() override { std::filesystem::remove_all(folder_); }

    static Outcome outcome(int seed) {
        Outcome result;
        result.ran.seed = seed;
        result.completed = true;
        return result;
    }

    std::filesystem::path folder_ =
        std::filesystem::path(testing::TempDir()) / "rover_experiment_journal";
    std::filesystem::path file_ = folder_ / "deep" / "profiles.journal";
    Plan plan_;
    project::Project solero_ = testsupport::shipped("solero");
};

}  // namespace

TEST_F(JournalTest, GoesOnWhereItWasStopped) {
    {
        auto journal = io::ExperimentJournal::open(file_, plan_, solero_);
        ASSERT_TRUE(journal) << toString(journal.problems());
        EXPECT_TRUE(journal.value().add(outcome(1)));
        EXPECT_TRUE(journal.value().add(outcome(2)));
    }
    const auto again = io::ExperimentJournal::open(file_, plan_, solero_);
    ASSERT_TRUE(again);
    ASSERT_EQ(again->outcomes().size(), 2U);
    EXPECT_EQ(again->outcomes()[1].ran.seed, 2);
}

// Killed while it wrote a line: that run is lost, and the next line begins anew.
TEST_F(JournalTest, ATornLineIsDroppedNotJoined) {
    {
        auto journal = io::ExperimentJournal::open(file_, plan_, solero_);
        ASSERT_TRUE(journal);
        EXPECT_TRUE(journal.value().add(outcome(1)));
        EXPECT_TRUE(journal.value().add(outcome(2)));
    }
    std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 20);
    {
        auto journal = io::ExperimentJournal::open(file_, plan_, solero_);
        ASSERT_TRUE(journal);
        EXPECT_EQ(journal->outcomes().size(), 1U);
        EXPECT_TRUE(journal.value().add(outcome(3)));
    }
    const auto again = io::ExperimentJournal::open(file_, plan_, solero_);
    ASSERT_TRUE(again);
    ASSERT_EQ(again->outcomes().size(), 2U);
    EXPECT_EQ(again->outcomes()[1].ran.seed, 3);
}

TEST_F(JournalTest, AnotherPlanOrRoverIsRefusedAndNothingLost) {
    {
        auto journal = io::ExperimentJournal::open(file_, plan_, solero_);
        ASSERT_TRUE(journal);
        EXPECT_TRUE(journal.value().add(outcome(1)));
    }
    Plan other = plan_;
    other.step = 0.001;
    EXPECT_FALSE(io::ExperimentJournal::open(file_, other, solero_));
    project::Project heavier = solero_;
    heavier.rover.bodies.front().mass = 20.0;
    EXPECT_FALSE(io::ExperimentJournal::open(file_, plan_, heavier));
    EXPECT_EQ(io::ExperimentJournal::open(file_, plan_, solero_)->outcomes().size(), 1U);
}

TEST_F(JournalTest, AFolderThatCannotBeIsAProblem) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "deep") << "a file";
    EXPECT_FALSE(io::ExperimentJournal::open(file_, plan_, solero_));
}
