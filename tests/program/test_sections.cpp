/// A path taught to the mini-vehicle once, learned as sections, driven there and back.

#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using Sections = Workplace;

nlohmann::json run_well(const Arguments& arguments) {
  Arguments with_json = arguments;
  with_json.emplace_back("--json");
  const ProgramRun run = run_aisle(with_json);
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  return nlohmann::json::parse(run.out);
}

TEST_F(Sections, APathThatWasDrivenOnceIsDrivenThereAndBack) {
  run_well({"teach", "mini-corridor", "--method", "sections", "--route", "main", "--operator", "scripted",
            "--out", at("taught")});
  const auto learned = run_well({"learn", at("taught"), "--method", "sections", "--out", at("learned")});
  std::string letters;
  for (const auto& section : learned["figures"]["sections"]) letters += section.get<std::string>().front();
  EXPECT_EQ(letters, "achrhra");  // left, right, right, as the corridors turn
  const auto twice = run_well({"learn", at("taught"), at("taught"), "--method", "sections"})["figures"];
  EXPECT_EQ(twice["teachings"], 2);
  EXPECT_EQ(twice["sections"], learned["figures"]["sections"]);
  EXPECT_THAT(names_in(at("learned")),
              ElementsAre("building.json", "sections.svg", "trip.tum", "trip_truth.tum"));

  const auto driven = run_well({"navigate", at("learned/building.json"), "--method", "sections", "--world",
                                "mini-corridor", "--and-back", "--out", at("run")})["figures"];
  EXPECT_EQ(driven["arrived"], true);
  EXPECT_EQ(driven["collisions"], 0);
  EXPECT_LT(driven["closing_error_m"], 0.1);
  EXPECT_LT(driven["closing_error_deg"], 3);
  EXPECT_LT(driven["wall_distance_rmse_m"], 0.02);

  const auto replayed = run_well({"replay", at("run")})["figures"];
  EXPECT_EQ(replayed["navigator"], "sections");
  EXPECT_EQ(replayed["different"], 0);
  EXPECT_GT(replayed["compared"], 3000);
}

TEST_F(Sections, WhatCannotBeDrivenIsRefusedWithItsPlace) {
  const auto building = [](const std::string& sections) {
    return R"({"format": "aisle.building", "version": 1, "routes": [{"name": "route", )"
           R"("start": {"at_m": [0, 0], "heading_deg": 0}, "sections": [)" +
           sections + "]}]}";
  };
  const auto navigate = [&](const std::string& text, const Arguments& more = {}) {
    Arguments arguments = {"navigate",     file("building.json", text), "--method", "sections", "--world",
                           "mini-corridor"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_aisle(arguments);
  };
  const ProgramRun unknown = navigate(building(R"("a 3", "q 2")"));
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("building.json: routes[0].sections[1]: 'q' is not a section"));
  EXPECT_EQ(navigate(building(R"("h 3", "l 36", "a 2")")).exit_code, 2);
  EXPECT_EQ(navigate(building(R"("a 3")"), {"--route", "other"}).exit_code, 2);
  EXPECT_EQ(navigate(building(R"("a 3")"), {"--vehicle", "alv"}).exit_code, 2);

  const ProgramRun blocked = navigate(building(R"("l 36", "a 3")"));  // into the wall
  EXPECT_EQ(blocked.exit_code, 1);
  EXPECT_THAT(blocked.out, HasSubstr("in section 2 of 2"));
}

TEST_F(Sections, AnObstacleOnTheFloorAheadIsWaitedFor) {
  file("building.json",
       R"({"format": "aisle.building", "version": 1, "routes": [{"name": "route", )"
       R"("start": {"at_m": [0, 0], "heading_deg": 0}, "sections": ["a 3.2 right 0.55"]}]})");
  const auto drive = [&](const std::string& scenario) {
    return run_aisle({"navigate", at("building.json"), "--method", "sections", "--world", "mini-corridor",
                      "--faults", scenario, "--set", "guard.wait_max_s=25", "--set", "speed.speed_mps=0.2",
                      "--json"});
  };
  const ProgramRun blocked = drive("mini-blocked");
  EXPECT_EQ(blocked.exit_code, 1) << blocked.err;
  const auto figures = blocked.json()["figures"];
  EXPECT_EQ(figures["state"], "blocked");
  EXPECT_THAT(figures["why"].get<std::string>(), HasSubstr("obstacle ahead"));
  EXPECT_THAT(figures["why"].get<std::string>(), HasSubstr("in section 1 of 1"));
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_NEAR(figures["distance_m"], 2.4 - 0.6 - 0.11 - 0.25, 0.1);  // the front stops a gap before the box

  const ProgramRun crossed = drive("mini-person-crossing");
  EXPECT_EQ(crossed.exit_code, 0) << crossed.out << crossed.err;
  EXPECT_EQ(crossed.json()["figures"]["collisions"], 0);
  EXPECT_GT(crossed.json()["figures"]["duration_s"], 20);
}

TEST_F(Sections, AnyVehiclesDriveIsLearned) {
  file("keys.txt", "0-8 up\n");
  run_well({"teach", "l-corridor", "--keys", at("keys.txt"), "--out", at("taught")});
  const auto learned = run_well({"learn", at("taught"), "--method", "sections"});
  ASSERT_EQ(learned["figures"]["sections"].size(), 1U);
  EXPECT_THAT(learned["figures"]["sections"][0].get<std::string>(), StartsWith("a "));
}

}  // namespace
}  // namespace aisle
