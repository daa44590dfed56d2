#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "aisle/core/random.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/world_yaml.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kHead = "format: aisle.world\nversion: 1\n";

std::string problems_of(const std::string& text) {
  const Result<World> world = parse_world(text, "w.yaml");
  return world ? std::string() : to_string(world.problems());
}

TEST(WorldYaml, ReadsWallsBoxesAndTour) {
  const Result<World> world = parse_world(std::string(kHead) +
                                              "name: closet\n"
                                              "walls:\n"
                                              "  - [[0, 0], [3, 0], [3, 2]]\n"
                                              "boxes:\n"
                                              "  - {centre: [1, 1], size: [1, 0.5], heading_deg: 90}\n"
                                              "tour: [[0.5, 0.5], [2.5, 0.5]]\n",
                                          "w.yaml");
  ASSERT_TRUE(world.ok()) << to_string(world.problems());
  EXPECT_EQ(world->name, "closet");
  ASSERT_THAT(world->walls, SizeIs(2));
  EXPECT_THAT(world->walls[1].foot.end, PointNear(Vec2(3, 2), 1e-12));
  ASSERT_THAT(world->furniture, SizeIs(1));
  EXPECT_THAT(world->furniture[0].size, PointNear(Vec2(1, 0.5), 1e-12));
  EXPECT_DOUBLE_EQ(world->furniture[0].heading_rad, 90 * kDegree);
  ASSERT_THAT(world->tour, SizeIs(2));
  EXPECT_THAT(world->tour[1], PointNear(Vec2(2.5, 0.5), 1e-12));
}

TEST(WorldYaml, ReportsEveryProblemWithItsLineAndKey) {
  EXPECT_EQ(problems_of("format: aisle.world\n"
                        "version: 2\n"
                        "walls:\n"
                        "  - [[0, 0], [.nan, 0]]\n"
                        "  - [[1, 1]]\n"
                        "  - [[0, 0], [1e9, 0], [x, 1]]\n"
                        "  - [[2, 2], [2, 2]]\n"
                        "boxes:\n"
                        "  - {centre: [1, 1], size: [0, 1]}\n"
                        "  - {center: [1, 1], size: [1, 1]}\n"
                        "door: 3\n"
                        "tour: 5\n"),
            "w.yaml:2: version: is not 1, the only version so far\n"
            "w.yaml:4: walls[0][1]: '.nan' is not a number\n"
            "w.yaml:5: walls[1]: a wall needs at least two points\n"
            "w.yaml:6: walls[2][1]: 1e9 is outside -10000 .. 10000\n"
            "w.yaml:6: walls[2][2]: 'x' is not a number\n"
            "w.yaml:7: walls[3]: the point [2, 2] stands there twice in succession\n"
            "w.yaml:9: boxes[0].size: is not positive\n"
            "w.yaml:10: boxes[1].center: unknown key (known: centre, size, heading_deg)\n"
            "w.yaml:10: boxes[1].centre: is missing\n"
            "w.yaml:11: door: unknown key (known: format, version, name, walls, boxes, tour)\n"
            "w.yaml:12: tour: is not a list");
}

TEST(WorldYaml, RefusesWhatIsNoWorld) {
  EXPECT_THAT(problems_of(""), HasSubstr("is not a world"));
  EXPECT_THAT(problems_of("[1, 2"), HasSubstr("w.yaml:1: is not YAML"));
  EXPECT_THAT(problems_of("name: empty\n"),
              AllOf(HasSubstr("format: is missing"), HasSubstr("walls: is missing")));
  EXPECT_THAT(problems_of(std::string(kHead) + "walls: []\nwalls: []\n"), HasSubstr("stands there twice"));
  EXPECT_THAT(problems_of(std::string(kHead) + "walls: []\ntour: [[1, 1]]\n"),
              HasSubstr("two different points"));
}

TEST(WorldYaml, RefusesMoreWallsThanAnyBuildingHas) {
  std::string text = std::string(kHead) + "walls:\n  - &long [";
  for (int i = 0; i < 1000; ++i) text += "[" + std::to_string(i) + ", 0], ";
  text += "]\n";
  for (int i = 0; i < 1000; ++i) text += "  - *long\n";
  EXPECT_THAT(problems_of(text), HasSubstr("at most 200000 are read"));
}

RC_GTEST_PROP(WorldYaml, WhatIsWrittenIsReadAgain, (std::uint64_t seed)) {
  Random random(seed);
  const auto millimetres = [&] { return (static_cast<double>(random.index(20'000)) - 10'000) / 1000; };
  World written{.name = "a \"name\": with\nsigns"};
  written.walls.resize(random.index(30));
  written.tour.resize(random.index(2) * 9);
  for (std::size_t i = 0; i < written.walls.size(); ++i) {
    const bool goes_on = i > 0 && random.index(2) == 0;
    written.walls[i].foot = {goes_on ? written.walls[i - 1].foot.end : Vec2(millimetres(), millimetres()),
                             Vec2(millimetres(), millimetres())};
  }
  for (Vec2& point : written.tour) point = {millimetres(), millimetres()};

  const Result<World> read = parse_world(world_yaml(written), "w.yaml");
  RC_ASSERT(read.ok());
  RC_ASSERT(read->name == written.name);
  RC_ASSERT(read->tour == written.tour);
  RC_ASSERT(read->walls.size() == written.walls.size());
  for (std::size_t i = 0; i < written.walls.size(); ++i) {
    RC_ASSERT(read->walls[i].foot.start == written.walls[i].foot.start);
    RC_ASSERT(read->walls[i].foot.end == written.walls[i].foot.end);
  }
}

TEST(WorldYaml, EveryShippedWorldHasATourToDrive) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(AISLE_SOURCE_DIR "/worlds")) {
    const Result<World> world = read_world(entry.path());
    ASSERT_TRUE(world.ok()) << to_string(world.problems());
    EXPECT_EQ(world->name, entry.path().stem()) << "the world is called as its file";
    EXPECT_GE(world->walls.size(), 30u) << entry.path();
    EXPECT_GE(world->tour.size(), 8u) << entry.path();
    names.push_back(world->name);
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"small-office", "two-loops", "round-hall"}));
}

TEST(WorldYaml, TheDocumentedExampleIsAWorld) {
  const Result<std::string> document = read_whole_file(AISLE_SOURCE_DIR "/docs/formats/world.md");
  ASSERT_TRUE(document.ok());
  const std::string fence = "```yaml\n";
  const std::size_t start = document->find(fence) + fence.size();
  const Result<World> world =
      parse_world(document->substr(start, document->find("```", start) - start), "world.md");
  ASSERT_TRUE(world.ok()) << to_string(world.problems());
  EXPECT_THAT(world->walls, SizeIs(5 + 2 + 2));
  EXPECT_THAT(world->furniture, SizeIs(2));
  EXPECT_THAT(world->tour, SizeIs(3));
}

TEST(WallSegments, ReadsOneWallALine) {
  const Result<World> world =
      parse_wall_segments("# a floor\n0 0 1.5 0 W\n\n1.5 0 1.5 2 B\n", "dir/floor-4.txt");
  ASSERT_TRUE(world.ok()) << to_string(world.problems());
  EXPECT_EQ(world->name, "floor-4");
  ASSERT_THAT(world->walls, SizeIs(2));
  EXPECT_THAT(world->walls[1].foot.end, PointNear(Vec2(1.5, 2), 1e-12));
  EXPECT_THAT(world->tour, IsEmpty());
}

TEST(WallSegments, NamesEveryBadLine) {
  const Result<World> world =
      parse_wall_segments("0 0 1 0 W\n0 0 nan 1 W\n1 2 3\n0 0 1e7 0 W\n", "floor.txt");
  ASSERT_FALSE(world.ok());
  EXPECT_THAT(to_string(world.problems()),
              AllOf(HasSubstr("floor.txt:2: "), HasSubstr("floor.txt:3: "), HasSubstr("floor.txt:4: ")));
  EXPECT_THAT(to_string(parse_wall_segments("# nothing\n", "floor.txt").problems()),
              HasSubstr("no wall segments"));
}

}  // namespace
}  // namespace aisle
