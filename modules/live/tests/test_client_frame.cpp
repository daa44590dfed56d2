#include "aisle/live/client_frame.hpp"

#include <gtest/gtest.h>

#include <string>

namespace aisle {
namespace {

using namespace std::string_literals;

TEST(ClientFrame, SubscriptionsAreRead) {
  const auto frame = parse_client_text(
      R"({"op":"subscribe","subscriptions":[{"id":7,"channelId":2},{"id":8,"channelId":3}]})");
  ASSERT_TRUE(frame);
  const auto& request = std::get<SubscribeRequest>(*frame);
  ASSERT_EQ(request.subscriptions.size(), 2);
  EXPECT_EQ(request.subscriptions[1].id, 8);
  EXPECT_EQ(request.subscriptions[1].channel, 3);
}

TEST(ClientFrame, ChannelsOfClientsAreRead) {
  const auto frame = parse_client_text(
      R"({"op":"advertise","channels":[{"id":1,"topic":"/drive","encoding":"json","schemaName":""}]})");
  ASSERT_TRUE(frame);
  EXPECT_EQ(std::get<AdvertiseRequest>(*frame).channels.at(0).topic, "/drive");
}

TEST(ClientFrame, WhatIsNotOfferedIsNamed) {
  const auto frame = parse_client_text(R"({"op":"getParameters","parameterNames":[]})");
  ASSERT_TRUE(frame);
  EXPECT_EQ(std::get<UnofferedRequest>(*frame).op, "getParameters");
}

TEST(ClientFrame, TextThatIsNoMessageIsNone) {
  for (const char* text :
       {"", "{", "[]", "3", R"({"op":1})", R"({"no":"op"})", R"({"op":"subscribe"})",
        R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":1}]})",
        R"({"op":"unsubscribe","subscriptionIds":["1"]})",
        R"({"op":"advertise","channels":[{"id":1,"topic":2,"encoding":"json"}]})", "\xff\xfe"})
    EXPECT_FALSE(parse_client_text(text)) << text;
}

TEST(ClientFrame, ServiceCallsAreReadLittleEndian) {
  const std::string bytes = "\x02\x05\0\0\0\x01\x02\0\0\x04\0\0\0json{}"s;
  const auto frame = parse_client_bytes(bytes);
  ASSERT_TRUE(frame);
  const auto& request = std::get<ServiceRequest>(*frame);
  EXPECT_EQ(request.service, 5);
  EXPECT_EQ(request.call, 513);
  EXPECT_EQ(request.encoding, "json");
  EXPECT_EQ(request.data, "{}");
}

TEST(ClientFrame, BytesThatAreNoMessageAreNone) {
  EXPECT_FALSE(parse_client_bytes(""));
  EXPECT_FALSE(parse_client_bytes("\x01\0\0"s));
  EXPECT_FALSE(parse_client_bytes("\x09\0\0\0\0"s));
  EXPECT_FALSE(parse_client_bytes("\x02\0\0\0\0\0\0\0\0\xff\xff\xff\xff json"s)) << "a length beyond the end";
}

}  // namespace
}  // namespace aisle
