#pragma once

#include <array>
#include <string>

namespace simcore::project {

/// A number of the project file: a literal in SI, or text such as "bogie_length/2" or "12 cm".
///
/// Text is kept as written, so that saving never rewrites what the user typed.
class Quantity {
  public:
    Quantity() = default;

    Quantity(double value) : value_(value) {}  // NOLINT(google-explicit-constructor)

    static Quantity expression(std::string text) {
        Quantity quantity;
        quantity.text_ = std::move(text);
        return quantity;
    }

    bool isLiteral() const { return text_.empty(); }

    /// The literal [SI]; 0 for an expression, which only an Evaluator can value.
    double literal() const { return value_; }

    /// The expression as written; empty for a literal.
    const std::string& text() const { return text_; }

    bool operator==(const Quantity&) const = default;

  private:
    double value_ = 0.0;
    std::string text_;
};

using Quantity3 = std::array<Quantity, 3>;

}  // namespace simcore::project
