#include "simcore/experiment/worker_pool.h"

#include <map>

#include <gtest/gtest.h>

using namespace simcore::experiment;

namespace {

using Answers = std::map<std::size_t, std::optional<std::string>>;

/// A worker that is a shell script.
std::vector<std::string> shell(const std::string& script) {
    return {"/bin/sh", "-c", script};
}

Answers answersOf(const std::vector<std::string>& command, const std::vector<std::string>& tasks,
                  int jobs) {
    Answers answers;
    const auto finished =
        runInWorkers(command, "hello", tasks, jobs, [&](std::size_t task, const auto& answer) {
            EXPECT_EQ(answers.count(task), 0U);
            answers[task] = answer;
            return true;
        });
    EXPECT_TRUE(finished) << toString(finished.problems());
    return answers;
}

constexpr const char* kEcho = "read greeting; while read task; do echo \"$greeting $task\"; done";

}  // namespace

TEST(WorkerPoolTest, EveryTaskIsAnsweredOnce) {
    std::vector<std::string> tasks;
    for (int i = 0; i < 50; ++i) {
        tasks.push_back("task" + std::to_string(i));
    }
    for (const int jobs : {1, 3, 100}) {
        const Answers answers = answersOf(shell(kEcho), tasks, jobs);
        ASSERT_EQ(answers.size(), tasks.size());
        for (std::size_t i = 0; i < tasks.size(); ++i) {
            EXPECT_EQ(answers.at(i), "hello " + tasks[i]);
        }
    }
}

TEST(WorkerPoolTest, NoTasksNeedNoWorkers) {
    EXPECT_TRUE(answersOf({"/no/such/program"}, {}, 2).empty());
}

// A worker that dies takes its task with it; the others go on.
TEST(WorkerPoolTest, ACrashLosesOneTask) {
    const std::string script =
        "read greeting; while read task; do test $task = bad && kill -9 $$; echo $task; done";
    const Answers answers = answersOf(shell(script), {"a", "bad", "b", "bad", "c"}, 2);
    ASSERT_EQ(answers.size(), 5U);
    for (const auto& [task, answer] : answers) {
        const bool isBad = task == 1 || task == 3;
        EXPECT_EQ(answer.has_value(), !isBad) << task;
    }
}

// One that ends at once, too, without reading what it is sent.
TEST(WorkerPoolTest, WorkersThatEndAtOnceLoseAll) {
    const Answers answers = answersOf({"/bin/false"}, {"a", "b", "c"}, 2);
    ASSERT_EQ(answers.size(), 3U);
    for (const auto& [task, answer] : answers) {
        EXPECT_FALSE(answer) << task;
    }
}

TEST(WorkerPoolTest, LongLinesComeWhole) {
    const std::string task(300000, 'x');
    EXPECT_EQ(answersOf(shell(kEcho), {task, task}, 1).at(1), "hello " + task);
}

TEST(WorkerPoolTest, StopsWhenAsked) {
    int answered = 0;
    const auto finished = runInWorkers(shell(kEcho), "hello", {"a", "b", "c", "d"}, 1,
                                       [&](std::size_t, const auto&) { return ++answered < 2; });
    EXPECT_TRUE(finished);
    EXPECT_EQ(answered, 2);
}

TEST(WorkerPoolTest, AProgramThatIsNotThereIsAProblem) {
    EXPECT_FALSE(runInWorkers({"/no/such/program"}, "hello", {"a"}, 1,
                              [](std::size_t, const auto&) { return true; }));
}
