#include "aisle/connection/topic_pace.hpp"

#include <algorithm>

namespace aisle {

void TopicPace::take(double arrived_s, double age_s) {
  if (messages == 0) {
    first_arrived_s = arrived_s;
    age_min_s = age_max_s = age_s;
  } else {
    gap_max_s = std::max(gap_max_s, arrived_s - last_arrived_s);
  }
  ++messages;
  last_arrived_s = arrived_s;
  age_sum_s += age_s;
  age_min_s = std::min(age_min_s, age_s);
  age_max_s = std::max(age_max_s, age_s);
}

double TopicPace::rate_hz() const {
  const double span_s = last_arrived_s - first_arrived_s;
  return messages < 2 || span_s <= 0 ? 0 : static_cast<double>(messages - 1) / span_s;
}

}  // namespace aisle
