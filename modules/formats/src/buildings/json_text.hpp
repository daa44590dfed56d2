#pragma once
/// JSON as people compare it: no more digits than mean something, one thing a line.

#include <string>
#include <string_view>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

constexpr int kMillimetreDecimals = 3;  // of metres: places in a building are not known better

/// Rounded to so many decimals, without trailing zeros and without "-0".
std::string decimals(double value, int count);

/// "[x, y]"
std::string point_json(const Vec2& p, int decimal_count);

/// With the quotes; what is no UTF-8 is replaced.
std::string quoted_json(const std::string& text);

/// A list with every element on a line of its own.
std::string list_json(const std::vector<std::string>& elements);

}  // namespace aisle
