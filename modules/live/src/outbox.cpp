#include "outbox.hpp"

#include <utility>

namespace aisle {

bool Outbox::put(const SessionTopic& topic, ros::Stamp_ns stamp, std::string_view cdr, bool somebody_looks) {
  const bool is_new = known_.insert(topic.name).second;
  if (!somebody_looks && !is_new && !topic.latched) return false;
  return push({topic, stamp, std::make_shared<const std::string>(cdr)});
}

bool Outbox::put_time(ros::Stamp_ns stamp) {
  return push({.stamp = stamp});
}

std::vector<Outbox::Item> Outbox::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(items_, {});
}

/// If the server's thread is that far behind, messages that are not latched are dropped.
bool Outbox::push(Item item) {
  const std::lock_guard lock(mutex_);
  if (items_.size() >= kItemsMax && !item.topic.latched) return false;
  items_.push_back(std::move(item));
  return items_.size() == 1;
}

}  // namespace aisle
