#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "building_texts.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string corridors_with(const std::string& passage, const std::string& other) {
  return golden_building("building_corridors.v3.json", passage, other);
}

Building any_explored_building(Random& random) {
  const auto any_point = [&] { return Vec2(random.uniform(-90, 90), random.uniform(-90, 90)); };
  Building building{.name = "explored"};
  for (std::size_t i = 0; i < 1 + random.index(5); ++i) {
    building.corridors.nodes.push_back({static_cast<CorridorNode::Kind>(random.index(3)), any_point()});
    const bool has_heading = random.uniform() < 0.5;
    building.places.push_back({"place " + std::to_string(i),
                               {random.uniform(-9, 9), 1, has_heading ? random.uniform(-3, 3) : 0},
                               has_heading});
  }
  const auto& nodes = building.corridors.nodes;
  for (std::size_t i = 0; i < random.index(6); ++i) {
    const std::size_t from = random.index(nodes.size()), to = random.index(nodes.size());
    building.corridors.corridors.push_back(
        {from, to, {nodes[from].p_map, any_point(), nodes[to].p_map}, random.uniform(0.5, 9)});
  }
  building.floor.emplace();
  for (int i = 0; i < 200; ++i) {
    const FloorCell cell{static_cast<int>(random.index(50)) - 40, static_cast<int>(random.index(30))};
    building.floor->set(cell, random.uniform() < 0.5 ? Floor::kFree : Floor::kOccupied);
  }
  return building;
}

TEST(BuildingCorridors, APlaceWithoutAHeadingHasNone) {
  const std::string text = corridors_with(R"(, "heading_deg": 90})", "}");
  const auto building = parse_building(text, "places");
  ASSERT_TRUE(building.ok()) << to_string(building.problems());
  EXPECT_TRUE(building->places[0].has_heading);
  EXPECT_FALSE(building->places[1].has_heading);
  EXPECT_EQ(building->places[1].T_map_place.theta, 0);
  EXPECT_THAT(building_json(*building), HasSubstr(R"({"name": "lift", "at_m": [4, 6]})"));
}

TEST(BuildingCorridors, TheGoldenFileSaysWhatWasExplored) {
  const auto building = parse_building(golden_building("building_corridors.v3.json"), "golden");
  ASSERT_TRUE(building.ok()) << to_string(building.problems());
  const CorridorGraph& graph = building->corridors;
  ASSERT_EQ(graph.nodes.size(), 4U);
  EXPECT_EQ(graph.nodes[0].kind, CorridorNode::Kind::kCrossing);
  EXPECT_EQ(graph.name_of(3), "end 3");
  ASSERT_EQ(graph.corridors.size(), 3U);
  EXPECT_EQ(graph.corridors[2].to, 3U);
  EXPECT_EQ(graph.corridors[2].path.size(), 3U);
  EXPECT_EQ(graph.corridors[1].width_m, 1.6);
  ASSERT_EQ(building->places.size(), 2U);
  EXPECT_EQ(building->places[1].name, "lift");
  EXPECT_THAT(building->places[1].T_map_place, PoseNear(Pose2{4, 6, kPi / 2}, 1e-9, 1e-9));
  ASSERT_TRUE(building->floor);
  EXPECT_EQ(building->floor->at(FloorCell{-2, 7}), Floor::kOccupied);
  EXPECT_EQ(building->floor->at(FloorCell{0, 8}), Floor::kFree);
  EXPECT_EQ(building->floor->at(FloorCell{0, 9}), Floor::kUnknown);
  EXPECT_EQ(building->floor->at(FloorCell{2, 11}), Floor::kFree);
  EXPECT_EQ(building->floor->count(Floor::kFree), 5U);
  EXPECT_EQ(building_json(*building), golden_building("building_corridors.v3.json"));
}

RC_GTEST_PROP(BuildingCorridors, WhatIsReadIsWrittenAgainToTheLastByte, (std::uint64_t seed)) {
  Random random(seed);
  const std::string written = building_json(any_explored_building(random));
  const auto read = parse_building(written, "written");
  RC_ASSERT(read.ok());
  RC_ASSERT(building_json(*read) == written);
}

RC_GTEST_PROP(BuildingCorridors, EveryCellOfTheFloorComesBack, (std::uint64_t seed)) {
  Random random(seed);
  const Building building = any_explored_building(random);
  const auto read = parse_building(building_json(building), "written");
  RC_ASSERT(read.ok());
  for (int y = -2; y < 35; ++y) {
    for (int x = -45; x < 15; ++x)
      RC_ASSERT(read->floor->at(FloorCell{x, y}) == building.floor->at(FloorCell{x, y}));
  }
}

TEST(BuildingCorridors, BadCorridorsNameTheirKeys) {
  EXPECT_THAT(building_problems(corridors_with("\"kind\": \"end\"", "\"kind\": \"door\"")),
              HasSubstr("b.json: corridors.nodes[1].kind: is none of"));
  EXPECT_THAT(building_problems(corridors_with("\"from\": 1", "\"from\": 4")),
              HasSubstr("corridors.corridors[0].from: is not a whole number from 0 to 3"));
  EXPECT_THAT(building_problems(corridors_with("[[0.5, 0], [4, 0]]", "[[0.5, 0]]")),
              HasSubstr("corridors.corridors[0].path_m: has less than two points"));
  EXPECT_THAT(building_problems(corridors_with("[[0.5, 0], [4, 0]]", "[[0.5, 0], [4, 1]]")),
              HasSubstr("corridors.corridors[0].path_m: does not lead from the node `from`"));
  EXPECT_THAT(building_problems(corridors_with("\"length_m\": 6.25", "\"way_m\": [[4, 0], [4, 6.25]]")),
              HasSubstr("corridors.corridors[1].way_m: is the former name of `path_m`"));
  EXPECT_THAT(building_problems(corridors_with("\"length_m\": 6.25", "\"length_m\": 7")),
              HasSubstr("corridors.corridors[1].length_m: is not the length of the path, 6.25"));
  EXPECT_THAT(building_problems(corridors_with("\"width_m\": 1.6", "\"width_m\": -1")),
              HasSubstr("corridors.corridors[1].width_m: is not a number from 0"));
  EXPECT_THAT(building_problems(
                  R"({"format": "aisle.building", "version": 1, "corridors": {"nodes": [], "corridors": [
                          {"from": 0, "to": 0, "width_m": 1, "path_m": [[0, 0], [1, 0]]}]}})"),
              HasSubstr("corridors.corridors[0]"));
}

TEST(BuildingCorridors, BadPlacesNameTheirKeys) {
  EXPECT_THAT(building_problems(corridors_with("\"name\": \"lift\"", "\"name\": \"home\"")),
              HasSubstr("places[1]: has the name of another place, 'home'"));
  EXPECT_THAT(building_problems(corridors_with("\"heading_deg\": 90", "\"heading_deg\": 900")),
              HasSubstr("places[1].heading_deg: is not a number from -360 to 360"));
}

TEST(BuildingCorridors, BadFloorsNameTheirRows) {
  EXPECT_THAT(building_problems(corridors_with("\"1#3.1#\"", "\"1#3.1\"")),
              HasSubstr("floor.rows[1]: is not a row of runs"));
  EXPECT_THAT(building_problems(corridors_with("\"1#3.1#\"", "\"0#\"")),
              HasSubstr("floor.rows[1]: is not a row of runs"));
  EXPECT_THAT(building_problems(corridors_with("\"1#3.1#\"", "\"99999999999999999999#\"")),
              HasSubstr("floor.rows[1]"));
  EXPECT_THAT(building_problems(corridors_with("\"1#3.1#\"", "\"16386#\"")), HasSubstr("floor.rows[1]"));
  EXPECT_THAT(building_problems(corridors_with("\"cell_m\": 0.05", "\"cell_m\": 0")),
              HasSubstr("floor.cell_m: is not a number from 0.01 to 1"));
  EXPECT_THAT(building_problems(corridors_with("[-2, 7]", "[-2, 70000]")),
              HasSubstr("floor.low_cell[1]: is not a whole number"));
}

TEST(BuildingCorridors, AFloorLargerThanCanBeIsRefusedBeforeItIsFilled) {
  std::string rows = "\"16384.\"";
  for (int i = 0; i < 5000; ++i) rows += ",\"1.\"";
  EXPECT_THAT(building_problems(corridors_with("\"5#\"", rows)),
              HasSubstr("floor.rows: are more than 40000000 cells in total"));
}

}  // namespace
}  // namespace aisle
