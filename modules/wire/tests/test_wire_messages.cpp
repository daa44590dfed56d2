#include <gmock/gmock.h>

#include "aisle/formats/sessions/cdr.hpp"
#include "hand_made_messages.hpp"
#include "opened_wire.hpp"

namespace aisle {
namespace {

using testing::ElementsAreArray;

class WireMessages : public testing::Test {
 protected:
  /// As many as either end keeps, so that none is lost.
  static std::vector<std::string> ten_strings() {
    std::vector<std::string> messages;
    for (int i = 0; i < 10; ++i)
      messages.push_back(string_message(std::string(static_cast<std::size_t>(i), 'x')));
    return messages;
  }

  static void expect_all(const Inbox& inbox) {
    std::vector<std::string> expected;
    for (const std::string& message : ten_strings()) expected.push_back(as_received(message));
    ASSERT_TRUE(inbox.wait_for(10));
    EXPECT_THAT(inbox.messages(), ElementsAreArray(expected));
  }

  static constexpr CycloneQuality kBestEffort{.reliable = false};
  CyclonePeer peer;
  std::unique_ptr<Wire> wire = opened_wire();
  Inbox inbox;
};

TEST_F(WireMessages, ASubscriptionGetsAllInOrder) {
  auto writer = peer.writer("rt" + test_topic("text"), kStringDdsType);
  const auto subscription =
      opened(wire->subscribe(test_topic("text"), kStringType, WireQuality::kDefault, into(inbox)));
  ASSERT_TRUE(eventually([&] { return subscription->publishers() == 1 && writer.readers() == 1; }));
  for (const std::string& message : ten_strings()) writer.write(message);
  expect_all(inbox);
}

TEST_F(WireMessages, APublisherReachesASubscriberWithAllInOrder) {
  const auto reader = peer.reader("rt" + test_topic("text"), kStringDdsType);
  const auto publisher = opened(wire->advertise(test_topic("text"), kStringType, WireQuality::kDefault));
  ASSERT_TRUE(eventually([&] { return publisher->subscribers() == 1 && reader.writers() == 1; }));
  for (const std::string& message : ten_strings()) publisher->publish(message);
  expect_all(reader.inbox());
}

TEST_F(WireMessages, AReliableSubscriberGetsTheLastCommand) {
  const auto reader = peer.reader("rt" + test_topic("cmd_vel"), kTwistDdsType);
  const auto publisher = opened(wire->advertise(test_topic("cmd_vel"), kTwistType, WireQuality::kCommand));
  ASSERT_TRUE(eventually([&] { return publisher->subscribers() == 1 && reader.writers() == 1; }));
  for (const double speed_mps : {0.1, 0.2, 0.3, 0.0}) publisher->publish(twist_message(speed_mps, -0.5));
  EXPECT_TRUE(eventually([&] {
    const auto messages = reader.inbox().messages();
    return !messages.empty() && messages.back() == twist_message(0.0, -0.5);
  }));
}

TEST_F(WireMessages, ScansOfABestEffortPublisherArrive) {
  auto writer = peer.writer("rt" + test_topic("scan"), kScanDdsType, kBestEffort);
  const auto subscription =
      opened(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kSensor, into(inbox)));
  ASSERT_TRUE(repeat_until_heard(inbox, [&] { writer.write(scan_message(720)); }));
  EXPECT_EQ(inbox.messages().front(), as_received(scan_message(720)));
}

TEST_F(WireMessages, ImagesOfManyFragmentsArrive) {
  auto writer = peer.writer("rt" + test_topic("image"), kImageDdsType, kBestEffort);
  const auto subscription =
      opened(wire->subscribe(test_topic("image"), kImageType, WireQuality::kSensor, into(inbox)));
  const std::string image = image_message(640, 480);
  ASSERT_TRUE(repeat_until_heard(inbox, [&] { writer.write(image); }));
  EXPECT_TRUE(inbox.messages().front() == as_received(image));
}

TEST_F(WireMessages, ImagesOfManyFragmentsArePublished) {
  const auto reader = peer.reader("rt" + test_topic("image"), kImageDdsType, kBestEffort);
  const auto publisher = opened(wire->advertise(test_topic("image"), kImageType, WireQuality::kSensor));
  const std::string image = image_message(640, 480);
  ASSERT_TRUE(repeat_until_heard(reader.inbox(), [&] { publisher->publish(image); }));
  EXPECT_TRUE(reader.inbox().messages().front() == as_received(image));
}

TEST_F(WireMessages, TheCdrOfSessionsReadsAndWritesWhatIsOnTheWire) {
  auto writer = peer.writer("rt" + test_topic("scan"), kScanDdsType, kBestEffort);
  const auto subscription =
      opened(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kSensor, into(inbox)));
  ASSERT_TRUE(repeat_until_heard(inbox, [&] { writer.write(scan_message(360)); }));
  const auto scan = parse_cdr<ros::LaserScan>(inbox.messages().front());
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->header.stamp, (ros::Time{7, 500'000'000}));
  EXPECT_EQ(scan->header.frame_id, "laser");
  ASSERT_EQ(scan->ranges.size(), 360U);
  EXPECT_FLOAT_EQ(scan->ranges[359], 1.359F);

  ros::Twist twist;
  twist.linear.x = 0.25;
  twist.angular.z = -0.5;
  EXPECT_EQ(cdr_bytes(twist), twist_message(0.25, -0.5));
}

TEST_F(WireMessages, AWireHearsItself) {
  const auto publisher = opened(wire->advertise(test_topic("text"), kStringType, WireQuality::kDefault));
  const auto subscription =
      opened(wire->subscribe(test_topic("text"), kStringType, WireQuality::kDefault, into(inbox)));
  ASSERT_TRUE(eventually([&] { return subscription->publishers() == 1 && publisher->subscribers() == 1; }));
  publisher->publish(string_message("hello"));
  ASSERT_TRUE(inbox.wait_for(1));
  EXPECT_EQ(inbox.messages().front(), as_received(string_message("hello")));
}

TEST_F(WireMessages, ATopicIsNotUsedWithTwoTypes) {
  auto scans = opened(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kSensor, into(inbox)));
  const auto other = wire->advertise(test_topic("scan"), kTwistType, WireQuality::kCommand);
  ASSERT_FALSE(other);
  EXPECT_EQ(
      to_string(other.problems()),
      test_topic("scan") + ": is in use as sensor_msgs/msg/LaserScan, so not as geometry_msgs/msg/Twist");
  EXPECT_TRUE(wire->subscribe(test_topic("scan"), kScanType, WireQuality::kDefault, into(inbox)));
  // Once nobody uses it any more, the topic has no type.
  scans.reset();
  EXPECT_TRUE(wire->advertise(test_topic("scan"), kTwistType, WireQuality::kCommand));
}

TEST_F(WireMessages, WhatIsNoNameIsRefused) {
  EXPECT_FALSE(wire->subscribe("scan", kScanType, WireQuality::kSensor, into(inbox)));
  EXPECT_FALSE(wire->subscribe("/scan", "LaserScan", WireQuality::kSensor, into(inbox)));
  EXPECT_FALSE(wire->advertise("/cmd vel", kTwistType, WireQuality::kCommand));
}

}  // namespace
}  // namespace aisle
