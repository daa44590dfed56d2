#include <gmock/gmock.h>

#include <set>

#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/clearance_grid.hpp"
#include "buildings/building_layout.hpp"
#include "driven_tour.hpp"
#include "paths/drivable_area.hpp"
#include "plan_raster.hpp"

namespace aisle {
namespace {

constexpr std::uint64_t kSeeds = 30;
constexpr double kVehicleHalf_m = 0.3;

class RandomBuilding : public testing::TestWithParam<BuildingKind> {
 protected:
  World building(std::uint64_t seed) const { return random_building({.kind = GetParam()}, Random(seed)); }
};

INSTANTIATE_TEST_SUITE_P(Kinds, RandomBuilding, testing::ValuesIn(kBuildingKinds),
                         [](const auto& kind) { return std::string(name_of(kind.param)); });

TEST_P(RandomBuilding, AVehicleGetsFromTheStartToEveryPlaceAndAlongTheTour) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = building(seed);
    const ClearanceGrid grid(obstacles_below(world, 2), 0.04);
    const DrivableArea area = drivable_area(world, grid, kVehicleHalf_m);
    ASSERT_TRUE(area.contains[grid.cell_at(world.start->position())]) << seed;
    for (const NamedPlace& place : world.places) {
      EXPECT_TRUE(area.contains[grid.cell_at(place.T_world_place.position())]) << seed << " " << place.name;
    }
    for (const Vec2& p : world.tour)
      EXPECT_TRUE(area.contains[grid.cell_at(p)]) << seed << " " << p.transpose();
  }
}

TEST_P(RandomBuilding, TheTourCanBeDriven) {
  for (std::uint64_t seed = 0; seed < kSeeds; seed += 6) {
    const DrivenTour driven = drive_tour(building(seed));
    EXPECT_TRUE(driven.arrived) << seed;
    EXPECT_GT(driven.clearance_min_m, kVehicleHalf_m) << seed;
  }
}

TEST_P(RandomBuilding, WallsAreClosedOutlinesWithoutDegenerateOrOverlappingPieces) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = building(seed);
    std::set<std::tuple<long, long>> corners;
    for (std::size_t i = 0; i < world.walls.size(); ++i) {
      const Segment2& wall = world.walls[i].floor_edge;
      const Vec2 extent = (wall.end - wall.start).cwiseAbs();
      EXPECT_LT(extent.minCoeff(), 1e-9) << seed;
      EXPECT_GT(extent.maxCoeff(), 0.015) << seed << " " << wall.start.transpose();
      const auto corner = std::tuple(std::lround(wall.start.x() * 1000), std::lround(wall.start.y() * 1000));
      EXPECT_TRUE(corners.insert(corner).second)
          << seed << ": two outlines touch at " << wall.start.transpose();
    }
  }
}

TEST_P(RandomBuilding, CorridorsAreAsWideAsAsked) {
  for (const double width_m : {1.2, 2.0, 3.0}) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const RandomBuildingRecipe recipe{.kind = GetParam(), .corridor_width_m = width_m};
      Random random(seed);
      for (const Rectangle& corridor : random_corridors(recipe, random).corridors) {
        EXPECT_GE(corridor.size().minCoeff(), width_m - 1e-6) << seed;
      }
    }
  }
}

TEST_P(RandomBuilding, SeedsGiveDifferentBuildingsAndEachTheSameAgain) {
  std::set<std::size_t> walls;
  std::set<double> lengths;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World once = building(seed), again = building(seed);
    ASSERT_EQ(once.walls.size(), again.walls.size());
    double length_m = 0;
    for (std::size_t i = 0; i < once.walls.size(); ++i) {
      ASSERT_EQ(once.walls[i].floor_edge.start, again.walls[i].floor_edge.start);
      length_m += once.walls[i].floor_edge.length();
    }
    ASSERT_EQ(once.posters.size(), again.posters.size());
    ASSERT_EQ(once.lamps.size(), again.lamps.size());
    lengths.insert(length_m);
  }
  EXPECT_EQ(lengths.size(), kSeeds);
}

TEST_P(RandomBuilding, DoorsStandInDoorwaysOfWhichSomeAreOpen) {
  std::size_t doors = 0, open = 0, rooms = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = building(seed);
    for (const Door& door : world.doors) {
      EXPECT_GT(door.wall_depth_m, 0);
      open += door.open_rad != 0;
    }
    doors += world.doors.size();
    for (const NamedPlace& place : world.places) rooms += place.name.starts_with("room");
  }
  EXPECT_GT(doors, kSeeds * 5);
  EXPECT_GT(open, doors / 10);
  EXPECT_LT(open, doors * 9 / 10);
  EXPECT_GT(rooms, kSeeds);
}

TEST_P(RandomBuilding, EveryBuildingHasLightAndWhatIsSeenVaries) {
  std::set<int> floors;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const World world = building(seed);
    EXPECT_FALSE(world.lamps.empty()) << seed;
    floors.insert(static_cast<int>(world.floor.kind));
  }
  EXPECT_EQ(floors.size(), 3);
}

TEST(RandomBuildingRecipe, SaysWhatIsOutOfRange) {
  EXPECT_TRUE((RandomBuildingRecipe{.size_m = 30, .corridor_width_m = 2}.problems().empty()));
  EXPECT_EQ((RandomBuildingRecipe{.size_m = 5, .corridor_width_m = 0.5}.problems().size()), 2);
}

}  // namespace
}  // namespace aisle
