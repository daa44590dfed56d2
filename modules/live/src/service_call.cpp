#include "aisle/live/service_call.hpp"

namespace aisle {

void ServiceCall::answer(const nlohmann::ordered_json& json) const {
  answer_(true, json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

bool ServiceMailbox::put(ServiceCall call) {
  {
    const std::lock_guard lock(mutex_);
    if (is_closed_ || calls_.size() >= kCallsMax) return false;
    calls_.push_back(std::move(call));
  }
  changed_.notify_one();
  return true;
}

std::optional<ServiceCall> ServiceMailbox::take() {
  const std::lock_guard lock(mutex_);
  return front();
}

std::optional<ServiceCall> ServiceMailbox::wait(std::chrono::microseconds longest) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, longest, [this] { return is_closed_ || !calls_.empty(); });
  return front();
}

void ServiceMailbox::close() {
  std::deque<ServiceCall> left;
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    left.swap(calls_);
  }
  changed_.notify_all();
  for (const ServiceCall& call : left) call.refuse("the program ends");
}

std::optional<ServiceCall> ServiceMailbox::front() {
  if (calls_.empty()) return std::nullopt;
  ServiceCall call = std::move(calls_.front());
  calls_.pop_front();
  return call;
}

}  // namespace aisle
