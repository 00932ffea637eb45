#include "simcore/project/expression.h"

#include <cctype>
#include <cmath>
#include <numbers>

#include <muParser.h>

#include "simcore/base/text.h"
#include "simcore/project/units.h"

namespace simcore::project {
namespace {

bool startsName(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}

bool continuesName(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// What the parser says, as a clause.
std::string whyNot(const mu::ParserError& error) {
    const std::string& token = error.GetToken();
    const auto at = error.GetPos();
    switch (error.GetCode()) {
        case mu::ecUNASSIGNABLE_TOKEN:
            return Text::of("unexpected token \"{}\" found at position {}", token, at);
        case mu::ecUNEXPECTED_OPERATOR:
            return Text::of("unexpected operator \"{}\" found at position {}", token, at);
        case mu::ecUNEXPECTED_VAL:
            return Text::of("unexpected value \"{}\" found at position {}", token, at);
        case mu::ecUNEXPECTED_VAR:
            return Text::of("unexpected variable \"{}\" found at position {}", token, at);
        case mu::ecUNEXPECTED_FUN:
            return Text::of("unexpected function \"{}\" at position {}", token, at);
        case mu::ecUNEXPECTED_PARENS:
            return Text::of("unexpected parenthesis \"{}\" at position {}", token, at);
        case mu::ecUNEXPECTED_EOF:
            return Text::of("unexpected end of expression at position {}", at);
        case mu::ecUNEXPECTED_ARG_SEP:
            return Text::of("unexpected argument separator at position {}", at);
        case mu::ecMISSING_PARENS:
            return Text::of("missing parenthesis");
        case mu::ecTOO_MANY_PARAMS:
            return Text::of("too many parameters for function \"{}\" at expression position {}",
                            token, at);
        case mu::ecTOO_FEW_PARAMS:
            return Text::of("too few parameters for function \"{}\" at expression position {}",
                            token, at);
        case mu::ecEMPTY_EXPRESSION:
            return Text::of("expression is empty");
        default:
            break;
    }
    std::string message = error.GetMsg();
    while (!message.empty() && (message.back() == '.' || message.back() == '\n')) {
        message.pop_back();
    }
    if (!message.empty()) {
        message[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(message[0])));
    }
    return message;
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
                return Text::of("it has several values; write one (decimals with a point)");
            }
            if (!std::isfinite(results[0])) {
                return Text::of("its value is not a finite number");
            }
            return results[0];
        } catch (const mu::ParserError& error) {
            return whyNot(error);
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
