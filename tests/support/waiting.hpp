#pragma once
/// Waiting for what other threads and programs do: until it happens, or until the test has failed.

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace aisle {

/// Far longer than anything takes, even on a loaded machine.
constexpr std::chrono::seconds kWaitMax{60};

/// Tries again and again. @return whether it became true
inline bool eventually(const std::function<bool()>& becomes_true) {
  const auto end = std::chrono::steady_clock::now() + kWaitMax;
  while (!becomes_true()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// Messages that another thread puts in. All calls are thread-safe.
class Inbox {
 public:
  void put(std::string_view message) {
    const std::lock_guard lock(mutex_);
    messages_.emplace_back(message);
    changed_.notify_all();
  }

  std::vector<std::string> messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
  }

  /// @return whether so many have come
  bool wait_for(std::size_t count, std::chrono::milliseconds longest = kWaitMax) const {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, longest, [&] { return messages_.size() >= count; });
  }

 private:
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::vector<std::string> messages_;
};

/// Says it again and again until something has come: for messages that may be lost.
inline bool repeat_until_heard(const Inbox& inbox, const std::function<void()>& say) {
  const auto end = std::chrono::steady_clock::now() + kWaitMax;
  while (std::chrono::steady_clock::now() < end) {
    say();
    if (inbox.wait_for(1, std::chrono::milliseconds(50))) return true;
  }
  return false;
}

}  // namespace aisle
