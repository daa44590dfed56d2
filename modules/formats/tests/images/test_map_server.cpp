#include <gmock/gmock.h>

#include <stdexcept>

#include "aisle/formats/images/map_server.hpp"

namespace aisle {
namespace {

/// Two cells wide, one high: a wall, then free floor.
OccupancyImage two_cells() {
  OccupancyImage image;
  image.width = 2;
  image.height = 1;
  image.origin_m = {-1.5, 2};
  image.cells = {kCellOccupied, kCellFree};
  return image;
}

TEST(MapServer, TheImageIsABinaryPgm) {
  EXPECT_EQ(pgm_bytes(two_cells()), std::string("P5\n2 1\n255\n\0\xfe", 13));
}

TEST(MapServer, TheYamlFileNamesImageResolutionAndLowerLeftCorner) {
  EXPECT_EQ(map_server_yaml(two_cells(), "map.pgm"),
            "image: map.pgm\n"
            "resolution: 0.05\n"
            "origin: [-1.500000, 2.000000, 0.0]\n"
            "negate: 0\n"
            "occupied_thresh: 0.65\n"
            "free_thresh: 0.196\n");
}

/// map_server's rule: occupancy p = (255 - value) / 255, compared with the two thresholds.
TEST(MapServer, TheThresholdsTellTheThreeKindsOfCellsApart) {
  const auto occupancy = [](std::uint8_t value) { return (255.0 - value) / 255; };
  EXPECT_GT(occupancy(kCellOccupied), 0.65);
  EXPECT_LT(occupancy(kCellFree), 0.196);
  EXPECT_GT(occupancy(kCellUnknown), 0.196);
  EXPECT_LT(occupancy(kCellUnknown), 0.65);
}

TEST(MapServer, CellsMustFillTheImage) {
  OccupancyImage image = two_cells();
  image.cells.push_back(kCellFree);
  EXPECT_THROW(pgm_bytes(image), std::invalid_argument);
  EXPECT_THROW(pgm_bytes(OccupancyImage{}), std::invalid_argument);
}

std::string why(const Result<MapServerYaml>& map) {
  return map.ok() ? "" : to_string(map.problems());
}

TEST(MapServerYaml, SaysWhereTheImageLies) {
  const auto map = parse_map_server_yaml(
      "image: a/floor.pgm\nresolution: 0.1\norigin: [-1.5, 2, 0.5]\nnegate: 1\noccupied_thresh: 0.6\n"
      "free_thresh: 0.25\nmode: trinary\n",
      "map.yaml");
  ASSERT_TRUE(map.ok()) << why(map);
  EXPECT_EQ(map->image, "a/floor.pgm");
  EXPECT_EQ(map->resolution_m, 0.1);
  EXPECT_EQ(map->T_map_plan.x, -1.5);
  EXPECT_EQ(map->T_map_plan.theta, 0.5);
  EXPECT_TRUE(map->thresholds.negate);
  EXPECT_EQ(map->thresholds.free_below, 0.25);
}

TEST(MapServerYaml, OurOwnMapsAreRead) {
  const auto map = parse_map_server_yaml(map_server_yaml(two_cells(), "map.pgm"), "map.yaml");
  ASSERT_TRUE(map.ok()) << why(map);
  const auto plan = parse_plan_image(pgm_bytes(two_cells()), "map.pgm", map->resolution_m, map->thresholds);
  ASSERT_TRUE(plan.ok());
  EXPECT_TRUE(plan->is_solid(0, 0));
  EXPECT_FALSE(plan->is_solid(1, 0));
}

TEST(MapServerYaml, EveryProblemIsNamedWithItsLineAndKey) {
  const std::string problems =
      why(parse_map_server_yaml("image: []\nresolution: wide\norigin: [1, 2]\nnegate: 2\n", "map.yaml"));
  EXPECT_EQ(problems,
            "map.yaml:1: image: is not the name of an image\n"
            "map.yaml:2: resolution: 'wide' is not a number from 0.001 to 10\n"
            "map.yaml:3: origin: is not [x, y, rotation]\n"
            "map.yaml:4: negate: '2' is not 0 or 1");
  EXPECT_EQ(why(parse_map_server_yaml("image: a.pgm\nresolution: 0.05\n", "m")), "m:1: origin: is missing");
  EXPECT_THAT(why(parse_map_server_yaml("- 1\n", "m")), testing::HasSubstr("is not a map"));
  EXPECT_THAT(why(parse_map_server_yaml("a: [", "m")), testing::HasSubstr("is not YAML"));
}

}  // namespace
}  // namespace aisle
