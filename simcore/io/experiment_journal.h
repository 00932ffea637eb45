#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <vector>

#include "simcore/io/experiment_json.h"

namespace simcore::io {

/// Outcomes on disk as they come, so that an experiment goes on where it was stopped: the plan with
/// its rover in the first line, then one outcome a line.
class ExperimentJournal {
  public:
    /// Goes on with a journal or begins one; makes its folder. Problems: a journal of another plan
    /// or rover, a folder that cannot be written.
    static Result<ExperimentJournal> open(const std::filesystem::path& file,
                                          const experiment::Plan& plan,
                                          const project::Project& project);

    /// Those that were there.
    const std::vector<experiment::Outcome>& outcomes() const { return outcomes_; }

    /// Writes one to disk. False when the disk does not take it.
    bool add(const experiment::Outcome& outcome);

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    std::unique_ptr<std::FILE, Close> file_;
    std::vector<experiment::Outcome> outcomes_;
};

}  // namespace simcore::io
