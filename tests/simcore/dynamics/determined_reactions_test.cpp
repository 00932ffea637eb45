// Which joint reactions the loads determine: what the engines say against the study of mobility,
// which finds it from the constraints of all joints at once, without a tree.
#include <filesystem>

#include <gtest/gtest.h>

#include "simcore/dynamics/engine.h"
#include "simcore/io/project_file.h"
#include "simcore/mobility/reactions.h"
#include "simcore/project/resolve.h"
#include "tests/support/projects.h"

namespace {

using namespace simcore;

std::vector<std::filesystem::path> projectFiles() {
    std::vector<std::filesystem::path> files;
    for (const char* folder : {"assets/projects", "assets/mechanisms"}) {
        for (const auto& entry : std::filesystem::directory_iterator(
                 std::filesystem::path(ROVER_SOURCE_DIR) / folder)) {
            if (entry.path().extension() == ".rover") {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

class DeterminedReactionsTest : public ::testing::TestWithParam<std::filesystem::path> {
  protected:
    /// Without wheels: to an engine, what presses on them is a load.
    mechanism::Mechanism mechanism() const {
        const auto project = io::loadProject(GetParam());
        if (!project) {
            throw std::runtime_error(toString(project.problems()));
        }
        auto resolved = project::resolve(*project);
        if (!resolved) {
            throw std::runtime_error(toString(resolved.problems()));
        }
        mechanism::Mechanism mechanism = std::move(resolved).value();
        mechanism.wheels.clear();
        return mechanism;
    }
};

INSTANTIATE_TEST_SUITE_P(Shipped, DeterminedReactionsTest, ::testing::ValuesIn(projectFiles()),
                         [](const auto& param) { return param.param.stem().string(); });

TEST_P(DeterminedReactionsTest, AreThoseOfTheStudyOfMobility) {
    const mechanism::Mechanism rover = mechanism();
    if (!dynamics::whyReducedCannotRun(rover).empty()) {
        GTEST_SKIP() << toString(dynamics::whyReducedCannotRun(rover));
    }
    std::vector<bool> expected(rover.joints.size(), true);
    for (const mobility::ReactionDeterminacy& reaction :
         mobility::determinedReactions(rover, mechanism::Model::Built)) {
        if (reaction.joint >= 0) {
            expected[static_cast<std::size_t>(reaction.joint)] =
                reaction.determinacy == mobility::Determinacy::All;
        }
    }
    const auto engine = dynamics::makeReducedEngine(rover, {0.001});
    engine->step({});
    const std::vector<dynamics::JointReaction>& reactions = engine->jointReactions();
    ASSERT_EQ(reactions.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(reactions[i].determined, expected[i]) << "joint " << rover.joints[i].name;
    }
}

TEST_P(DeterminedReactionsTest, AreTheSameForOde) {
    const mechanism::Mechanism rover = mechanism();
    if (!dynamics::whyOdeCannotRun(rover).empty() ||
        !dynamics::whyReducedCannotRun(rover).empty()) {
        GTEST_SKIP() << "not for both engines";
    }
    const auto ode = dynamics::makeOdeEngine(rover, {0.001});
    const auto reduced = dynamics::makeReducedEngine(rover, {0.001});
    ode->step({});
    reduced->step({});
    for (std::size_t i = 0; i < rover.joints.size(); ++i) {
        EXPECT_EQ(ode->jointReactions()[i].determined, reduced->jointReactions()[i].determined)
            << "joint " << rover.joints[i].name;
    }
}

}  // namespace
