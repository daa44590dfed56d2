#include "live_hand.hpp"

#include <utility>

namespace aisle {

OperatorInput LiveHand::look(double stamp_s) {
  if (auto heard = inbox_.take()) {
    newest_ = std::move(heard);
    heard_s_ = stamp_s;
  }
  const bool is_fresh = newest_ && !is_held_ && stamp_s - heard_s_ + newest_->age_s <= kCommandAgeMax_s;
  return {.requested = is_fresh ? newest_->command : Command{},
          .marks = std::exchange(marks_, {}),
          .quit = std::exchange(is_finished_, false)};
}

void LiveHand::begin() {
  (void)inbox_.take();
  newest_.reset();
  marks_.clear();
  is_finished_ = false;
}

}  // namespace aisle
