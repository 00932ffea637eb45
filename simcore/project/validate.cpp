#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "simcore/project/names.h"
#include "simcore/project/resolve.h"

namespace simcore::project {
namespace {

/// A scenario number must lie in a range that any engine can run; wide, to catch typing errors.
struct Range {
    double low;
    double high;
};

void append(Problems& problems, const Problems& more) {
    for (const Problem& problem : more) {
        if (std::find(problems.begin(), problems.end(), problem) == problems.end()) {
            problems.push_back(problem);
        }
    }
}

void checkNumber(const Quantity& quantity, const ParameterValues& parameters,
                 const std::string& element, const char* what, const char* dimension, Range range,
                 Problems& problems) {
    const auto value = evaluate(quantity, parameters, element + ", " + what, dimension);
    append(problems, value.problems());
    if (value && !(*value >= range.low && *value <= range.high)) {
        problems.push_back(
            {Severity::Critical, element + ", " + what,
             fmt::format("{:.6g} is not between {:.6g} and {:.6g}.", *value, range.low, range.high),
             "Correct it; values are in SI unless a unit is written."});
    }
}

const std::vector<Override>* findVariant(const Project& project, const std::string& name) {
    for (const Variant& variant : project.variants) {
        if (variant.name == name) {
            return &variant.set;
        }
    }
    return nullptr;
}

void validateScenario(const Project& project, const Scenario& scenario, Problems& problems) {
    const std::string element = "scenario " + scenario.name;
    std::vector<Override> overrides;
    if (!scenario.variant.empty()) {
        const auto* found = findVariant(project, scenario.variant);
        if (found == nullptr) {
            problems.push_back({Severity::Critical, element,
                                fmt::format("there is no variant '{}'.", scenario.variant),
                                "Name one of the project's variants, or none."});
            return;
        }
        overrides = *found;
    }
    const auto parameters = evaluateParameters(project.rover, overrides);
    if (!parameters) {
        return;  // reported with the rover or the variant
    }
    const auto check = [&](const Quantity& quantity, const char* what, const char* dimension,
                           Range range) {
        checkNumber(quantity, *parameters, element, what, dimension, range, problems);
    };
    check(scenario.soil.friction, "friction", "ratio", {0.0, 5.0});
    check(scenario.soil.rollingResistance, "rolling resistance", "ratio", {0.0, 1.0});
    check(scenario.controller.speed, "speed", "speed", {-10.0, 10.0});
    check(scenario.controller.assumedFriction, "assumed friction", "ratio", {0.0, 5.0});
    check(scenario.controller.period, "controller period", "time", {1e-4, 1.0});
    check(scenario.controller.proportional, "proportional gain", "", {0.0, 1e6});
    check(scenario.controller.integral, "integral gain", "", {0.0, 1e6});
    check(scenario.controller.derivative, "derivative gain", "", {0.0, 1e6});
    check(scenario.run.step, "step", "time", {1e-5, 0.02});
    check(scenario.run.distance, "distance", "length", {0.01, 1000.0});
    check(scenario.run.duration, "duration", "time", {0.0, 1e5});
    check(scenario.run.settle, "settling time", "time", {0.0, 60.0});
    check(scenario.run.ramp, "ramp time", "time", {0.0, 60.0});
}

}  // namespace

Problems validate(const Project& project) {
    Problems problems;
    const auto parameters = evaluateParameters(project.rover);
    append(problems, parameters.problems());
    if (parameters) {
        append(problems, resolve(project.rover, *parameters).problems());
    }
    std::set<std::string> names;
    for (const Variant& variant : project.variants) {
        if (!names.insert(variant.name).second || variant.name.empty()) {
            problems.push_back({Severity::Critical, "variant " + variant.name,
                                "the name is empty or used twice.", "Rename it."});
        }
        const auto values = evaluateParameters(project.rover, variant.set);
        for (Problem problem : values.problems()) {
            problem.element = "variant " + variant.name + ", " + problem.element;
            append(problems, {problem});
        }
    }
    names.clear();
    for (const Scenario& scenario : project.scenarios) {
        if (!names.insert(scenario.name).second || scenario.name.empty()) {
            problems.push_back({Severity::Critical, "scenario " + scenario.name,
                                "the name is empty or used twice.", "Rename it."});
        }
        validateScenario(project, scenario, problems);
    }
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
        return static_cast<int>(a.severity) > static_cast<int>(b.severity);
    });
    return problems;
}

}  // namespace simcore::project
