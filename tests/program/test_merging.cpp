#include <gmock/gmock.h>

#include "workplace.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// A corridor without a mark, as a building file: nothing tells where along it a map begins.
constexpr const char* kBareCorridor = R"({"format": "aisle.building", "version": 3, "name": "corridor",
  "walls": [{"start_m": [0, 0], "end_m": [20, 0]}, {"start_m": [20, 2], "end_m": [0, 2]}],
  "floor": {"cell_m": 1, "low_cell": [0, 0], "rows": ["20.", "20."]}})";

using Merging = Workplace;
using MergingOfALog = WorkplaceWithLog;

TEST_F(MergingOfALog, AMapHasNotChangedAgainstItselfAndIsTheWholeOfItself) {
  ASSERT_EQ(run_aisle({"map", log(), "--out", at("map"), "--json"}).exit_code, 0);
  const std::string building = at("map/building.json");
  const ProgramRun diff = run_aisle({"diff", building, building, "--out", at("changes"), "--json"});
  ASSERT_EQ(diff.exit_code, 0) << diff.out << diff.err;
  const auto figures = diff.json()["figures"];
  EXPECT_EQ(figures["alignment"]["verdict"], "found");
  EXPECT_LT(figures["alignment"]["rival_share"], 0.3);
  EXPECT_GT(figures["walls_m"]["kept"], 100);
  EXPECT_EQ(figures["walls_m"]["new"], 0);
  EXPECT_EQ(figures["walls_m"]["gone"], 0);
  EXPECT_EQ(figures["doors"].size(), 0u);
  EXPECT_THAT(read_bytes(at("changes/changes.svg")), HasSubstr("<svg"));

  const ProgramRun merge = run_aisle({"merge", building, building, "--out", at("whole"), "--json"});
  ASSERT_EQ(merge.exit_code, 0) << merge.out << merge.err;
  EXPECT_NEAR(merge.json()["figures"]["parts"][1]["x_m"].get<double>(), 0, 0.01);
  EXPECT_EQ(run_aisle({"show", at("whole/building.json")}).exit_code, 0);
}

TEST_F(Merging, AMapWithoutAFloorIsRefusedAndSaysHowToKeepOne) {
  const std::string bare = file("bare.json", R"({"format": "aisle.building", "version": 3, "name": "x",
    "walls": [{"start_m": [0, 0], "end_m": [20, 0]}]})");
  for (const char* verb : {"diff", "merge"}) {
    const ProgramRun run = run_aisle({verb, bare, bare});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("bare.json: floor: is missing"));
    EXPECT_THAT(run.err, HasSubstr("maps of logs have one"));
  }
}

TEST_F(Merging, WhatCannotBeAlignedIsABadResultThatSaysWhy) {
  const std::string corridor = file("corridor.json", kBareCorridor);
  const ProgramRun diff = run_aisle({"diff", corridor, corridor, "--json"});
  EXPECT_EQ(diff.exit_code, 1) << diff.err;
  EXPECT_EQ(diff.json()["ok"], false);
  EXPECT_NE(diff.json()["figures"]["alignment"]["verdict"], "found");
  const ProgramRun merge = run_aisle({"merge", corridor, corridor, "--out", at("whole")});
  EXPECT_EQ(merge.exit_code, 1);
  EXPECT_THAT(merge.out, HasSubstr("not merged"));
  EXPECT_TRUE(names_in(at("whole")).empty());
}

TEST_F(Merging, OneMapIsNotMerged) {
  EXPECT_EQ(run_aisle({"merge", at("map.json")}).exit_code, 2);
}

}  // namespace
}  // namespace aisle
