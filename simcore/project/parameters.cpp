// Parameter values: overrides, dependency order, ranges.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

#include "simcore/base/text.h"
#include "simcore/project/expression.h"
#include "simcore/project/resolve.h"
#include "simcore/project/units.h"

namespace simcore::project {
namespace {

Problem parameterProblem(const std::string& name, std::string reason, std::string remedy) {
    return {Severity::Critical, Text::of("parameter {}", name), std::move(reason),
            std::move(remedy)};
}

/// Evaluates parameters depth first, so that each is valued after those it uses.
class ParameterSolver {
  public:
    ParameterSolver(const Rover& rover, std::map<std::string, Quantity> overrides)
        : overrides_(std::move(overrides)) {
        for (const Parameter& parameter : rover.parameters) {
            if (!isParameterName(parameter.name)) {
                problems_.push_back(parameterProblem(
                    parameter.name, Text::of("this name cannot be used in expressions."),
                    Text::of("Use up to 100 letters, digits and underscores, not starting with a "
                             "digit and not the name of a function.")));
            } else if (!byName_.emplace(parameter.name, &parameter).second) {
                problems_.push_back(parameterProblem(parameter.name,
                                                     Text::of("the name is used twice."),
                                                     Text::of("Rename one of them.")));
            }
        }
    }

    Result<ParameterValues> solve(const Rover& rover) {
        for (const Parameter& parameter : rover.parameters) {
            if (byName_.contains(parameter.name)) {
                visit(parameter);
            }
        }
        if (hasCritical(problems_)) {
            return problems_;
        }
        return Result<ParameterValues>(values_, problems_);
    }

    Problems& problems() { return problems_; }

    const Parameter* find(const std::string& name) const {
        const auto found = byName_.find(name);
        return found == byName_.end() ? nullptr : found->second;
    }

  private:
    enum class Mark { Open, Done };

    /// A parameter being valued, and how far through those it uses.
    struct Step {
        const Parameter* parameter;
        std::vector<const Parameter*> uses;
        std::size_t next = 0;
    };

    /// Values `first` after all that it uses. A stack of its own: a chain may be of any length.
    void visit(const Parameter& first) {
        std::vector<Step> path;
        open(first, path);
        while (!path.empty()) {
            Step& step = path.back();
            if (step.next < step.uses.size()) {
                open(*step.uses[step.next++], path);
            } else {
                value(*step.parameter);
                marks_[step.parameter->name] = Mark::Done;
                path.pop_back();
            }
        }
    }

    void open(const Parameter& parameter, std::vector<Step>& path) {
        const auto [mark, isNew] = marks_.emplace(parameter.name, Mark::Open);
        if (!isNew) {
            if (mark->second == Mark::Open) {
                problems_.push_back(
                    parameterProblem(parameter.name, Text::of("its value depends on itself."),
                                     Text::of("Break the circle: give one a number.")));
            }
            return;
        }
        if (!parameter.unit.empty() && parameter.unit != "-" &&
            findUnit(parameter.unit) == nullptr) {
            problems_.push_back(
                {Severity::Warning, Text::of("parameter {}", parameter.name),
                 Text::of("its unit '{}' is not known.", parameter.unit),
                 Text::of("Use a unit such as mm, deg or kg; it is shown in SI now.")});
        }
        Step step{&parameter, {}};
        for (const std::string& name : namesIn(quantityOf(parameter).text())) {
            if (const Parameter* used = find(name)) {
                step.uses.push_back(used);
            }
        }
        path.push_back(std::move(step));
    }

    const Quantity& quantityOf(const Parameter& parameter) const {
        const auto found = overrides_.find(parameter.name);
        return found == overrides_.end() ? parameter.value : found->second;
    }

    void value(const Parameter& parameter) {
        const Quantity& quantity = quantityOf(parameter);
        double number = quantity.literal();
        if (!quantity.isLiteral()) {
            const auto result = evaluator_.evaluate(quantity.text());
            if (const auto* reason = std::get_if<std::string>(&result)) {
                problems_.push_back(parameterProblem(
                    parameter.name, Text::of("'{}' has no value: {}.", quantity.text(), *reason),
                    Text::of("Use numbers, other parameters and a unit at the end.")));
                return;
            }
            number = std::get<double>(result);
            checkDimension(parameter, quantity.text());
        }
        if (!std::isfinite(number)) {
            problems_.push_back(parameterProblem(parameter.name,
                                                 Text::of("its value is not a finite number."),
                                                 Text::of("Give a number.")));
            return;
        }
        checkRange(parameter, number, overrides_.contains(parameter.name));
        evaluator_.define(parameter.name, number);
        values_[parameter.name] = number;
    }

    void checkDimension(const Parameter& parameter, const std::string& text) {
        const auto written = splitUnit(text);
        const Unit* display = findUnit(parameter.unit);
        if (written && display &&
            std::string_view(written->unit->dimension) != display->dimension) {
            problems_.push_back(
                parameterProblem(parameter.name,
                                 Text::of("'{}' is a {}, but this is a {}.", text,
                                          Text::translated(written->unit->dimension),
                                          Text::translated(display->dimension)),
                                 Text::of("Write it in {} or another unit of {}.", display->symbol,
                                          Text::translated(display->dimension))));
        }
    }

    void checkRange(const Parameter& parameter, double number, bool overridden) {
        if (parameter.minimum && parameter.maximum && *parameter.minimum > *parameter.maximum) {
            problems_.push_back(parameterProblem(parameter.name,
                                                 Text::of("its minimum is above its maximum."),
                                                 Text::of("Swap or correct them.")));
            return;
        }
        const bool low = parameter.minimum && number < *parameter.minimum;
        const bool high = parameter.maximum && number > *parameter.maximum;
        if (!low && !high) {
            return;
        }
        const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
        const double limit = low ? *parameter.minimum : *parameter.maximum;
        problems_.push_back(parameterProblem(
            parameter.name,
            low ? Text::of("{}{} is below its minimum of {}{}.", formatIn(number, parameter.unit),
                           unit, formatIn(limit, parameter.unit), unit)
                : Text::of("{}{} is above its maximum of {}{}.", formatIn(number, parameter.unit),
                           unit, formatIn(limit, parameter.unit), unit),
            overridden ? Text::of("Set it within its range.")
                       : Text::of("Change the value, or the range if it is too narrow.")));
    }

    std::map<std::string, Quantity> overrides_;
    std::map<std::string, const Parameter*> byName_;
    std::map<std::string, Mark> marks_;
    ParameterValues values_;
    ExpressionEvaluator evaluator_;
    Problems problems_;
};

bool isDerived(const Parameter& parameter) {
    return !parameter.value.isLiteral() && !namesIn(parameter.value.text()).empty();
}

}  // namespace

Quantity quantityFrom(const std::string& text) {
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc() && stop == end && std::isfinite(number)) {
        return Quantity(number);
    }
    // Not a plain number: an expression, judged when it is valued.
    return Quantity::expression(text.empty() ? " " : text);
}

Result<ParameterValues> evaluateParameters(const Rover& rover, const std::vector<Override>& variant,
                                           const std::vector<Assignment>& assignments) {
    std::vector<Override> all = variant;
    for (const Assignment& assignment : assignments) {
        all.push_back({assignment.parameter, quantityFrom(assignment.value)});
    }
    std::map<std::string, Quantity> overrides;
    for (const Override& change : all) {
        overrides[change.parameter] = change.value;
    }
    ParameterSolver solver(rover, overrides);
    for (const Override& change : all) {
        const Parameter* parameter = solver.find(change.parameter);
        if (parameter == nullptr) {
            solver.problems().push_back(parameterProblem(
                change.parameter, Text::of("the rover has no parameter of this name."),
                Text::of("Check the spelling against the rover's parameters.")));
        } else if (isDerived(*parameter)) {
            solver.problems().push_back(parameterProblem(
                change.parameter,
                Text::of("it is derived ({}) and cannot be set.", parameter->value.text()),
                Text::of("Set the parameters it is made of.")));
        }
    }
    return solver.solve(rover);
}

Result<ParameterValues> evaluateParameters(const Project& project, const std::string& variant,
                                           const std::vector<Assignment>& assignments) {
    if (variant.empty()) {
        return evaluateParameters(project.rover, {}, assignments);
    }
    const auto found = std::find_if(project.variants.begin(), project.variants.end(),
                                    [&](const Variant& v) { return v.name == variant; });
    if (found == project.variants.end()) {
        return Problem{Severity::Critical, Text::of("variant {}", variant),
                       Text::of("there is no such variant."),
                       Text::of("Name one of the project's variants, or none.")};
    }
    return evaluateParameters(project.rover, found->set, assignments);
}

Result<double> evaluate(const Quantity& quantity, const ParameterValues& parameters,
                        const std::string& element, std::string_view dimension) {
    if (quantity.isLiteral()) {
        if (!std::isfinite(quantity.literal())) {
            return Problem{Severity::Critical, element,
                           Text::of("its value is not a finite number."),
                           Text::of("Give a number.")};
        }
        return quantity.literal();
    }
    if (!dimension.empty()) {
        if (const std::string why = whyWrongDimension(quantity.text(), dimension); !why.empty()) {
            return Problem{Severity::Critical, element, why + ".",
                           Text::of("Write it in a unit of {}, or as a number in SI.",
                                    Text::translated(std::string(dimension).c_str()))};
        }
    }
    ExpressionEvaluator evaluator;
    for (const auto& [name, value] : parameters) {
        evaluator.define(name, value);
    }
    const auto result = evaluator.evaluate(quantity.text());
    if (const auto* reason = std::get_if<std::string>(&result)) {
        return Problem{Severity::Critical, element,
                       Text::of("'{}' has no value: {}.", quantity.text(), *reason),
                       Text::of("Use numbers, parameters of the rover and a unit at the end.")};
    }
    return std::get<double>(result);
}

}  // namespace simcore::project
