#include <algorithm>

#include "workplace.hpp"

namespace aisle {
namespace {

class Go : public Workplace {};

constexpr const char* kCarriedIntoTheCorner = R"(format: aisle.scenario
version: 1
name: carried-into-the-corner
world: l-corridor
events:
  - near: [9, 1.1]
    lift: {at: [14.5, 1.5], heading_deg: 45}
)";

TEST_F(Go, FindsItselfWhereItIsPutDownAndAgainAfterItWasCarriedAway) {
  ASSERT_EQ(run_aisle({"explore", "l-corridor", "--out", at("explored"), "--json"}).exit_code, 0);
  const ProgramRun run =
      run_aisle({"go", at("explored/building.json"), "home", "--world", "l-corridor", "--start", "14.9,9,-90",
                 "--faults", file("carried.yaml", kCarriedIntoTheCorner), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["arrived"], true);
  EXPECT_EQ(figures["times_lost"], 1);
  EXPECT_EQ(figures["collisions"], 0);
}

class GoInAMap : public WorkplaceWithLog {
 protected:
  void SetUp() override {
    WorkplaceWithLog::SetUp();
    ASSERT_EQ(run_aisle({"map", log(), "--out", at("map"), "--json"}).exit_code, 0);
  }
  ProgramRun convert(const Arguments& more) const {
    Arguments all = {"convert", at("map/map.yaml"), "--building", "-o", at("building.json"), "--json"};
    all.insert(all.end(), more.begin(), more.end());
    return run_aisle(all);
  }
};

/// A mask of cells of 0.5 m around the map's origin: black between two corners, in metres.
std::string mask_pgm(double x_low, double y_low, double x_high, double y_high) {
  std::string pgm = "P2\n160 160\n255\n";
  for (int row = 0; row < 160; ++row) {
    for (int column = 0; column < 160; ++column) {
      const double x = 0.5 * column - 39.75, y = 39.75 - 0.5 * row;
      const bool is_zone = x > x_low && x < x_high && y > y_low && y < y_high;
      pgm += is_zone ? "0 " : "254 ";
    }
    pgm += "\n";
  }
  return pgm;
}

constexpr const char* kMask = "image: mask.pgm\nresolution: 0.5\norigin: [-40, -40, 0]\nnegate: 0\n";

TEST_F(GoInAMap, DrivesToAPlaceTheOtherWayRoundWhereAMaskClosesTheCorridor) {
  file("mask.pgm", mask_pgm(8, -1.5, 9, 1.5));
  const auto made = convert({"--place", "desk=14.4,2.5", "--keep-out", file("mask.yaml", kMask)}).json();
  EXPECT_EQ(made["figures"]["places"], 2) << "and home, at the map's origin";
  EXPECT_EQ(made["figures"]["barriers"], 4);
  const ProgramRun run = run_aisle({"go", at("building.json"), "desk", "--world", "small-office", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  EXPECT_EQ(run.json()["figures"]["collisions"], 0);
  EXPECT_GT(run.json()["figures"]["distance_m"], 22) << "through the zone it would be 17 m";
}

TEST_F(GoInAMap, DrivesToGoalsInOrderAndSaysHowItStandsAtTheirHeadings) {
  convert({});
  const auto go = [this](const std::vector<std::string>& places) {
    std::vector<std::string> arguments = {"go", at("building.json")};
    arguments.insert(arguments.end(), places.begin(), places.end());
    arguments.insert(arguments.end(), {"--world", "small-office", "--vehicle", "turtlebot", "--json"});
    return run_aisle(arguments);
  };
  const ProgramRun run = go({"2,0", "1,0,-90"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["places_reached"], 2);
  ASSERT_EQ(figures["headings"].size(), 1U);
  EXPECT_EQ(figures["headings"][0]["place"], 2);
  EXPECT_EQ(figures["headings"][0]["reached"], true);
  EXPECT_LT(std::abs(figures["headings"][0]["off_deg"].get<double>()), 10);
  EXPECT_THAT(go({"home", "nowhere"}), IsRefused("goal 2: 'nowhere' is unknown"));
}

TEST_F(GoInAMap, RecordsItsGoalsWheneverTheyChange) {
  convert({});
  const ProgramRun run = run_aisle({"go", at("building.json"), "2,0", "1,0", "--world", "small-office",
                                    "--vehicle", "turtlebot", "--out", at("driven"), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
  const auto topics = run_aisle({"info", at("driven"), "--json"}).json()["figures"]["topics"];
  const auto goals =
      std::find_if(topics.begin(), topics.end(), [](const auto& topic) { return topic["name"] == "/goals"; });
  ASSERT_NE(goals, topics.end());
  EXPECT_EQ((*goals)["messages"], 3) << "none, one and both are reached";
}

TEST_F(GoInAMap, PlacesWhereNothingCanDriveAreRefused) {
  EXPECT_THAT(convert({"--place", "desk=300,2"}), IsRefused("'desk' at 300,2 is not on floor"));
  file("mask.pgm", mask_pgm(-2, -2, 2, 2));
  EXPECT_THAT(convert({"--keep-out", file("mask.yaml", kMask)}),
              IsRefused("'home' at 0,0 lies in a keep-out zone; missions begin at home"));
  EXPECT_THAT(run_aisle({"convert", file("plan.pgm", "P2\n1 1\n255\n0\n"), "--building", "-o", at("b.json"),
                         "--json"}),
              IsRefused("plan.pgm"));
}

}  // namespace
}  // namespace aisle
