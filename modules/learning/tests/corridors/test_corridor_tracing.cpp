#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "aisle/core/angle.hpp"
#include "aisle/core/random.hpp"
#include "aisle/learning/corridors/corridor_tracing.hpp"

namespace aisle {
namespace {

using NodeKind = CorridorNode::Kind;

/// Frees the cells of a rectangle and surrounds it with occupied cells, except where it is free already.
void add_room(FloorGrid& floor, const Vec2& min, const Vec2& max) {
  const FloorCell low = floor.cell_at(min), high = floor.cell_at(max);
  for (int y = low.y - 1; y <= high.y; ++y) {
    for (int x = low.x - 1; x <= high.x; ++x) {
      const bool is_inside = x >= low.x && y >= low.y && x < high.x && y < high.y;
      if (is_inside || floor.at(FloorCell{x, y}) == Floor::kUnknown)
        floor.set({x, y}, is_inside ? Floor::kFree : Floor::kOccupied);
    }
  }
}

CorridorGraph traced(const FloorGrid& floor, const Vec2& start) {
  return trace_corridors(floor, start, {});
}

TEST(CorridorTracing, NothingKnownMakesNoGraph) {
  EXPECT_TRUE(traced(FloorGrid(), {0, 0}).nodes.empty());
}

TEST(CorridorTracing, OneCorridorHasTwoEndsAndItsWidth) {
  FloorGrid floor;
  add_room(floor, {0, -1}, {20, 1});
  const CorridorGraph graph = traced(floor, {1, 0});
  ASSERT_EQ(graph.corridors.size(), 1U);
  EXPECT_EQ(graph.count(NodeKind::kEnd), 2U);
  EXPECT_NEAR(graph.corridors[0].width_m, 2, 0.11);
  EXPECT_NEAR(graph.length_m(), 18, 0.3);
  EXPECT_LT((graph.nodes[0].p_map - Vec2(1, 0)).norm(), 0.2);
  EXPECT_LT((graph.nodes[1].p_map - Vec2(19, 0)).norm(), 0.2);
}

TEST(CorridorTracing, ASingleRoomIsOnePlaceOrOneShortCorridor) {
  FloorGrid floor;
  add_room(floor, {0, 0}, {3, 3});
  const CorridorGraph graph = traced(floor, {1, 1});
  EXPECT_EQ(graph.count(NodeKind::kCrossing), 0U);
  EXPECT_LT(graph.length_m(), 0.5);
}

TEST(CorridorTracing, ACrossHasOneCrossingWithFourCorridors) {
  FloorGrid floor;
  add_room(floor, {0, -1}, {20, 1});
  add_room(floor, {9, -10}, {10.6, 10});
  const CorridorGraph graph = traced(floor, {1, 0});
  ASSERT_EQ(graph.count(NodeKind::kCrossing), 1U);
  EXPECT_EQ(graph.count(NodeKind::kEnd), 4U);
  EXPECT_EQ(graph.corridors.size(), 4U);
  const auto crossing = std::find_if(graph.nodes.begin(), graph.nodes.end(),
                                     [](const CorridorNode& n) { return n.kind == NodeKind::kCrossing; });
  EXPECT_LT((crossing->p_map - Vec2(9.8, 0)).norm(), 0.3);
}

TEST(CorridorTracing, TwoBranchesAShortDistanceApartAreTwoCrossings) {
  FloorGrid floor;
  add_room(floor, {0, -1}, {20, 1});
  add_room(floor, {6, 0}, {8, 8});
  add_room(floor, {12, -8}, {14, 0});
  const CorridorGraph graph = traced(floor, {1, 0});
  EXPECT_EQ(graph.count(NodeKind::kCrossing), 2U);
  EXPECT_EQ(graph.corridors.size(), 5U);
}

TEST(CorridorTracing, ALoopWithoutACrossingHasOneNodeNearTheStart) {
  FloorGrid floor;
  add_room(floor, {0, 0}, {20, 2});
  add_room(floor, {0, 10}, {20, 12});
  add_room(floor, {0, 0}, {2, 12});
  add_room(floor, {18, 0}, {20, 12});
  const CorridorGraph graph = traced(floor, {10, 1});
  ASSERT_EQ(graph.nodes.size(), 1U);
  EXPECT_EQ(graph.nodes[0].kind, NodeKind::kRound);
  EXPECT_LT((graph.nodes[0].p_map - Vec2(10, 1)).norm(), 0.2);
  ASSERT_EQ(graph.corridors.size(), 1U);
  EXPECT_NEAR(graph.length_m(), 2 * (18 + 10), 2.5);
}

TEST(CorridorTracing, AnAlcoveIsNoCrossingAndARoomBehindADoorIs) {
  FloorGrid floor;
  add_room(floor, {0, -1}, {20, 1});
  add_room(floor, {4, 1}, {5.5, 1.6});
  EXPECT_EQ(traced(floor, {1, 0}).count(NodeKind::kCrossing), 0U);
  add_room(floor, {10, 1}, {11, 1.2});
  add_room(floor, {9, 1.2}, {13, 5});
  EXPECT_EQ(traced(floor, {1, 0}).count(NodeKind::kCrossing), 1U);
}

TEST(CorridorTracing, WhereTheVehicleDoesNotGetThroughThereIsNoCorridor) {
  FloorGrid floor;
  add_room(floor, {0, -1}, {20, 1});
  add_room(floor, {10, 1}, {10.6, 6});
  const CorridorGraph graph = traced(floor, {1, 0});
  EXPECT_EQ(graph.count(NodeKind::kCrossing), 0U);
  EXPECT_EQ(graph.corridors.size(), 1U);
}

TEST(CorridorTracing, FarFromDrivableFloorThereIsNoGraph) {
  FloorGrid floor;
  add_room(floor, {0, -1}, {20, 1});
  EXPECT_TRUE(traced(floor, {10, 5}).nodes.empty());
}

/// A comb of corridors with rough walls: branches to the left of a main corridor.
struct RoughComb {
  FloorGrid floor;
  std::size_t branches = 0;
  Vec2 p_map_start = Vec2::Zero();
};

RoughComb any_comb(Random& random) {
  RoughComb comb{.floor = FloorGrid(), .branches = 1 + random.index(4)};
  const double pitch_m = random.uniform(5, 8), main_m = random.uniform(1.2, 2.5);
  const double end_m = pitch_m * static_cast<double>(comb.branches + 1);
  const Pose2 T_map_comb{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-kPi, kPi)};
  const double width_m = random.uniform(1.2, 2.5), rough_m = random.uniform(0, 0.06);
  const auto is_free = [&](const Vec2& p) {
    if (p.x() > 0 && p.x() < end_m && std::abs(p.y()) < main_m / 2) return true;
    const double branch = std::round(p.x() / pitch_m);
    return branch >= 1 && branch <= static_cast<double>(comb.branches) &&
           std::abs(p.x() - branch * pitch_m) < width_m / 2 && p.y() > 0 && p.y() < 6;
  };
  for (double x = -1; x < end_m + 1; x += 0.02) {
    for (double y = -3; y < 7; y += 0.02) {
      const Vec2 rough(random.uniform(-rough_m, rough_m), random.uniform(-rough_m, rough_m));
      if (is_free(Vec2(x, y) + rough))
        comb.floor.set(comb.floor.cell_at(T_map_comb * Vec2(x, y)), Floor::kFree);
    }
  }
  comb.p_map_start = T_map_comb * Vec2(1, 0);
  return comb;
}

RC_GTEST_PROP(CorridorTracing, ARoughCombHasACrossingForEveryBranchWhicheverPathItLies,
              (std::uint64_t seed)) {
  Random random(seed);
  const RoughComb comb = any_comb(random);
  const CorridorGraph graph = traced(comb.floor, comb.p_map_start);
  RC_ASSERT(graph.count(NodeKind::kCrossing) == comb.branches);
  RC_ASSERT(graph.count(NodeKind::kEnd) == comb.branches + 2);
}

}  // namespace
}  // namespace aisle
