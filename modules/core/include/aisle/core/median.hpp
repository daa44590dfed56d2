#pragma once

#include <algorithm>
#include <vector>

namespace aisle {

/// The value in the middle, the upper one of an even number. O(n).
/// @param values  at least one
template <typename Value>
Value median(std::vector<Value> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace aisle
