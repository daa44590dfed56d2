#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/formats/sessions/session_message.hpp"

namespace aisle {

/// Passes messages from the mission's thread to the server's. Putting never waits for a client.
class Outbox {
 public:
  static constexpr std::size_t kItemsMax = 1024;

  struct Item {
    SessionTopic topic;  ///< without a name: a message with the time
    ros::Stamp_ns stamp = 0;
    std::shared_ptr<const std::string> cdr;
  };

  /// Messages without a viewer are only put if later clients need them.
  /// @return whether to call take(): true once until the next take()
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
