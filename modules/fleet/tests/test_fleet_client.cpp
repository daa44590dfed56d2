#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "aisle/fleet/fleet_client.hpp"
#include "orders.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class RecordingLink final : public FleetLink {
 public:
  bool is_connected() const override { return connected; }
  std::size_t connections() const override { return count; }
  std::vector<FleetMessage> take_received() override { return std::exchange(received, {}); }
  void send(const FleetMessage& message, bool) override { sent.push_back(message); }

  std::vector<std::string> take_topics() {
    std::vector<std::string> topics;
    for (const FleetMessage& message : std::exchange(sent, {})) topics.push_back(message.topic);
    return topics;
  }

  bool connected = true;
  std::size_t count = 1;
  std::vector<FleetMessage> received, sent;
};

class Client : public testing::Test {
 protected:
  RecordingLink link;
  FleetClient client{
      {"maker", "7"}, straight_tracker(), {}, link, [] { return std::string("2026-01-31T12:00:00Z"); }};
  VehicleState vehicle{.T_map_vehicle = Pose2{}, .map_id = "hall"};
};

TEST_F(Client, GreetsOnEachConnectionAndSendsWhatChanges) {
  client.exchange(0.1, vehicle);
  EXPECT_THAT(link.take_topics(), ElementsAre("connection", "factsheet", "state"));
  client.exchange(0.2, vehicle);
  EXPECT_THAT(link.take_topics(), IsEmpty());
  vehicle.is_driving = true;
  client.exchange(0.3, vehicle);
  EXPECT_THAT(link.take_topics(), ElementsAre("state"));
  client.exchange(0.6, vehicle);
  EXPECT_THAT(link.take_topics(), ElementsAre("visualization"));
  client.exchange(30.4, vehicle);
  EXPECT_THAT(link.take_topics(), ElementsAre("state", "visualization"));
  link.connected = false;
  vehicle.is_driving = false;
  client.exchange(31, vehicle);
  EXPECT_THAT(link.take_topics(), IsEmpty());
  link.connected = true;
  ++link.count;
  client.exchange(31.1, vehicle);
  EXPECT_THAT(link.take_topics(), ElementsAre("connection", "factsheet", "state", "visualization"));
  client.leave();
  EXPECT_THAT(link.sent.back().json, testing::HasSubstr("OFFLINE"));
}

TEST_F(Client, WhatCannotBeReadIsAnErrorOfTheState) {
  link.received = {{"order", "{\"version\": \"2.1.0\"}\xff"},
                   {"order", R"({"version": "2.1.0"})"},
                   {"instantActions", "7"}};
  client.exchange(0.1, vehicle);
  const auto state = nlohmann::json::parse(link.sent.back().json);
  EXPECT_EQ(state["errors"].size(), 3U);
  EXPECT_EQ(state["errors"][1]["errorType"], "validationError");
  EXPECT_EQ(state["errors"][1]["errorLevel"], "WARNING");
  EXPECT_EQ(state["errors"][1]["errorReferences"][1]["referenceValue"], "orderId");
}

TEST_F(Client, TheStateNamesWhatIsLeftOfTheOrder) {
  client.tracker().take(order_along(0, 1, 2), vehicle.T_map_vehicle);
  client.exchange(0.1, vehicle);
  const auto state = nlohmann::json::parse(link.sent.back().json);
  for (const char* key :
       {"headerId", "timestamp", "version", "manufacturer", "serialNumber", "orderId", "orderUpdateId",
        "lastNodeId", "lastNodeSequenceId", "nodeStates", "edgeStates", "driving", "actionStates",
        "batteryState", "operatingMode", "errors", "safetyState"})
    EXPECT_TRUE(state.contains(key)) << key << " is required";
  EXPECT_EQ(state["lastNodeId"], "n0");
  EXPECT_EQ(state["nodeStates"].size(), 2U);
  EXPECT_EQ(state["nodeStates"][1]["released"], false);
  EXPECT_EQ(state["edgeStates"][0]["edgeId"], "n0n1");
}

TEST(FleetIdentity, TopicsAreThoseOfTheStandard) {
  EXPECT_EQ((FleetIdentity{"maker", "7"}.topic("order")), "uagv/v2/maker/7/order");
  EXPECT_THAT((FleetIdentity{"a/b", ""}.problems()), testing::SizeIs(2));
}

}  // namespace
}  // namespace aisle
