#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simcore/base/result.h"

namespace simcore::experiment {

/// Gives tasks to processes: a task is a line of text on a process's standard input, its answer a
/// line on its standard output, begun when it has read all of the task. A process that ends before
/// it has answered loses its task, not the others; a new one is started in its place.
///
/// @param command   program and arguments of a worker
/// @param greeting  line that every worker gets first; it is not answered
/// @param tasks     lines
/// @param jobs      processes at a time, at least 1
/// @param answered  called in the order of answers: the task's index and its answer, nothing where
///                  the worker ended; false stops everything
///
/// Problem: a worker cannot be started.
Result<bool> runInWorkers(
    const std::vector<std::string>& command, const std::string& greeting,
    const std::vector<std::string>& tasks, int jobs,
    const std::function<bool(std::size_t task, const std::optional<std::string>& answer)>&
        answered);

}  // namespace simcore::experiment
