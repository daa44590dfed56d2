#pragma once

#include <vector>

#include "aisle/guidance/key_controls.hpp"
#include "aisle/simulation/operators/operator.hpp"

namespace aisle {

/// A key and for how long it is held.
struct TimedKey {
  double from_s = 0;
  double to_s = 0;  ///< not before from_s
  Key key;
};

/// Presses keys at their times; quits half a second after the last.
class KeyScript final : public Operator {
 public:
  KeyScript(std::vector<TimedKey> keys, const KeySpeeds& speeds, bool is_differential);

  OperatorInput look(const OperatorView& view) override;

 private:
  std::vector<TimedKey> keys_;
  KeyControls controls_;
  double end_s_ = 0;
  double last_stamp_s_ = 0;
};

}  // namespace aisle
