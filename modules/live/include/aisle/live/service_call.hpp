#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

namespace aisle {

/// A client's call of a service. It waits until it is answered, once, from any thread.
class ServiceCall {
 public:
  /// @param answer  true: the answer's JSON; false: why the call is refused
  using Answer = std::function<void(bool is_done, std::string text)>;

  ServiceCall(std::string service, nlohmann::json arguments, Answer answer)
      : service_(std::move(service)), arguments_(std::move(arguments)), answer_(std::move(answer)) {}

  const std::string& service() const { return service_; }
  const nlohmann::json& arguments() const { return arguments_; }  ///< an object

  void answer(const nlohmann::ordered_json& json) const;
  void refuse(const std::string& why) const { answer_(false, why); }

 private:
  std::string service_;
  nlohmann::json arguments_;
  Answer answer_;
};

/// Calls on their path from the server's thread to the one that answers them.
class ServiceMailbox {
 public:
  static constexpr std::size_t kCallsMax = 64;

  /// @return false: too many wait, or nobody answers any more
  bool put(ServiceCall call);

  /// The oldest call; nullopt if none waits.
  std::optional<ServiceCall> take();
  /// The same, but waits for one as long as this, or until the mailbox is closed.
  std::optional<ServiceCall> wait(std::chrono::microseconds longest);

  /// No call will be taken any more; those that wait are refused.
  void close();

 private:
  std::optional<ServiceCall> front();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<ServiceCall> calls_;
  bool is_closed_ = false;
};

/// A service as the server offers it.
struct LiveService {
  std::string name;
  bool needs_lease = false;
  ServiceMailbox* mailbox = nullptr;  ///< of whoever answers; must outlive the server
};

}  // namespace aisle
