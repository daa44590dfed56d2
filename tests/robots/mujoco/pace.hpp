#pragma once

#include <chrono>

#include "ros/messages.hpp"

namespace robots {

/// Holds simulated time to the machine's clock, and says what stamps are made of it. What a slow machine
/// loses is not caught up: the world has then stood still meanwhile.
class Pace {
 public:
  /// @param simulated_clock stamps are simulated time, from 0; else they are wall clock time
  Pace(double speed, bool simulated_clock);

  /// Sleeps until the simulation may have reached this time.
  void wait_for(double simulated_s);
  Time stamp(double simulated_s) const;
  /// Since the beginning, on the machine's clock.
  double wall_s() const;

 private:
  using Steady = std::chrono::steady_clock;

  double speed_;
  bool simulated_clock_;
  Steady::time_point began_ = Steady::now();
  Steady::time_point start_ = began_;
  std::chrono::nanoseconds start_stamp_{0};
};

}  // namespace robots
