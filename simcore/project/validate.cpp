#include <algorithm>
#include <set>

#include "simcore/base/text.h"
#include "simcore/project/names.h"
#include "simcore/project/resolve.h"

namespace simcore::project {
namespace {

void validateScenario(const Project& project, const Scenario& scenario, Problems& problems) {
    const auto parameters = evaluateParameters(project, scenario.variant);
    if (parameters) {
        appendNew(problems, evaluateScenario(scenario, *parameters).problems());
        return;
    }
    for (const Problem& problem : parameters.problems()) {
        // The others are reported with the rover or the variant.
        if (problem.element == Text::of("variant {}", scenario.variant)) {
            appendNew(problems,
                      {{problem.severity, Text::of("scenario {}", scenario.name),
                        Text::of("there is no variant '{}'.", scenario.variant), problem.remedy}});
        }
    }
}

}  // namespace

Problems validate(const Project& project) {
    Problems problems;
    const auto parameters = evaluateParameters(project.rover);
    appendNew(problems, parameters.problems());
    if (parameters) {
        appendNew(problems, resolve(project.rover, *parameters).problems());
    }
    std::set<std::string> names;
    for (const Variant& variant : project.variants) {
        if (!names.insert(variant.name).second || variant.name.empty()) {
            problems.push_back({Severity::Critical, Text::of("variant {}", variant.name),
                                Text::of("the name is empty or used twice."),
                                Text::of("Rename it.")});
        }
        const auto values = evaluateParameters(project.rover, variant.set);
        Problems found = values.problems();
        if (values) {
            appendNew(found, resolve(project.rover, *values).problems());
        }
        for (Problem problem : found) {
            // What is wrong without the variant is reported once.
            if (std::find(problems.begin(), problems.end(), problem) == problems.end()) {
                problem.element = Text::of("variant {}, {}", variant.name, problem.element);
                appendNew(problems, {problem});
            }
        }
    }
    names.clear();
    for (const Scenario& scenario : project.scenarios) {
        if (!names.insert(scenario.name).second || scenario.name.empty()) {
            problems.push_back({Severity::Critical, Text::of("scenario {}", scenario.name),
                                Text::of("the name is empty or used twice."),
                                Text::of("Rename it.")});
        }
        validateScenario(project, scenario, problems);
    }
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
        return static_cast<int>(a.severity) > static_cast<int>(b.severity);
    });
    return problems;
}

}  // namespace simcore::project
