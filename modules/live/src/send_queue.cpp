#include "send_queue.hpp"

#include <algorithm>
#include <utility>

namespace aisle {

bool SendQueue::push(OutFrame frame) {
  bytes_ += frame.bytes();
  frames_.push_back(std::move(frame));
  while (is_too_full()) {
    if (!lose_one()) return frames_.size() == 1;
  }
  return true;
}

std::optional<OutFrame> SendQueue::pop() {
  if (frames_.empty()) return std::nullopt;
  OutFrame frame = std::move(frames_.front());
  frames_.pop_front();
  bytes_ -= frame.bytes();
  return frame;
}

/// The newest is kept, even if it is larger than the limit.
bool SendQueue::lose_one() {
  const auto end = frames_.end() - 1;
  const auto oldest =
      std::find_if(frames_.begin(), end, [](const OutFrame& frame) { return frame.may_be_lost; });
  if (oldest == end) return false;
  bytes_ -= oldest->bytes();
  frames_.erase(oldest);
  ++lost_;
  return true;
}

}  // namespace aisle
