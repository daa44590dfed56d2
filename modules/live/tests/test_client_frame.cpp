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

TEST(ClientFrame, APlaybackRequestMaySeek) {
  // 1.5 times as fast, to 258 ns
  const std::string bytes = "\x03\x01\0\0\xc0\x3f\x01\x02\x01\0\0\0\0\0\0\x02\0\0\0id"s;
  const auto frame = parse_client_bytes(bytes);
  ASSERT_TRUE(frame);
  const auto& request = std::get<PlaybackRequest>(*frame);
  EXPECT_FALSE(request.plays);
  EXPECT_EQ(request.rate, 1.5F);
  EXPECT_EQ(request.seek_to_ns, 258U);
  EXPECT_EQ(request.id, "id");
  const auto plays = parse_client_bytes("\x03\0\0\0\x80\x3f\0\x02\x01\0\0\0\0\0\0\x01\0\0\0x"s);
  ASSERT_TRUE(plays);
  EXPECT_TRUE(std::get<PlaybackRequest>(*plays).plays);
  EXPECT_FALSE(std::get<PlaybackRequest>(*plays).seek_to_ns) << "the flag before it says that it does not";
}

TEST(ClientFrame, BytesThatAreNoMessageAreNone) {
  EXPECT_FALSE(parse_client_bytes(""));
  EXPECT_FALSE(parse_client_bytes("\x01\0\0"s));
  EXPECT_FALSE(parse_client_bytes("\x09\0\0\0\0"s));
  EXPECT_FALSE(parse_client_bytes("\x02\0\0\0\0\0\0\0\0\xff\xff\xff\xff json"s)) << "a length beyond the end";
  EXPECT_FALSE(parse_client_bytes("\x03\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\x02\0\0\0x"s)) << "likewise";
  EXPECT_FALSE(parse_client_bytes("\x03\x02\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\x01\0\0\0x"s)) << "no command";
  EXPECT_FALSE(parse_client_bytes("\x03\0\0\0\x80\x7f\0\0\0\0\0\0\0\0\0\x01\0\0\0x"s)) << "infinitely fast";
}

}  // namespace
}  // namespace aisle
