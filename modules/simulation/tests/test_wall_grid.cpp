#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/simulation/wall_grid.hpp"

namespace aisle {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

double nearest_by_brute_force(const std::vector<Segment2>& walls, const Vec2& origin, const Vec2& direction) {
  double nearest_m = kNever;
  for (const Segment2& wall : walls) nearest_m = std::min(nearest_m, ray_distance(origin, direction, wall));
  return nearest_m;
}

/// Coordinates on a coarse lattice: walls on cell borders, shared ends and rays through corners are common.
Vec2 any_point(Random& random, double side_m, bool on_lattice) {
  const Vec2 p{random.uniform(-side_m, side_m), random.uniform(-side_m, side_m)};
  return on_lattice ? Vec2(std::round(2 * p.x()) / 2, std::round(2 * p.y()) / 2) : p;
}

TEST(WallGrid, AnEmptyWorldHasNothingToHit) {
  EXPECT_EQ(WallGrid({}).cast({0, 0}, {1, 0}), kNever);
}

TEST(WallGrid, SeesAWallFromOutsideItsGridButNotBehindTheRay) {
  const WallGrid grid({{{10, -1}, {10, 1}}});
  EXPECT_DOUBLE_EQ(grid.cast({-90, 0.5}, {1, 0}), 100);
  EXPECT_EQ(grid.cast({-90, 0.5}, {-1, 0}), kNever);
  EXPECT_EQ(grid.cast({-90, 2}, {1, 0}), kNever);
}

TEST(WallGrid, TwoWallsThatMeetLeaveNoGap) {
  const WallGrid grid({{{3, 1}, {1, 3}}, {{1, 3}, {-2, 3}}});
  EXPECT_TRUE(std::isfinite(grid.cast({0, 0}, Vec2(1, 3).normalized())));
}

RC_GTEST_PROP(WallGrid, FindsWhatAskingEveryWallFinds, (std::uint64_t seed)) {
  Random random(seed);
  const double side_m = random.uniform(1, 60);
  const bool on_lattice = random.index(2) == 0;
  std::vector<Segment2> walls(random.index(80));
  for (Segment2& wall : walls) {
    wall = {any_point(random, side_m, on_lattice), any_point(random, side_m, on_lattice)};
  }
  const WallGrid grid(walls);
  for (int i = 0; i < 60; ++i) {
    const Vec2 origin = any_point(random, 1.3 * side_m, on_lattice);
    const double heading_rad =
        on_lattice ? static_cast<double>(random.index(8)) * 45 * kDegree : random.uniform(-kPi, kPi);
    const Vec2 direction = unit(heading_rad);
    RC_ASSERT(grid.cast(origin, direction) == nearest_by_brute_force(walls, origin, direction));
  }
}

}  // namespace
}  // namespace aisle
