#pragma once

#include "aisle/core/clock.hpp"

namespace aisle {

/// A clock that shows the time it was set to.
class SetClock final : public Clock {
 public:
  double now_s() const override { return time_s; }
  double time_s = 100;
};

}  // namespace aisle
