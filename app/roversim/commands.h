#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simcore/base/problem.h"
#include "simcore/project/resolve.h"

namespace CLI {
class App;
}

/// The verbs of roversim. Each adds itself to the command line and returns its exit code through
/// `exitCode`: 0 good, 1 the answer is no, 2 wrong use.
namespace roversim {

inline constexpr int kGood = 0;
inline constexpr int kAnswerIsNo = 1;
inline constexpr int kWrongUse = 2;

void addNewCommand(CLI::App& app, int& exitCode);
void addMobilityCommand(CLI::App& app, int& exitCode);
void addValidateCommand(CLI::App& app, int& exitCode);
void addConvertCommand(CLI::App& app, int& exitCode);
void addCriticalFrictionCommand(CLI::App& app, int& exitCode);
void addChannelsCommand(CLI::App& app, int& exitCode);
void addExperimentCommand(CLI::App& app, int& exitCode);
void addExportCommand(CLI::App& app, int& exitCode);
void addRelaxCommand(CLI::App& app, int& exitCode);
void addReplayCommand(CLI::App& app, int& exitCode);
void addReproduceCommand(CLI::App& app, int& exitCode);
void addRunCommand(CLI::App& app, int& exitCode);
void addStaticsCommand(CLI::App& app, int& exitCode);
void addTerrainCommand(CLI::App& app, int& exitCode);
void addWorkerCommand(CLI::App& app, int& exitCode);

/// Loads a project; on failure prints why to stderr.
std::optional<simcore::project::Project> loadOrComplain(const std::string& file);

/// "NAME=VALUE" texts; on a malformed one prints why and returns nothing.
std::optional<std::vector<simcore::project::Assignment>> parseAssignments(
    const std::vector<std::string>& texts);

/// Prints problems to stderr, each with the file in front.
void printProblems(const std::string& file, const simcore::Problems& problems);

}  // namespace roversim
