#include "simcore/base/problem.h"

#include <algorithm>

#include "simcore/base/text.h"

namespace simcore {

namespace {

const char* wordFor(Severity severity) {
    switch (severity) {
        case Severity::Critical:
            return Text::mark("critical");
        case Severity::Warning:
            return Text::mark("warning");
        case Severity::Info:
            break;
    }
    return Text::mark("info");
}

}  // namespace

std::string toString(Severity severity) {
    return wordFor(severity);
}

std::string toString(const Problem& problem) {
    std::string text = Text::translated(wordFor(problem.severity)) + ": ";
    if (!problem.element.empty()) {
        text += problem.element + ": ";
    }
    text += problem.reason;
    if (!problem.remedy.empty()) {
        text += " " + problem.remedy;
    }
    return text;
}

std::string toString(const Problems& problems) {
    std::string text;
    for (const Problem& problem : problems) {
        text += toString(problem) + "\n";
    }
    return text;
}

void appendNew(Problems& problems, const Problems& more) {
    for (const Problem& problem : more) {
        if (std::find(problems.begin(), problems.end(), problem) == problems.end()) {
            problems.push_back(problem);
        }
    }
}

bool hasCritical(const Problems& problems) {
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem& p) { return p.severity == Severity::Critical; });
}

}  // namespace simcore
