#include <gmock/gmock.h>

#include <filesystem>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/buildings/floor_marks.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/formats/key_script_text.hpp"
#include "aisle/formats/logs/carmen_log.hpp"
#include "aisle/formats/logs/laser_csv.hpp"
#include "aisle/formats/logs/relations.hpp"
#include "aisle/formats/logs/trajectory.hpp"
#include "aisle/formats/sessions/decision_text.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/formats/whole_file.hpp"
#include "aisle/formats/worlds/scenario_yaml.hpp"
#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "image_sequences/image_folder.hpp"
#include "pose_matchers.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// The fenced block number `index` of a page under docs/formats/.
std::string example(const std::string& page, int index = 0) {
  const std::string text = *read_whole_file(std::filesystem::path(AISLE_SOURCE_DIR) / "docs/formats" / page);
  std::size_t fence = text.find("```");
  for (int i = 0; i < 2 * index; ++i) fence = text.find("```", fence + 3);
  const std::size_t start = text.find('\n', fence) + 1;
  return text.substr(start, text.find("```", start) - start);
}

TEST(DocumentedExamples, TheCarmenLogIsRead) {
  const auto carmen = parse_carmen_log(example("carmen.md"), "carmen.md");
  ASSERT_TRUE(carmen.ok()) << to_string(carmen.problems());
  EXPECT_THAT(carmen->warnings, IsEmpty());
  EXPECT_THAT(carmen->log.scans, SizeIs(2));
  EXPECT_THAT(carmen->log.laser().T_vehicle_laser, PoseNear(Pose2{0.1, 0, 0}, 0, 0));
}

TEST(DocumentedExamples, TheLaserCsvIsRead) {
  const auto table = parse_laser_csv(example("laser_csv.md"), "laser_csv.md");
  ASSERT_TRUE(table.ok()) << to_string(table.problems());
  ASSERT_THAT(table->log.scans, SizeIs(2));
  EXPECT_THAT(table->log.scans[0].ranges_m, SizeIs(5));
  EXPECT_THAT(table->log.laser().T_vehicle_laser, PoseNear(Pose2{0.15, 0, 0}, 0, 0));
}

TEST(DocumentedExamples, BothFormsOfRelationsAreReadAndSayTheSame) {
  LaserLog log;
  log.scans.resize(29);
  log.scans[24].stamp_s = 1216.630413;
  log.scans[28].stamp_s = 1217.490267;
  for (const int form : {0, 1}) {
    const auto relations = parse_relations(example("relations.md", form), "relations.md", log);
    ASSERT_TRUE(relations.ok()) << to_string(relations.problems());
    ASSERT_THAT(*relations, SizeIs(1));
    EXPECT_EQ((*relations)[0].scan_1, 24U);
    EXPECT_EQ((*relations)[0].scan_2, 28U);
    EXPECT_THAT((*relations)[0].T_1_2, PoseNear(Pose2{0.407950, -0.016330, -0.069620}, 0, 0));
  }
}

TEST(DocumentedExamples, TheBuildingsAreReadAndWrittenAsTheyStand) {
  for (const int form : {0, 1, 2}) {
    const std::string text = example("building.md", form);
    const auto building = parse_building(text, "building.md");
    ASSERT_TRUE(building.ok()) << to_string(building.problems());
    EXPECT_EQ(building_json(*building), text);
  }
}

TEST(DocumentedExamples, TheSectionsAreReadAndWrittenAsTheyStand) {
  const std::string text = example("sections.md");
  const auto building = parse_building(text, "sections.md");
  ASSERT_TRUE(building.ok()) << to_string(building.problems());
  EXPECT_EQ(building_json(*building), text);
}

TEST(DocumentedExamples, ThePathThroughARoomIsReadAndWrittenAsItStands) {
  const std::string text = example("rooms.md");
  const auto building = parse_building(text, "rooms.md");
  ASSERT_TRUE(building.ok()) << to_string(building.problems());
  ASSERT_TRUE(building->routes.front().room);
  EXPECT_EQ(building->routes.front().room->turnings.front().number, 5);
  EXPECT_EQ(building_json(*building), text);
}

TEST(DocumentedExamples, TheTrajectoryIsReadAndWrittenAsItStands) {
  const std::string text = example("trajectory.md");
  const auto trajectory = parse_tum(text, "trajectory.md");
  ASSERT_TRUE(trajectory.ok()) << to_string(trajectory.problems());
  EXPECT_EQ(tum_text(trajectory->stamps_s, trajectory->T_map_vehicle), text);
}

TEST(DocumentedExamples, TheFloorMarksAreRead) {
  const auto marks = parse_floor_marks(example("floor_marks.md"), "floor_marks.md");
  ASSERT_TRUE(marks.ok()) << to_string(marks.problems());
  ASSERT_THAT(*marks, SizeIs(5));
  EXPECT_EQ((*marks)[1].pixel_px, Vec2(528.5, 301));
  EXPECT_EQ((*marks)[1].p_vehicle, Vec2(3, -1));
}

TEST(DocumentedExamples, TheMapServerFileIsWrittenAsItStands) {
  OccupancyImage image;
  image.origin_m = {-12.35, -4.1};
  EXPECT_EQ(map_server_yaml(image, "map.pgm"), example("map_server.md"));
}

TEST(DocumentedExamples, TheConnectionIsRead) {
  const auto connection = parse_connection(example("connection.md"), "connection.md");
  ASSERT_TRUE(connection.ok()) << to_string(connection.problems());
  EXPECT_EQ(connection->vehicle, "turtlebot.yaml");
  EXPECT_THAT(connection->emergency_stops, SizeIs(1));
  EXPECT_EQ(connection->limits.speed_max_mps, 0.3);
}

TEST(DocumentedExamples, TheVehicleIsRead) {
  const auto vehicle = parse_vehicle(example("vehicle.md"), "vehicle.md");
  ASSERT_TRUE(vehicle.ok()) << to_string(vehicle.problems());
  EXPECT_THAT(vehicle->description.cameras, SizeIs(1));
  EXPECT_DOUBLE_EQ(vehicle->simulated.odometry.distance_scale, 0.02);
}

/// Without the line end.
std::string example_line(const std::string& page, int index) {
  const std::string text = example(page, index);
  return text.substr(0, text.find('\n'));
}

TEST(DocumentedExamples, TheSessionsTextsAreReadAndWrittenAsTheyStand) {
  for (const int form : {0, 1, 2}) {
    const std::string origin_text = example_line("session.md", form);
    const auto origin = parse_session_origin(origin_text, "session.md");
    ASSERT_TRUE(origin.ok()) << to_string(origin.problems());
    EXPECT_EQ(session_origin_json(*origin), origin_text);
  }
  const auto decision = parse_decision(example_line("session.md", 3));
  ASSERT_TRUE(decision);
  EXPECT_EQ(decision_text(*decision), example_line("session.md", 3));
  const auto input = parse_operator(example_line("session.md", 4));
  ASSERT_TRUE(input);
  EXPECT_EQ(operator_text(*input), example_line("session.md", 4));
}

TEST(DocumentedExamples, ASessionOfALandmarkMissionContainsABuilding) {
  const auto origin = parse_session_origin(example_line("session.md", 1), "session.md");
  ASSERT_TRUE(origin.ok()) << to_string(origin.problems());
  EXPECT_TRUE(parse_building(origin->building, "building").ok());
  EXPECT_EQ(origin->route, "desk to stairs");
  EXPECT_TRUE(origin->in_reverse);
}

TEST(DocumentedExamples, TheListOfImagesHasPoses) {
  const auto list = parse_image_csv(example("image-sequences.md"), "recording/list.csv", {});
  ASSERT_TRUE(list.ok()) << to_string(list.problems());
  ASSERT_THAT(list->images, SizeIs(3));
  EXPECT_THAT(list->warnings, IsEmpty());
  EXPECT_EQ(list->images[1].file, "recording/0002.jpg");
  EXPECT_THAT(*list->images[2].T_odom_vehicle, PoseNear(Pose2{0.2, 0.01, 4.5 * kDegree}, 0, 1e-12));
}

TEST(DocumentedExamples, ThePlanIsARoomWithAPillar) {
  const auto read = parse_plan_image(example("plan.md"), "plan.md", 0.05);
  ASSERT_TRUE(read.ok()) << to_string(read.problems());
  EXPECT_TRUE(read->plan.is_solid(2, 2));
  EXPECT_TRUE(read->plan.is_solid(3, 2)) << "unknown";
  EXPECT_FALSE(read->plan.is_solid(1, 2));
}

TEST(DocumentedExamples, TheScenarioIsRead) {
  const auto scenario = parse_scenario(example("scenario.md"), "scenario.md");
  ASSERT_TRUE(scenario.ok()) << to_string(scenario.problems());
  EXPECT_THAT(scenario->events, SizeIs(8));
}

TEST(DocumentedExamples, TheTimedKeysAreRead) {
  const auto keys = parse_key_script(example("keys.md"), "keys.md");
  ASSERT_TRUE(keys.ok()) << to_string(keys.problems());
  EXPECT_THAT(*keys, SizeIs(8));
}

}  // namespace
}  // namespace aisle
