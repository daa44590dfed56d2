#include <gmock/gmock.h>

#include "hand_made_messages.hpp"
#include "opened_wire.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

class WireQualities : public testing::Test {
 protected:
  std::unique_ptr<WireSubscription> subscription(WireQuality quality) {
    return opened(wire->subscribe(test_topic("text"), kStringType, quality, into(inbox)));
  }
  CycloneWriter writer(const CycloneQuality& quality) {
    return peer.writer("rt" + test_topic("text"), kStringDdsType, quality);
  }
  static bool becomes(const WireSubscription& subscription, const std::string& incompatible) {
    return eventually([&] { return subscription.incompatible_quality() == incompatible; });
  }

  CyclonePeer peer;
  std::unique_ptr<Wire> wire = opened_wire();
  Inbox inbox;
};

TEST_F(WireQualities, ALateSubscriptionGetsWhatWasLatched) {
  auto latched = writer({.latched = true});
  latched.write(string_message("mount 1"));
  latched.write(string_message("mount 2"));
  const auto late = subscription(WireQuality::kLatched);
  ASSERT_TRUE(inbox.wait_for(2));
  EXPECT_THAT(inbox.messages(),
              ElementsAre(as_received(string_message("mount 1")), as_received(string_message("mount 2"))));
}

TEST_F(WireQualities, ALateSubscriberGetsWhatIsLatchedHere) {
  const auto publisher = opened(wire->advertise(test_topic("text"), kStringType, WireQuality::kLatched));
  publisher->publish(string_message("map"));
  const auto late = peer.reader("rt" + test_topic("text"), kStringDdsType, {.latched = true});
  ASSERT_TRUE(late.inbox().wait_for(1));
  EXPECT_THAT(late.inbox().messages(), ElementsAre(as_received(string_message("map"))));
}

TEST_F(WireQualities, WhatIsNotLatchedIsNotOfferedAsLatched) {
  const auto publisher = opened(wire->advertise(test_topic("text"), kStringType, WireQuality::kDefault));
  const auto reader = peer.reader("rt" + test_topic("text"), kStringDdsType, {.latched = true});
  EXPECT_TRUE(eventually([&] { return reader.incompatible_policy() == DDS_DURABILITY_QOS_POLICY_ID; }));
}

TEST_F(WireQualities, BestEffortIsNotOfferedAsReliable) {
  const auto publisher = opened(wire->advertise(test_topic("text"), kStringType, WireQuality::kSensor));
  const auto reader = peer.reader("rt" + test_topic("text"), kStringDdsType);
  EXPECT_TRUE(eventually([&] { return reader.incompatible_policy() == DDS_RELIABILITY_QOS_POLICY_ID; }));
}

TEST_F(WireQualities, AReliableSubscriptionNamesWhatAPublisherLacks) {
  const auto reliable = subscription(WireQuality::kDefault);
  EXPECT_EQ(reliable->incompatible_quality(), "");
  const auto best_effort = writer({.reliable = false});
  EXPECT_TRUE(becomes(*reliable, "reliability"));
  EXPECT_EQ(reliable->publishers(), 0U);
}

TEST_F(WireQualities, ALatchedSubscriptionNamesWhatAPublisherLacks) {
  const auto latched = subscription(WireQuality::kLatched);
  const auto is_volatile = writer({});
  EXPECT_TRUE(becomes(*latched, "durability"));
  const auto best_effort = writer({.reliable = false});
  EXPECT_TRUE(becomes(*latched, "durability, reliability"));
}

TEST_F(WireQualities, APublisherThatIsGoneLacksNothing) {
  const auto robot = opened_wire();
  const auto reliable = subscription(WireQuality::kDefault);
  auto best_effort = opened(robot->advertise(test_topic("text"), kStringType, WireQuality::kSensor));
  EXPECT_TRUE(becomes(*reliable, "reliability"));
  best_effort.reset();
  EXPECT_TRUE(becomes(*reliable, ""));
}

TEST_F(WireQualities, ASubscriptionToSensorsFitsEveryPublisher) {
  const auto sensor = subscription(WireQuality::kSensor);
  const auto best_effort = writer({.reliable = false});
  const auto reliable = writer({});
  const auto latched = writer({.latched = true});
  EXPECT_TRUE(eventually([&] { return sensor->publishers() == 3; }));
  EXPECT_EQ(sensor->incompatible_quality(), "");
}

TEST_F(WireQualities, PublishersOfOtherTopicsAndTypesAreNoneThatDoNotFit) {
  const auto other_topic = peer.writer("rt" + test_topic("other"), kStringDdsType, {.reliable = false});
  const auto other_type = peer.writer("rt" + test_topic("text"), kTwistDdsType, {.reliable = false});
  const auto reliable = subscription(WireQuality::kDefault);
  ASSERT_TRUE(eventually([&] { return endpoints_of_test(*wire).size() == 2; }));
  EXPECT_EQ(reliable->incompatible_quality(), "");
}

}  // namespace
}  // namespace aisle
