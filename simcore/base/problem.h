#pragma once

#include <string>
#include <vector>

namespace simcore {

/// How bad a problem is. A project with a critical problem cannot be analysed or run.
enum class Severity { Info, Warning, Critical };

/// One thing wrong with what the user gave us: where it is, why it is wrong and what to do.
struct Problem {
    Severity severity = Severity::Critical;
    /// What it concerns, as the user names it: "joint fork_upper", "parameter wheel_radius", a
    /// file.
    std::string element;
    /// Why it is a problem, one sentence.
    std::string reason;
    /// What to do about it, one sentence.
    std::string remedy;

    bool operator==(const Problem&) const = default;
};

using Problems = std::vector<Problem>;

/// "critical" | "warning" | "info".
std::string toString(Severity severity);

/// "critical: joint fork_upper: <reason> <remedy>", for a terminal or a dialog.
std::string toString(const Problem& problem);

/// All problems, one a line.
std::string toString(const Problems& problems);

/// Appends those of `more` that are not there yet: the same mistake is often met on several ways.
void appendNew(Problems& problems, const Problems& more);

/// True when at least one problem is critical.
bool hasCritical(const Problems& problems);

}  // namespace simcore
