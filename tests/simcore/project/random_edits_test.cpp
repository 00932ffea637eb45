// Long histories of edits by lot: nothing breaks, files read back, undoing all gives the same
// bytes.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "simcore/io/project_file.h"
#include "simcore/run/simulation.h"
#include "tests/support/projects.h"
#include "tests/support/random_edits.h"

using simcore::project::Project;

namespace {

/// Undo as the document has it: whole projects, those after the present one for redo.
struct History {
    explicit History(Project first) : states{std::move(first)} {}

    const Project& present() const { return states[now]; }

    void edit(Project next) {
        states.resize(now + 1, states.front());
        states.push_back(std::move(next));
        ++now;
    }

    std::vector<Project> states;
    std::size_t now = 0;
};

/// A little way, whatever becomes of it.
void drive(simcore::run::ResolvedRun run) {
    constexpr int kSteps = 25;
    simcore::run::Simulation simulation(std::move(run));
    for (int k = 0; k < kSteps && !simulation.finished(); ++k) {
        simulation.step();
    }
    EXPECT_GT(simulation.snapshot().step, 0);
}

class RandomEditsTest : public testing::TestWithParam<const char*> {};

}  // namespace

// ROVER_RANDOM_EDITS is the number of steps of each.
TEST_P(RandomEditsTest, UndoingAllGivesTheSameBytes) {
    const int steps = testsupport::stepsFrom("ROVER_RANDOM_EDITS", 300);
    constexpr std::uint64_t kSeed = 7;
    testsupport::RandomEdits edits(kSeed);
    const Project first = testsupport::shipped(GetParam());
    const std::string before = simcore::io::formatProject(first);
    History history(first);
    int made = 0;
    for (int step = 0; step < steps; ++step) {
        SCOPED_TRACE("step " + std::to_string(step));
        switch (edits.below(10)) {
            case 0:
                history.now -= std::min<std::size_t>(history.now, 1 + edits.below(4));
                break;
            case 1:
                history.now += history.now + 1 < history.states.size() ? 1 : 0;
                break;
            case 2: {
                const std::string text = simcore::io::formatProject(history.present());
                const auto read = simcore::io::parseProject(text, "text");
                ASSERT_TRUE(read) << toString(read.problems());
                EXPECT_TRUE(*read == history.present());
                EXPECT_EQ(simcore::io::formatProject(*read), text);
                break;
            }
            case 3:
                if (step % 5 == 0 && !history.present().scenarios.empty()) {
                    simcore::run::RunRequest request;
                    request.scenario = history.present().scenarios.front().name;
                    using simcore::project::EngineKind;
                    request.engine = step % 2 == 0 ? EngineKind::Ode : EngineKind::Reduced;
                    auto run = simcore::run::prepareRun(history.present(), request);
                    EXPECT_TRUE(run || hasCritical(run.problems()));
                    if (run) {
                        drive(std::move(run).value());
                    }
                }
                break;
            default:
                if (auto next = edits.edit(history.present())) {
                    history.edit(std::move(*next));
                    ++made;
                }
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(made, steps / 10) << "most edits are refused";
    EXPECT_EQ(simcore::io::formatProject(history.states.front()), before);
}

INSTANTIATE_TEST_SUITE_P(Shipped, RandomEditsTest, testing::Values("solero", "shrimp"));
