#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/exploration/floor_distances.hpp"

namespace aisle {
namespace {

constexpr double kClearance_m = 0.1;
constexpr double kLeeway_m = 0.3025;
constexpr int kSide = 24;

/// By relaxing cell by cell until no distance gets shorter; diagonal steps cost 1.4 straight ones.
std::map<std::pair<int, int>, int> tenths_by_trying(const FloorClearance& clearance, FloorCell start,
                                                    int leeway) {
  std::map<std::pair<int, int>, int> tenths = {{{start.x, start.y}, 0}};
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [cell, so_far] : std::map(tenths)) {
      for (int step = 0; step < 9; ++step) {
        const int x = step % 3 - 1, y = step / 3 - 1;
        const std::pair next(cell.first + x, cell.second + y);
        const double clearance_m = clearance.to_doubtful_m(FloorCell{next.first, next.second});
        if (clearance_m <= 0 || (clearance_m < kClearance_m && so_far > leeway)) continue;
        const int then = so_far + (x != 0 && y != 0 ? 14 : 10);
        const auto known = tenths.find(next);
        if (known != tenths.end() && known->second <= then) continue;
        tenths[next] = then;
        changed = true;
      }
    }
  }
  return tenths;
}

RC_GTEST_PROP(FloorDistances, AreThoseThatTryingAllPathsGives, (std::uint64_t seed)) {
  Random random(seed);
  FloorGrid grid;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      grid.set({x, y}, random.uniform() < 0.06 ? Floor::kOccupied : Floor::kFree);
  }
  const KnownFloor floor(grid);
  const FloorCell start{static_cast<int>(random.index(kSide)), static_cast<int>(random.index(kSide))};
  FloorDistances distances;
  distances.measure(floor, {1, 1}, kClearance_m, 0);
  distances.measure(floor, grid.centre(start), kClearance_m, kLeeway_m);
  const auto expected =
      tenths_by_trying(floor.clearance(), start, static_cast<int>(10 * kLeeway_m / grid.cell_m()));
  for (int y = -3; y < kSide + 3; ++y) {
    for (int x = -3; x < kSide + 3; ++x) {
      const auto path = expected.find({x, y});
      const float path_m = distances.to({x, y});
      RC_ASSERT(std::isfinite(path_m) == (path != expected.end()));
      if (path == expected.end()) continue;
      RC_ASSERT(std::abs(path_m - 0.1 * path->second * grid.cell_m()) < 1e-5);
      RC_ASSERT(path_m >= 0.98 * (grid.centre({x, y}) - grid.centre(distances.start())).norm());
    }
  }
}

TEST(FloorDistances, NothingIsReachedFromOutsideTheFloor) {
  FloorGrid grid;
  grid.set({0, 0}, Floor::kFree);
  const KnownFloor floor(grid);
  FloorDistances distances;
  distances.measure(floor, {1000, 1000}, kClearance_m, 1);
  EXPECT_EQ(distances.to({0, 0}), FloorDistances::kUnreached);
}

/// Two corridors between the same ends, of which one is one-way.
TEST(FloorDistances, GoTheOtherWayRoundWhereTheFloorIsOneWay) {
  FloorGrid grid;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool is_block = x >= 8 && x < 16 && y >= 4 && y < 20;
      grid.set({x, y}, is_block ? Floor::kOccupied : Floor::kFree);
    }
  }
  const auto at = [&](int x, int y) { return grid.centre(FloorCell{x, y}); };
  FloorDistances free;
  free.measure(KnownFloor(grid), at(4, 2), 0.01, 0);
  const std::vector<Zone> zones = {{.kind = Zone::Kind::kOneWay,
                                    .outline = {at(8, -4), at(16, -4), at(16, 4), at(8, 4)},
                                    .direction_rad = 0}};
  const KnownFloor floor(grid, FloorClearance(), zones);
  FloorDistances along, against;
  along.measure(floor, at(4, 2), 0.01, 0, FloorDistances::Paths::kFromStart);
  against.measure(floor, at(4, 2), 0.01, 0, FloorDistances::Paths::kToStart);
  EXPECT_EQ(along.to({20, 2}), free.to({20, 2}));
  EXPECT_GT(against.to({20, 2}), free.to({20, 2}) + 1);
  EXPECT_EQ(against.to({4, 20}), free.to({4, 20})) << "off the zone";
}

}  // namespace
}  // namespace aisle
