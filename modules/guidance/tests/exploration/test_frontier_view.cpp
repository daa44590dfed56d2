#include "aisle/guidance/exploration/frontier_view.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "aisle/core/random.hpp"
#include "free_floor.hpp"

namespace aisle {
namespace {

/// A corridor known to the east up to x = 10. Unknown floor blocks half of its width.
class FrontierView : public testing::Test {
 protected:
  FrontierView() : known_(free_floor({{Vec2(0, 0), Vec2(6, 4)}, {Vec2(6, 2), Vec2(10, 4)}})) {
    for (int i = 0; i < 8; ++i) frontier_.edge.emplace_back(9.9, 2.2 + 0.2 * i);
  }

  bool sees(const Pose2& T_map_vehicle, double reach_m = 5, std::span<const float> near_m = {}) const {
    return sees_frontier({kGeometry, near_m, reach_m}, known_, T_map_vehicle, frontier_, 4);
  }

  KnownFloor known_;
  Frontier frontier_;
};

TEST_F(FrontierView, SeesWhatLiesBeforeItWithinReach) {
  EXPECT_TRUE(sees({5, 3, 0}));
  EXPECT_FALSE(sees({5, 3, 0}, 3));
}

TEST_F(FrontierView, SeesNothingBehindIt) {
  EXPECT_FALSE(sees({6.5, 3, kPi}));
}

TEST_F(FrontierView, DoesNotSeeThroughUnknownFloor) {
  EXPECT_FALSE(sees({5, 0.5, 0}));
}

TEST_F(FrontierView, SeesNothingInTheBeamsBlindZone) {
  const std::vector<float> near_m(181, 4.5F);
  EXPECT_FALSE(sees({5, 3, 0}, 5, near_m));
  EXPECT_TRUE(sees({4.5, 3, 0}, 5, near_m));
}

TEST_F(FrontierView, LooksIntoAPocketAcrossItsEdgeNotAlongIt) {
  frontier_.edge.assign(4, Vec2(5, 4.175));
  EXPECT_FALSE(sees({3, 3, 0})) << "unknown floor lies before it";
  frontier_.is_pocket = true;
  EXPECT_TRUE(sees({3, 3, 0}));
  EXPECT_FALSE(sees({1.5, 3.8, 0}));
  for (double x = 4.525; x < 5.2; x += 0.05) occupy(known_, known_.grid().cell_at({x, 4.025}));
  EXPECT_FALSE(sees({3, 3, 0})) << "a wall stands in the line of sight";
}

/// Oracle: where no clearance is known, every step of the line of sight is checked.
RC_GTEST_PROP(FrontierViewInStrides, SeesTheSameAsStepByStep, (std::uint64_t seed)) {
  Random random(seed);
  KnownFloor known = free_floor({{Vec2(0, 0), Vec2(8, 8)}});
  const auto place = [&] { return Vec2(8 * random.uniform(), 8 * random.uniform()); };
  for (int i = 0; i < 25; ++i)
    set(known, known.grid().cell_at(place()), i % 3 == 0 ? Floor::kUnknown : Floor::kOccupied);
  const KnownFloor without_clearance(known.grid(), FloorClearance(0));
  for (int i = 0; i < 200; ++i) {
    Frontier frontier;
    frontier.is_pocket = random.uniform() < 0.5;
    frontier.edge = {place()};
    const Vec2 p_map = place();
    const Pose2 T_map_vehicle{p_map.x(), p_map.y(), 2 * kPi * random.uniform()};
    const auto sees_on = [&](const KnownFloor& floor) {
      return sees_frontier({kGeometry, {}, 6}, floor, T_map_vehicle, frontier, 1);
    };
    RC_ASSERT(sees_on(known) == sees_on(without_clearance));
  }
}

}  // namespace
}  // namespace aisle
