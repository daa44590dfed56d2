#pragma once

#include <algorithm>
#include <optional>

namespace aisle {

/// A mission's time: begins one cycle before the end of its first one, and stands still while the vehicle is
/// held.
class MissionClock {
 public:
  explicit MissionClock(double cycle_s) : cycle_s_(cycle_s) {}

  /// The time until the next cycle ends does not count, but for that cycle.
  void hold() { is_held_ = true; }

  /// The mission's time at the end of a cycle. @param end_s  by the robot's clock
  double at(double end_s) {
    if (!last_end_s_) {
      first_s_ = end_s - cycle_s_;
    } else if (is_held_) {
      const double held_s = std::max(0.0, end_s - *last_end_s_ - cycle_s_);
      first_s_ += held_s;
      held_s_ += held_s;
    }
    is_held_ = false;
    last_end_s_ = end_s;
    return end_s - first_s_;
  }

  double held_s() const { return held_s_; }

 private:
  double cycle_s_;
  double first_s_ = 0;
  double held_s_ = 0;
  std::optional<double> last_end_s_;
  bool is_held_ = false;
};

}  // namespace aisle
