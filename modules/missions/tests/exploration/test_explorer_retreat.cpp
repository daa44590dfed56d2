#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "explorer_run.hpp"

namespace aisle {
namespace {

constexpr double kTimeMax_s = 900;

/// A corridor along x, 8 m x 1.3 m, and on its left, behind a door that is open into it, a narrow room of
/// 1.5 m x 2.6 m, which is a dead end: the vehicle gets in, but a search in it finds no path out.
World corridor_with_narrow_room() {
  return walled_by({{0, 0},
                    {8, 0},
                    {8, 1.3},
                    {4.92, 1.3},
                    {4.92, 2.4},
                    {4.96, 2.4},
                    {4.96, 1.5},
                    {5.1, 1.5},
                    {5.1, 4.1},
                    {3.58, 4.1},
                    {3.58, 1.5},
                    {4, 1.5},
                    {4, 1.3},
                    {0, 1.3}},
                   {1, 0.65, 0});
}

double off_m(const std::vector<Vec2>& path, const Vec2& p) {
  double least_m = 1e9;
  for (const Vec2& q : path) least_m = std::min(least_m, (p - q).norm());
  return least_m;
}

struct RoomRun {
  Decision last;
  double back_m = 0;       ///< distance driven back along its trail
  double off_trail_m = 0;  ///< greatest distance from the trail meanwhile
  std::size_t collisions = 0;
  double off_home_m = 0;
};

RoomRun drive_into_room(const World& world, std::uint64_t seed) {
  ExplorerRun run(world, seed);
  RoomRun driven;
  std::vector<Vec2> path_in;
  while (run.goes_on(kTimeMax_s)) {
    const Truth before = run.vehicle.truth();
    run.step();
    if (run.last.state == "retreating") {
      driven.back_m += run.vehicle.truth().path_m - before.path_m;
      driven.off_trail_m = std::max(driven.off_trail_m, off_m(path_in, before.T_world_vehicle.position()));
    } else {
      path_in.push_back(before.T_world_vehicle.position());
    }
  }
  driven.last = run.last;
  driven.collisions = run.vehicle.truth().collisions;
  driven.off_home_m = run.off_home_m();
  return driven;
}

TEST(ExplorerRetreat, GoesBackAlongItsOwnTrailOutOfANarrowDeadEndAndThenHome) {
  constexpr std::uint64_t kSeeds = 10;
  const World world = corridor_with_narrow_room();
  int stuck = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const RoomRun run = drive_into_room(world, seed);
    EXPECT_EQ(run.last.status, NavigatorStatus::kDone) << run.last.why;
    EXPECT_LT(run.off_trail_m, 0.1);
    EXPECT_EQ(run.collisions, 0);
    EXPECT_LT(run.off_home_m, 0.1);
    if (run.back_m > 3) ++stuck;
  }
  EXPECT_GE(stuck, 2);  // others find a path out by themselves
}

/// Its front 0.1 m before the wall: it can neither go on nor turn, and sees no floor behind itself.
TEST(ExplorerRetreat, BacksOutFromAWallThatItWasPutDownBeforeAndComesHome) {
  const World corridor = walled_by({{0, 0}, {8, 0}, {8, 2.4}, {0, 2.4}}, {4, 2.046, 90 * kDegree});
  ExplorerRun run(corridor, 1, {}, "jackal");
  while (run.goes_on(kTimeMax_s)) run.step();
  EXPECT_EQ(run.last.status, NavigatorStatus::kDone);
  EXPECT_EQ(run.last.why, "explored");
  EXPECT_EQ(run.vehicle.truth().collisions, 0U);
  EXPECT_LT(run.off_home_m(), 0.1);
}

}  // namespace
}  // namespace aisle
