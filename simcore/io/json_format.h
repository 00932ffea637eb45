#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace simcore::io {

/// Text of a JSON value: 2 spaces a level, an object or array on one line where it fits in 110
/// columns, shortest numbers that read back exactly. The same value always gives the same text.
std::string formatJson(const nlohmann::ordered_json& value);

/// What is no number becomes null.
nlohmann::ordered_json numberOrNull(double value);

}  // namespace simcore::io
