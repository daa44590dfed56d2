#include "aisle/missions/statistics.hpp"

#include <algorithm>

#include "aisle/core/rounded.hpp"

namespace aisle {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto index = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
  return values[index];
}

nlohmann::ordered_json cycle_figures(const std::vector<double>& cycle_s) {
  return {{"median", rounded(1e3 * quantile(cycle_s, 0.5), 3)},
          {"p99", rounded(1e3 * quantile(cycle_s, 0.99), 3)}};
}

void Spread::add(double value) {
  sum_ += value;
  worst_ = count_ == 0 ? value : std::max(worst_, value);
  ++count_;
}

double Spread::mean() const {
  return count_ == 0 ? 0 : sum_ / static_cast<double>(count_);
}

nlohmann::ordered_json Spread::json(int decimals) const {
  return {{"mean", rounded(mean(), decimals)}, {"worst", rounded(worst_, decimals)}};
}

}  // namespace aisle
