#include "aisle/live/live_server.hpp"

#include <gmock/gmock.h>

#include <thread>

#include "live_client.hpp"
#include "waiting.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

const SessionTopic kText{"/decision", "std_msgs/msg/String"};
const SessionTopic kKept{"/session", "std_msgs/msg/String", true};

class Server : public testing::Test {
 protected:
  static std::unique_ptr<LiveServer> open(LiveServerOptions options, ServiceMailbox& calls) {
    options.port = 0;
    auto server = LiveServer::open(std::move(options), {{"echo", false, &calls}});
    if (!server) throw std::runtime_error(to_string(server.problems()));
    return std::move(*server);
  }

  ServiceMailbox calls;
  std::unique_ptr<LiveServer> server = open({.version = "1.2"}, calls);
};

bool is_refused(std::uint16_t port, const std::map<std::string, std::string>& headers,
                const std::string& target = "/", const std::string& subprotocol = "foxglove.websocket.v1") {
  try {
    LiveClient client(port, headers, target, subprotocol);
    return false;
  } catch (const boost::system::system_error&) {
    return true;
  }
}

TEST_F(Server, ShowsWhatIsPublished) {
  server->take(kKept, 1, "latched");
  LiveClient client(server->port());
  client.subscribe_to_all();
  client.read_until([&] { return !client.messages.empty(); });
  EXPECT_EQ(client.server_info["metadata"]["aisle"], "1.2");
  EXPECT_EQ(client.messages[0].topic, "/session");
  EXPECT_EQ(client.messages[0].cdr, "latched");
  server->take(kText, 7, "text");
  server->take_time(8);
  client.read_until([&] { return client.time_ns == 8 && client.topics.size() == 2; });
  client.call("lease/take");  // answered only after the subscription was handled
  server->take(kText, 9, "next");
  client.read_until([&] { return client.messages.back().cdr == "next"; });
  EXPECT_EQ(client.messages.back().stamp, 9);
}

TEST_F(Server, AcceptsBothSubprotocolsAndNoOther) {
  EXPECT_FALSE(is_refused(server->port(), {}, "/", "foxglove.sdk.v1"));
  EXPECT_FALSE(is_refused(server->port(), {}, "/", "other, foxglove.websocket.v1"));
  EXPECT_TRUE(is_refused(server->port(), {}, "/", "other"));
  EXPECT_TRUE(is_refused(server->port(), {}, "/", ""));
}

TEST_F(Server, RefusesForeignOrigins) {
  const std::string own = "http://127.0.0.1:" + std::to_string(server->port());
  EXPECT_FALSE(is_refused(server->port(), {{"Origin", own}}));
  EXPECT_TRUE(is_refused(server->port(), {{"Origin", "http://evil.example"}}));
  EXPECT_EQ(live_http(server->port(), "GET", "/healthz", {{"Origin", "http://evil.example"}}).status, 403);
  EXPECT_EQ(live_http(server->port(), "GET", "/healthz", {{"Host", "evil.example"}}).status, 403);
  EXPECT_EQ(live_http(server->port(), "GET", "/healthz").body, R"({"ok":true,"version":"1.2"})");
}

TEST_F(Server, AsksForItsToken) {
  ServiceMailbox others;
  const auto guarded = open({.token = "0123456789abcdef"}, others);
  EXPECT_TRUE(is_refused(guarded->port(), {}));
  EXPECT_TRUE(is_refused(guarded->port(), {}, "/?token=0123456789abcdeX"));
  EXPECT_FALSE(is_refused(guarded->port(), {}, "/?token=0123456789abcdef"));
  EXPECT_FALSE(is_refused(guarded->port(), {{"Authorization", "Bearer 0123456789abcdef"}}));
}

TEST_F(Server, OpensToOtherMachinesOnlyWithAToken) {
  ServiceMailbox others;
  for (const LiveServerOptions& options :
       {LiveServerOptions{.address = "0.0.0.0"}, LiveServerOptions{.address = "0.0.0.0", .token = "short"},
        LiveServerOptions{.address = "nowhere"}, LiveServerOptions{.port = server->port()}}) {
    const auto refused = LiveServer::open(options, {{"echo", false, &others}});
    ASSERT_FALSE(refused);
    EXPECT_THAT(to_string(refused.problems()), testing::AnyOf(HasSubstr("--"), HasSubstr("listened")));
  }
}

TEST_F(Server, ClosesOnGarbageAndOversizedMessages) {
  for (const std::string& garbage : {std::string("garbage"), std::string((1 << 20) + 1, 'x')}) {
    LiveClient client(server->port());
    client.send_bytes(garbage);
    EXPECT_THROW(client.read_until([] { return false; }), boost::system::system_error);
  }
  EXPECT_FALSE(is_refused(server->port(), {})) << "others are served all the same";
}

TEST_F(Server, ClosesOnTooManyMessages) {
  LiveClient client(server->port());
  EXPECT_THROW(
      {
        for (int i = 0; i < 2000; ++i) client.send_text(R"({"op":"unsubscribe","subscriptionIds":[]})");
        client.read_until([] { return false; });
      },
      boost::system::system_error);
}

TEST_F(Server, LimitsTheNumberOfConnections) {
  std::vector<std::unique_ptr<LiveClient>> clients;
  for (std::size_t i = 0; i < LiveServer::kConnectionsMax; ++i)
    clients.push_back(std::make_unique<LiveClient>(server->port()));
  EXPECT_TRUE(is_refused(server->port(), {}));
}

TEST_F(Server, AnswersCallsFromAnotherThread) {
  const std::jthread answering([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      if (const auto call = calls.wait(std::chrono::milliseconds(20)))
        call->answer({{"heard", call->arguments()["say"]}});
    }
  });
  LiveClient client(server->port());
  EXPECT_EQ(client.call("echo", {{"say", "hello"}})["heard"], "hello");
}

TEST_F(Server, PassesOnDriveCommandsOfTheLeaseHolder) {
  LiveClient client(server->port());
  const std::string lease = client.call("lease/take")["lease"];
  client.advertise_drive();
  client.drive({{"lease", lease}, {"sequence", 1}, {"speed_mps", 0.25}});
  client.call("lease/renew", {{"lease", lease}});  // answered only after the command was handled
  const auto command = server->drive().take();
  ASSERT_TRUE(command);
  EXPECT_EQ(command->command.speed_mps, 0.25);
}

TEST_F(Server, IsNotHeldUpByAClientThatReadsNothing) {
  LiveClient stalled(server->port());
  LiveClient awake(server->port());
  server->take(kText, 1, "");
  server->take(kKept, 1, "latched");  // arrives once both are subscribed to
  for (LiveClient* client : {&stalled, &awake}) {
    client->subscribe_to_all();
    client->read_until([client] { return !client->messages.empty(); });
  }
  const std::string large(1 << 20, 'x');
  for (int i = 0; i < 100; ++i) {
    server->take(kText, 100 + i, large);
    awake.read_until([&] { return awake.messages.back().stamp == static_cast<std::uint64_t>(100 + i); });
  }
  EXPECT_EQ(awake.messages.back().cdr.size(), large.size());
}

TEST_F(Server, SaysGoodbyeAfterAllThatWasSent) {
  LiveClient slow(server->port());
  server->take(kKept, 1, "begins");
  slow.subscribe_to_all();
  slow.read_until([&] { return !slow.messages.empty(); });
  for (int i = 0; i < 3; ++i) server->take(kKept, 2 + i, std::string(1 << 20, 'x'));
  server->take(kKept, 9, "ends");
  server->say_goodbye();
  slow.read_until([&] { return slow.messages.back().cdr == "ends"; });
  EXPECT_EQ(server->clients(), 1U) << "it has not heard the goodbye";
  EXPECT_THROW(slow.read_until([] { return false; }), boost::system::system_error);
  EXPECT_TRUE(eventually([&] { return server->clients() == 0; }));
  EXPECT_TRUE(is_refused(server->port(), {})) << "nobody comes any more";
}

}  // namespace
}  // namespace aisle
