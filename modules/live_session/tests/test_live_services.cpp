#include <gmock/gmock.h>

#include "golden_files.hpp"
#include "live_arguments.hpp"
#include "live_maze.hpp"
#include "live_missions.hpp"
#include "live_pace.hpp"
#include "live_state.hpp"

namespace aisle {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

constexpr const char* kMaze =
    "o---o---o\n"
    "| S     |\n"
    "o---o---o\n";

TEST(LiveMaze, ReportsEveryStepOfARun) {
  const auto run = maze_steps({{"maze", kMaze}, {"rules", "published"}});
  ASSERT_TRUE(run) << to_string(run.problems());
  EXPECT_EQ((*run)["width"], 2);
  EXPECT_EQ((*run)["start"], nlohmann::ordered_json({0, 0}));
  const Json steps = (*run)["steps"];
  ASSERT_EQ(steps.size(), 3);
  EXPECT_EQ(steps[0]["open"], "E");
  EXPECT_EQ(steps[0]["move"], "E");
  EXPECT_EQ(steps[1]["cell"], Json({1, 0}));
  EXPECT_EQ(steps[1]["move"], "W");
  EXPECT_EQ(steps[2]["move"], "");
  EXPECT_EQ((*run)["figures"]["moves"], 2);
  EXPECT_EQ((*run)["figures"]["complete"], true);
}

TEST(LiveMaze, SaysWhatIsWrongWithAMaze) {
  EXPECT_THAT(to_string(maze_steps({{"maze", "o---o"}}).problems()), HasSubstr("maze"));
  EXPECT_THAT(to_string(maze_steps({{"maze", kMaze}, {"rules", "mine"}}).problems()), HasSubstr("roaming"));
  EXPECT_FALSE(maze_steps(Json::object()));
}

TEST(LiveArgumentsRead, ReportsAllProblems) {
  const Json json = {{"name", "../x"}, {"count", -1}, {"flag", 1}, {"text", 5}, {"more", 1}};
  LiveArguments arguments(json);
  arguments.name("name");
  arguments.count("count", 10);
  arguments.flag("flag");
  arguments.text("text");
  arguments.needed_name("session");
  const std::string problems = to_string(arguments.problems());
  for (const char* key : {"name:", "count:", "flag:", "text:", "session: is missing", "more: is not known"})
    EXPECT_THAT(problems, HasSubstr(key));
}

TEST(LiveEnd, NamesNoFolderOfTheServer) {
  Outcome outcome{.verb = "drive"};
  outcome.text = "0.3 m/s; session in /srv/robot/sessions/run-1.\nsee /srv/robot/report.html\n";
  EXPECT_EQ(live_end("drive", outcome)["text"], "0.3 m/s; session in run-1.\n");
  const auto failed = live_end("go", Problem{{"/srv/robot/buildings/lab.json", 3, "floor"}, "is missing"});
  EXPECT_EQ(failed["problems"][0], "lab.json:3: floor: is missing");
}

class LiveMissions : public testing::Test {
 protected:
  std::string refusal(const Json& arguments) const {
    const auto mission = live_mission(options, arguments, {});
    return mission ? "" : to_string(mission.problems());
  }
  LiveOptions options;
};

TEST_F(LiveMissions, AreCheckedBeforeTheyBegin) {
  EXPECT_THAT(refusal(Json::object()), HasSubstr("mission"));
  EXPECT_THAT(refusal({{"mission", "dance"}}), HasSubstr("patrol"));
  EXPECT_EQ(refusal({{"mission", "drive"}}), "");
  EXPECT_EQ(refusal({{"mission", "explore"}, {"lease", "t"}}), "");
  EXPECT_THAT(refusal({{"mission", "explore"}, {"speed", 3}}), HasSubstr("speed: is not known"));
  EXPECT_THAT(refusal({{"mission", "teach"}}), HasSubstr("session: is missing"));
  EXPECT_THAT(refusal({{"mission", "teach"}, {"session", "a"}}), HasSubstr("without a folder"));
}

TEST_F(LiveMissions, NeedExistingFilesAndOverwriteNone) {
  options.listening.sessions = options.listening.buildings = kGolden;
  EXPECT_THAT(refusal({{"mission", "go"}, {"building", "none"}, {"place", "a"}}),
              HasSubstr("there is no 'none'"));
  EXPECT_EQ(refusal({{"mission", "go"}, {"building", "building.v1"}, {"x_m", 1}, {"y_m", 2}}), "");
  EXPECT_THAT(refusal({{"mission", "go"}, {"building", "building.v1"}}), HasSubstr("place: is missing"));
  EXPECT_THAT(refusal({{"mission", "explore"}, {"building", "building.v1"}}), HasSubstr("there already"));
  EXPECT_THAT(refusal({{"mission", "learn"}, {"session", "none"}, {"building", "new"}}),
              HasSubstr("there is no 'none'"));
}

TEST_F(LiveMissions, GoToOneGoalOrToSeveralInOrder) {
  options.listening.buildings = kGolden;
  const auto go = [](const Json& goal) {
    Json request = {{"mission", "go"}, {"building", "building.v1"}};
    request.update(goal);
    return request;
  };
  const Json goals = {{{"x_m", 1}, {"y_m", 2}, {"heading_deg", 90}}, {{"place", "desk"}}};
  EXPECT_EQ(refusal(go({{"x_m", 1}, {"y_m", 2}, {"heading_deg", 90}})), "");
  EXPECT_EQ(refusal(go({{"goals", goals}})), "");
  EXPECT_THAT(refusal(go({{"goals", 3}})), HasSubstr("goals: must be a list"));
  EXPECT_THAT(refusal(go({{"goals", Json::array()}})), HasSubstr("place: is missing"));
  EXPECT_THAT(refusal(go({{"goals", {{{"place", "a"}}, {{"x_m", 1}}}}})), HasSubstr("goals.2: has neither"));
  EXPECT_THAT(refusal(go({{"goals", {{{"x_m", "1"}, {"y_m", 2}}}}})),
              HasSubstr("goals.1.x_m: must be a number"));
}

TEST(LiveVehicle, IsTheOneThatTheServerWasStartedWith) {
  LiveOptions options;
  EXPECT_EQ(waiting_vehicle(options), "alv");
  options.vehicle = "turtlebot";
  EXPECT_EQ(waiting_vehicle(options), "turtlebot");
}

class SteppedClock final : public Clock {
 public:
  double now_s() const override { return time_s; }
  double time_s = 50;
};

TEST(LivePaceKept, WaitsForTheVehiclesTime) {
  SteppedClock clock;
  LivePace pace(clock, 2);
  EXPECT_EQ(pace.wait_s(10), 0);
  EXPECT_DOUBLE_EQ(pace.wait_s(11), 0.5);
  clock.time_s += 0.5;
  EXPECT_DOUBLE_EQ(pace.wait_s(11), 0);
}

TEST(LivePaceKept, DoesNotCatchUpALongDelay) {
  SteppedClock clock;
  LivePace pace(clock, 1);
  (void)pace.wait_s(0);
  clock.time_s += 10;
  EXPECT_EQ(pace.wait_s(1), 0);
  EXPECT_NEAR(pace.wait_s(1.1), 0.1, 1e-9);
}

TEST(LivePaceKept, StartsAgainWhenTheVehiclesTimeStartsAgain) {
  SteppedClock clock;
  LivePace pace(clock, 1);
  (void)pace.wait_s(100);
  EXPECT_EQ(pace.wait_s(0.1), 0);
}

TEST(LivePaceKept, KeepsNoPaceAtRateZero) {
  SteppedClock clock;
  LivePace pace(clock, 0);
  (void)pace.wait_s(0);
  EXPECT_EQ(pace.wait_s(1000), 0);
}

}  // namespace
}  // namespace aisle
