#include <gmock/gmock.h>

#include "golden_files.hpp"
#include "workplace.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The names of all values of a JSON object, nested ones prefixed with their parents' names:
/// "online.rotation_deg.mean".
void collect_keys(const nlohmann::ordered_json& json, const std::string& prefix, std::string& keys) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) {
      collect_keys(value, prefix + key + ".", keys);
    } else {
      keys += prefix + key + "\n";
    }
  }
}

std::string without_comments(const std::string& text) {
  return text.substr(text.find("\n\n") + 2);
}

class Map : public WorkplaceWithLog {};

TEST_F(Map, JsonHasTheWordsThatOthersRelyOn) {
  const ProgramRun run = run_aisle({"map", log(), "--relations", relations(), "--out", at("out"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::string keys;
  collect_keys(nlohmann::ordered_json::parse(run.out), "", keys);
  EXPECT_EQ(keys, without_comments(read_bytes(kGolden / "program/map.keys.txt")));
}

TEST_F(Map, FiguresAreThoseOfTheSimulatedRun) {
  const auto result = run_aisle({"map", log(), "--relations", relations(), "--json"}).json();
  EXPECT_EQ(result["verb"], "map");
  EXPECT_EQ(result["ok"], true);
  EXPECT_THAT(result["files"], IsEmpty());
  const auto& figures = result["figures"];
  EXPECT_EQ(figures["scans"], scan_lines(log_lines()).size());
  EXPECT_NEAR(figures["path_m"].get<double>(), 100, 5);
  EXPECT_GT(figures["walls"], 20);
  EXPECT_GT(figures["orthogonal_share"], 0.8);
  EXPECT_EQ(figures["no_dominant_direction"], false);
  EXPECT_GT(figures["loop_closures"], 0);
  EXPECT_GT(figures["cpu_s"], 0);
  EXPECT_GT(figures["realtime_factor"], 1);
  EXPECT_GT(figures["peak_rss_mb"], 1);
  EXPECT_GT(figures["relations"]["count"], 50);
  EXPECT_LT(figures["translation_m"]["mean"], 0.03);
  EXPECT_LT(figures["rotation_deg"]["mean"], 0.3);
  EXPECT_LT(figures["online"]["translation_m"]["mean"], 0.06);
}

TEST_F(Map, TextAndJsonTellTheSame) {
  const ProgramRun text = run_aisle({"map", log()});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.err, IsEmpty());
  const auto figures = run_aisle({"map", log(), "--json"}).json()["figures"];
  EXPECT_THAT(text.out, HasSubstr(figures["scans"].dump() + " scans"));
  EXPECT_THAT(text.out, HasSubstr(figures["walls"].dump() + " walls"));
}

TEST_F(Map, WritesTheFilesThatItNames) {
  const auto files = run_aisle({"map", log(), "--out", at("new/out"), "--json"}).json()["files"];
  EXPECT_THAT(names_in(at("new/out")),
              ElementsAre("building.json", "map.pgm", "map.png", "map.svg", "map.yaml", "trajectory.tum"));
  EXPECT_EQ(files.size(), 6);
  for (const std::string path : files) EXPECT_THAT(read_bytes(path), Not(IsEmpty())) << path;
}

TEST_F(Map, TheBuildingKeepsItsFloorUnlessToldNotTo) {
  run_aisle({"map", log(), "--out", at("whole")});
  EXPECT_THAT(read_bytes(at("whole/building.json")), HasSubstr("\"floor\""));
  run_aisle({"map", log(), "--no-floor", "--out", at("walls")});
  EXPECT_THAT(read_bytes(at("walls/building.json")), Not(HasSubstr("\"floor\"")));
  EXPECT_EQ(read_bytes(at("walls/map.pgm")), read_bytes(at("whole/map.pgm")));
}

TEST_F(Map, TheMapOfCellsIsWrittenInTheModeAskedFor) {
  run_aisle({"map", log(), "--out", at("raw"), "--map-mode", "raw"});
  EXPECT_THAT(read_bytes(at("raw/map.yaml")), HasSubstr("mode: raw"));
  run_aisle({"map", log(), "--out", at("scale"), "--map-mode", "scale"});
  EXPECT_THAT(read_bytes(at("scale/map.yaml")), HasSubstr("image: map-cells.png"));
  EXPECT_THAT(read_bytes(at("scale/map-cells.png")), HasSubstr("PNG"));
}

TEST_F(Map, TheTrajectoryHasOnePoseAtEveryScan) {
  run_aisle({"map", log(), "--out", at("out")});
  const std::string text = read_bytes(at("out/trajectory.tum"));
  std::size_t poses = 0;
  for (std::size_t start = 0; start < text.size(); start = text.find('\n', start) + 1)
    poses += text[start] != '#';
  EXPECT_EQ(poses, scan_lines(log_lines()).size());
}

TEST_F(Map, SameInputsGiveTheSameFiles) {
  run_aisle({"map", log(), "--out", at("first")});
  run_aisle({"map", log(), "--out", at("second")});
  ASSERT_THAT(names_in(at("first")), Not(IsEmpty()));
  for (const std::string& name : names_in(at("first"))) {
    EXPECT_TRUE(read_bytes(at("first/" + name)) == read_bytes(at("second/" + name))) << name;
  }
}

TEST_F(Map, PublishedRulesMakeAMapOfTheirOwn) {
  const auto published = run_aisle({"map", log(), "--rules", "published", "--json"}).json()["figures"];
  const auto refined = run_aisle({"map", log(), "--rules", "refined", "--json"}).json()["figures"];
  EXPECT_EQ(published["loop_closures"], 0);
  EXPECT_GT(published["walls"], 0);
  EXPECT_NE(published["walls"], refined["walls"]);
}

TEST_F(Map, StagesBeginWithOdometryAndEndWithTheMap) {
  const auto figures =
      run_aisle({"map", log(), "--relations", relations(), "--stages", "--json"}).json()["figures"];
  const auto& stages = figures["stages"];
  ASSERT_GE(stages.size(), 3);
  EXPECT_EQ(stages.front()["stage"], "odometry");
  EXPECT_EQ(stages.back()["translation_m"], figures["translation_m"]);
  EXPECT_LT(stages.back()["translation_m"]["mean"], stages.front()["translation_m"]["mean"]);
}

TEST_F(Map, TheOdometryCanBeLeftAside) {
  const auto by_scans = run_aisle({"map", log(), "--odometry", "none", "--json"}).json()["figures"];
  EXPECT_EQ(by_scans["trust"], "good");
  EXPECT_THAT(by_scans["warnings"].dump(), HasSubstr("there is no odometry: mapped by the scans alone"));
  EXPECT_NEAR(by_scans["path_m"].get<double>(), 100, 5);
}

TEST_F(Map, ALogHasNoTopicsToChoose) {
  const ProgramRun run = run_aisle({"map", log(), "--scan", "/scan", "--odometry", "/odom", "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("--scan is for bags"), HasSubstr("only none is for logs")));
}

TEST_F(Map, InfoTellsWhatALogHolds) {
  const auto figures = run_aisle({"info", log(), "--json"}).json()["figures"];
  EXPECT_EQ(figures["scans"], scan_lines(log_lines()).size());
  EXPECT_GT(figures["odometry"], 0);
  EXPECT_GT(figures["duration_s"], 0);
}

TEST_F(Map, ALogWithOneScanIsMapped) {
  const auto lines = log_lines();
  const ProgramRun run =
      run_aisle({"map", log_of("one.log", {lines[scan_lines(lines).front()]}), "--out", at("out"), "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.json()["figures"]["scans"], 1);
  EXPECT_THAT(names_in(at("out")), Not(IsEmpty()));
}

TEST_F(Map, CompareSaysHowFarATrajectoryIsOff) {
  ASSERT_EQ(run_aisle({"map", log(), "--out", at("out")}).exit_code, 0);
  const std::string path = at("out/trajectory.tum");
  const ProgramRun same = run_aisle({"compare", path, path, "--out", at("compared"), "--json"});
  ASSERT_EQ(same.exit_code, 0) << same.err;
  const auto figures = same.json()["figures"];
  EXPECT_LT(figures["position_m"]["max"].get<double>(), 1e-6);
  EXPECT_EQ(figures["without_truth"], 0);
  EXPECT_THAT(names_in(at("compared")), ElementsAre("compared.png", "compared.svg"));
  EXPECT_THAT(run_aisle({"compare", path, at("none"), "--json"}), IsRefused("none: no such file"));
  EXPECT_THAT(run_aisle({"compare", path, file("far.tum", "1 0 0 0 0 0 0 1\n"), "--json"}),
              IsRefused("have a true pose within 0.25 s"));
}

TEST_F(Map, OfARecordingInAnArchiveIsThatOfTheRecordingAndNamesItByItsPlace) {
  const std::string packed = at("packed.tar.gz");
  ASSERT_EQ(std::system(("tar -czf " + packed + " -C " + at("sim") + " simulated-trip.log").c_str()), 0);
  const ProgramRun alone = run_aisle({"map", log(), "--json"});
  const ProgramRun unpacked = run_aisle({"map", packed, "--json"});
  ASSERT_EQ(unpacked.exit_code, alone.exit_code) << unpacked.err;
  EXPECT_EQ(unpacked.json()["figures"]["walls"], alone.json()["figures"]["walls"]);
  EXPECT_THAT(unpacked.out + unpacked.err, Not(HasSubstr("aisle-unpacked-")));
  EXPECT_EQ(run_aisle({"info", packed}).exit_code, 0);
}

}  // namespace
}  // namespace aisle
