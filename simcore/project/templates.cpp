#include "simcore/project/templates.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "simcore/base/text.h"

namespace simcore::project {

std::vector<int> mainDimensions(const Project& templ) {
    std::vector<int> places;
    const std::vector<Parameter>& parameters = templ.rover.parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (parameters[i].value.isLiteral() && parameters[i].minimum && parameters[i].maximum) {
            places.push_back(static_cast<int>(i));
        }
    }
    return places;
}

Result<Project> fromTemplate(const Project& templ, const std::vector<Assignment>& dimensions) {
    std::vector<std::string> names;
    for (const int place : mainDimensions(templ)) {
        names.push_back(templ.rover.parameters[static_cast<std::size_t>(place)].name);
    }
    Problems problems;
    for (const Assignment& one : dimensions) {
        if (std::find(names.begin(), names.end(), one.parameter) == names.end()) {
            problems.push_back({Severity::Critical, Text::of("parameter {}", one.parameter),
                                Text::of("it is no main dimension of this template."),
                                Text::of("Main dimensions: {}.", fmt::join(names, ", "))});
        }
    }
    if (!problems.empty()) {
        return problems;
    }
    const auto values = evaluateParameters(templ.rover, {}, dimensions);
    if (!values) {
        return values.problems();
    }
    Project project = templ;
    for (const Assignment& one : dimensions) {
        for (Parameter& parameter : project.rover.parameters) {
            if (parameter.name == one.parameter) {
                parameter.value = values->at(parameter.name);
                parameter.source = "chosen";
            }
        }
    }
    problems = validate(project);
    if (hasCritical(problems)) {
        return problems;
    }
    return Result<Project>(std::move(project), std::move(problems));
}

}  // namespace simcore::project
