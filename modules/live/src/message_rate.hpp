#pragma once

#include <algorithm>

namespace aisle {

/// Limits the rate of messages: so many per second on average, and as many in one burst.
class MessageRate {
 public:
  explicit MessageRate(double per_s) : per_s_(per_s), left_(per_s) {}

  bool admit(double now_s) {
    left_ = std::min(per_s_, left_ + (now_s - last_s_) * per_s_);
    last_s_ = now_s;
    if (left_ < 1) return false;
    left_ -= 1;
    return true;
  }

 private:
  double per_s_;
  double left_;
  double last_s_ = 0;
};

}  // namespace aisle
