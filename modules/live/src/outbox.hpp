#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/formats/sessions/session_message.hpp"

namespace aisle {

/// Messages on their path from the mission's thread to the server's. Putting never waits for a client.
class Outbox {
 public:
  static constexpr std::size_t kItemsMax = 1024;

  struct Item {
    SessionTopic topic;  ///< without a name: the time
    ros::Stamp_ns stamp = 0;
    std::shared_ptr<const std::string> cdr;
  };

  /// Messages that nobody could see are only put where they matter to who comes later.
  /// @return whether take() is to be called: it was not since the last call that said so
  bool put(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr, bool somebody_looks);
  bool put_time(ros::Stamp_ns stamp);

  std::vector<Item> take();

 private:
  bool push(Item item);

  std::mutex mutex_;
  std::vector<Item> items_;
  std::set<std::string> known_;
};

}  // namespace aisle
