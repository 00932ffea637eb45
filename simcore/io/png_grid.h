#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace simcore::io {

/// A grey PNG of 16 bit, as bytes; `values` row by row from the top.
std::string formatPng(int columns, int rows, const std::vector<std::uint16_t>& values);

}  // namespace simcore::io
