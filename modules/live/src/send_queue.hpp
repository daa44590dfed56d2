#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace aisle {

/// One WebSocket message to a client: its head, then a body that many clients share.
struct OutFrame {
  std::string head;
  std::shared_ptr<const std::string> body;  ///< null: the message is the head alone
  bool is_text = false;
  bool may_be_lost = false;  ///< a newer message will replace it
  bool is_goodbye = false;   ///< no message: the connection is closed after all before it

  std::size_t bytes() const { return head.size() + (body ? body->size() : 0); }
};

/// The messages waiting for one client. If a client is too slow, its oldest droppable messages are dropped.
class SendQueue {
 public:
  static constexpr std::size_t kFramesMax = 256;
  static constexpr std::size_t kBytesMax = 4 << 20;

  /// @return false if too much is waiting even without the droppable messages
  bool push(OutFrame frame);
  /// The oldest message; nullopt if none waits.
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
