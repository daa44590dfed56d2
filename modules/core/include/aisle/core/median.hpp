#pragma once

#include <algorithm>
#include <span>
#include <vector>

namespace aisle {

/// The median, of an even number of values the upper one of the middle two. Reorders the values. O(n).
/// @param values  at least one
template <typename Value>
Value median_reordering(std::span<Value> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The same, without reordering the caller's values.
template <typename Value>
Value median(std::vector<Value> values) {
  return median_reordering(std::span(values));
}

}  // namespace aisle
