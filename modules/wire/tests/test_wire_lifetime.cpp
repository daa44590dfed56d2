#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "hand_made_messages.hpp"
#include "opened_wire.hpp"

namespace aisle {
namespace {

/// A robot that publishes on one topic without a pause.
class TalkingRobot {
 public:
  TalkingRobot() : writer_(peer_.writer("rt" + test_topic("scan"), kScanDdsType)) {}
  ~TalkingRobot() {
    over_ = true;
    thread_.join();
  }

 private:
  CyclonePeer peer_;
  CycloneWriter writer_;
  std::atomic<bool> over_{false};
  std::thread thread_{[this] {
    const std::string message = scan_message(720);
    while (!over_) {
      writer_.write(message);
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
  }};
};

TEST(WireLifetime, ASubscriptionThatEndedCallsNobody) {
  const auto wire = opened_wire();
  const TalkingRobot robot;
  for (int round = 0; round < 20; ++round) {
    // Gone before the next round: a late call is one into freed memory, which sanitizers see.
    const auto inbox = std::make_unique<Inbox>();
    auto subscription =
        opened(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kDefault, into(*inbox)));
    ASSERT_TRUE(inbox->wait_for(3));
    subscription.reset();
    const std::size_t received = inbox->messages().size();
    std::this_thread::yield();
    EXPECT_EQ(inbox->messages().size(), received);
  }
}

TEST(WireLifetime, AWireIsClosedWhileMessagesFlow) {
  const TalkingRobot robot;
  for (int round = 0; round < 5; ++round) {
    Inbox inbox;
    auto wire = opened_wire();
    auto subscription =
        opened(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kDefault, into(inbox)));
    const auto publisher = opened(wire->advertise(test_topic("cmd_vel"), kTwistType, WireQuality::kCommand));
    ASSERT_TRUE(inbox.wait_for(3));
    publisher->publish(twist_message(0, 0));
  }
}

TEST(WireLifetime, WhatAWireMadeGoesOnWithoutIt) {
  const TalkingRobot robot;
  Inbox inbox;
  auto wire = opened_wire();
  const auto subscription =
      opened(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kSensor, into(inbox)));
  wire.reset();
  EXPECT_TRUE(inbox.wait_for(3));
}

TEST(WireLifetime, SubscriptionsComeAndGoInSeveralThreads) {
  const auto wire = opened_wire();
  const TalkingRobot robot;
  std::atomic<int> heard{0};
  const auto come_and_go = [&] {
    for (int round = 0; round < 10; ++round) {
      Inbox inbox;
      const auto subscription =
          opened(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kSensor, into(inbox)));
      const auto publisher =
          opened(wire->advertise(test_topic("cmd_vel"), kTwistType, WireQuality::kCommand));
      publisher->publish(twist_message(0, 0));
      wire->endpoints();
      subscription->incompatible_quality();
      heard += inbox.wait_for(1) ? 1 : 0;
    }
  };
  std::thread other(come_and_go);
  come_and_go();
  other.join();
  EXPECT_EQ(heard, 20);
}

}  // namespace
}  // namespace aisle
