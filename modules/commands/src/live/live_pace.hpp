#pragma once

#include <optional>

#include "aisle/core/clock.hpp"

namespace aisle {

/// How a simulated vehicle's time keeps pace with people's.
class LivePace {
 public:
  /// @param rate  vehicle's seconds in a second; 0: no pace is kept
  LivePace(const Clock& clock, double rate) : clock_(clock), rate_(rate) {}

  /// Time stood still: it goes on from here.
  void rest() { begun_.reset(); }
  void set_rate(double rate);
  double rate() const { return rate_; }

  /// How long to wait until the vehicle's time is due. Who comes too late is not hurried on.
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
