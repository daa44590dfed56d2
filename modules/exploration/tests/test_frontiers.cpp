#include <gtest/gtest.h>

#include <set>

#include "drawn_floor.hpp"

namespace aisle {
namespace {

TEST(Frontiers, CorridorWhoseEndIsNotSeenYetHasOne) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  const auto frontiers = drawn.frontiers();
  ASSERT_EQ(frontiers.size(), 1);
  EXPECT_NEAR(frontiers[0].p_map.x(), 5 - drawn.params.clearance_m, 0.15);
  EXPECT_NEAR(frontiers[0].p_map.y(), 1, 0.3);
  EXPECT_NEAR(frontiers[0].path_m, frontiers[0].p_map.x() - 1, 0.2);
}

TEST(Frontiers, ClosedCorridorHasNone) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  drawn.put({5, 0}, {5.05, 2}, Floor::kOccupied);
  EXPECT_TRUE(drawn.frontiers().empty());
}

TEST(Frontiers, DoorIsOneWhenTheVehicleFitsThrough) {
  for (const double width_m : {0.55, 1.0}) {
    DrawnFloor drawn;
    drawn.put_corridor(5, 2);
    drawn.put({5, 0}, {5.05, 2}, Floor::kOccupied);
    drawn.put({2, 2}, {2 + width_m, 2.05}, Floor::kFree);
    EXPECT_EQ(drawn.frontiers().size(), width_m > 0.9 ? 1 : 0) << width_m;
  }
}

/// The floor seen in the middle of a hall ends all around: one look shows only a part of that.
TEST(Frontiers, AreCutWhereOneLookCannotShowThem) {
  DrawnFloor drawn;
  drawn.put({0, 0}, {20, 20}, Floor::kFree);
  const auto frontiers = drawn.frontiers();
  const int most = static_cast<int>(drawn.params.length_max_m / drawn.floor.cell_m()) + 1;
  std::set<FloorCell> cells;
  std::size_t counted = 0;
  for (const Frontier& frontier : frontiers) {
    EXPECT_LE(frontier.box.end.x - frontier.box.low.x, most);
    EXPECT_LE(frontier.box.end.y - frontier.box.low.y, most);
    cells.insert(frontier.cells.begin(), frontier.cells.end());
    counted += frontier.cells.size();
  }
  EXPECT_EQ(cells.size(), counted) << "none belongs to two";
  drawn.params.length_max_m = 100;
  const auto whole = drawn.frontiers();
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_EQ(cells, std::set<FloorCell>(whole.front().cells.begin(), whole.front().cells.end()));
}

TEST(Frontiers, UnreachableOnesAreLeftOut) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  drawn.put({5, 0}, {5.05, 2}, Floor::kOccupied);
  drawn.put({7, 0}, {9, 2}, Floor::kFree);
  EXPECT_TRUE(drawn.frontiers().empty());
}

TEST(Frontiers, RimLiesWhereTheFreeFloorEnds) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  const auto frontiers = drawn.frontiers();
  ASSERT_EQ(frontiers.size(), 1);
  ASSERT_FALSE(frontiers[0].edge.empty());
  for (const Vec2& p : frontiers[0].edge) EXPECT_NEAR(p.x(), 5.025, 0.06);
}

TEST(Frontiers, AreFoundWhereTheyWereOnCellsHalfAsWide) {
  DrawnFloor coarse, fine(0.025);
  for (DrawnFloor* drawn : {&coarse, &fine}) drawn->put_corridor(5, 2);
  const Frontier halved = with_cells_halved(coarse.frontiers().at(0)), found = fine.frontiers().at(0);
  ASSERT_EQ(halved.cells.size(), coarse.frontiers()[0].cells.size());
  for (const FloorCell cell : halved.cells) EXPECT_TRUE(found.box.widened(2).contains(cell));
  EXPECT_TRUE(halved.box.widened(2).contains(found.box.low));
}

}  // namespace
}  // namespace aisle
