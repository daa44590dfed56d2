#include "aisle/maps/known_floor.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace aisle {
namespace {

constexpr FloorCell kPost{20, 20};

FloorGrid free_hall() {
  FloorGrid grid;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) grid.set({x, y}, Floor::kFree);
  }
  return grid;
}

TEST(KnownFloor, KnowsTheClearanceOfAFloorThatItIsGiven) {
  const KnownFloor floor(free_hall());
  EXPECT_GT(floor.clearance().to_doubtful_m(kPost), 0.9);
  EXPECT_TRUE(floor.is_free(kPost));
  EXPECT_FALSE(floor.is_free({-1, 0}));
}

TEST(KnownFloor, ItsClearanceFollowsEveryChange) {
  KnownFloor floor(free_hall());
  const FloorBox changed = floor.change([](FloorGrid& grid) {
    grid.set(kPost, Floor::kOccupied);
    FloorBox box;
    box.include(kPost);
    return box;
  });
  EXPECT_TRUE(changed.contains(kPost));
  EXPECT_EQ(floor.clearance().to_occupied_m(kPost), 0);
  EXPECT_NEAR(floor.clearance().to_doubtful_m(FloorCell{24, 20}), 0.175, 1e-6);
  EXPECT_FALSE(floor.is_free(kPost));
}

TEST(KnownFloor, IsNotFreeUnderABarrier) {
  FloorGrid grid = free_hall();
  FloorClearance clearance;
  const Vec2 p_map_low = grid.centre({10, 10}), p_map_high = grid.centre({30, 10});
  clearance.bar(std::vector<Barrier>{{.segment = {p_map_low, p_map_high}}}, grid.cell_m());
  const KnownFloor floor(std::move(grid), std::move(clearance));
  EXPECT_FALSE(floor.is_free({20, 10}));
  EXPECT_TRUE(floor.is_free({20, 15}));
}

}  // namespace
}  // namespace aisle
