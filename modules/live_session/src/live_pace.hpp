#pragma once

#include <optional>

#include "aisle/core/clock.hpp"

namespace aisle {

/// Keeps simulated time in pace with real time.
class LivePace {
 public:
  /// @param rate  simulated seconds per second; 0: as fast as possible
  LivePace(const Clock& clock, double rate) : clock_(clock), rate_(rate) {}

  /// Simulated time stood still: the pace is kept from now on.
  void rest() { begun_.reset(); }
  void set_rate(double rate);
  double rate() const { return rate_; }

  /// How long to wait until a simulated time is due [s]. A delay of over half a second is not caught up.
  double wait_s(double stamp_s);

 private:
  struct Begin {
    double clock_s = 0;
    double stamp_s = 0;
  };

  const Clock& clock_;
  double rate_;
  std::optional<Begin> begun_;
};

}  // namespace aisle
