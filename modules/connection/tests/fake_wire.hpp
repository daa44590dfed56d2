#pragma once
/// A wire without a network: the test is the robot at its other end.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "aisle/core/clock.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// A clock that tests move.
class MovedClock final : public Clock {
 public:
  double now_s() const override { return now_s_; }
  void move(double by_s) { now_s_ = now_s_ + by_s; }

 private:
  std::atomic<double> now_s_ = 1000;
};

/// What was sent on one topic; threads may send.
class SentMessages {
 public:
  void add(std::string_view message) {
    {
      const std::lock_guard lock(mutex_);
      messages_.emplace_back(message);
    }
    arrived_.notify_all();
  }

  /// Waits until the newest message satisfies `is_wanted`. Tests hang, and are killed, if none ever does.
  template <class Predicate>
  void wait_for_newest(const Predicate& is_wanted) {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, [&] { return !messages_.empty() && is_wanted(messages_.back()); });
  }
  void wait_for_more_than(std::size_t count) {
    std::unique_lock lock(mutex_);
    arrived_.wait(lock, [&] { return messages_.size() > count; });
  }
  /// For at most a few of the periods in which commands are sent.
  void await_more_than(std::size_t count) {
    std::unique_lock lock(mutex_);
    arrived_.wait_for(lock, std::chrono::milliseconds(200), [&] { return messages_.size() > count; });
  }
  std::vector<std::string> all() const {
    const std::lock_guard lock(mutex_);
    return messages_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<std::string> messages_;
};

class FakePublisher final : public WirePublisher {
 public:
  explicit FakePublisher(std::shared_ptr<SentMessages> sent) : sent_(std::move(sent)) {}
  void publish(std::string_view message) override { sent_->add(message); }
  std::size_t subscribers() const override { return 1; }

 private:
  std::shared_ptr<SentMessages> sent_;
};

class FakeWire final : public Wire {
 public:
  Result<std::unique_ptr<WireSubscription>> subscribe(const std::string& topic, const std::string& /*type*/,
                                                      WireQuality /*quality*/, Sink sink) override {
    sinks_[topic] = std::move(sink);
    return std::unique_ptr<WireSubscription>(std::make_unique<Subscription>(*this, topic));
  }
  Result<std::unique_ptr<WirePublisher>> advertise(const std::string& topic, const std::string& /*type*/,
                                                   WireQuality /*quality*/) override {
    advertised.insert(topic);
    return std::unique_ptr<WirePublisher>(std::make_unique<FakePublisher>(sent(topic)));
  }
  std::vector<WireEndpoint> endpoints() const override { return endpoints_of_others; }

  /// Gives a message to whoever has subscribed the topic.
  void tell(const std::string& topic, std::string_view message) {
    if (const auto sink = sinks_.find(topic); sink != sinks_.end()) sink->second(message);
  }
  std::shared_ptr<SentMessages> sent(const std::string& topic) {
    auto& messages = sent_[topic];
    if (!messages) messages = std::make_shared<SentMessages>();
    return messages;
  }

  std::vector<WireEndpoint> endpoints_of_others;
  std::set<std::string> advertised;
  std::map<std::string, std::string> incompatible;  ///< topic -> quality

 private:
  class Subscription final : public WireSubscription {
   public:
    Subscription(FakeWire& wire, std::string topic) : wire_(wire), topic_(std::move(topic)) {}
    ~Subscription() override { wire_.sinks_.erase(topic_); }
    Subscription(const Subscription&) = delete;
    Subscription& operator=(const Subscription&) = delete;
    std::size_t publishers() const override { return 1; }
    std::string incompatible_quality() const override {
      const auto found = wire_.incompatible.find(topic_);
      return found == wire_.incompatible.end() ? std::string() : found->second;
    }

   private:
    FakeWire& wire_;
    std::string topic_;
  };

  std::map<std::string, Sink> sinks_;
  std::map<std::string, std::shared_ptr<SentMessages>> sent_;
};

}  // namespace aisle
