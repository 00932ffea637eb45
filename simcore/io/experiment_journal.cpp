#include "simcore/io/experiment_journal.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "simcore/base/text.h"

namespace simcore::io {
namespace {

Problem cannotWrite(const std::filesystem::path& file, const std::string& why) {
    return {Severity::Critical, file.string(), Text::of("it cannot be written: {}.", why),
            Text::of("Choose another folder, or free space.")};
}

}  // namespace

Result<ExperimentJournal> ExperimentJournal::open(const std::filesystem::path& file,
                                                  const experiment::Plan& plan,
                                                  const project::Project& project) {
    ExperimentJournal journal;
    const std::string heading = formatPlan(plan, project);
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) {
        return cannotWrite(file, error.message());
    }
    bool endsInLine = true;
    bool isNew = true;
    if (std::ifstream in(file); in) {
        std::string line;
        isNew = !std::getline(in, line);
        if (!isNew && line != heading) {
            return Problem{Severity::Critical, file.string(),
                           Text::of("it holds runs of another plan or rover."),
                           Text::of("Give another folder, or delete it to begin anew.")};
        }
        while (std::getline(in, line)) {
            endsInLine = !in.eof();
            // The last line is torn where the program was killed.
            if (auto outcome = parseOutcome(line)) {
                journal.outcomes_.push_back(std::move(*outcome));
            }
        }
    }
    journal.file_.reset(std::fopen(file.c_str(), "a"));
    if (!journal.file_) {
        return cannotWrite(file, std::strerror(errno));
    }
    const std::string start = (endsInLine ? "" : "\n") + (isNew ? heading + "\n" : std::string());
    if (std::fputs(start.c_str(), journal.file_.get()) < 0 ||
        std::fflush(journal.file_.get()) != 0) {
        return cannotWrite(file, std::strerror(errno));
    }
    return journal;
}

bool ExperimentJournal::add(const experiment::Outcome& outcome) {
    outcomes_.push_back(outcome);
    const std::string line = formatOutcome(outcome) + "\n";
    return std::fputs(line.c_str(), file_.get()) >= 0 && std::fflush(file_.get()) == 0;
}

}  // namespace simcore::io
