/// The life of a landmark route: taught, learned, driven autonomously, refined.

#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Learning : public Workplace {
 protected:
  nlohmann::json run(const Arguments& arguments) const {
    Arguments all = arguments;
    all.push_back("--json");
    const ProgramRun run = run_aisle(all);
    EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
    return run.json();
  }
};

/// The localisation and tracking figures that every shipped world must reach.
void expect_precise(const nlohmann::json& localisation, const nlohmann::json& tracking) {
  EXPECT_LE(localisation["across_rmse_m"], 0.02);
  EXPECT_LE(localisation["along_rmse_m"], 0.05);
  EXPECT_LE(localisation["heading_rmse_deg"], 0.3);
  EXPECT_LE(tracking["rmse_m"], 0.03);
  EXPECT_LE(tracking["max_m"], 0.10);
}

TEST_F(Learning, ARouteIsTaughtOnceLearnedDrivenAloneReplayedAndRefined) {
  const auto taught = run({"teach", "l-corridor", "--method", "landmarks", "--route", "main", "--seed", "1",
                           "--out", at("taught")});
  EXPECT_EQ(taught["figures"]["route"], "main");
  EXPECT_EQ(taught["figures"]["simulated"], true);
  EXPECT_EQ(taught["figures"]["collisions"], 0);

  const auto learned = run({"learn", at("taught"), "--out", at("learned")})["figures"];
  EXPECT_GE(learned["landmarks"], 20);
  EXPECT_EQ(learned["route"], "main");
  EXPECT_NEAR(learned["length_m"], taught["figures"]["distance_m"], 0.3);
  EXPECT_LE(learned["building_bytes"], 12'000);  // 23 m of corridor
  EXPECT_THAT(names_in(at("learned")),
              ElementsAre("building.json", "landmarks.svg", "trip.tum", "trip_truth.tum"));

  const std::string building = at("learned/building.json");
  const auto navigated = run({"navigate", building, "--world", "l-corridor", "--out", at("run")});
  EXPECT_TRUE(std::filesystem::exists(navigated["files"]["driven_svg"].get<std::string>()));
  const auto driven = navigated["figures"];
  EXPECT_EQ(driven["arrived"], true);
  EXPECT_EQ(driven["collisions"], 0);
  EXPECT_EQ(driven["lost_count"], 0);
  EXPECT_EQ(driven["simulated"], true);
  EXPECT_EQ(driven["landmarks"], learned["landmarks"]);
  EXPECT_NEAR(driven["distance_m"], learned["length_m"], 0.5);
  EXPECT_GT(driven["duration_s"], 30);
  EXPECT_TRUE(driven["cycle_ms"].contains("median") && driven["cycle_ms"].contains("p99"));
  expect_precise(driven["localisation"], driven["tracking"]);

  const auto replayed = run({"replay", at("run")})["figures"];
  EXPECT_EQ(replayed["navigator"], "landmarks");
  EXPECT_EQ(replayed["different"], 0);
  EXPECT_EQ(replayed["compared"], replayed["cycles"]);
  EXPECT_GT(replayed["compared"], 300);

  const auto refined = run({"refine", building, at("run"), "--out", at("refined")})["figures"];
  EXPECT_EQ(refined["landmarks_before"], learned["landmarks"]);
  EXPECT_GT(refined["trips"][0]["matched_share"], 0.9);
  EXPECT_GE(refined["landmarks"], 20);
  EXPECT_LE(refined["landmarks"], learned["landmarks"]);

  const ProgramRun refused = run_aisle({"refine", building, at("run"), "--units", "cm", "--scan", "/scan"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err,
            "--scan: is for buildings without landmarks: a session says that itself\n"
            "--units: is for buildings without landmarks: a session says that itself\n");
}

TEST_F(Learning, ATrialIsAWholeMissionWithItsStatistics) {
  const auto figures = run({"trial", "landmarks", "--seeds", "1..1", "--world", "l-corridor"})["figures"];
  EXPECT_EQ(figures["missions"], 1);
  EXPECT_EQ(figures["arrived_share"], 1.0);
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_EQ(figures["wrong_confident"], 0);
  EXPECT_EQ(figures["runs"].size(), 1U);
  EXPECT_EQ(figures["runs"][0]["arrived"], true);
  for (const char* key : {"lost_count", "distance_m", "landmarks"})
    EXPECT_TRUE(figures[key].contains("mean") && figures[key].contains("worst")) << key;
  for (const char* key : {"across_rmse_m", "along_rmse_m", "heading_rmse_deg"})
    EXPECT_TRUE(figures["localisation"][key].contains("worst")) << key;
  expect_precise(figures["runs"][0]["localisation"], figures["runs"][0]["tracking"]);
}

TEST_F(Learning, TheReturnPathIsDrivenFromARunTaughtInOneDirection) {
  file("keys.txt", "0-14 up\n");
  run({"teach", "l-corridor", "--keys", at("keys.txt"), "--route", "main", "--out", at("taught")});
  run({"learn", at("taught"), "--out", at("learned")});
  const auto driven = run({"navigate", at("learned/building.json"), "--world", "l-corridor", "--route",
                           "main", "--reverse"})["figures"];
  EXPECT_EQ(driven["in_reverse"], true);
  EXPECT_EQ(driven["arrived"], true);
  EXPECT_EQ(driven["collisions"], 0);
}

TEST_F(Learning, TheSameSeedGivesTheSameBuilding) {
  file("keys.txt", "0-4 up\n");
  for (const char* name : {"one", "other"}) {
    run({"teach", "l-corridor", "--keys", at("keys.txt"), "--out", at(std::string(name) + "-taught")});
    run({"learn", at(std::string(name) + "-taught"), "--out", at(name)});
  }
  for (const std::string& name : names_in(at("one")))
    EXPECT_TRUE(read_bytes(at("one/" + name)) == read_bytes(at("other/" + name))) << name;
}

TEST_F(Learning, EveryVerbListsItsParameters) {
  for (const char* verb : {"teach", "learn", "navigate", "refine", "trial"}) {
    const ProgramRun printed = run_aisle({verb, "--print-params"});
    EXPECT_EQ(printed.exit_code, 0) << verb << printed.err;
    EXPECT_THAT(printed.out, HasSubstr(":")) << verb;
  }
}

}  // namespace
}  // namespace aisle
