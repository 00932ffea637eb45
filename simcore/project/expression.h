#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>

namespace simcore::project {

/// Values arithmetic expressions over named parameters (muParser: + - * / ^, sin, sqrt, min, ...;
/// angles in rad; `pi`), optionally followed by a unit: "2*wheel_radius + 5 mm" is *not* possible
/// (one unit, at the end, for the whole expression), "12 cm" is.
class ExpressionEvaluator {
  public:
    ExpressionEvaluator();
    ~ExpressionEvaluator();
    ExpressionEvaluator(const ExpressionEvaluator&) = delete;
    ExpressionEvaluator& operator=(const ExpressionEvaluator&) = delete;

    /// Makes `name` usable in expressions.
    void define(const std::string& name, double value);

    /// The value [SI], or the reason why there is none, as a clause for people.
    std::variant<double, std::string> evaluate(const std::string& text);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Names (identifiers not followed by a bracket) that occur in an expression.
std::set<std::string> namesIn(const std::string& expression);

/// True when `name` can be used as a parameter name: at most 100 letters, digits, underscores, no
/// leading digit, not a function or constant of the expression language.
bool isParameterName(const std::string& name);

}  // namespace simcore::project
