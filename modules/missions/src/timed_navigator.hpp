#pragma once

#include <vector>

#include "aisle/core/process_usage.hpp"
#include "aisle/guidance/navigator.hpp"

namespace aisle {

/// Measures the processor time of each cycle, from observation to decision.
class TimedNavigator final : public Navigator {
 public:
  /// Both must outlive this.
  TimedNavigator(Navigator& navigator, std::vector<double>& cycle_s)
      : navigator_(navigator), cycle_s_(cycle_s) {}

  Decision step(const Observation& observation) override {
    const double begun_s = thread_cpu_s();
    Decision decision = navigator_.step(observation);
    cycle_s_.push_back(thread_cpu_s() - begun_s);
    return decision;
  }

 private:
  Navigator& navigator_;
  std::vector<double>& cycle_s_;
};

}  // namespace aisle
