#include <gmock/gmock.h>

#include "aisle/simulation/buildings/random_building.hpp"
#include "aisle/simulation/vehicle/simulated_vehicle.hpp"
#include "exploration/exploration_check.hpp"

namespace aisle {
namespace {

using testing::HasSubstr;

/// A corridor of 10 m x 2 m along x with a gap in its right end.
World corridor_with_gap(double gap_m) {
  World world;
  const Vec2 corners[] = {{10, 1 + gap_m / 2}, {10, 2}, {0, 2}, {0, 0}, {10, 0}, {10, 1 - gap_m / 2}};
  for (std::size_t i = 1; i < std::size(corners); ++i)
    world.walls.push_back({.floor_edge = {corners[i], corners[i - 1]}});
  return world;
}

std::string problems_at(const World& world, const Pose2& T_world_start) {
  return to_string(check_explorable(world, "w.yaml", {}, T_world_start));
}

TEST(ExplorationCheck, AClosedWorldIsExplorable) {
  EXPECT_EQ(problems_at(corridor_with_gap(0), {3, 1, 0}), "");
}

TEST(ExplorationCheck, AGapThatTheVehicleDoesNotGetThroughLeadsNowhere) {
  EXPECT_EQ(problems_at(corridor_with_gap(0.55), {3, 1, 0}), "");
}

TEST(ExplorationCheck, AWorldThatIsOpenToTheOutsideIsRefusedWithThePlace) {
  EXPECT_THAT(problems_at(corridor_with_gap(1), {3, 1, 0}),
              HasSubstr("w.yaml: walls: the floor leads out of the building near "));
  const auto opening = opening_of(corridor_with_gap(1), {}, {3, 1});
  ASSERT_TRUE(opening);
  EXPECT_NEAR(opening->x(), 10, 0.6);
  EXPECT_NEAR(opening->y(), 1, 0.5);
}

TEST(ExplorationCheck, AStartOutsideAllWallsIsOpen) {
  EXPECT_THAT(problems_at(corridor_with_gap(0), {30, 1, 0}), HasSubstr("leads out of the building"));
  EXPECT_THAT(problems_at(World{}, {0, 0, 0}), HasSubstr("leads out of the building"));
}

TEST(ExplorationCheck, AStartInAWallIsRefusedWithThePlace) {
  EXPECT_THAT(problems_at(corridor_with_gap(0), {5, 1.9, 0}),
              HasSubstr("w.yaml: start: the vehicle does not fit at 5.00, 1.90"));
}

TEST(ExplorationCheck, RandomBuildingsAreExplorable) {
  for (const BuildingKind kind : kBuildingKinds) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const World world = random_building({.kind = kind}, Random(seed));
      EXPECT_EQ(problems_at(world, *start_pose(world)), "") << name_of(kind) << " " << seed;
    }
  }
}

}  // namespace
}  // namespace aisle
