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

/// The smaller value is better; among equals the index nearer to 0, then the greater index.
inline bool is_better(const GridValue& a, const GridValue& b) {
  if (a.value != b.value) return a.value < b.value;
  return std::abs(a.index) != std::abs(b.index) ? std::abs(a.index) < std::abs(b.index) : a.index > b.index;
}

/// The best of f(min) .. f(max), the same as an exhaustive search finds, for a function whose neighbouring
/// values differ by at most `slope`: intervals that cannot hold a better value are skipped.
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
  std::vector<std::pair<GridValue, GridValue>> intervals = {{first, try_at(max)}};
  while (!intervals.empty()) {
    const auto [a, b] = intervals.back();
    intervals.pop_back();
    const int steps = b.index - a.index;
    const double bound = (a.value + b.value - slope * steps) / 2;
    if (steps < 2 || bound > best.value + kRounding) continue;
    const double lowest_at = a.index + (steps + (a.value - b.value) / slope) / 2;
    const int middle = std::clamp(static_cast<int>(std::lround(lowest_at)), a.index + 1, b.index - 1);
    const GridValue m = try_at(middle);
    intervals.push_back({a, m});
    intervals.push_back({m, b});
  }
  return best;
}

}  // namespace aisle
