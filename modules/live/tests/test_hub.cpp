#include "hub.hpp"

#include <gmock/gmock.h>

#include "little_endian.hpp"
#include "set_clock.hpp"

namespace aisle {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const SessionTopic kScan{"/bumper", "std_msgs/msg/Bool"};
const SessionTopic kLatched{"/session", "std_msgs/msg/String", true};

std::shared_ptr<const std::string> body(const std::string& text) {
  return std::make_shared<const std::string>(text);
}

/// What a client received.
struct Sent {
  std::vector<Json> texts;
  std::vector<OutFrame> messages;

  void take(OutFrame frame) {
    if (frame.is_text) {
      texts.push_back(Json::parse(frame.head));
    } else {
      messages.push_back(std::move(frame));
    }
  }
  Json take_last() {
    Json last = texts.empty() ? Json() : texts.back();
    texts.clear();
    return last;
  }
};

class HubTest : public testing::Test {
 protected:
  HubTest() {
    join(1, client);
    greeting = client.texts.back();
    client.texts.clear();
  }

  void join(ClientId id, Sent& sent) {
    hub.join(id, [&sent](OutFrame frame) { sent.take(std::move(frame)); });
  }

  void subscribe(std::uint32_t id, std::uint32_t channel) {
    hub.receive_text(
        1, Json({{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", channel}}}}}).dump());
  }

  /// The answer, or the reason for a refusal.
  Json call(ClientId id, Sent& sent, const std::string& service, const Json& arguments) {
    const auto& services = greeting.at("services");
    std::uint32_t number = 0;
    for (const Json& offered : services) {
      if (offered["name"] == service) number = offered["id"];
    }
    std::string bytes = "\x02";
    append_little_endian(bytes, number);
    append_little_endian(bytes, std::uint32_t{9});
    append_little_endian(bytes, std::uint32_t{4});
    sent.messages.clear();
    sent.texts.clear();
    EXPECT_TRUE(hub.receive_bytes(id, bytes + "json" + arguments.dump()));
    if (!sent.texts.empty()) return sent.texts.back();
    return sent.messages.empty() ? Json() : Json::parse(sent.messages.back().head.substr(17));
  }

  std::string lease_of(ClientId id, Sent& sent) {
    return call(id, sent, "lease/take", Json::object())["lease"];
  }

  void drive(const std::string& lease, std::uint64_t sequence) {
    std::string bytes = "\x01";
    append_little_endian(bytes, std::uint32_t{3});
    hub.receive_bytes(1, bytes + Json({{"lease", lease}, {"sequence", sequence}, {"speed_mps", 0.3}}).dump());
  }

  SetClock clock;
  DriveInbox inbox{clock};
  ServiceMailbox mailbox;
  Hub hub{"aisle", "1",   {{"open", false, &mailbox}, {"closed", true, &mailbox}},
          clock,   inbox, [](const std::function<void()>& work) { work(); }};
  Sent client;
  Json greeting;  ///< the services
};

TEST_F(HubTest, GreetsWithWhatItOffers) {
  Sent late;
  hub.publish(kScan, 5, body("x"));
  join(2, late);
  ASSERT_EQ(late.texts.size(), 3);
  EXPECT_EQ(late.texts[0]["op"], "serverInfo");
  EXPECT_THAT(late.texts[0]["capabilities"].get<std::vector<std::string>>(),
              ElementsAre("clientPublish", "services", "time"));
  const Json& channel = late.texts[1]["channels"][0];
  EXPECT_EQ(channel["topic"], "/bumper");
  EXPECT_EQ(channel["schemaName"], "std_msgs/msg/Bool");
  EXPECT_EQ(channel["schema"], "bool data\n");
  EXPECT_EQ(channel["encoding"], "cdr");
  EXPECT_EQ(late.texts[2]["op"], "advertiseServices");
}

class HubPlayback : public testing::Test {
 protected:
  HubPlayback() {
    for (const ClientId id : {ClientId{1}, ClientId{2}})
      hub.join(id, [this, id](OutFrame frame) { sent[id].take(std::move(frame)); });
  }

  void ask(ClientId id) {
    EXPECT_TRUE(
        hub.receive_bytes(id, std::string("\x03\x01\0\0\0\x40\x01\x02\x01\0\0\0\0\0\0\x02\0\0\0id", 21)));
  }

  SetClock clock;
  DriveInbox inbox{clock};
  ServiceMailbox mailbox;
  Hub hub{"aisle", "1",   {{"replay/play", true, &mailbox}},
          clock,   inbox, [](const std::function<void()>& work) { work(); }};
  std::map<ClientId, Sent> sent;
  const Playback replay{.first = 1'000'000'000, .last = 9'000'000'005, .at = 258, .rate = 2};
};

TEST_F(HubPlayback, IsOfferedWhileASessionIsReplayed) {
  const Json before = sent[1].texts.front();
  EXPECT_FALSE(before.contains("dataStartTime"));
  hub.show_playback(replay);
  const Json during = sent[1].take_last();
  EXPECT_EQ(during["op"], "serverInfo");
  EXPECT_EQ(during["capabilities"].back(), "playbackControl");
  EXPECT_EQ(during["dataStartTime"], Json({{"sec", 1}, {"nsec", 0}}));
  EXPECT_EQ(during["dataEndTime"], Json({{"sec", 9}, {"nsec", 5}}));
  EXPECT_NE(during["sessionId"], before["sessionId"]);
  hub.show_playback(replay);
  EXPECT_THAT(sent[1].texts, IsEmpty()) << "it is the same one";
  hub.show_playback({});
  EXPECT_EQ(sent[1].take_last()["capabilities"].size(), 3U);
}

TEST_F(HubPlayback, ARequestIsPassedOnAndAnsweredWithItsId) {
  hub.show_playback(replay);
  ask(1);
  const auto call = mailbox.take();
  ASSERT_TRUE(call);
  EXPECT_EQ(call->service(), "replay/control");
  EXPECT_EQ(call->arguments(), Json({{"plays", false}, {"rate", 2.0}, {"seek_to_ns", 258}}));
  Playback paused = replay;
  paused.status = PlaybackStatus::kPaused;
  paused.did_seek = true;
  hub.show_playback(paused);
  call->answer(nlohmann::ordered_json::object());
  ASSERT_EQ(sent[1].messages.size(), 2U);
  const std::string state("\x05\x01\x02\x01\0\0\0\0\0\0\0\0\0\x40\x01", 15);
  EXPECT_EQ(sent[1].messages[0].head, state + std::string("\0\0\0\0", 4));
  EXPECT_EQ(sent[1].messages[1].head, state + std::string("\x02\0\0\0id", 6));
  EXPECT_THAT(sent[2].messages, IsEmpty()) << "it may not know such messages";
}

TEST_F(HubPlayback, ARequestIsRefusedWithoutAReplayAndWhileAnotherHasTheControls) {
  ask(1);
  EXPECT_THAT(sent[1].take_last()["message"], HasSubstr("nothing is being replayed"));
  hub.show_playback(replay);
  ASSERT_TRUE(hub.lease().take(2));
  ask(1);
  EXPECT_THAT(sent[1].take_last()["message"], HasSubstr("another client has the controls"));
  EXPECT_FALSE(mailbox.take());
  EXPECT_EQ(sent[1].messages.back().head.substr(1, 1), std::string(1, '\0')) << "what it is: playing";
  ask(2);
  EXPECT_TRUE(mailbox.take());
}

TEST_F(HubTest, SendsMessagesOnlyToSubscribers) {
  hub.publish(kScan, 5, body("before"));
  EXPECT_THAT(client.messages, IsEmpty());
  subscribe(77, 1);
  hub.publish(kScan, 258, body("after"));
  ASSERT_EQ(client.messages.size(), 1);
  EXPECT_EQ(client.messages[0].head, std::string("\x01\x4d\0\0\0\x02\x01\0\0\0\0\0\0", 13));
  EXPECT_EQ(*client.messages[0].body, "after");
  EXPECT_TRUE(client.messages[0].may_be_lost);
  hub.receive_text(1, R"({"op":"unsubscribe","subscriptionIds":[77]})");
  hub.publish(kScan, 300, body("later"));
  EXPECT_EQ(client.messages.size(), 1);
}

TEST_F(HubTest, SendsTheLastLatchedMessageToLateSubscribers) {
  hub.publish(kLatched, 5, body("old"));
  hub.publish(kLatched, 6, body("new"));
  subscribe(1, 1);
  ASSERT_EQ(client.messages.size(), 1);
  EXPECT_EQ(*client.messages[0].body, "new");
  hub.forget_latched();
  Sent late;
  join(2, late);
  hub.receive_text(2, R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":1}]})");
  EXPECT_THAT(late.messages, IsEmpty());
}

TEST_F(HubTest, AnswersWrongRequestsWithAStatus) {
  hub.publish(kScan, 5, body("x"));
  subscribe(1, 99);
  EXPECT_THAT(client.take_last()["message"].get<std::string>(), HasSubstr("no channel 99"));
  subscribe(1, 1);
  subscribe(1, 1);
  EXPECT_THAT(client.take_last()["message"].get<std::string>(), HasSubstr("already"));
  hub.receive_text(1, R"({"op":"unsubscribe","subscriptionIds":[5]})");
  EXPECT_EQ(client.take_last()["op"], "status");
  hub.receive_text(1, R"({"op":"fetchAsset"})");
  EXPECT_THAT(client.take_last()["message"].get<std::string>(), HasSubstr("not offered"));
  hub.receive_text(1, R"({"op":"advertise","channels":[{"id":1,"topic":"/cmd_vel","encoding":"json"}]})");
  EXPECT_THAT(client.take_last()["message"].get<std::string>(), HasSubstr("/drive"));
  EXPECT_FALSE(hub.receive_text(1, "garbage"));
  EXPECT_FALSE(hub.receive_bytes(1, "garbage"));
}

TEST_F(HubTest, PassesCallsToTheirMailboxAndAnswersBack) {
  EXPECT_TRUE(call(1, client, "open", {{"x", 1}}).is_null());
  const auto waiting = mailbox.take();
  ASSERT_TRUE(waiting);
  EXPECT_EQ(waiting->service(), "open");
  EXPECT_EQ(waiting->arguments()["x"], 1);
  waiting->answer({{"y", 2}});
  ASSERT_EQ(client.messages.size(), 1);
  EXPECT_THAT(client.messages[0].head, testing::EndsWith(R"(json{"y":2})"));
}

TEST_F(HubTest, RefusesWithServiceFailure) {
  call(1, client, "open", Json::object());
  mailbox.take()->refuse("not now");
  const Json failure = client.take_last();
  EXPECT_EQ(failure["op"], "serviceCallFailure");
  EXPECT_EQ(failure["message"], "not now");
  EXPECT_EQ(failure["callId"], 9);
  EXPECT_EQ(call(1, client, "no such service", Json::object())["op"], "serviceCallFailure");
  EXPECT_EQ(call(1, client, "open", 3)["op"], "serviceCallFailure");
}

TEST_F(HubTest, DoesNotAnswerClientsThatAreGone) {
  call(1, client, "open", Json::object());
  const auto waiting = mailbox.take();
  hub.leave(1);
  waiting->answer(Json::object());
  EXPECT_THAT(client.messages, IsEmpty());
}

TEST_F(HubTest, RefusesCallsWithoutTheLeaseTheyNeed) {
  EXPECT_EQ(call(1, client, "closed", Json::object())["op"], "serviceCallFailure");
  EXPECT_EQ(call(1, client, "closed", {{"lease", "guess"}})["op"], "serviceCallFailure");
  EXPECT_FALSE(mailbox.take());
  call(1, client, "closed", {{"lease", lease_of(1, client)}});
  EXPECT_TRUE(mailbox.take());
}

TEST_F(HubTest, TakesDriveCommandsOfTheLeaseHolder) {
  hub.receive_text(1, R"({"op":"advertise","channels":[{"id":3,"topic":"/drive","encoding":"json"}]})");
  drive("guess", 1);
  EXPECT_FALSE(inbox.take());
  const std::string lease = lease_of(1, client);
  drive(lease, 1);
  EXPECT_EQ(inbox.take()->command.speed_mps, 0.3);
  drive(lease, 1);
  EXPECT_FALSE(inbox.take());
  EXPECT_THAT(client.take_last()["message"].get<std::string>(), HasSubstr("sequence 1"));
}

TEST_F(HubTest, FreesTheLeaseOfAClosedConnection) {
  Sent other;
  join(2, other);
  const std::string lease = lease_of(1, client);
  EXPECT_EQ(call(2, other, "lease/take", Json::object())["op"], "serviceCallFailure");
  hub.leave(1);
  EXPECT_FALSE(lease_of(2, other).empty());
}

}  // namespace
}  // namespace aisle
