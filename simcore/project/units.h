#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simcore::project {

/// A unit the user may write or see. `factor` turns a value in this unit into SI.
struct Unit {
    const char* symbol;
    const char* dimension;  ///< "length", "mass", "angle", ...
    double factor;
};

/// The unit written as `symbol` ("mm", "deg", "N/m", ...), or null.
const Unit* findUnit(std::string_view symbol);

/// All units of the dimension that `symbol` has, for choosers.
std::vector<const Unit*> unitsLike(std::string_view symbol);

/// "12 cm" -> {"12", cm}; text without a unit at its end -> nothing. A unit counts only after a
/// blank, or directly after a plain number, so that names such as link2m stay names.
struct ValueWithUnit {
    std::string value;
    const Unit* unit;
};

std::optional<ValueWithUnit> splitUnit(std::string_view text);

/// Why text such as "12 kg" is no `dimension` ("length", ...), as a clause; empty when it is, or
/// when no unit is written.
std::string whyWrongDimension(std::string_view text, std::string_view dimension);

/// SI value as shown: in `unit` with at most `digits` significant digits, e.g. "70".
std::string formatIn(double valueSi, std::string_view unit, int digits = 7);

}  // namespace simcore::project
