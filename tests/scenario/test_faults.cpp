/// All faults of the shipped scenarios while a learned route is driven autonomously: the vehicle arrives, or
/// ends the mission with a reason, and never hits anything. Simulated.

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// The southern corridor of the world `crossings`, learned once for all tests.
class Faults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = std::make_unique<TemporaryDirectory>();
    const std::string shipped = read_bytes(AISLE_SOURCE_DIR "/worlds/crossings.yaml");
    write_bytes(at("crossings.yaml"),
                shipped.substr(0, shipped.find("\ntour:")) + "\ntour: [[4, 1.1], [17.5, 1.1]]\n");
    const ProgramRun taught =
        run_aisle({"teach", at("crossings.yaml"), "--operator", "scripted", "--out", at("taught")});
    ASSERT_EQ(taught.exit_code, 0) << taught.err;
    const ProgramRun learned = run_aisle({"learn", at("taught"), "--out", at("learned")});
    ASSERT_EQ(learned.exit_code, 0) << learned.err;
  }

  static void TearDownTestSuite() { directory_.reset(); }

  static std::string at(const std::string& name) { return (directory_->path() / name).string(); }

  static std::string scenario_with(const std::vector<std::string>& events) {
    std::string text = "format: aisle.scenario\nversion: 1\nname: faults\nevents:\n";
    for (const std::string& event : events) text += "  - " + event + "\n";
    return text;
  }

  ProgramRun drive(const std::string& scenario, const Arguments& more = {}) const {
    Arguments arguments = {"navigate", at("learned/building.json"),
                           "--world",  "crossings",
                           "--faults", scenario,
                           "--speed",  "0.5",
                           "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_aisle(arguments);
  }

  void expect_arrival(const std::string& scenario) const {
    const ProgramRun run = drive(scenario);
    EXPECT_EQ(run.exit_code, 0) << scenario << run.err << run.out;
    EXPECT_EQ(run.json()["figures"]["collisions"], 0) << scenario;
  }

  void expect_arrival_or_a_reason(const std::string& scenario) const {
    const ProgramRun run = drive(scenario);
    const auto figures = run.json()["figures"];
    EXPECT_EQ(run.exit_code, figures["arrived"] ? 0 : 1) << scenario << run.err;
    EXPECT_TRUE(figures["arrived"] || figures["why"] != "") << scenario;
    EXPECT_EQ(figures["collisions"], 0) << scenario;
  }

 private:
  static inline std::unique_ptr<TemporaryDirectory> directory_;
};

TEST_F(Faults, TheVehicleArrivesAlthoughItsCameraFailsForAWhile) {
  for (const char* scenario : {"camera-frozen", "camera-dark", "camera-dropped", "camera-late"})
    expect_arrival(scenario);
}

/// They are used where the vehicle was when they were taken: unused, a steering wheel off its zero would
/// drive it into the wall.
TEST_F(Faults, ImagesThatAlwaysComeLateKeepTheVehicleOnItsPathNevertheless) {
  write_bytes(at("late.yaml"), scenario_with({"{from_s: 4, camera: {fault: late, delay_s: 0.4}}",
                                              "{from_s: 4, steering: {bias_deg: 6}}"}));
  const ProgramRun run = drive(at("late.yaml"));
  EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_LT(figures["tracking"]["max_m"], 0.15);
}

TEST_F(Faults, ARunWhoseImagesAlwaysCameLateIsLearnedFrom) {
  write_bytes(at("late.yaml"), scenario_with({"{camera: {fault: late, delay_s: 0.4}}"}));
  const ProgramRun driven = run_aisle({"drive", at("crossings.yaml"), "--operator", "scripted", "--faults",
                                       at("late.yaml"), "--out", at("driven_late")});
  ASSERT_EQ(driven.exit_code, 0) << driven.err;
  const ProgramRun learned = run_aisle({"learn", at("driven_late"), "--out", at("learned_late")});
  ASSERT_EQ(learned.exit_code, 0) << learned.err;
  const ProgramRun run = run_aisle(
      {"navigate", at("learned_late/building.json"), "--world", "crossings", "--speed", "0.5", "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err << run.out;
  EXPECT_EQ(run.json()["figures"]["collisions"], 0);
}

TEST_F(Faults, WheelsThatCountHalfThePathStopTheVehicle) {
  write_bytes(at("wheels.yaml"), scenario_with({"{from_s: 4, slip: {spin: -0.5}}"}));
  const ProgramRun run = drive(at("wheels.yaml"));
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["state"], "slipping");
  EXPECT_THAT(figures["why"].get<std::string>(), HasSubstr("times the path that the camera sees"));
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_LT(figures["distance_m"], 8);
}

TEST_F(Faults, TheVehicleArrivesThroughChangesOfLightAndWithoutItsLineLasers) {
  for (const char* scenario : {"light-change", "laser-off"}) expect_arrival(scenario);
}

TEST_F(Faults, NeitherSlipNorSteeringErrorsDriveTheVehicleAgainstAnything) {
  for (const char* scenario : {"slip-burst", "steering-bias"}) expect_arrival_or_a_reason(scenario);
}

TEST_F(Faults, ABlockedCorridorEndsTheMissionBeforeTheVehicleHitsAnything) {
  const ProgramRun run = drive("blocked-corridor", {"--out", at("run")});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  const auto figures = run.json()["figures"];
  EXPECT_EQ(figures["state"], "blocked");
  EXPECT_THAT(figures["why"].get<std::string>(), HasSubstr("obstacle ahead"));
  EXPECT_EQ(figures["collisions"], 0);
  EXPECT_NEAR(figures["distance_m"], 16 - 0.3 - 0.8 - 0.95 - 4,
              0.2);  // from x = 4 m until 0.8 m before the box

  const auto replayed = run_aisle({"replay", at("run"), "--json"}).json()["figures"];
  EXPECT_EQ(replayed["different"], 0);
  EXPECT_EQ(replayed["compared"], replayed["cycles"]);
}

TEST_F(Faults, ACrossingPersonIsWaitedFor) {
  expect_arrival("person-crossing");
}

}  // namespace
}  // namespace aisle
