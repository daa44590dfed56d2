/// A path through a furnished room: shown once, learned, and driven autonomously until parked.

#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Rooms = Workplace;

/// A short bright path between dark boxes, with a painted frame at its end.
constexpr const char* kRoom = R"(format: aisle.world
version: 1
name: short room
floor: {kind: plain, brightness: 0.62, contrast: 0.04}
walls:
  - [[0, 0], [8, 0], [8, 3], [0, 3], [0, 0]]
furniture:
  - {centre: [2.5, 0.25], size: [3, 0.5], brightness: 0.2}
  - {centre: [2.5, 2.75], size: [3, 0.5], brightness: 0.2}
lamps:
  - {centre: [2, 1.5]}
  - {centre: [6, 1.5]}
parking_frames:
  - {name: bay, centre: [6.2, 1.5], size: [1.7, 1.2], line_width_m: 0.06, brightness: 1}
start: {at: [1, 1.5]}
routes:
  - {name: to the bay, park: frame, way: [[1, 1.5], [5.85, 1.5]]}
)";

nlohmann::json run_for_figures(const Arguments& arguments, int exit_code = 0) {
  Arguments with_json = arguments;
  with_json.emplace_back("--json");
  const ProgramRun run = run_aisle(with_json);
  EXPECT_EQ(run.exit_code, exit_code) << run.out << run.err;
  return nlohmann::json::parse(run.out)["figures"];
}

TEST_F(Rooms, APathThatWasShownOnceIsDrivenIntoItsFrame) {
  const std::string world = file("room.yaml", kRoom);
  run_for_figures({"teach", world, "--method", "rooms", "--route", "to the bay", "--operator", "scripted",
                   "--out", at("taught")});
  const auto learned = run_for_figures({"learn", at("taught"), "--method", "rooms", "--out", at("learned")});
  EXPECT_EQ(learned["parking"], "frame");
  EXPECT_NEAR(learned["frame_size_m"][0].get<double>(), 1.64, 0.03);
  EXPECT_NEAR(learned["frame_size_m"][1].get<double>(), 1.14, 0.03);
  EXPECT_THAT(names_in(at("learned")), ElementsAre("building.json", "trip.tum", "trip_truth.tum"));

  const auto parked =
      run_for_figures({"park", at("learned/building.json"), "to the bay", "--world", world, "--strategy",
                       "frame", "--start", "2.4,1.6,-6", "--out", at("parking")});
  EXPECT_EQ(parked["parked"], true);
  EXPECT_EQ(parked["collisions"], 0);
  EXPECT_LT(parked["end_error_m"], 0.03);
  EXPECT_LT(parked["end_error_deg"], 1.5);

  const auto replayed = run_for_figures({"replay", at("parking")});
  EXPECT_EQ(replayed["navigator"], "route");
  EXPECT_EQ(replayed["different"], 0);

  const auto backed = run_for_figures({"park", at("learned/building.json"), "to the bay", "--world", world,
                                       "--reverse", "--start", "2.4,1.6,-6", "--out", at("backing")});
  EXPECT_EQ(backed["parked"], true);
  EXPECT_EQ(backed["collisions"], 0);
  EXPECT_LT(backed["end_error_m"], 0.03);
  EXPECT_LT(backed["end_error_deg"], 1.5);
  EXPECT_EQ(run_for_figures({"replay", at("backing")})["different"], 0);
}

TEST_F(Rooms, APathThatCannotBeTaughtLeavesTheOthersOfATrial) {
  const std::string away = "  - {name: to no bay, park: frame, path: [[5.85, 1.5], [3, 1.5]]}\n";
  const auto trial = run_for_figures({"trial", "park", "--strategy", "frame", "--seeds", "1..3", "--world",
                                      file("room.yaml", kRoom + away)});
  EXPECT_EQ(trial["missions"], 1);
  EXPECT_EQ(trial["success_share"], 1.0);
  ASSERT_EQ(trial["runs"].size(), 1U);
  EXPECT_EQ(trial["runs"][0]["route"], "to the bay");
  ASSERT_EQ(trial["not_taught"].size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(trial["not_taught"][i]["seed"], 1 + 2 * i);
    EXPECT_EQ(trial["not_taught"][i]["route"], "to no bay");
    EXPECT_THAT(trial["not_taught"][i]["why"].get<std::string>(), HasSubstr("shows no parking frame"));
  }
}

TEST_F(Rooms, ATrialWithoutAnyTaughtRunFails) {
  const std::string room = kRoom;
  const std::string no_frame =
      room.substr(0, room.find("parking_frames:")) + room.substr(room.find("start:"));
  const auto trial = run_for_figures(
      {"trial", "park", "--strategy", "frame", "--seeds", "1", "--world", file("bare.yaml", no_frame)}, 1);
  EXPECT_EQ(trial["missions"], 0);
  EXPECT_EQ(trial["not_taught"].size(), 1U);
}

TEST_F(Rooms, BetweenCloseTurningsTheVehicleBacksAndDrivesTheSecond) {
  const auto trial = run_for_figures({"trial", "turnings", "--close", "--seeds", "1"});
  ASSERT_EQ(trial["runs"].size(), 2U);
  for (const auto& run : trial["runs"]) {
    EXPECT_EQ(run["parked"], true) << run;
    EXPECT_EQ(run.value("corner_seen", false), true) << run;
    EXPECT_LT(run["end_error_m"], 0.2) << run;
  }
}

TEST_F(Rooms, WheelsAndSteeringThatMisreportAreFoundByTheImages) {
  const std::string faults = file("faults.yaml", R"(format: aisle.scenario
version: 1
name: twice and crooked
events:
  - {from_s: 8, slip: {spin: 1}}
  - {from_s: 12, steering: {bias_deg: 3}}
)");
  const auto trial = run_for_figures({"trial", "rooms", "--seeds", "402..403", "--faults", faults});
  EXPECT_EQ(trial["arrived_share"], 1.0);
  EXPECT_EQ(trial["collisions"], 0);
  for (const auto& run : trial["runs"]) {
    EXPECT_NEAR(run["odometry_error"]["distance_factor"], 0.5, 0.05) << run;
    EXPECT_NEAR(run["odometry_error"]["steering_bias_deg"], 3, 1) << run;
  }
}

TEST_F(Rooms, WhatCannotBeDrivenIsRefused) {
  const std::string world = file("room.yaml", kRoom);
  const std::string building = file("building.json", R"({"format": "aisle.building", "version": 1, "routes": [
{"name": "route", "start": {"at_m": [0, 0], "heading_deg": 0}, "pieces": [{"length_m": 3}],
 "room": {"brightness": {"grey": 160, "deviation": 2}, "parking": "view"}},
{"name": "corridor", "start": {"at_m": [0, 0], "heading_deg": 0}, "pieces": [{"length_m": 3}]}]})");
  const ProgramRun strategy = run_aisle({"park", building, "route", "--world", world, "--strategy", "frame"});
  EXPECT_EQ(strategy.exit_code, 2);
  EXPECT_THAT(strategy.err, HasSubstr("was taught with another parking strategy"));
  const ProgramRun backwards = run_aisle({"park", building, "route", "--world", world, "--reverse"});
  EXPECT_EQ(backwards.exit_code, 2);
  EXPECT_THAT(backwards.err, HasSubstr("does not end in a painted frame"));
  const ProgramRun corridor = run_aisle({"park", building, "corridor", "--world", world});
  EXPECT_EQ(corridor.exit_code, 2);
  EXPECT_THAT(corridor.err, HasSubstr("was not taught as a path through a room"));
  EXPECT_EQ(run_aisle({"park", building, "nowhere", "--world", world}).exit_code, 2);
  EXPECT_EQ(run_aisle({"park", building, "route", "--world", world, "--vehicle", "mini"}).exit_code, 2);
  EXPECT_EQ(run_aisle({"park", building, "route", "--world", world, "--start", "1,2"}).exit_code, 2);
  const ProgramRun unknown = run_aisle(
      {"teach", world, "--method", "rooms", "--route", "none", "--operator", "scripted", "--out", at("x")});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("routes: none is 'none'"));
}

}  // namespace
}  // namespace aisle
