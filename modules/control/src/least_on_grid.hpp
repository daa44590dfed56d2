#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace aisle {

struct GridValue {
  int index = 0;
  double value = 0;
};

/// Less of two; among equals the one nearer to index 0, then the greater index.
inline bool is_better(const GridValue& a, const GridValue& b) {
  if (a.value != b.value) return a.value < b.value;
  return std::abs(a.index) != std::abs(b.index) ? std::abs(a.index) < std::abs(b.index) : a.index > b.index;
}

/// The best of f(min) .. f(max), the same as all tries would give, for a function whose neighbouring values
/// differ by at most `slope`: segments that can hold nothing as good as the best are left out.
template <class Function>
GridValue least_on_grid(int min, int max, double slope, Function&& f) {
  constexpr double kRounding = 1e-9;
  const GridValue first{min, f(min)};
  GridValue best = first;
  const auto try_at = [&](int index) {
    const GridValue tried{index, f(index)};
    if (is_better(tried, best)) best = tried;
    return tried;
  };
  if (min == max) return first;
  std::vector<std::pair<GridValue, GridValue>> path_segments = {{first, try_at(max)}};
  while (!path_segments.empty()) {
    const auto [a, b] = path_segments.back();
    path_segments.pop_back();
    const int steps = b.index - a.index;
    const double bound = (a.value + b.value - slope * steps) / 2;
    if (steps < 2 || bound > best.value + kRounding) continue;
    const double lowest_at = a.index + (steps + (a.value - b.value) / slope) / 2;
    const int middle = std::clamp(static_cast<int>(std::lround(lowest_at)), a.index + 1, b.index - 1);
    const GridValue m = try_at(middle);
    path_segments.push_back({a, m});
    path_segments.push_back({m, b});
  }
  return best;
}

}  // namespace aisle
