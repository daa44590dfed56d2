#pragma once
/// JSON that people can compare: only significant digits, one item per line.

#include <string>
#include <string_view>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

constexpr int kMillimetreDecimals = 3;  // of metres: positions in a building are not more accurate

/// Rounded to `count` decimals, without trailing zeros and without "-0".
std::string decimals(double value, int count);

/// "[x, y]"
std::string point_json(const Vec2& p, int decimal_count);

/// With the quotes; invalid UTF-8 is replaced.
std::string quoted_json(const std::string& text);

/// A list with each element on its own line.
std::string list_json(const std::vector<std::string>& elements);

}  // namespace aisle
