#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Parameters : public WorkplaceWithLog {
 protected:
  int walls(const Arguments& options) const {
    Arguments arguments = {"map", log(), "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_aisle(arguments).json()["figures"]["walls"].get<int>();
  }
};

TEST_F(Parameters, AnUnknownKeyIsRefused) {
  EXPECT_THAT(run_aisle({"map", log(), "--set", "juggle=1", "--json"}), IsRefused("juggle: unknown key"));
}

TEST_F(Parameters, AValueOutOfRangeIsRefusedWithTheRange) {
  EXPECT_THAT(run_aisle({"map", log(), "--set", "segments.range_max_m=9999", "--json"}),
              IsRefused("segments.range_max_m: 9999 is outside 1 .. 200"));
}

TEST_F(Parameters, ASettingWithoutAValueIsRefused) {
  EXPECT_THAT(run_aisle({"map", log(), "--set", "segments.range_max_m", "--json"}), IsRefused("key=value"));
}

TEST_F(Parameters, AllBadSettingsAreReportedAtOnce) {
  const ProgramRun run =
      run_aisle({"map", log(), "--set", "juggle=1", "--set", "segments.range_max_m=near", "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("juggle"), HasSubstr("segments.range_max_m: 'near' is not a number")));
}

TEST_F(Parameters, AllProblemsOfAFileAreReportedAtOnceWithTheirLines) {
  const std::string params = file("bad.yaml", "juggle: 1\nsegments:\n  range_max_m: 9999\n  colour: red\n");
  const ProgramRun run =
      run_aisle({"map", log(), "--params", params, "--set", "drawn_length_m=-1", "--json"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err,
              AllOf(HasSubstr(params + ":1: juggle"), HasSubstr(params + ":3: segments.range_max_m: 9999"),
                    HasSubstr(params + ":4: segments.colour"), HasSubstr("drawn_length_m: -1")));
  EXPECT_EQ(run.json()["ok"], false);
}

TEST_F(Parameters, AFileThatIsNoneIsRefused) {
  EXPECT_THAT(run_aisle({"map", log(), "--params", at("none.yaml"), "--json"}), IsRefused("no such file"));
  EXPECT_THAT(run_aisle({"map", log(), "--params", file("odd.yaml", "a: [1"), "--json"}),
              IsRefused(at("odd.yaml:")));
}

TEST_F(Parameters, PrintedParametersCanBeReadBack) {
  const ProgramRun printed = run_aisle({"map", "--print-params"});
  EXPECT_EQ(printed.exit_code, 0);
  const std::string params = file("printed.yaml", printed.out);
  ASSERT_EQ(run_aisle({"map", log(), "--out", at("defaults")}).exit_code, 0);
  ASSERT_EQ(run_aisle({"map", log(), "--params", params, "--out", at("printed")}).exit_code, 0);
  EXPECT_TRUE(read_bytes(at("defaults/building.json")) == read_bytes(at("printed/building.json")));
}

TEST_F(Parameters, PrintedParametersOfTheSimulatorCanBeReadBack) {
  const std::string params = file("printed.yaml", run_aisle({"sim", "log", "--print-params"}).out);
  ASSERT_EQ(run_aisle({"sim", "log", AISLE_SOURCE_DIR "/worlds/small-office.yaml", "--params", params,
                       "--out", at("printed")})
                .exit_code,
            0);
  EXPECT_TRUE(read_bytes(at("printed/simulated-trip.log")) == read_bytes(log()));
}

TEST_F(Parameters, ArePrintedToMachinesWithTheirRanges) {
  const auto map = run_aisle({"map", "--print-params", "--json"}).json();
  EXPECT_EQ(map["verb"], "map");
  const auto range_max = map["figures"]["params"]["segments.range_max_m"];
  EXPECT_GT(range_max["value"], range_max["min"]);
  EXPECT_EQ(range_max["min"], 1);
  EXPECT_EQ(range_max["max"], 200);
  EXPECT_THAT(range_max["doc"].get<std::string>(), Not(IsEmpty()));
  const auto sim = run_aisle({"sim", "log", "--print-params", "--json"}).json();
  EXPECT_EQ(sim["verb"], "sim log");
  EXPECT_EQ(sim["figures"]["params"]["scanner.beams"]["value"], 180);
  EXPECT_EQ(sim["figures"]["params"]["driver.turn_rate_max_deg_s"]["value"], 45);
}

TEST_F(Parameters, SettingsWinOverFilesAndLaterFilesOverEarlierOnes) {
  const std::string longer = file("longer.yaml", "drawn_length_m: 3\n");
  const std::string longest = file("longest.yaml", "drawn_length_m: 6\n");
  const int drawn_from_3_m = walls({"--set", "drawn_length_m=3"});
  const int drawn_from_6_m = walls({"--set", "drawn_length_m=6"});
  ASSERT_NE(drawn_from_3_m, drawn_from_6_m);
  EXPECT_EQ(walls({"--params", longest, "--set", "drawn_length_m=3"}), drawn_from_3_m);
  EXPECT_EQ(walls({"--params", longer, "--params", longest}), drawn_from_6_m);
}

}  // namespace
}  // namespace aisle
