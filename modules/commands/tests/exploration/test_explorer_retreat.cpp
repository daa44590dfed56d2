#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "explorer_trip.hpp"

namespace aisle {
namespace {

constexpr double kTimeMax_s = 900;

/// A corridor along x, 8 m x 1.3 m, and on its left, behind a door that is open into it, a narrow room of
/// 1.5 m x 2.6 m, which is a dead end: the vehicle gets in, but a search in it finds no way out.
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

double off_m(const std::vector<Vec2>& way, const Vec2& p) {
  double least_m = 1e9;
  for (const Vec2& q : way) least_m = std::min(least_m, (p - q).norm());
  return least_m;
}

struct RoomTrip {
  Decision last;
  double back_m = 0;       ///< driven back along its trail
  double off_trail_m = 0;  ///< at most, meanwhile
  std::size_t collisions = 0;
  double off_home_m = 0;
};

RoomTrip drive_into_room(const World& world, std::uint64_t seed) {
  ExplorerTrip trip(world, seed);
  RoomTrip driven;
  std::vector<Vec2> way_in;
  while (trip.goes_on(kTimeMax_s)) {
    const SimulatedTruth before = trip.vehicle.truth();
    trip.step();
    if (trip.last.state == "retreating") {
      driven.back_m += trip.vehicle.truth().way_m - before.way_m;
      driven.off_trail_m = std::max(driven.off_trail_m, off_m(way_in, before.T_world_vehicle.position()));
    } else {
      way_in.push_back(before.T_world_vehicle.position());
    }
  }
  driven.last = trip.last;
  driven.collisions = trip.vehicle.truth().collisions;
  driven.off_home_m = trip.off_home_m();
  return driven;
}

TEST(ExplorerRetreat, GoesBackAlongItsOwnTrailOutOfANarrowDeadEndAndThenHome) {
  constexpr std::uint64_t kSeeds = 30;
  const World world = corridor_with_narrow_room();
  int stuck = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const RoomTrip trip = drive_into_room(world, seed);
    EXPECT_EQ(trip.last.status, NavigatorStatus::kDone) << trip.last.why;
    EXPECT_LT(trip.off_trail_m, 0.1);
    EXPECT_EQ(trip.collisions, 0);
    EXPECT_LT(trip.off_home_m, 0.1);
    if (trip.back_m > 3) ++stuck;
  }
  EXPECT_GE(stuck, 5);  // others find a way out by themselves
}

}  // namespace
}  // namespace aisle
