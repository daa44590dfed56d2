#include <gtest/gtest.h>

#include "room_plan.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

class Explore : public Workplace {};

/// A corridor with two dead ends, and the vehicle near one of them.
constexpr const char* kDeadEnds = R"(format: aisle.world
version: 1
name: dead-ends
walls:
  - [[0, 0], [6, 0], [6, 2.2], [0, 2.2], [0, 0]]
lamps:
  - {centre: [3, 1.1]}
start: {at: [1.2, 1.1], heading_deg: 0}
)";

TEST_F(Explore, ARunIsReplayedDecisionByDecisionAndContinuedOnlyByTheSameExplorer) {
  const ProgramRun whole =
      run_aisle({"explore", "l-corridor", "--session", at("run"), "--set", "time_max_s=60", "--json"});
  EXPECT_EQ(whole.exit_code, 1) << whole.err;
  ASSERT_EQ(run_aisle({"cut", at("run"), "--from", "0", "--to", "55", "--out", at("part")}).exit_code, 0);
  EXPECT_EQ(run_aisle({"replay", at("part"), "--json"}).json()["figures"]["different"], 0);

  const ProgramRun other = run_aisle({"explore", "l-corridor", "--resume", at("part"), "--json"});
  EXPECT_EQ(other.exit_code, 2);
  const ProgramRun order = run_aisle({"explore", "l-corridor", "--resume", at("part"), "--order", "published",
                                      "--set", "time_max_s=60", "--json"});
  EXPECT_EQ(order.exit_code, 2);
}

TEST_F(Explore, WhatWasLearnedBeforeTheInterruptionIsKnownAfterIt) {
  ASSERT_EQ(run_aisle({"explore", "l-corridor", "--session", at("run"), "--json"}).exit_code, 0);
  ASSERT_EQ(run_aisle({"cut", at("run"), "--from", "0", "--to", "90", "--out", at("part")}).exit_code, 0);
  const ProgramRun resumed =
      run_aisle({"explore", "l-corridor", "--resume", at("part"), "--out", at("out"), "--json"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  const auto figures = resumed.json()["figures"];
  EXPECT_EQ(figures["certificate"], true);
  EXPECT_GE(figures["covered_share"], 0.98);
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_LE(figures["home_error_m"], 0.1);
  EXPECT_GT(figures["duration_s"], 90);
  EXPECT_THAT(names_in(at("out")),
              testing::ElementsAre("building.json", "exploration.png", "exploration.svg", "report.html"));
  EXPECT_THAT(read_bytes(at("out") + "/report.html"),
              testing::AllOf(testing::HasSubstr("States and stack"), testing::HasSubstr("100.0 %"),
                             testing::HasSubstr("<dt>home error</dt>")));
}

TEST_F(Explore, ACameraThatSeesLaserMarkersShowsABuildingAsWell) {
  const std::string world = file("dead-ends.yaml", kDeadEnds);
  const ProgramRun run = run_aisle({"explore", world, "--sensor", "markers", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["certificate"], true);
  EXPECT_GE(figures["covered_share"], 0.98);
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_LE(figures["home_error_m"], 0.1);
  EXPECT_LE(figures["home_error_deg"], 2);
}

TEST_F(Explore, ATrialExploresByTheSensorThatItIsGiven) {
  const std::string world = file("dead-ends.yaml", kDeadEnds);
  const std::vector<std::string> briefly = {"--sensor", "markers", "--set", "time_max_s=20", "--json"};
  const auto run_briefly = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), briefly.begin(), briefly.end());
    return run_aisle(arguments).json()["figures"];
  };
  const auto explored = run_briefly({"explore", world});
  const auto tried = run_briefly({"trial", "explore", "--world", world})["runs"][0];
  EXPECT_GT(explored["distance_m"], 1);
  for (const char* figure : {"distance_m", "covered_share", "free_m2", "wall_rmse_m"})
    EXPECT_EQ(tried[figure], explored[figure]) << figure;
}

TEST_F(Explore, ATrialCountsWhatIsCompleteAndWhatHasACertificate) {
  const std::string world = file("dead-ends.yaml", kDeadEnds);
  const auto trial = [&](const std::string& set) {
    return run_aisle({"trial", "explore", "--world", world, "--seeds", "1..4", "--set", set, "--json"})
        .json()["figures"];
  };
  const auto figures = trial("time_max_s=1000");
  double complete = 0, certified = 0;
  for (const auto& run : figures["runs"]) {
    complete += run["covered_share"] >= 0.98 && run["came_home"] == true && run["collisions"] == 0 ? 1 : 0;
    certified += run["certificate"] == true ? 1 : 0;
  }
  EXPECT_GE(certified, 3);
  EXPECT_EQ(figures["complete_share"], complete / 4);
  EXPECT_EQ(figures["certificate_share"], certified / 4);

  const auto too_brief = trial("time_max_s=10");
  EXPECT_EQ(too_brief["complete_share"], 0);
  EXPECT_EQ(too_brief["certificate_share"], 0);
}

TEST_F(Explore, ATrialThatStartsAnywhereIsRefusedWhereTheVehicleHasNoSpaceForThat) {
  const std::string world = file("narrow.yaml",
                                 "format: aisle.world\nversion: 1\nname: narrow\n"
                                 "walls: [[[0, 0], [2.4, 0], [2.4, 0.8], [0, 0.8], [0, 0]]]\n"
                                 "start: {at: [0.6, 0.4], heading_deg: 0}\n");
  const std::string why = world + ": walls: leave no space for a random start";
  EXPECT_THAT(run_aisle({"trial", "explore", "--start-anywhere", "--world", world, "--json"}),
              IsRefused(why));
  EXPECT_THAT(run_aisle({"trial", "localise", "--world", world, "--json"}), IsRefused(why));
}

/// At a half-open door the search found paths out, but each was blocked at its start until the retry budget
/// was spent.
TEST_F(Explore, AVehicleThatIsBlockedOnEveryPathOutBacktracks) {
  const ProgramRun run = run_aisle({"explore", "alcoves", "--order", "nearest-frontier", "--json"});
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["came_home"], true) << figures["ended_because"];
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_LE(figures["home_error_m"], 0.1);
}

/// It sees what is before its front only: it cannot turn on that.
TEST_F(Explore, AVehicleThatWasPutAcrossACorridorTurnsOutOfIt) {
  for (const char* start : {"9.38,0.73,95", "14.85,5.37,40", "2.37,1.29,-66"}) {
    const ProgramRun run = run_aisle({"explore", "l-corridor", "--start", start, "--json"});
    const auto figures = run.json()["figures"];
    EXPECT_EQ(figures["came_home"], true) << start << ": " << figures["ended_because"];
    EXPECT_GE(figures["covered_share"], 0.98) << start;
    EXPECT_LE(figures["home_error_m"], 0.1) << start;
  }
}

/// No path that the search knows leads into the first pose, from which it moved away by less than its step.
TEST_F(Explore, AVehicleComesHomeAsItLeftWhereThereIsHardlySpace) {
  const ProgramRun run =
      run_aisle({"explore", "laboratory", "--start", "1.833,3.075,-162.9", "--seed", "701", "--json"});
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["came_home"], true) << figures["ended_because"];
  EXPECT_LE(figures["home_error_m"], 0.05);
}

TEST_F(Explore, PeopleWhoWalkThroughNeitherShutItInNorStayInItsMap) {
  const ProgramRun run = run_aisle({"explore", "people-crossing", "--vehicle", "turtlebot", "--json"});
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["certificate"], true) << figures["ended_because"];
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_LE(figures["wall_false_share"], 0.02);
}

TEST_F(Explore, APlanIsExploredLikeTheWorldThatIsMadeOfIt) {
  const std::string plan = file("room.pbm", room_pbm(90, 40));
  ASSERT_EQ(run_aisle({"convert", plan, "--resolution", "0.1", "-o", at("room.yaml")}).exit_code, 0);
  const ProgramRun on_plan =
      run_aisle({"explore", plan, "--resolution", "0.1", "--set", "time_max_s=20", "--json"});
  const ProgramRun in_world = run_aisle({"explore", at("room.yaml"), "--set", "time_max_s=20", "--json"});
  const auto of_plan = on_plan.json()["figures"], of_world = in_world.json()["figures"];
  EXPECT_GT(of_plan["distance_m"], 1);
  for (const char* figure : {"distance_m", "covered_share", "free_m2", "wall_rmse_m"})
    EXPECT_EQ(of_plan[figure], of_world[figure]) << figure;
}

TEST_F(Explore, TheVehicleNavigatesInAnExploredBuilding) {
  ASSERT_EQ(run_aisle({"explore", "l-corridor", "--out", at("out"), "--json"}).exit_code, 0);
  const ProgramRun round =
      run_aisle({"patrol", at("out") + "/building.json", "--world", "l-corridor", "--json"});
  EXPECT_EQ(round.exit_code, 0) << round.out;
  const auto figures = round.json()["figures"];
  EXPECT_EQ(figures["arrived"], true);
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_GE(figures["graph_coverage"], 0.9);
}

}  // namespace
}  // namespace aisle
