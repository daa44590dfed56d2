#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/maps/floor_clearance.hpp"

namespace aisle {
namespace {

constexpr double kFar_m = 0.6;

/// By brute force over all cells around.
double distance_by_trying_m(const FloorGrid& floor, FloorCell cell, bool unknown_counts) {
  const int reach = 14;
  double nearest_m = kFar_m;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const Floor there = floor.at(FloorCell{cell.x + x, cell.y + y});
      const bool counts = there == Floor::kOccupied || (unknown_counts && there == Floor::kUnknown);
      if (counts) nearest_m = std::min(nearest_m, (std::hypot(x, y) - 0.5) * floor.cell_m());
    }
  }
  return std::max(nearest_m, 0.0);
}

RC_GTEST_PROP(FloorClearance, IsTheDistanceThatTryingAllCellsGives, (std::uint64_t seed)) {
  Random random(seed);
  FloorGrid floor(0.05);
  FloorClearance clearance(kFar_m);
  for (int round = 0; round < 4; ++round) {
    FloorBox changed;
    const int left = static_cast<int>(random.index(300)) - 150,
              low = static_cast<int>(random.index(300)) - 150;
    for (int y = low; y < low + 25; ++y) {
      for (int x = left; x < left + 25; ++x) {
        floor.set({x, y}, random.uniform() < 0.03 ? Floor::kOccupied : Floor::kFree);
        changed.include({x, y});
      }
    }
    clearance.update(floor, changed);
  }
  for (int i = 0; i < 400; ++i) {
    const FloorCell cell{static_cast<int>(random.index(400)) - 200,
                         static_cast<int>(random.index(400)) - 200};
    RC_ASSERT(std::abs(clearance.to_doubtful_m(cell) - distance_by_trying_m(floor, cell, true)) < 1e-6);
    RC_ASSERT(std::abs(clearance.to_occupied_m(cell) - distance_by_trying_m(floor, cell, false)) < 1e-6);
  }
}

TEST(FloorClearance, CountsWhatLiesUnderABarrierAsOccupiedWhateverIsSeenThere) {
  FloorGrid floor(0.1);
  FloorClearance clearance(kFar_m);
  const Barrier barriers[] = {{.segment = {{1.05, -1}, {1.05, 1}}}};
  clearance.bar(barriers, floor.cell_m());
  for (int round = 0; round < 3; ++round) {
    FloorBox changed;
    for (int y = -20; y < 20; ++y) {
      for (int x = -20; x < 20; ++x) {
        floor.see_free({x, y});
        changed.include({x, y});
      }
    }
    clearance.update(floor, changed);
    EXPECT_TRUE(clearance.is_barred({10, 0}));
    EXPECT_EQ(clearance.to_doubtful_m({10, 0}), 0);
    EXPECT_NEAR(clearance.to_occupied_m({8, 0}), 0.15, 1e-6);
    EXPECT_NEAR(clearance.to_doubtful_m({13, 5}), 0.25, 1e-6);
    EXPECT_FALSE(clearance.is_barred({9, 0}));
  }
}

TEST(FloorClearance, KnowsNoFreeFloorBeforeItWasSeen) {
  const FloorClearance clearance;
  EXPECT_EQ(clearance.to_doubtful_m({5, 5}), 0);
  EXPECT_EQ(clearance.to_occupied_m({5, 5}), clearance.far_m());
}

}  // namespace
}  // namespace aisle
