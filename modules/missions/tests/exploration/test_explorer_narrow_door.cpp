#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "explorer_run.hpp"

namespace aisle {
namespace {

/// A corridor along x, 8 m x 1.6 m, and on its left a room of 5 m x 4 m, of which little is seen through its
/// door: that is 0.76 m wide, for a vehicle of 0.6 m.
World corridor_with_narrow_door() {
  return walled_by({{0, 0},
                    {8, 0},
                    {8, 1.6},
                    {4.78, 1.6},
                    {4.78, 1.72},
                    {7, 1.72},
                    {7, 5.72},
                    {2, 5.72},
                    {2, 1.72},
                    {4.02, 1.72},
                    {4.02, 1.6},
                    {0, 1.6}},
                   {1, 0.8, 0});
}

struct NarrowDoorRun {
  std::string why;
  double farthest_in_m = -1.72;  ///< of the vehicle's origin beyond the door
  std::size_t collisions = 0;
};

NarrowDoorRun drive_to_narrow_door(double cell_least_m) {
  constexpr double kLate_s = 900;
  ExplorerNavigatorParams params;
  params.learner.cell_least_m = cell_least_m;
  ExplorerRun run(corridor_with_narrow_door(), 1, params);
  NarrowDoorRun driven;
  while (run.goes_on(kLate_s)) {
    run.step();
    driven.farthest_in_m = std::max(driven.farthest_in_m, run.vehicle.truth().T_world_vehicle.y - 1.72);
  }
  driven.why = run.last.why;
  driven.collisions = run.vehicle.truth().collisions;
  return driven;
}

TEST(ExplorerNarrowDoor, IsPassedOnCellsHalfAsWide) {
  const NarrowDoorRun driven = drive_to_narrow_door(0.025);
  EXPECT_EQ(driven.why, "explored");
  EXPECT_GT(driven.farthest_in_m, 0.5);
  EXPECT_EQ(driven.collisions, 0);
}

TEST(ExplorerNarrowDoor, IsTooNarrowOnCellsAsTheyAreAtFirst) {
  const NarrowDoorRun driven = drive_to_narrow_door(0.05);
  EXPECT_EQ(driven.why, "explored");
  EXPECT_LT(driven.farthest_in_m, 0);
}

}  // namespace
}  // namespace aisle
