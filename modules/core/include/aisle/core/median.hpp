#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace aisle {

/// The value in the middle, the upper one of an even number; puts the values into another order. O(n).
/// @param values  at least one
template <typename Value>
Value median_reordering(std::span<Value> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The same of values that stay as they are.
template <typename Value>
Value median(std::vector<Value> values) {
  return median_reordering(std::span(values));
}

}  // namespace aisle
