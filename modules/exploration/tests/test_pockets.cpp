#include <gtest/gtest.h>

#include <cmath>

#include "drawn_floor.hpp"

namespace aisle {
namespace {

/// A corridor that is all known.
DrawnFloor closed_corridor() {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  drawn.put({5, 0}, {5.05, 2}, Floor::kOccupied);
  return drawn;
}

TEST(Pockets, WhereAllIsKnownThereIsNone) {
  EXPECT_TRUE(closed_corridor().pockets().empty());
}

TEST(Pockets, ARecessTooNarrowForTheVehicleIsOne) {
  DrawnFloor drawn = closed_corridor();
  drawn.put({2, 2}, {2.4, 2.05}, Floor::kFree);
  EXPECT_TRUE(drawn.frontiers().empty());
  const auto pockets = drawn.pockets();
  ASSERT_EQ(pockets.size(), 1);
  EXPECT_TRUE(pockets[0].is_pocket);
  for (const Vec2& p : pockets[0].edge) EXPECT_NEAR(p.y(), 2.075, 0.01);
  const Vec2 p_stand = drawn.floor.centre(pockets[0].viewpoint);
  EXPECT_LT(p_stand.y(), 2);
  EXPECT_NEAR(pockets[0].path_m, (p_stand - Vec2(1, 1)).norm(), 0.15);
}

TEST(Pockets, AnEdgeTooShortIsNone) {
  DrawnFloor drawn = closed_corridor();
  drawn.put({2, 2}, {2.2, 2.05}, Floor::kFree);
  EXPECT_TRUE(drawn.pockets().empty());
}

TEST(Pockets, ARoomBehindADoorTooNarrowForTheVehicleIsLookedInto) {
  DrawnFloor drawn = closed_corridor();
  drawn.put({2, 2}, {2.5, 2.05}, Floor::kFree);
  drawn.put({1.5, 2.05}, {3, 4}, Floor::kFree);
  EXPECT_TRUE(drawn.frontiers().empty());
  EXPECT_FALSE(drawn.pockets().empty());
}

TEST(Pockets, ALineOfSightThroughASlitIsFound) {
  DrawnFloor drawn = closed_corridor();
  drawn.put({2, 2}, {2.1, 2.05}, Floor::kFree);
  drawn.put({2, 2.05}, {4.5, 4.5}, Floor::kFree);
  drawn.put({1.95, 2.05}, {2, 4.5}, Floor::kOccupied);
  drawn.put({4.5, 2.05}, {4.55, 4.55}, Floor::kOccupied);
  drawn.put({2, 4.5}, {3.6, 4.55}, Floor::kOccupied);
  drawn.put({3.9, 4.5}, {4.55, 4.55}, Floor::kOccupied);
  EXPECT_EQ(drawn.pockets().size(), 1);
}

TEST(Pockets, BehindADoorsLeafALineOfSightAlongTheEdgeIsFound) {
  DrawnFloor drawn = closed_corridor();
  drawn.put({2, 2}, {2.3, 2.05}, Floor::kFree);
  drawn.put({2, 2.05}, {4.5, 4.5}, Floor::kFree);
  drawn.put({1.95, 2.05}, {2, 3}, Floor::kOccupied);
  drawn.put({4.5, 2.05}, {4.55, 4.55}, Floor::kOccupied);
  drawn.put({2, 4.5}, {4.5, 4.55}, Floor::kOccupied);
  ASSERT_EQ(drawn.pockets().size(), 1);
  EXPECT_LT(drawn.floor.centre(drawn.pockets()[0].viewpoint).y(), 2);
}

TEST(Pockets, ALongEdgeIsWorthALongerPath) {
  const PocketParams params{.path_max_m = 3, .path_max_m_per_m2 = 60};
  const auto is_far = [&](double behind_m2, double path_m) {
    return params.is_far({.behind_m2 = behind_m2, .path_m = path_m, .is_pocket = true});
  };
  EXPECT_FALSE(is_far(0.01, 2.9));
  EXPECT_TRUE(is_far(0.01, 3.1));
  EXPECT_FALSE(is_far(0.15, 8.9));
  EXPECT_TRUE(is_far(0.15, 9.1));
  EXPECT_FALSE(params.is_far({.path_m = 99, .is_pocket = false}));
}

TEST(Pockets, WhatAFrontierLeadsToIsNone) {
  DrawnFloor drawn;
  drawn.put_corridor(5, 2);
  ASSERT_EQ(drawn.frontiers().size(), 1);
  EXPECT_TRUE(drawn.pockets().empty());
}

TEST(Pockets, FloorThatCannotBeSeenFromReachableFloorIsNone) {
  DrawnFloor drawn = closed_corridor();
  drawn.put({6, 0}, {8, 2}, Floor::kFree);
  EXPECT_TRUE(drawn.pockets().empty());
}

}  // namespace
}  // namespace aisle
