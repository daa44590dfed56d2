#include "aisle/exploration/building_explorer.hpp"

#include <gtest/gtest.h>

#include "drawn_floor.hpp"

namespace aisle {
namespace {

ExplorerParams minding_pockets() {
  ExplorerParams params;
  params.pockets.path_max_m = 8;
  return params;
}

ExploringTarget look_and_decide(BuildingExplorer& explorer, const DrawnFloor& drawn,
                                const Pose2& T_map_vehicle, const Vec2& p_map_middle, const Pose2& T_map_home,
                                std::size_t cycle = 1) {
  const KnownFloor known = drawn.known_now();
  explorer.look_around(known, p_map_middle);
  return explorer.decide(known, T_map_vehicle, T_map_home, cycle);
}

/// Where a vehicle goes from the left end of a corridor that is all known except for a recess.
ExploringTarget target_with_recess_at(double x_m, BuildingExplorer& explorer) {
  DrawnFloor drawn;
  drawn.put_corridor(20, 2);
  drawn.put({20, 0}, {20.05, 2}, Floor::kOccupied);
  drawn.put({x_m, 2}, {x_m + 0.4, 2.05}, Floor::kFree);
  const Pose2 T_map_vehicle{1, 1, 0};
  return look_and_decide(explorer, drawn, T_map_vehicle, {1.35, 1}, T_map_vehicle);
}

TEST(BuildingExplorer, LooksIntoAPocketThatItComesBy) {
  BuildingExplorer explorer(minding_pockets(), ExploringOrder::kRecommended);
  const ExploringTarget target = target_with_recess_at(5, explorer);
  EXPECT_EQ(target.kind, ExploringTarget::Kind::kPath);
  EXPECT_TRUE(target.frontier.is_pocket);
}

TEST(BuildingExplorer, IgnoresPocketsIfConfiguredTo) {
  ExplorerParams params;
  params.pockets.path_max_m = 0;
  BuildingExplorer explorer(params, ExploringOrder::kRecommended);
  EXPECT_EQ(target_with_recess_at(5, explorer).kind, ExploringTarget::Kind::kHome);
}

TEST(BuildingExplorer, GoesHomeRatherThanFarForAPocket) {
  BuildingExplorer explorer(minding_pockets(), ExploringOrder::kRecommended);
  EXPECT_EQ(target_with_recess_at(15, explorer).kind, ExploringTarget::Kind::kHome);
  EXPECT_EQ(explorer.paths_waiting(), 0);
  explorer.stop(2);
}

TEST(BuildingExplorer, LeavesNoFarPocketUndone) {
  DrawnFloor drawn;
  drawn.put_corridor(20, 2);  // its far end is open
  drawn.put({15, 2}, {15.4, 2.05}, Floor::kFree);
  BuildingExplorer explorer(minding_pockets(), ExploringOrder::kRecommended);
  const Pose2 T_map_home{1, 1, 0};
  const auto decide = [&] { return look_and_decide(explorer, drawn, T_map_home, {1.35, 1}, T_map_home); };
  ASSERT_EQ(decide().kind, ExploringTarget::Kind::kPath);
  ASSERT_EQ(explorer.paths_waiting(), 2);
  explorer.abandon_all(2);
  ASSERT_EQ(decide().kind, ExploringTarget::Kind::kHome);
  EXPECT_EQ(explorer.paths_abandoned(), 1) << "the corridor's far end";
}

TEST(BuildingExplorer, RetriesAnAbandonedPathOnceFromElsewhere) {
  DrawnFloor drawn;
  drawn.put_corridor(20, 2);
  BuildingExplorer explorer({}, ExploringOrder::kRecommended);
  const auto kind_at = [&](double x_m) {
    return look_and_decide(explorer, drawn, {x_m, 1, 0}, {x_m, 1}, {1, 1, 0}).kind;
  };
  ASSERT_EQ(kind_at(18), ExploringTarget::Kind::kPath);
  explorer.abandon(0, 2);
  EXPECT_EQ(kind_at(17.5), ExploringTarget::Kind::kHome);
  EXPECT_EQ(kind_at(15), ExploringTarget::Kind::kPath);
  explorer.abandon(0, 3);
  EXPECT_EQ(kind_at(10), ExploringTarget::Kind::kHome);
}

TEST(BuildingExplorer, RetriesAnAbandonedPathOnceWhenItKnowsMore) {
  DrawnFloor drawn;
  drawn.put_corridor(20, 2);
  BuildingExplorer explorer({}, ExploringOrder::kRecommended);
  const auto kind_now = [&] { return look_and_decide(explorer, drawn, {18, 1, 0}, {18, 1}, {1, 1, 0}).kind; };
  ASSERT_EQ(kind_now(), ExploringTarget::Kind::kPath);
  explorer.abandon(0, 2);
  EXPECT_EQ(kind_now(), ExploringTarget::Kind::kHome);
  drawn.put({20, 5}, {23, 8}, Floor::kFree);
  EXPECT_EQ(kind_now(), ExploringTarget::Kind::kPath);
}

/// A corridor that is all known except for what lies beyond a slit in its wall.
class SecondLook : public testing::Test {
 protected:
  SecondLook() {
    drawn_.put_corridor(20, 2);
    drawn_.put({20, 0}, {20.05, 2}, Floor::kOccupied);
    drawn_.put({5, 2}, {5.4, 2.05}, Floor::kFree);
  }

  /// How many pockets it wants to look into from around there, while none of them shows anything.
  int looks_at(double x_m) {
    for (int looks = 0;; ++looks) {
      const ExploringTarget target = look_and_decide(explorer_, drawn_, {x_m, 1, 0}, {x_m, 1}, {1, 1, 0});
      if (target.kind == ExploringTarget::Kind::kHome) return looks;
      explorer_.give_up(target.path, 2);
    }
  }

  DrawnFloor drawn_;
  BuildingExplorer explorer_{minding_pockets(), ExploringOrder::kRecommended};
};

TEST_F(SecondLook, IsWorthWhileFromElsewhereWhereMuchIsHidden) {
  drawn_.put({4, 2.05}, {6.5, 3.5}, Floor::kFree);
  const int looks = looks_at(5);
  EXPECT_GT(looks, 0);
  EXPECT_EQ(looks_at(5.5), 0);
  EXPECT_EQ(looks_at(8), looks);
  EXPECT_EQ(looks_at(5), 0);
}

TEST_F(SecondLook, IsNotWorthWhileIntoARecess) {
  EXPECT_EQ(looks_at(5), 1);
  EXPECT_EQ(looks_at(8), 0);
}

TEST(BuildingExplorer, RetriesAGivenUpPathOnCellsHalfAsWide) {
  DrawnFloor coarse, fine(0.025);
  for (DrawnFloor* drawn : {&coarse, &fine}) drawn->put_corridor(20, 2);
  BuildingExplorer explorer({}, ExploringOrder::kRecommended);
  const auto target_on = [&](const DrawnFloor& drawn) {
    return look_and_decide(explorer, drawn, {18, 1, 0}, {18, 1}, {1, 1, 0});
  };
  ASSERT_EQ(target_on(coarse).kind, ExploringTarget::Kind::kPath);
  EXPECT_FALSE(explorer.has_left_floor());
  explorer.give_up(0, 2);
  ASSERT_EQ(target_on(coarse).kind, ExploringTarget::Kind::kHome);
  ASSERT_TRUE(explorer.has_left_floor());
  explorer.halve_cells();
  const ExploringTarget again = target_on(fine);
  EXPECT_EQ(again.kind, ExploringTarget::Kind::kPath);
  EXPECT_EQ(again.path, 0);
  EXPECT_EQ(explorer.paths_waiting(), 1);
}

/// C99's order: all paths off a crossing were explored, and the vehicle has to go back there.
class BackToACrossing : public testing::Test {
 protected:
  BackToACrossing() {
    drawn_.put_corridor(20, 2);
    drawn_.put({5, 2}, {7, 2.05}, Floor::kFree);
    decide(T_map_crossing_);
    drawn_.put({4.95, 2.05}, {7.05, 2.1}, Floor::kOccupied);
    decide({3, 1, kPi});
    drawn_.put({20, 0}, {20.05, 2}, Floor::kOccupied);
  }

  ExploringTarget decide(const Pose2& T_map_vehicle) {
    return look_and_decide(explorer_, drawn_, T_map_vehicle, T_map_vehicle.position(), T_map_crossing_,
                           ++cycle_);
  }

  DrawnFloor drawn_;
  BuildingExplorer explorer_{{}, ExploringOrder::kPublished};
  Pose2 T_map_crossing_{10, 1, kPi};
  Pose2 T_map_end_{18, 1, 0};
  std::size_t cycle_ = 0;
};

TEST_F(BackToACrossing, GoesThereFirst) {
  const ExploringTarget target = decide(T_map_end_);
  EXPECT_EQ(target.kind, ExploringTarget::Kind::kCrossing);
  EXPECT_EQ(target.T_map_back.position(), T_map_crossing_.position());
  EXPECT_EQ(decide(T_map_crossing_).kind, ExploringTarget::Kind::kHome);
}

TEST_F(BackToACrossing, GoesOnFromElsewhereIfItDoesNotGetThere) {
  decide(T_map_end_);
  explorer_.pass_crossing_by();
  EXPECT_EQ(decide(T_map_end_).kind, ExploringTarget::Kind::kHome);
}

}  // namespace
}  // namespace aisle
