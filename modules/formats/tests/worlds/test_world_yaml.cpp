#include <gmock/gmock.h>

#include "aisle/core/angle.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kWorldHead = "format: aisle.world\nversion: 1\n";

std::string world_problems(const std::string& text) {
  const Result<World> world = parse_world(text, "w.yaml");
  return world ? std::string() : to_string(world.problems());
}

TEST(WorldYaml, ReadsWallsBoxesAndTour) {
  const Result<World> world = parse_world(std::string(kWorldHead) +
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
  EXPECT_THAT(world->walls[1].floor_edge.end, PointNear(Vec2(3, 2), 1e-12));
  ASSERT_THAT(world->furniture, SizeIs(1));
  EXPECT_THAT(world->furniture[0].size, PointNear(Vec2(1, 0.5), 1e-12));
  EXPECT_DOUBLE_EQ(world->furniture[0].heading_rad, 90 * kDegree);
  ASSERT_THAT(world->tour, SizeIs(2));
  EXPECT_THAT(world->tour[1], PointNear(Vec2(2.5, 0.5), 1e-12));
}

TEST(WorldYaml, ReadsEverythingAWorldCanContain) {
  const Result<World> world = parse_world(
      std::string(kWorldHead) +
          "ceiling_m: 3\n"
          "ceiling_brightness: 0.8\n"
          "skirting_height_m: 0.12\n"
          "skirting_brightness: 0.2\n"
          "ambient_light: 0.4\n"
          "texture_seed: 18446744073709551615\n"
          "floor: {kind: carpet, tile_m: 0.5, brightness: 0.3, contrast: 0.2}\n"
          "start: {at: [1, 2], heading_deg: 90}\n"
          "walls:\n"
          "  - [[0, 0], [9, 0]]\n"
          "  - {line: [[0, 4], [0, 0]], height_m: 1.2, brightness: 0.6}\n"
          "doors:\n"
          "  - {hinge: [0.5, 4], closed_heading_deg: 180, open_deg: -30, width_m: 0.8, height_m: 2, "
          "brightness: 0.4,\n"
          "     frame_width_m: 0.1, frame_brightness: 0.2, wall_depth_m: 0.15}\n"
          "posters:\n"
          "  - {kind: notice_board, centre: [5, 0], facing_deg: 90, width_m: 1, height_m: 0.7, bottom_m: "
          "1.1}\n"
          "lamps:\n"
          "  - {centre: [3, 2], length_m: 1.5, width_m: 0.2, heading_deg: 45, power: 0.5}\n"
          "papers:\n"
          "  - {centre: [4, 1], heading_deg: 10, length_m: 0.2, width_m: 0.1, brightness: 0.9}\n"
          "furniture:\n"
          "  - {kind: chair, centre: [6, 2], size: [0.4, 0.5], heading_deg: 180, height_m: 0.9, brightness: "
          "0.3}\n"
          "parking_frames:\n"
          "  - {name: dock, centre: [7, 2], size: [1.2, 0.9], heading_deg: 90, line_width_m: 0.06, "
          "brightness: 1}\n"
          "boards:\n"
          "  - {centre: [2, 3, 1.2], yaw_deg: 90, pitch_deg: 10, roll_deg: -5, columns: 7, rows: 5, "
          "square_m: 0.04}\n"
          "people:\n"
          "  - {path: [[1, 3], [5, 3]], speed_mps: 0.8, start_s: 2, radius_m: 0.3, height_m: 1.8}\n"
          "places:\n"
          "  - {name: desk, at: [8, 2], heading_deg: -90}\n",
      "w.yaml");
  ASSERT_TRUE(world.ok()) << to_string(world.problems());
  EXPECT_EQ(world->ceiling_m, 3);
  EXPECT_EQ(world->ceiling_brightness, 0.8);
  EXPECT_EQ(world->skirting_height_m, 0.12);
  EXPECT_EQ(world->skirting_brightness, 0.2);
  EXPECT_EQ(world->ambient_light, 0.4);
  EXPECT_EQ(world->texture_seed, UINT64_MAX);
  EXPECT_EQ(world->floor.kind, FloorCovering::Kind::kCarpet);
  EXPECT_EQ(world->floor.tile_m, 0.5);
  EXPECT_EQ(world->floor.brightness, 0.3);
  EXPECT_EQ(world->floor.contrast, 0.2);
  EXPECT_THAT(world->start.value(), PoseNear(Pose2{1, 2, kPi / 2}, 1e-12, 1e-12));
  ASSERT_THAT(world->walls, SizeIs(2));
  EXPECT_EQ(world->walls[0].height_m, 3) << "up to the ceiling";
  EXPECT_EQ(world->walls[1].height_m, 1.2);
  EXPECT_EQ(world->walls[1].brightness, 0.6);
  const Door& door = world->doors.at(0);
  EXPECT_THAT(door.hinge, PointNear(Vec2(0.5, 4), 1e-12));
  EXPECT_DOUBLE_EQ(door.closed_heading_rad, kPi);
  EXPECT_DOUBLE_EQ(door.open_rad, -30 * kDegree);
  EXPECT_EQ(door.width_m, 0.8);
  EXPECT_EQ(door.height_m, 2);
  EXPECT_EQ(door.brightness, 0.4);
  EXPECT_EQ(door.frame_width_m, 0.1);
  EXPECT_EQ(door.frame_brightness, 0.2);
  EXPECT_EQ(door.wall_depth_m, 0.15);
  const Poster& poster = world->posters.at(0);
  EXPECT_EQ(poster.kind, Poster::Kind::kNoticeBoard);
  EXPECT_THAT(poster.centre, PointNear(Vec2(5, 0), 1e-12));
  EXPECT_DOUBLE_EQ(poster.facing_rad, kPi / 2);
  EXPECT_EQ(poster.width_m, 1);
  EXPECT_EQ(poster.height_m, 0.7);
  EXPECT_EQ(poster.bottom_m, 1.1);
  const Lamp& lamp = world->lamps.at(0);
  EXPECT_THAT(lamp.centre, PointNear(Vec2(3, 2), 1e-12));
  EXPECT_EQ(lamp.length_m, 1.5);
  EXPECT_EQ(lamp.width_m, 0.2);
  EXPECT_DOUBLE_EQ(lamp.heading_rad, kPi / 4);
  EXPECT_EQ(lamp.power, 0.5);
  const FloorPaper& paper = world->papers.at(0);
  EXPECT_THAT(paper.centre, PointNear(Vec2(4, 1), 1e-12));
  EXPECT_DOUBLE_EQ(paper.heading_rad, 10 * kDegree);
  EXPECT_EQ(paper.length_m, 0.2);
  EXPECT_EQ(paper.width_m, 0.1);
  EXPECT_EQ(paper.brightness, 0.9);
  const Furniture& chair = world->furniture.at(0);
  EXPECT_EQ(chair.kind, Furniture::Kind::kChair);
  EXPECT_THAT(chair.centre, PointNear(Vec2(6, 2), 1e-12));
  EXPECT_THAT(chair.size, PointNear(Vec2(0.4, 0.5), 1e-12));
  EXPECT_DOUBLE_EQ(chair.heading_rad, kPi);
  EXPECT_EQ(chair.height_m, 0.9);
  EXPECT_EQ(chair.brightness, 0.3);
  const ParkingFrame& frame = world->parking_frames.at(0);
  EXPECT_EQ(frame.name, "dock");
  EXPECT_THAT(frame.centre, PointNear(Vec2(7, 2), 1e-12));
  EXPECT_THAT(frame.size, PointNear(Vec2(1.2, 0.9), 1e-12));
  EXPECT_DOUBLE_EQ(frame.heading_rad, kPi / 2);
  EXPECT_EQ(frame.line_width_m, 0.06);
  EXPECT_EQ(frame.brightness, 1);
  const CalibrationBoard& board = world->boards.at(0);
  EXPECT_EQ(board.p_world_centre, Vec3(2, 3, 1.2));
  EXPECT_DOUBLE_EQ(board.yaw_rad, kPi / 2);
  EXPECT_DOUBLE_EQ(board.pitch_rad, 10 * kDegree);
  EXPECT_DOUBLE_EQ(board.roll_rad, -5 * kDegree);
  EXPECT_EQ(board.columns, 7);
  EXPECT_EQ(board.rows, 5);
  EXPECT_EQ(board.square_m, 0.04);
  const Person& person = world->people.at(0);
  EXPECT_THAT(person.path, SizeIs(2));
  EXPECT_EQ(person.speed_mps, 0.8);
  EXPECT_EQ(person.start_s, 2);
  EXPECT_EQ(person.radius_m, 0.3);
  EXPECT_EQ(person.height_m, 1.8);
  EXPECT_EQ(world->places.at(0).name, "desk");
  EXPECT_THAT(world->places[0].T_world_place, PoseNear(Pose2{8, 2, -kPi / 2}, 1e-12, 1e-12));
}

TEST(WorldYaml, ABoxIsSeenByCamerasAndByAScannerAtKneeHeight) {
  const Result<World> world =
      parse_world(std::string(kWorldHead) + "walls: []\nboxes: [{centre: [0, 0], size: [1, 1]}]\n", "w.yaml");
  ASSERT_TRUE(world.ok());
  EXPECT_EQ(world->furniture.at(0).kind, Furniture::Kind::kBox);
  EXPECT_THAT(cross_section(*world, 0.3), SizeIs(4));
}

TEST(WorldYaml, ReportsEveryProblemWithItsLineAndKey) {
  EXPECT_EQ(
      world_problems("format: aisle.world\n"
                     "version: 2\n"
                     "walls:\n"
                     "  - [[0, 0], [.nan, 0]]\n"
                     "  - [[1, 1]]\n"
                     "  - [[0, 0], [1e9, 0], [x, 1]]\n"
                     "  - [[2, 2], [2, 2]]\n"
                     "  - {line: [[2, 2]], brightness: 2}\n"
                     "boxes:\n"
                     "  - {centre: [1, 1], size: [0, 1]}\n"
                     "  - {center: [1, 1], size: [1, 1]}\n"
                     "doors:\n"
                     "  - {hinge: [1, 1], closed_heading_deg: 90, width_m: 0}\n"
                     "  - 5\n"
                     "floor: {kind: parquet}\n"
                     "places: [{name: '', at: 3}]\n"
                     "texture_seed: -1\n"
                     "door: 3\n"
                     "tour: 5\n"),
      "w.yaml:2: version: is not 1, the only one supported\n"
      "w.yaml:4: walls[0][1]: '.nan' is not a number\n"
      "w.yaml:5: walls[1]: a wall needs at least two points\n"
      "w.yaml:6: walls[2][1]: 1e9 is outside -10000 .. 10000\n"
      "w.yaml:6: walls[2][2]: 'x' is not a number\n"
      "w.yaml:7: walls[3]: the point [2, 2] is given twice in a row\n"
      "w.yaml:8: walls[4].brightness: 2 is outside 0 .. 1\n"
      "w.yaml:10: boxes[0].size: 0 is outside 0.01 .. 1000\n"
      "w.yaml:11: boxes[1].center: unknown key (known: kind, centre, size, heading_deg, height_m, "
      "brightness, returns)\n"
      "w.yaml:11: boxes[1].centre: is missing\n"
      "w.yaml:13: doors[0].width_m: 0 is outside 0.05 .. 20\n"
      "w.yaml:14: doors[1]: has no keys (known: hinge, closed_heading_deg, open_deg, width_m, height_m, "
      "brightness, frame_width_m, frame_brightness, wall_depth_m)\n"
      "w.yaml:15: floor.kind: 'parquet' is none of plain, tiles, carpet\n"
      "w.yaml:16: places[0].name: is empty\n"
      "w.yaml:16: places[0].at: is not [x, y]\n"
      "w.yaml:17: texture_seed: '-1' is not a whole number from 0 to 18446744073709551615\n"
      "w.yaml:18: door: unknown key (known: format, version, walls, boxes, floor, start, doors, posters, "
      "lamps, "
      "papers, furniture, parking_frames, boards, people, places, routes, turnings, name, ceiling_m, "
      "ceiling_brightness, skirting_height_m, skirting_brightness, ambient_light, texture_seed, tour)\n"
      "w.yaml:19: tour: is not a list");
}

TEST(WorldYaml, TextsAreOneLine) {
  EXPECT_THAT(world_problems(std::string(kWorldHead) + "name: \"one\\ntwo\"\nwalls: []\n"),
              HasSubstr("name: is not a line of UTF-8 text"));
}

TEST(WorldYaml, NamesTheLineOfEveryContradiction) {
  EXPECT_EQ(world_problems(std::string(kWorldHead) + "ceiling_m: 2\n"
                                                     "walls:\n"
                                                     "  - [[0, 0], [9, 0]]\n"
                                                     "boxes:\n"
                                                     "  - {centre: [5, 5], size: [2, 2]}\n"
                                                     "start: {at: [5, 5]}\n"
                                                     "doors:\n"
                                                     "  - {hinge: [1, 0], closed_heading_deg: 0}\n"
                                                     "posters:\n"
                                                     "  - {centre: [5, 0], facing_deg: 90, height_m: 0.5}\n"
                                                     "  - {centre: [5, 0.5], facing_deg: 90, height_m: 0.5}\n"
                                                     "  - {centre: [5, 0], facing_deg: 0, height_m: 0.5}\n"
                                                     "people:\n"
                                                     "  - {path: [[1, 1]]}\n"
                                                     "places:\n"
                                                     "  - {name: desk, at: [8, 4]}\n"
                                                     "  - {name: desk, at: [8, 3]}\n"
                                                     "tour:\n"
                                                     "  - [2, 2]\n"
                                                     "  - [3, 0.05]\n"),
            "w.yaml:19: places[1].name: is the name of places[0] too\n"
            "w.yaml:10: doors[0].height_m: ends at 2.05 m, above the ceiling at 2 m\n"
            "w.yaml:16: people[0].path: needs at least two different points\n"
            "w.yaml:8: start.at: is inside a piece of furniture\n"
            "w.yaml:22: tour[1]: is closer than 0.1 m to an obstacle\n"
            "w.yaml:13: posters[1]: does not hang on a wall\n"
            "w.yaml:14: posters[2]: does not hang on a wall");
}

TEST(WorldYaml, RefusesWhatIsNoWorld) {
  EXPECT_THAT(world_problems(""), HasSubstr("is not a world"));
  EXPECT_THAT(world_problems("[1, 2"), HasSubstr("w.yaml:1: is not YAML"));
  EXPECT_THAT(world_problems("name: empty\n"),
              AllOf(HasSubstr("format: is missing"), HasSubstr("walls: is missing")));
  EXPECT_THAT(world_problems(std::string(kWorldHead) + "walls: []\nwalls: []\n"),
              HasSubstr("is given twice"));
  EXPECT_THAT(world_problems(std::string(kWorldHead) + "walls: []\ntour: [[1, 1]]\n"),
              HasSubstr("two different points"));
}

TEST(WorldYaml, RefusesMoreWallsThanAnyBuildingHas) {
  std::string text = std::string(kWorldHead) + "walls:\n  - &long [";
  for (int i = 0; i < 1000; ++i) text += "[" + std::to_string(i) + ", 0], ";
  text += "]\n";
  for (int i = 0; i < 1000; ++i) text += "  - *long\n";
  EXPECT_THAT(world_problems(text), HasSubstr("at most 200000 are read"));
}

TEST(WallSegments, ReadsOneWallALine) {
  const Result<World> world =
      parse_wall_segments("# a floor\n0 0 1.5 0 W\n\n1.5 0 1.5 2 B\n", "dir/floor-4.txt");
  ASSERT_TRUE(world.ok()) << to_string(world.problems());
  EXPECT_EQ(world->name, "floor-4");
  ASSERT_THAT(world->walls, SizeIs(2));
  EXPECT_THAT(world->walls[1].floor_edge.end, PointNear(Vec2(1.5, 2), 1e-12));
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
