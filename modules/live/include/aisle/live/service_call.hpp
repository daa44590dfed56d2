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

/// A client's call of a service. It must be answered exactly once, from any thread.
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

/// Passes calls from the server's thread to the thread that answers them.
class ServiceMailbox {
 public:
  static constexpr std::size_t kCallsMax = 64;

  /// @return false if too many calls wait or the mailbox is closed
  bool put(ServiceCall call);

  /// The oldest call; nullopt if none waits.
  std::optional<ServiceCall> take();
  /// The same, but waits up to `longest` for a call, or until the mailbox is closed.
  std::optional<ServiceCall> wait(std::chrono::microseconds longest);

  /// No more calls are accepted; waiting ones are refused.
  void close();

 private:
  std::optional<ServiceCall> front();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<ServiceCall> calls_;
  bool is_closed_ = false;
};

/// A service that the server offers.
struct LiveService {
  std::string name;
  bool needs_lease = false;
  ServiceMailbox* mailbox = nullptr;  ///< of the thread that answers; must outlive the server
};

}  // namespace aisle
