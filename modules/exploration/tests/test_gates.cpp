#include <gtest/gtest.h>

#include "drawn_floor.hpp"

namespace aisle {
namespace {

TEST(Gates, CorridorWhoseEndIsNotSeenYetHasOne) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  const auto gates = drawn.gates();
  ASSERT_EQ(gates.size(), 1);
  EXPECT_NEAR(gates[0].p_map.x(), 5 - drawn.params.room_m, 0.15);
  EXPECT_NEAR(gates[0].p_map.y(), 1, 0.3);
  EXPECT_NEAR(gates[0].way_m, gates[0].p_map.x() - 1, 0.2);
}

TEST(Gates, ClosedCorridorHasNone) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  drawn.put({5, 0}, {5.05, 2}, Floor::kOccupied);
  EXPECT_TRUE(drawn.gates().empty());
}

TEST(Gates, DoorIsOneWhenTheVehicleFitsThrough) {
  for (const double width_m : {0.55, 1.0}) {
    DrawnFloor drawn;
    drawn.put_corridor(5, 2);
    drawn.put({5, 0}, {5.05, 2}, Floor::kOccupied);
    drawn.put({2, 2}, {2 + width_m, 2.05}, Floor::kFree);
    EXPECT_EQ(drawn.gates().size(), width_m > 0.9 ? 1 : 0) << width_m;
  }
}

TEST(Gates, WhatCannotBeReachedIsNone) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  drawn.put({5, 0}, {5.05, 2}, Floor::kOccupied);
  drawn.put({7, 0}, {9, 2}, Floor::kFree);
  EXPECT_TRUE(drawn.gates().empty());
}

TEST(Gates, RimLiesWhereTheFreeFloorEnds) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  const auto gates = drawn.gates();
  ASSERT_EQ(gates.size(), 1);
  ASSERT_FALSE(gates[0].rim.empty());
  for (const Vec2& p : gates[0].rim) EXPECT_NEAR(p.x(), 5.025, 0.06);
}

TEST(Gates, AreFoundWhereTheyWereOnCellsHalfAsWide) {
  DrawnFloor coarse, fine(0.025);
  for (DrawnFloor* drawn : {&coarse, &fine}) drawn->put_corridor(5, 2);
  const Gate halved = with_cells_halved(coarse.gates().at(0)), found = fine.gates().at(0);
  ASSERT_EQ(halved.sill.size(), coarse.gates()[0].sill.size());
  for (const FloorCell cell : halved.sill) EXPECT_TRUE(found.box.widened(2).contains(cell));
  EXPECT_TRUE(halved.box.widened(2).contains(found.box.low));
}

}  // namespace
}  // namespace aisle
