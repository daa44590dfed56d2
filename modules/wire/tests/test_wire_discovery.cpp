#include <gmock/gmock.h>

#include "hand_made_messages.hpp"
#include "multicast_listener.hpp"
#include "opened_wire.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using Kind = WireEndpoint::Kind;

class WireDiscovery : public testing::Test {
 protected:
  bool becomes_known(std::size_t count) {
    return eventually([&] { return endpoints_of_test(*wire).size() == count; });
  }

  std::unique_ptr<Wire> wire = opened_wire();
  Inbox inbox;
};

TEST_F(WireDiscovery, WhatOthersPublishAndSubscribeIsListedInOrder) {
  CyclonePeer peer;
  const auto scan = peer.writer("rt" + test_topic("scan"), kScanDdsType, {.reliable = false});
  const auto mounts =
      peer.writer("rt" + test_topic("mounts"), "tf2_msgs::msg::dds_::TFMessage_", {.latched = true});
  const auto commands = peer.reader("rt" + test_topic("cmd_vel"), kTwistDdsType);
  const auto more_commands = peer.writer("rt" + test_topic("cmd_vel"), kTwistDdsType);
  ASSERT_TRUE(becomes_known(4));
  const auto found = endpoints_of_test(*wire);
  const std::string& robot = found.front().participant;
  EXPECT_THAT(
      found,
      ElementsAre(
          WireEndpoint{Kind::kPublisher, test_topic("cmd_vel"), kTwistType, true, false, robot},
          WireEndpoint{Kind::kSubscriber, test_topic("cmd_vel"), kTwistType, true, false, robot},
          WireEndpoint{Kind::kPublisher, test_topic("mounts"), "tf2_msgs/msg/TFMessage", true, true, robot},
          WireEndpoint{Kind::kPublisher, test_topic("scan"), kScanType, false, false, robot}));
}

TEST_F(WireDiscovery, ServicesAndWhatIsOurOwnAreNotListed) {
  const auto subscription =
      opened(wire->subscribe(test_topic("own"), kScanType, WireQuality::kSensor, into(inbox)));
  const auto publisher = opened(wire->advertise(test_topic("own"), kScanType, WireQuality::kSensor));
  CyclonePeer peer;
  const auto service = peer.reader("rq" + test_topic("addRequest"), "a::srv::dds_::Add_Request_");
  const auto not_ros = peer.writer(test_topic("square"), "ShapeType");
  const auto scan = peer.writer("rt" + test_topic("scan"), kScanDdsType);
  ASSERT_TRUE(becomes_known(1));
  EXPECT_EQ(endpoints_of_test(*wire).front().topic, test_topic("scan"));
}

TEST_F(WireDiscovery, TypesThatAreNotOfRosAreListedAsTheyAre) {
  CyclonePeer peer;
  const auto odd = peer.writer("rt" + test_topic("odd"), "ShapeType");
  const auto subscription =
      opened(wire->subscribe(test_topic("odd"), kScanType, WireQuality::kDefault, into(inbox)));
  ASSERT_TRUE(becomes_known(1));
  EXPECT_EQ(endpoints_of_test(*wire).front().type, "ShapeType");
  EXPECT_EQ(subscription->incompatible_quality(), "");
}

TEST_F(WireDiscovery, WhatIsNoLongerPublishedIsNoLongerListed) {
  const auto robot = opened_wire();
  const auto stays = opened(robot->advertise(test_topic("scan"), kScanType, WireQuality::kSensor));
  auto ends = opened(robot->advertise(test_topic("text"), kStringType, WireQuality::kDefault));
  ASSERT_TRUE(becomes_known(2));
  ends.reset();
  ASSERT_TRUE(becomes_known(1));
  EXPECT_EQ(endpoints_of_test(*wire).front().topic, test_topic("scan"));
}

TEST_F(WireDiscovery, AProgramThatLeftIsForgottenAndFoundAgain) {
  const auto subscription =
      opened(wire->subscribe(test_topic("text"), kStringType, WireQuality::kDefault, into(inbox)));
  for (int start = 0; start < 2; ++start) {
    CyclonePeer peer(test_domain(), 1);
    auto writer = peer.writer("rt" + test_topic("text"), kStringDdsType);
    ASSERT_TRUE(eventually([&] { return subscription->publishers() == 1; }));
    // Of those that are gone, none is left.
    ASSERT_TRUE(becomes_known(1));
  }
  EXPECT_TRUE(becomes_known(0));
  EXPECT_TRUE(eventually([&] { return subscription->publishers() == 0; }));
}

TEST_F(WireDiscovery, AProgramThatFellSilentIsForgotten) {
  CyclonePeer peer(test_domain(), 1);
  const auto writer = peer.writer("rt" + test_topic("text"), kStringDdsType);
  const auto subscription =
      opened(wire->subscribe(test_topic("text"), kStringType, WireQuality::kDefault, into(inbox)));
  ASSERT_TRUE(eventually([&] { return subscription->publishers() == 1; }));
  peer.fall_silent();
  EXPECT_TRUE(becomes_known(0));
  EXPECT_TRUE(eventually([&] { return subscription->publishers() == 0; }));
}

TEST_F(WireDiscovery, TwoWiresOfOneProgramAreTwoPrograms) {
  const auto robot = opened_wire();
  Inbox of_robot;
  const auto commands =
      opened(robot->subscribe(test_topic("cmd_vel"), kTwistType, WireQuality::kCommand, into(of_robot)));
  const auto texts = opened(robot->advertise(test_topic("text"), kStringType, WireQuality::kDefault));
  const auto publisher = opened(wire->advertise(test_topic("cmd_vel"), kTwistType, WireQuality::kCommand));
  const auto subscription =
      opened(wire->subscribe(test_topic("text"), kStringType, WireQuality::kDefault, into(inbox)));
  ASSERT_TRUE(becomes_known(2));
  ASSERT_TRUE(eventually([&] { return endpoints_of_test(*robot).size() == 2; }));
  EXPECT_NE(endpoints_of_test(*robot).front().participant, endpoints_of_test(*wire).front().participant);

  EXPECT_TRUE(repeat_until_heard(of_robot, [&] { publisher->publish(twist_message(0.1, 0)); }));
  EXPECT_TRUE(repeat_until_heard(inbox, [&] { texts->publish(string_message("bumped")); }));
}

TEST_F(WireDiscovery, ItAnnouncesItselfByMulticastIfAsked) {
  const MulticastListener listener(test_domain());
  if (!listener.hears_itself()) GTEST_SKIP() << "no multicast on the loopback of this machine";
  const auto announcing = Wire::open({.domain = test_domain(), .announces_by_multicast = true});
  ASSERT_TRUE(announcing);
  EXPECT_TRUE(eventually([&] { return listener.heard().starts_with("RTPS"); }));
}

}  // namespace
}  // namespace aisle
