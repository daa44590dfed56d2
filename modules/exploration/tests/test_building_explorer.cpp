#include "aisle/exploration/building_explorer.hpp"

#include <gtest/gtest.h>

#include "drawn_floor.hpp"

namespace aisle {
namespace {

ExplorerParams minding_nooks() {
  ExplorerParams params;
  params.nooks.way_max_m = 8;
  return params;
}

/// Where the vehicle goes that stands at the left end of a corridor of which all is known but a recess.
ExploringTarget target_with_recess_at(double x_m, BuildingExplorer& explorer) {
  DrawnFloor drawn;
  drawn.put_corridor(20, 2);
  drawn.put({20, 0}, {20.05, 2}, Floor::kOccupied);
  drawn.put({x_m, 2}, {x_m + 0.4, 2.05}, Floor::kFree);
  const Pose2 T_map_vehicle{1, 1, 0};
  return explorer.decide(drawn.floor, drawn.clearance_now(), T_map_vehicle, {1.35, 1}, T_map_vehicle, 1);
}

TEST(BuildingExplorer, LooksIntoANookThatItComesBy) {
  BuildingExplorer explorer(minding_nooks(), ExploringOrder::kRecommended);
  const ExploringTarget target = target_with_recess_at(5, explorer);
  EXPECT_EQ(target.kind, ExploringTarget::Kind::kPath);
  EXPECT_TRUE(target.gate.is_nook);
}

TEST(BuildingExplorer, PassesNooksUnlessToldToMindThem) {
  BuildingExplorer explorer({}, ExploringOrder::kRecommended);
  EXPECT_EQ(target_with_recess_at(5, explorer).kind, ExploringTarget::Kind::kHome);
}

TEST(BuildingExplorer, GoesHomeRatherThanFarForANook) {
  BuildingExplorer explorer(minding_nooks(), ExploringOrder::kRecommended);
  EXPECT_EQ(target_with_recess_at(15, explorer).kind, ExploringTarget::Kind::kHome);
  EXPECT_EQ(explorer.paths_waiting(), 0);
  explorer.stop(2);
}

}  // namespace
}  // namespace aisle
