#include "aisle/formats/images/bee_map.hpp"

#include <gmock/gmock.h>

#include "aisle/formats/images/cell_map.hpp"
#include "session_samples.hpp"
#include "written_file.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

const std::string kBeeHead =
    "robot_specifications->global_mapsize_x   30\nrobot_specifications->resolution   10\n\n";
/// Two columns of three cells: the first unknown, occupied, free; the second free, free, neither.
const std::string kBeeCells = "global_map[0]: 2 3\n-1.000 0.010 0.990\n1.000 0.900 0.500\n";

TEST(BeeMap, HasItsCellsColumnByColumnFromTheLowerLeftCorner) {
  ASSERT_TRUE(begins_bee_map(kBeeHead + kBeeCells));
  const auto map = parse_bee_map(kBeeHead + kBeeCells, "wean.dat");
  ASSERT_TRUE(map.ok()) << to_string(map.problems());
  const FloorPlan& plan = map->plan;
  EXPECT_EQ(plan.width, 2);
  EXPECT_EQ(plan.height, 3);
  EXPECT_DOUBLE_EQ(plan.cell_m, 0.1);
  const auto seen = [&](int x, int y) {
    return map->unseen[plan.index(x, y)] != 0 ? '?' : plan.is_solid(x, y) ? '#' : '.';
  };
  EXPECT_EQ(std::string({seen(0, 2), seen(1, 2)}), ".?") << "the top row";
  EXPECT_EQ(std::string({seen(0, 1), seen(1, 1)}), "#.");
  EXPECT_EQ(std::string({seen(0, 0), seen(1, 0)}), "?.");
  EXPECT_TRUE(plan.is_solid(1, 2)) << "what nobody has seen is no floor";
}

TEST(BeeMap, WhatIsWrongIsSaidWithItsLine) {
  const auto problems = [](const std::string& text) {
    return to_string(parse_bee_map(text, "m.dat").problems());
  };
  EXPECT_THAT(problems(kBeeHead), HasSubstr("m.dat:3: ends without 'global_map[0]:'"));
  EXPECT_THAT(problems(kBeeCells), HasSubstr("m.dat:1: needs 'robot_specifications->resolution' above"));
  EXPECT_THAT(problems(kBeeHead + "global_map[0]: 2 30000\n"), HasSubstr("m.dat:4: "));
  EXPECT_THAT(problems(kBeeHead + "global_map[0]: 2 3\n1 1 1\n1 red 1\n"),
              HasSubstr("m.dat:6: 'red' is not a prob"));
  EXPECT_THAT(problems(kBeeHead + "global_map[0]: 2 3\n1 1 1\n1 1\n"), HasSubstr("ends after 5 of 6 cells"));
  EXPECT_THAT(problems(kBeeHead + "global_map[0]: 2 3\n1 1 1\n1 1 1 1\n"),
              HasSubstr("m.dat:6: has more than 2 x 3"));
  EXPECT_THAT(problems(kBeeHead + "global_map[0]: 2 3\n1 1 1\n1 nan 1\n"), HasSubstr("'nan' is not a prob"));
}

TEST(BeeMap, IsReadWhereAMapOfCellsIs) {
  const SessionPlace place;
  write_file(place / "wean.dat", kBeeHead + kBeeCells);
  const auto map = read_cell_map(place / "wean.dat");
  ASSERT_TRUE(map.ok()) << to_string(map.problems());
  EXPECT_EQ(map->plan.width, 2);
}

}  // namespace
}  // namespace aisle
