#include <gmock/gmock.h>

#include <csignal>
#include <map>
#include <optional>
#include <thread>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "live_client.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

using testing::Not;
using testing::StartsWith;

/// The program while it serves; the test ends it as Ctrl-C would.
class LiveProgram : public Workplace {
 protected:
  void start(Arguments arguments) {
    arguments.insert(arguments.end(), {"--port", "0"});
    running.emplace(arguments);
    for (int i = 0; i < 1000 && port == 0; ++i) {
      const std::string err = running->error_so_far();
      const std::size_t at = err.find("127.0.0.1:");
      if (at != std::string::npos && err.find('\n', at) != std::string::npos)
        port = static_cast<std::uint16_t>(std::stoi(err.substr(at + 10)));
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_NE(port, 0) << "no address was announced";
  }

  void TearDown() override {
    if (!running) return;
    running->signal(SIGINT);
    running->wait();
  }

  std::optional<RunningAisle> running;
  std::uint16_t port = 0;
};

nlohmann::json state_of(const LiveClient& client) {
  for (auto at = client.messages.rbegin(); at != client.messages.rend(); ++at) {
    if (at->topic == "/live/state") return nlohmann::json::parse(parse_cdr<ros::String>(at->cdr)->data);
  }
  return {};
}

double speed_of(const LiveClient& client) {
  for (auto at = client.messages.rbegin(); at != client.messages.rend(); ++at) {
    if (at->topic == "/odom") return parse_cdr<ros::Odometry>(at->cdr)->twist.twist.linear.x;
  }
  return 0;
}

double commanded_speed(const LiveClient& client) {
  for (auto at = client.messages.rbegin(); at != client.messages.rend(); ++at) {
    if (at->topic == "/cmd_vel") return parse_cdr<ros::Twist>(at->cdr)->linear.x;
  }
  return 0;
}

using Recorded = std::map<std::pair<std::string, std::uint64_t>, std::string>;

Recorded recorded(const std::string& session) {
  auto reader = SessionReader::open(session);
  Recorded messages;
  while (true) {
    const auto message = reader->next();
    if (!message || !*message) return messages;
    messages[{(*message)->topic.name, static_cast<std::uint64_t>((*message)->stamp)}] = (*message)->cdr;
  }
}

TEST_F(LiveProgram, ShowsTheVeryBytesThatItRecordsAndNeverTheTruth) {
  start({"live", "l-corridor", "--out", at("lab"), "--rate", "0"});
  LiveClient client(port);
  client.subscribe_to_all();
  const std::string lease = client.call("lease/take")["lease"];
  client.call("mission/start", {{"lease", lease}, {"mission", "drive"}, {"session", "run"}});
  client.read_until([&] { return state_of(client)["session"] == "run"; });
  const std::size_t begun = client.messages.size();
  client.read_until([&] { return client.messages.size() > begun + 300; });
  client.call("mission/finish", {{"lease", client.call("lease/take")["lease"]}});
  client.read_until([&] { return state_of(client)["mode"] == "idle"; });
  EXPECT_EQ(state_of(client)["last"]["ok"], true);

  const Recorded session = recorded(at("lab/sessions/run"));
  std::map<std::string, std::size_t> same;
  for (std::size_t i = begun; i < client.messages.size(); ++i) {
    const LiveClient::Message& message = client.messages[i];
    EXPECT_THAT(message.topic, Not(StartsWith("/truth")));
    const auto found = session.find({message.topic, message.stamp});
    if (found == session.end() || message.topic == "/live/state") continue;
    same[message.topic] += found->second == message.cdr ? 1 : 0;
  }
  for (const char* topic :
       {"/wheels", "/odom", "/decision", "/cmd_vel", "/tf", "/camera/top/image_raw/compressed"})
    EXPECT_GT(same[topic], 5) << topic;
}

TEST_F(LiveProgram, StopsByItselfWhenDriveCommandsStayAway) {
  start({"live", "l-corridor", "--rate", "2"});
  LiveClient client(port);
  client.subscribe_to_all();
  const std::string lease = client.call("lease/take")["lease"];
  client.advertise_drive();
  std::uint64_t sequence = 0;
  const auto drive = [&] {
    client.drive({{"lease", lease}, {"sequence", ++sequence}, {"speed_mps", 0.3}});
    const std::size_t before = client.messages.size();
    client.read_until([&] { return client.messages.size() > before; });
  };
  while (commanded_speed(client) < 0.25 || speed_of(client) < 0.1) drive();
  const std::uint64_t quiet_from = client.time_ns;
  client.read_until([&] { return commanded_speed(client) == 0; });
  EXPECT_LE(client.time_ns - quiet_from, 700'000'000U);
  client.read_until([&] { return speed_of(client) == 0; });
}

TEST_F(LiveProgram, StopsInAnEmergencyWithoutALease) {
  start({"live", "l-corridor", "--rate", "2"});
  LiveClient driver(port);
  LiveClient bystander(port);
  driver.subscribe_to_all();
  const std::string lease = driver.call("lease/take")["lease"];
  EXPECT_THROW(bystander.call("lease/take"), std::runtime_error) << "one driver at a time";
  EXPECT_THROW(bystander.call("mission/stop"), std::runtime_error);
  driver.advertise_drive();
  std::uint64_t sequence = 0;
  const auto drive = [&] {
    driver.drive({{"lease", lease}, {"sequence", ++sequence}, {"speed_mps", 0.3}});
    const std::size_t before = driver.messages.size();
    driver.read_until([&] { return driver.messages.size() > before; });
  };
  while (commanded_speed(driver) < 0.25) drive();
  bystander.call("mission/emergency_stop");
  const std::uint64_t stopped_ns = driver.time_ns;
  while (commanded_speed(driver) > 0) drive();
  EXPECT_LE(driver.time_ns - stopped_ns, 300'000'000U);
  for (int i = 0; i < 20; ++i) drive();
  EXPECT_EQ(commanded_speed(driver), 0) << "until it is released";
  driver.call("mission/emergency_release", {{"lease", lease}});
  while (commanded_speed(driver) < 0.25) drive();
}

TEST_F(LiveProgram, RunsMissionsAndAnswersQuestions) {
  start({"live", "l-corridor", "--out", at("lab"), "--rate", "0"});
  LiveClient client(port);
  client.subscribe_to_all();
  EXPECT_EQ(client.call("maze/run", {{"maze", "o---o\n| S |\no---o\n"}})["figures"]["complete"], true);
  EXPECT_TRUE(client.call("sessions/list")["sessions"].empty());
  EXPECT_THROW(client.call("mission/start", {{"mission", "explore"}}), std::runtime_error) << "no lease";
  const std::string lease = client.call("lease/take")["lease"];
  EXPECT_THROW(client.call("mission/start", {{"lease", lease}, {"mission", "dance"}}), std::runtime_error);
  client.call("mission/start",
              {{"lease", lease}, {"mission", "teach"}, {"session", "run"}, {"scripted", true}});
  client.read_until([&] { return state_of(client)["mode"] == "mission"; });
  client.read_until([&] { return client.time_ns > 3'000'000'000U; });
  client.call("mission/stop", {{"lease", client.call("lease/take")["lease"]}});
  client.read_until([&] { return state_of(client)["mode"] == "idle"; });
  EXPECT_THAT(state_of(client)["last"]["text"].get<std::string>(),
              testing::HasSubstr("ended by the operator"));
  EXPECT_EQ(client.call("sessions/list")["sessions"][0]["name"], "run");
  EXPECT_TRUE(client.call("sessions/info", {{"session", "run"}}).contains("topics"));
  EXPECT_EQ(live_http(port, "GET", "/sessions/").body, R"({"sessions":["run"]})");
  EXPECT_EQ(live_http(port, "GET", "/sessions/run/run_0.db3").status, 200);

  client.call("replay/start", {{"lease", client.call("lease/take")["lease"]}, {"session", "run"}});
  client.read_until(
      [&] { return state_of(client)["mode"] == "replay" && state_of(client)["replay"]["at_s"] > 0.5; });
}

TEST_F(LiveProgram, AReplayIsControlledByAViewersOwnControls) {
  ASSERT_EQ(run_aisle({"drive", "l-corridor", "--out", at("kept/run"), "--no-images", "--keys",
                       file("keys", "0-3 up\n")})
                .exit_code,
            0);
  start({"live", "l-corridor", "--sessions", at("kept")});
  LiveClient page(port), viewer(port);
  viewer.subscribe_to_all();
  const std::string lease = page.call("lease/take")["lease"];
  page.call("replay/start", {{"lease", lease}, {"session", "run"}});
  viewer.read_until([&] { return viewer.server_info.contains("dataStartTime"); });
  EXPECT_EQ(viewer.server_info["capabilities"].back(), "playbackControl");
  const nlohmann::json begin = viewer.server_info["dataStartTime"];
  const std::uint64_t begin_ns =
      begin["sec"].get<std::uint64_t>() * 1'000'000'000 + begin["nsec"].get<std::uint64_t>();
  viewer.pause_at(begin_ns, "too early");
  viewer.read_until([&] { return !viewer.playback.empty(); });
  EXPECT_EQ(viewer.playback.back().request, "too early");
  EXPECT_NE(viewer.playback.back().status, 1) << "it is not paused: the page has the controls";
  page.call("lease/release", {{"lease", lease}});
  viewer.pause_at(begin_ns + 1'500'000'000, "jump");
  viewer.read_until([&] { return viewer.playback.back().request == "jump"; });
  EXPECT_EQ(viewer.playback.back().status, 1);
  EXPECT_EQ(viewer.playback.back().stamp, begin_ns + 1'500'000'000);
  EXPECT_TRUE(viewer.playback.back().did_seek);
  viewer.read_until([&] { return state_of(viewer)["replay"]["playing"] == false; });
  EXPECT_NEAR(state_of(viewer)["replay"]["at_s"].get<double>(), 1.5, 1e-3);
  page.call("replay/stop", {{"lease", page.call("lease/take")["lease"]}});
  viewer.read_until([&] { return !viewer.server_info.contains("dataStartTime"); });
}

TEST_F(LiveProgram, WatchesAnotherVerb) {
  start({"drive", "l-corridor", "--operator", "page", "--live", "--no-images", "--json"});
  LiveClient client(port);
  client.subscribe_to_all();
  client.read_until([&] { return state_of(client)["mission"] == "drive"; });
  const std::string lease = client.call("lease/take")["lease"];
  EXPECT_THROW(client.call("mission/start", {{"lease", lease}, {"mission", "drive"}}), std::runtime_error);
  client.call("mission/pause", {{"lease", lease}});
  const std::uint64_t paused = client.time_ns;
  client.read_until([&] { return state_of(client)["paused"] == true; });
  EXPECT_LE(client.time_ns, paused + 200'000'000U);
  client.call("mission/resume", {{"lease", lease}});
  client.call("mission/finish", {{"lease", lease}});
  const ProgramRun run = running->wait();
  running.reset();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["figures"]["state"], "ended");
}

TEST_F(LiveProgram, ListsTheSessionsOfAFolderWhileAnotherVerbIsWatched) {
  ASSERT_EQ(run_aisle({"drive", "l-corridor", "--out", at("kept/run"), "--no-images", "--keys",
                       file("keys", "0-0.5 up\n")})
                .exit_code,
            0);
  start({"drive", "l-corridor", "--operator", "page", "--live", "--no-images", "--sessions", at("kept")});
  LiveClient client(port);
  EXPECT_EQ(client.call("sessions/list")["sessions"][0]["name"], "run");
}

TEST_F(LiveProgram, RefusesWhatWouldBeUnsafe) {
  const std::string token = file("token", "short\n");
  EXPECT_THAT(run_aisle({"--json", "live", "l-corridor", "--listen", "0.0.0.0"}), IsRefused("--token-file"));
  EXPECT_THAT(run_aisle({"--json", "live", "l-corridor", "--listen", "0.0.0.0", "--token-file", token}),
              IsRefused("at least 16"));
  EXPECT_THAT(run_aisle({"--json", "live", "l-corridor", "--listen", "lan"}), IsRefused("is not an address"));
  EXPECT_THAT(run_aisle({"--json", "live", "l-corridor", "--cert", token}), IsRefused("--key"));
  EXPECT_THAT(run_aisle({"--json", "live", "l-corridor", "--cert", token, "--key", token}),
              IsRefused("no certificate in PEM form"));
  EXPECT_THAT(run_aisle({"--json", "drive", "l-corridor", "--operator", "page"}), IsRefused("needs --live"));
}

}  // namespace
}  // namespace aisle
