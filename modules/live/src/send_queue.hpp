#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace aisle {

/// One WebSocket message on its path to a client: its head, then a body that many clients share.
struct OutFrame {
  std::string head;
  std::shared_ptr<const std::string> body;  ///< null: the head is all
  bool is_text = false;
  bool may_be_lost = false;  ///< a newer one will follow

  std::size_t bytes() const { return head.size() + (body ? body->size() : 0); }
};

/// What waits for one client. A client that is too slow loses the oldest messages that may be lost.
class SendQueue {
 public:
  static constexpr std::size_t kFramesMax = 256;
  static constexpr std::size_t kBytesMax = 4 << 20;

  /// @return false: even without all that may be lost too much is waiting
  bool push(OutFrame frame);
  /// The oldest; nullopt if nothing waits.
  std::optional<OutFrame> pop();

  std::size_t lost() const { return lost_; }

 private:
  bool is_too_full() const { return frames_.size() > kFramesMax || bytes_ > kBytesMax; }
  bool lose_one();

  std::deque<OutFrame> frames_;
  std::size_t bytes_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace aisle
