#include "aisle/simulation/operators/key_script.hpp"

#include <algorithm>
#include <utility>

namespace aisle {

KeyScript::KeyScript(std::vector<TimedKey> keys, const KeySpeeds& speeds, bool is_differential)
    : keys_(std::move(keys)), controls_(speeds, is_differential) {
  for (const TimedKey& timed : keys_) end_s_ = std::max(end_s_, timed.to_s);
}

OperatorInput KeyScript::look(const OperatorView& view) {
  const double before_s = std::exchange(last_stamp_s_, view.stamp_s);
  std::vector<Key> pressed;
  for (const auto& [from_s, to_s, key] : keys_) {
    const bool begins = from_s > before_s && from_s <= view.stamp_s;
    const bool begins_at_once = from_s == 0 && before_s == 0;
    const bool is_held = from_s <= view.stamp_s && view.stamp_s < to_s;
    if (begins || begins_at_once || is_held) pressed.push_back(key);
  }
  OperatorInput input = controls_.press(view.stamp_s, pressed);
  input.quit = input.quit || view.stamp_s > end_s_ + 0.5;
  return input;
}

}  // namespace aisle
