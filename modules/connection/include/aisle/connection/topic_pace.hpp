#pragma once

#include <cstddef>

namespace aisle {

/// How regularly the messages of a topic arrive.
struct TopicPace {
  std::size_t messages = 0;
  double first_arrived_s = 0;
  double last_arrived_s = 0;
  double gap_max_s = 0;
  double age_sum_s = 0;  ///< of all messages: the time by the clock of this machine, less their stamp
  double age_min_s = 0;
  double age_max_s = 0;

  void take(double arrived_s, double age_s);
  double rate_hz() const;
  double age_mean_s() const { return messages == 0 ? 0 : age_sum_s / static_cast<double>(messages); }
};

}  // namespace aisle
