#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
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
  EXPECT_EQ(map_image_bytes(two_cells()), std::string("P5\n2 1\n255\n\0\xfe", 13));
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
  EXPECT_THROW(map_image_bytes(image), std::invalid_argument);
  EXPECT_THROW(map_image_bytes(OccupancyImage{}), std::invalid_argument);
}

std::string why(const Result<MapServerYaml>& map) {
  return map.ok() ? "" : to_string(map.problems());
}

const std::string kHead = "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n";

/// Which pixels of one row a map shows as free: 1 free, 0 solid.
std::string free_pixels(const TransparentImage& row, const std::string& more_yaml) {
  const auto map = parse_map_server_yaml(kHead + more_yaml, "map.yaml");
  if (!map) return to_string(map.problems());
  std::string free;
  const FloorPlan plan = plan_of_map(row, *map).plan;
  for (int x = 0; x < plan.width; ++x) free += plan.is_solid(x, 0) ? '0' : '1';
  return free;
}

TransparentImage row_of(const std::vector<std::uint8_t>& greys, std::vector<std::uint8_t> transparent = {}) {
  TransparentImage row{Image(static_cast<int>(greys.size()), 1), std::move(transparent)};
  row.image.bytes = greys;
  return row;
}

TEST(MapServerYaml, SaysWhereTheImageLies) {
  const auto map = parse_map_server_yaml(
      "image: a/floor.pgm\nresolution: 0.1\norigin: [-1.5, 2, 0.5]\nnegate: 1\noccupied_thresh: 0.6\n"
      "free_thresh: 0.25\nmode: scale\n",
      "map.yaml");
  ASSERT_TRUE(map.ok()) << why(map);
  EXPECT_EQ(map->image, "a/floor.pgm");
  EXPECT_EQ(map->resolution_m, 0.1);
  EXPECT_EQ(map->T_map_plan.x, -1.5);
  EXPECT_EQ(map->T_map_plan.theta, 0.5);
  EXPECT_TRUE(map->negate);
  EXPECT_EQ(map->free_below, 0.25);
  EXPECT_EQ(map->occupied_above, 0.6);
  EXPECT_EQ(map->mode, MapMode::kScale);
  EXPECT_THAT(map->warnings, testing::IsEmpty());
}

class OwnMaps : public testing::TestWithParam<MapMode> {};

INSTANTIATE_TEST_SUITE_P(Modes, OwnMaps, testing::Values(MapMode::kTrinary, MapMode::kScale, MapMode::kRaw),
                         [](const auto& mode) { return std::string(name_of(mode.param)); });

TEST_P(OwnMaps, AreReadAsTheyWereWritten) {
  OccupancyImage image = two_cells();
  image.width = 3;
  image.cells = {kCellOccupied, kCellFree, kCellUnknown};
  const auto map = parse_map_server_yaml(map_server_yaml(image, "map.pgm", GetParam()), "map.yaml");
  ASSERT_TRUE(map.ok()) << why(map);
  EXPECT_EQ(map->mode, GetParam());
  const auto pixels = parse_plan_pixels(map_image_bytes(image, GetParam()), "map.pgm");
  ASSERT_TRUE(pixels.ok()) << to_string(pixels.problems());
  const PlanReading reading = plan_of_map(*pixels, *map);
  EXPECT_TRUE(reading.plan.is_solid(0, 0));
  EXPECT_FALSE(reading.plan.is_solid(1, 0));
  EXPECT_TRUE(reading.plan.is_solid(2, 0));
  EXPECT_THAT(reading.unseen, testing::ElementsAre(0, 0, 1)) << "no wall: unknown";
  EXPECT_THAT(reading.warnings, testing::IsEmpty());
}

/// navigation2#2590: `mode: raw` was read as trinary, so that free (0) became a wall.
TEST(MapServerModes, RawValuesAreOccupancyInPercent) {
  EXPECT_EQ(free_pixels(row_of({0, 19, 20, 100, 101, 254, 255}), "mode: raw\n"), "1100000");
  EXPECT_EQ(free_pixels(row_of({0, 255}), "mode: raw\nnegate: 1\n"), "10") << "negate means nothing here";
}

TEST(MapServerModes, TrinaryAndScaleGoByTheThresholds) {
  for (const std::string mode : {"mode: trinary\n", "mode: scale\n"}) {
    EXPECT_EQ(free_pixels(row_of({0, 128, 204, 206, 255}), mode), "00011");
    EXPECT_EQ(free_pixels(row_of({0, 48, 128, 255}), mode + "negate: 1\n"), "1100");
    EXPECT_EQ(free_pixels(row_of({255, 255, 0}, {0, 1, 0}), mode), "100") << "transparent: unknown";
  }
  EXPECT_EQ(free_pixels(row_of({0, 255, 128}), "mode: grey\n"),
            "map.yaml:4: mode: 'grey' is not trinary, scale or raw");
}

/// navigation2#5138, #5278: map_saver's grey for unknown beside its own default threshold.
TEST(MapServerModes, TheUnknownGreyOfMapSaverIsUnknownWhateverTheThreshold) {
  const auto map = parse_map_server_yaml(kHead + "free_thresh: 0.25\n", "map.yaml");
  const PlanReading saved = plan_of_map(row_of({0, 205, 254, 255}), *map);
  EXPECT_TRUE(saved.plan.is_solid(1, 0));
  EXPECT_FALSE(saved.plan.is_solid(2, 0));
  EXPECT_THAT(to_string(saved.warnings), testing::HasSubstr("map.yaml:4: free_thresh: 0.25 makes grey 205 free"));
  const PlanReading drawn = plan_of_map(row_of({0, 205, 210, 220, 254}), *map);
  EXPECT_FALSE(drawn.plan.is_solid(1, 0)) << "a drawn map with other greys";
  EXPECT_THAT(to_string(drawn.warnings), testing::HasSubstr("taken as free"));
  EXPECT_EQ(free_pixels(row_of({0, 205, 254}), "mode: scale\nfree_thresh: 0.25\n"), "011");
}

TEST(MapServerYaml, BooleansAreYamlsOwn) {
  for (const std::string yes : {"1", "true", "True", "yes", "on"}) {
    EXPECT_EQ(free_pixels(row_of({0, 255}), "negate: " + yes + "\n"), "10") << yes;
  }
  for (const std::string no : {"0", "false", "False", "FALSE", "no"}) {
    EXPECT_EQ(free_pixels(row_of({0, 255}), "negate: " + no + "\n"), "01") << no;
  }
}

TEST(MapServerYaml, ARotationThatIsNoNumberIsNoneAndSaid) {
  for (const std::string nan : {"nan", "-nan", ".nan", "-.NaN"}) {
    const auto map =
        parse_map_server_yaml("image: a\nresolution: 1\norigin: [1, 2, " + nan + "]\n", "map.yaml");
    ASSERT_TRUE(map.ok()) << why(map);
    EXPECT_EQ(map->T_map_plan.theta, 0);
    EXPECT_EQ(to_string(map->warnings), "map.yaml:3: origin[2]: '" + nan + "' is not a number; 0 is taken");
  }
}

TEST(MapServerYaml, SwappedThresholdsAndDuplicateKeysAreNamed) {
  EXPECT_EQ(why(parse_map_server_yaml(kHead + "free_thresh: 0.65\noccupied_thresh: 0.196\n", "m")),
            "m:4: free_thresh: 0.65 is not below occupied_thresh, 0.196; are they swapped?");
  EXPECT_EQ(why(parse_map_server_yaml(kHead + "resolution: 0.2\n", "m")),
            "m:4: resolution: is given twice, first on line 2");
  const auto equal = parse_map_server_yaml(kHead + "free_thresh: 0.5\noccupied_thresh: 0.5\n", "m");
  ASSERT_TRUE(equal.ok());
  EXPECT_THAT(to_string(equal->warnings), testing::HasSubstr("m:4: free_thresh: 0.5 is not below"));
}

TEST(MapServerYaml, AnImageInTheHomeFolderIsFound) {
  std::string home = testing::TempDir() + "/home_XXXXXX";
  ASSERT_NE(::mkdtemp(home.data()), nullptr);
  const std::string before = std::getenv("HOME") ? std::getenv("HOME") : "";
  setenv("HOME", home.c_str(), 1);
  std::ofstream(home + "/a.pgm") << "P2\n1 1\n255\n254\n";
  std::ofstream(home + "/map.yaml") << "image: ~/a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n";
  const auto read = read_map_server(home + "/map.yaml");
  setenv("HOME", before.c_str(), 1);
  std::filesystem::remove_all(home);
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_FALSE(read->plan.is_solid(0, 0));
}

TEST(MapServerYaml, EveryProblemIsNamedWithItsLineAndKey) {
  const std::string problems =
      why(parse_map_server_yaml("image: []\nresolution: wide\norigin: [1, 2]\nnegate: 2\n", "map.yaml"));
  EXPECT_EQ(problems,
            "map.yaml:1: image: is not the name of an image\n"
            "map.yaml:2: resolution: 'wide' is not a number from 0.001 to 10\n"
            "map.yaml:3: origin: is not [x, y, rotation]\n"
            "map.yaml:4: negate: '2' is not 0, 1, true or false");
  EXPECT_EQ(why(parse_map_server_yaml("image: a.pgm\nresolution: 0.05\n", "m")), "m:1: origin: is missing");
  EXPECT_THAT(why(parse_map_server_yaml("- 1\n", "m")), testing::HasSubstr("is not a map"));
  EXPECT_THAT(why(parse_map_server_yaml("a: [", "m")), testing::HasSubstr("is not YAML"));
}

}  // namespace
}  // namespace aisle
