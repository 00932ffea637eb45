#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simcore/run/simulation.h"

namespace CLI {
class App;
}

namespace roversim {

/// What every verb that drives a scenario can be asked for on top of it.
struct RunOptions {
    std::string file;
    std::string scenario;
    std::string engine;
    std::string controller;
    std::optional<double> distance;
    std::optional<double> height;
    std::optional<double> step;
    std::string joints;
    std::vector<std::string> set;
};

/// Declares FILE, --scenario, --engine, --controller, --distance, --height, --dt, --joints and
/// --set.
void addRunOptions(CLI::App& command, RunOptions& options);

/// The request of these options; on a malformed --set prints why and returns nothing.
std::optional<simcore::run::RunRequest> requestOf(const RunOptions& options);

}  // namespace roversim
