#include <gmock/gmock.h>

#include <random>

#include "aisle/fleet/order_json.hpp"

namespace aisle {
namespace {

constexpr const char* kOrder = R"({"headerId": 1, "timestamp": "2026-01-31T12:00:00Z", "version": "2.1.0",
 "manufacturer": "m", "serialNumber": "s", "orderId": "o", "orderUpdateId": 3,
 "nodes": [
  {"nodeId": "a", "sequenceId": 4, "released": true, "actions": [],
   "nodePosition": {"x": 1.5, "y": -2, "theta": 0.5, "mapId": "hall", "allowedDeviationXY": 0.3}},
  {"nodeId": "b", "sequenceId": 6, "released": false, "actions": [
    {"actionType": "wait", "actionId": "w", "blockingType": "HARD",
     "actionParameters": [{"key": "duration", "value": 2}]}]}],
 "edges": [{"edgeId": "ab", "sequenceId": 5, "released": false, "startNodeId": "a", "endNodeId": "b",
  "maxSpeed": 0.3, "actions": []}]})";

std::string with(const std::string& from, const std::string& to) {
  std::string text = kOrder;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string why_refused(const std::string& text) {
  const auto order = read_order(text);
  return order ? "it was read" : to_string(order.problems());
}

TEST(OrderJson, AnOrderIsRead) {
  const auto order = read_order(kOrder);
  ASSERT_TRUE(order) << to_string(order.problems());
  EXPECT_EQ(order->update_id, 3U);
  EXPECT_EQ(*order->nodes[0].p_map, Vec2(1.5, -2));
  EXPECT_EQ(order->nodes[0].deviation_m, 0.3);
  EXPECT_FALSE(order->nodes[1].p_map);
  EXPECT_EQ(order->nodes[1].actions[0].parameters.at("duration"), 2);
  EXPECT_EQ(order->edges[0].speed_max_mps, 0.3);
}

TEST(OrderJson, WhatIsWrongIsSaidWithItsKey) {
  using testing::HasSubstr;
  EXPECT_THAT(why_refused(with("2.1.0", "3.0.0")), HasSubstr("version: is not 2.x"));
  EXPECT_THAT(why_refused(with(R"("orderId": "o", )", "")), HasSubstr("orderId: is missing"));
  EXPECT_THAT(why_refused(with(R"("sequenceId": 6)", R"("sequenceId": 8)")),
              HasSubstr("nodes[1].sequenceId: is not 6"));
  EXPECT_THAT(why_refused(with(R"("sequenceId": 4)", R"("sequenceId": -4)")),
              HasSubstr("nodes[0].sequenceId"));
  EXPECT_THAT(why_refused(with(R"("endNodeId": "b")", R"("endNodeId": "c")")),
              HasSubstr("edges[0].endNodeId: is not 'b'"));
  EXPECT_THAT(why_refused(with(R"("x": 1.5)", R"("x": "1.5")")), HasSubstr("nodes[0].nodePosition.x"));
  EXPECT_THAT(why_refused(with(R"("x": 1.5)", R"("x": 1e300)")), HasSubstr("nodes[0].nodePosition.x"));
  EXPECT_THAT(why_refused(with(R"("released": true)", R"("released": false)")),
              HasSubstr("there is no base"));
  EXPECT_THAT(why_refused(with("HARD", "HARDER")), HasSubstr("blockingType: is neither"));
  EXPECT_THAT(why_refused(with(R"("maxSpeed": 0.3)", R"("maxSpeed": 0)")), HasSubstr("maxSpeed"));
}

TEST(OrderJson, DepthAndSizeAreLimited) {
  EXPECT_THAT(why_refused(std::string(kFleetMessage_bytes + 1, ' ')),
              testing::HasSubstr("larger than 1 MiB"));
  EXPECT_FALSE(read_order(std::string(100000, '[')).ok());
  std::string nodes;
  for (int i = 0; i < 3000; ++i) nodes += "{},";
  EXPECT_THAT(why_refused(with(R"("nodes": [)", R"("nodes": [)" + nodes)),
              testing::HasSubstr("more than 2000"));
}

TEST(OrderJson, HostileBytesAreRefusedAndNothingWorse) {
  const std::string text = kOrder;
  for (std::size_t length = 0; length < text.size(); ++length)
    EXPECT_FALSE(read_order(text.substr(0, length)).ok());
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    std::string hostile = text;
    for (int k = 0; k < 3; ++k) {
      constexpr std::string_view kBytes = "{}[]\",:0-9e.truefalsn\\\xff\x00";
      hostile[random() % hostile.size()] = kBytes[random() % kBytes.size()];
    }
    const auto order = read_order(hostile);
    EXPECT_TRUE(!order || order->nodes.size() == order->edges.size() + 1) << hostile;
    static_cast<void>(read_instant_actions(hostile));
  }
}

TEST(OrderJson, InstantActionsAreReadUnderBothNames) {
  const std::string list = R"([{"actionType": "startPause", "actionId": "1", "blockingType": "NONE"}]})";
  EXPECT_TRUE(read_instant_actions(R"({"version": "2.1.0", "actions": )" + list).ok());
  EXPECT_TRUE(read_instant_actions(R"({"version": "2.0.0", "instantActions": )" + list).ok());
  EXPECT_FALSE(read_instant_actions(R"({"version": "2.1.0"})").ok());
  EXPECT_FALSE(read_instant_actions(R"([])").ok());
}

}  // namespace
}  // namespace aisle
