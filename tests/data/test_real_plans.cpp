#include <gmock/gmock.h>

#include <algorithm>

#include "aisle/core/progress.hpp"
#include "aisle/formats/images/plan_image.hpp"
#include "aisle/formats/mazes/maze_file.hpp"
#include "aisle/formats/worlds/world_yaml.hpp"
#include "aisle/simulation/buildings/maze_building.hpp"
#include "aisle/simulation/paths/round_trip.hpp"
#include "aisle/simulation/plans/free_sides.hpp"
#include "aisle/simulation/plans/plan_tracing.hpp"
#include "driven_tour.hpp"
#include "plan_raster.hpp"
#include "real_data.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;

constexpr double kDrivenTourMax_m = 400;  ///< longer ones take too long to drive
constexpr double kVehicleHalf_m = 0.3;
constexpr double kGridError_m = 0.08;
/// Real doors may be 0.7 m wide, so the driver cuts no corners.
constexpr double kLookAhead_m = 0.15;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Written and read back, as a user gets it.
World written(const World& world) {
  auto again = parse_world(world_yaml(world), world.name);
  EXPECT_TRUE(again.ok()) << world.name << to_string(again.ok() ? Problems{} : again.problems());
  return again.ok() ? *again : World{};
}

/// Gives the world a start and a tour and checks both.
void expect_drivable(World world) {
  SilentProgress silent;
  const auto run = plan_round_trip(world, {}, silent);
  ASSERT_TRUE(run.has_value()) << world.name;
  world.tour = run->tour;
  world.start = run->T_world_start;
  const ClearanceGrid grid(obstacles_below(world, 2), 0.05);
  EXPECT_GE(grid.clearance_m(world.start->position()), 0.3) << world.name;
  double tour_m = 0;
  for (std::size_t i = 1; i < world.tour.size(); ++i) tour_m += (world.tour[i] - world.tour[i - 1]).norm();
  if (world.tour.size() < 2 || tour_m > kDrivenTourMax_m) return;
  const DrivenTour driven = drive_tour(written(world), kLookAhead_m);
  EXPECT_TRUE(driven.arrived) << world.name;
  EXPECT_GT(driven.clearance_min_m, kVehicleHalf_m - kGridError_m) << world.name;
}

struct PlanFolder {
  std::string name;
  std::string path;
  double cell_m;

  friend void PrintTo(const PlanFolder& folder, std::ostream* out) { *out << folder.path; }
};

class RealPlans : public testing::TestWithParam<PlanFolder> {};

INSTANTIATE_TEST_SUITE_P(Folders, RealPlans,
                         testing::Values(PlanFolder{"KthFloors", "worlds/kth_floorplans_mapex", 0.05},
                                         PlanFolder{"Offices", "worlds/ipa_room_segmentation/pbm", 0.05},
                                         PlanFolder{"StageMaps", "worlds/ros_stage_maps/pbm", 0.05},
                                         PlanFolder{"ExploreBench", "worlds/explore_bench/pbm", 0.1}),
                         [](const auto& folder) { return folder.param.name; });

TEST_P(RealPlans, AreTracedWithoutLosingFloorAndCanBeDriven) {
  const fs::path folder = real_data() / GetParam().path;
  AISLE_NEEDS(folder);
  for (const fs::path& file : files_in(folder)) {
    auto read = read_plan_image(file, GetParam().cell_m);
    ASSERT_TRUE(read.ok()) << file;
    FloorPlan* plan = &read->plan;
    clean_plan(*plan, {.speck_m = 0.1});
    SilentProgress silent;
    World world{.name = file.stem().string()};
    const auto walls = trace_plan(*plan, {}, silent);
    ASSERT_TRUE(walls) << file;
    for (const Segment2& wall : *walls) world.walls.push_back({.floor_edge = wall});
    const Agreement agrees = agreement(*plan, wall_floor_edges(written(world)));
    EXPECT_GE(agrees.all, 0.99) << file;
    EXPECT_GE(agrees.away_from_borders, 0.999) << file;
    expect_drivable(world);
  }
}

TEST(RealSegments, FloorsOfWallSegmentsCanBeDriven) {
  const fs::path folder = real_data() / "worlds/kth_floorplans_osu/segments";
  AISLE_NEEDS(folder);
  for (const fs::path& file : files_in(folder)) {
    auto world = read_wall_segments(file);
    ASSERT_TRUE(world.ok()) << file;
    const std::vector<Segment2> floor_edges = with_free_sides_left(wall_floor_edges(*world));
    for (std::size_t i = 0; i < floor_edges.size(); ++i) world->walls[i].floor_edge = floor_edges[i];
    EXPECT_EQ(written(*world).walls.size(), world->walls.size()) << file;
    expect_drivable(*world);
  }
}

TEST(RealMazes, CompetitionMazesCanBeDriven) {
  const fs::path folder = real_data() / "worlds/micromouse/classic";
  AISLE_NEEDS(folder);
  const std::vector<fs::path> files = files_in(folder);
  for (std::size_t i = 0; i < files.size(); i += files.size() / 5) {
    const auto maze = read_maze(files[i]);
    ASSERT_TRUE(maze.ok()) << files[i];
    expect_drivable(build_maze(maze->world, {.corridor_width_m = 1.2}));
  }
}

}  // namespace
}  // namespace aisle
