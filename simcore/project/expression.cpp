#include "simcore/project/expression.h"

#include <cctype>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <muParser.h>

#include "simcore/project/units.h"

namespace simcore::project {
namespace {

bool startsName(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}

bool continuesName(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

}  // namespace

struct ExpressionEvaluator::Impl {
    mu::Parser parser;

    Impl() { parser.DefineConst("pi", std::numbers::pi); }

    std::variant<double, std::string> evaluatePlain(const std::string& text) {
        try {
            parser.SetExpr(text);
            int count = 0;
            const double* results = parser.Eval(count);
            if (count != 1) {
                return std::string("it has several values; write one (decimals with a point)");
            }
            if (!std::isfinite(results[0])) {
                return std::string("its value is not a finite number");
            }
            return results[0];
        } catch (const mu::ParserError& error) {
            std::string message = error.GetMsg();
            while (!message.empty() && (message.back() == '.' || message.back() == '\n')) {
                message.pop_back();
            }
            if (!message.empty()) {
                message[0] =
                    static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
            }
            return message;
        }
    }
};

ExpressionEvaluator::ExpressionEvaluator() : impl_(std::make_unique<Impl>()) {}

ExpressionEvaluator::~ExpressionEvaluator() = default;

void ExpressionEvaluator::define(const std::string& name, double value) {
    // A constant, not a variable: an expression must not be able to assign to a parameter.
    impl_->parser.DefineConst(name, value);
}

std::variant<double, std::string> ExpressionEvaluator::evaluate(const std::string& text) {
    if (const auto split = splitUnit(text)) {
        auto value = impl_->evaluatePlain(split->value);
        if (double* number = std::get_if<double>(&value)) {
            *number *= split->unit->factor;
        }
        return value;
    }
    return impl_->evaluatePlain(text);
}

std::set<std::string> namesIn(const std::string& expression) {
    const auto split = splitUnit(expression);
    const std::string& text = split ? split->value : expression;
    std::set<std::string> names;
    for (std::size_t i = 0; i < text.size();) {
        if (!startsName(text[i])) {
            // Skip the exponent of a number such as 1e-3 together with the number.
            const bool number = std::isdigit(static_cast<unsigned char>(text[i])) || text[i] == '.';
            ++i;
            while (number && i < text.size() && (continuesName(text[i]) || text[i] == '.')) {
                ++i;
            }
            continue;
        }
        const std::size_t begin = i;
        while (i < text.size() && continuesName(text[i])) {
            ++i;
        }
        std::size_t next = i;
        while (next < text.size() && text[next] == ' ') {
            ++next;
        }
        if (next == text.size() || text[next] != '(') {
            names.insert(text.substr(begin, i - begin));
        }
    }
    return names;
}

bool isParameterName(const std::string& name) {
    constexpr std::size_t kLongest = 100;  // muParser takes no longer identifier
    if (name.empty() || name.size() > kLongest || !startsName(name[0])) {
        return false;
    }
    for (char c : name) {
        if (!continuesName(c)) {
            return false;
        }
    }
    static const std::set<std::string> reserved = [] {
        std::set<std::string> names{"pi", "_pi", "_e"};
        const mu::Parser parser;
        for (const auto& function : parser.GetFunDef()) {
            names.insert(function.first);
        }
        return names;
    }();
    return !reserved.contains(name);
}

}  // namespace simcore::project
