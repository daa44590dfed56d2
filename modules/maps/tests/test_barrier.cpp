#include "aisle/maps/barrier.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

using testing::ElementsAre;

const Footprint kVehicle{.front_m = 1, .rear_m = 0.5, .width_m = 0.6};

TEST(BarrierMet, IsWhatTheOutlineTouchesOrContains) {
  EXPECT_TRUE(meets(kVehicle, {{2, 1}, {-2, -1}})) << "right through it";
  EXPECT_TRUE(meets(kVehicle, {{0.2, 0.1}, {0.3, 0.1}})) << "wholly within";
  EXPECT_TRUE(meets(kVehicle, {{1, 0.2}, {1, 3}})) << "at its front";
  EXPECT_FALSE(meets(kVehicle, {{1.01, -3}, {1.01, 3}})) << "just before it";
  EXPECT_FALSE(meets(kVehicle, {{-0.51, -3}, {-0.51, 3}})) << "just behind it";
  EXPECT_FALSE(meets(kVehicle, {{1.3, 0.1}, {0.7, 0.7}})) << "past its corner";
}

TEST(BarrierMet, IsTheFirstThatIsMetWhereTheVehicleStands) {
  const std::vector<Barrier> barriers = {{.segment = {{0, 5}, {9, 5}}},
                                         {.kind = Barrier::Kind::kGlass, .segment = {{4, 0}, {4, 3}}}};
  EXPECT_EQ(barrier_met(barriers, kVehicle, {2, 2, 0}), nullptr);
  EXPECT_EQ(barrier_met(barriers, kVehicle, {3.2, 2, 0}), &barriers[1]);
  EXPECT_EQ(barrier_met(barriers, kVehicle, {2, 4.2, kPi / 2}), &barriers[0]);
}

TEST(CellsUnder, AreThoseThatALinePasses) {
  EXPECT_THAT(cells_under({{0.1, 0.1}, {1.2, 0.1}}, 0.5),
              ElementsAre(FloorCell{0, 0}, FloorCell{1, 0}, FloorCell{2, 0}));
  EXPECT_THAT(cells_under({{-0.1, 0.7}, {-0.1, -0.2}}, 0.5),
              ElementsAre(FloorCell{-1, -1}, FloorCell{-1, 0}, FloorCell{-1, 1}));
  EXPECT_THAT(cells_under({{0.3, 0.1}, {0.6, 0.4}}, 0.5), ElementsAre(FloorCell{0, 0}, FloorCell{1, 0}));
  EXPECT_THAT(cells_under({{0.1, 0.1}, {0.1, 0.1}}, 0.5), ElementsAre(FloorCell{0, 0})) << "a point";
}

TEST(CellsUnder, EndAtTheFloorsReach) {
  EXPECT_EQ(cells_under({{-1e6, 0.2}, {1e6, 0.2}}, 0.01).size(), 2 * FloorGrid::kReach + 1U);
  EXPECT_TRUE(cells_under({{1e5, 1e5}, {1e6, 1e6}}, 0.05).empty());
}

RC_GTEST_PROP(CellsUnder, LeaveNoGapAndHoldEveryPointOfTheLine, (std::uint64_t seed)) {
  Random random(seed);
  const auto any_point = [&] { return Vec2(random.uniform(-4, 4), random.uniform(-4, 4)); };
  const Segment2 line{any_point(), any_point()};
  const FloorGrid floor(0.1);
  const std::vector<FloorCell> cells = cells_under(line, floor.cell_m());
  for (int i = 0; i <= 400; ++i) {
    const FloorCell cell = floor.cell_at(line.start + i / 400.0 * (line.end - line.start));
    const bool is_there = std::any_of(cells.begin(), cells.end(), [&](FloorCell other) {
      return std::abs(other.x - cell.x) + std::abs(other.y - cell.y) <= 1;
    });
    RC_ASSERT(is_there);
  }
  for (const FloorCell& cell : cells) RC_ASSERT(line.distance(floor.centre(cell)) <= 0.0708);
}

}  // namespace
}  // namespace aisle
