#pragma once
/// Figures over many values.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

namespace aisle {

/// Quantile: the value that a share (0 .. 1) of all values does not exceed; 0 if there are none.
double quantile(std::vector<double> values, double share);

/// {"median": ..., "p99": ...} of processor times [ms].
nlohmann::ordered_json cycle_figures(const std::vector<double>& cycle_s);

/// Mean and worst of a figure over missions.
class Spread {
 public:
  void add(double value);
  double mean() const;
  double worst() const { return worst_; }
  nlohmann::ordered_json json(int decimals) const;

 private:
  double sum_ = 0, worst_ = 0;
  std::size_t count_ = 0;
};

}  // namespace aisle
