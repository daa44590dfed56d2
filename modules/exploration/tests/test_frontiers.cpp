#include <gtest/gtest.h>

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
