#include <gmock/gmock.h>

#include <algorithm>

#include "workplace.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A scripted person drives the cart while faults occur.
class Scenarios : public Workplace {
 protected:
  ProgramRun drive(const std::string& world, const std::string& scenario) const {
    return run_aisle(
        {"drive", world, "--faults", scenario, "--operator", "scripted", "--no-images", "--json"});
  }
};

TEST_F(Scenarios, ABlockedCorridorMakesThePersonGiveUpInFrontOfIt) {
  const ProgramRun run = drive("crossings", "blocked-corridor");
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["state"], "given up");
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_NEAR(figures["distance_m"], 16 - 0.3 - 0.95 - 4, 0.5);  // from x = 4 m until the front is at the box
}

TEST_F(Scenarios, ACrossingPersonIsWaitedFor) {
  const auto usual = drive("crossings", "laser-off").json()["figures"];
  const ProgramRun run = drive("crossings", "person-crossing");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["state"], "ended");
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_GT(figures["duration_s"], usual["duration_s"]);
}

TEST_F(Scenarios, AKidnappedVehicleGoesOnWhereItWasPutDown) {
  const auto usual = drive("crossings", "laser-off").json()["figures"];
  const ProgramRun run = drive("crossings", "lifted");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["collisions"], 0);
  // The path from x = 7 m round the corner up to y = 6 m was not driven.
  EXPECT_NEAR(usual["distance_m"].get<double>() - figures["distance_m"].get<double>(), 21.1 - 7 + 6 - 1.1,
              1.5);
}

TEST_F(Scenarios, PlacesMeanNothingInAnotherWorld) {
  EXPECT_THAT(drive("l-corridor", "lifted"),
              IsRefused("lifted: world: the scenario is for the world 'crossings', this is 'l-corridor'"));
}

TEST_F(Scenarios, DroppedImagesAreMissing) {
  file("keys.txt", "0-12.5 up\n");
  const ProgramRun run = run_aisle({"drive", "mini-corridor", "--vehicle", "mini", "--keys", at("keys.txt"),
                                    "--faults", "camera-dropped", "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_NEAR(figures["cycles"].get<int>() - figures["pictures"].get<int>(), 20, 1);
}

TEST_F(Scenarios, EveryShippedOneRuns) {
  for (const std::string& name : names_in(AISLE_SOURCE_DIR "/scenarios")) {
    const std::string scenario = fs::path(name).stem();
    const std::string text = read_bytes(AISLE_SOURCE_DIR "/scenarios/" + name);
    const auto belongs_to = [&](const std::string& world) {
      return text.find("world: " + world) != std::string::npos;
    };
    if (belongs_to("mini-corridor")) continue;  // test_sections.cpp
    const std::vector<std::string> worlds = {"crossings", "laboratory"};
    const auto own = std::find_if(worlds.begin(), worlds.end(), belongs_to);
    const ProgramRun run = drive(own == worlds.end() ? "l-corridor" : *own, scenario);
    EXPECT_LE(run.exit_code, 1) << scenario << run.err;
    EXPECT_GT(run.json()["figures"]["duration_s"], 20) << scenario;
  }
}

}  // namespace
}  // namespace aisle
