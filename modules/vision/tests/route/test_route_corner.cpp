#include "aisle/vision/route/route_corner.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/geometry/segment2.hpp"

namespace aisle {
namespace {

const Vec2 kEye(0.9, 0);

/// Where rays from the camera first meet what stands there, from left to right.
std::vector<Vec2> edges_of(const std::vector<Segment2>& floor_edges) {
  constexpr double kHalfView_rad = 36 * kDegree;
  constexpr int kRays = 80;
  std::vector<Vec2> edges;
  for (int i = 0; i < kRays; ++i) {
    const double angle_rad = kHalfView_rad * (1 - 2.0 * i / (kRays - 1));
    const Vec2 ray = unit(angle_rad);
    double nearest_m = 6;
    for (const Segment2& floor_edge : floor_edges) {
      const Vec2 along = floor_edge.end - floor_edge.start, off = floor_edge.start - kEye;
      const double cross = ray.x() * along.y() - ray.y() * along.x();
      if (std::abs(cross) < 1e-9) continue;
      const double away_m = (off.x() * along.y() - off.y() * along.x()) / cross;
      const double share = (off.x() * ray.y() - off.y() * ray.x()) / cross;
      if (away_m > 0 && share >= 0 && share <= 1) nearest_m = std::min(nearest_m, away_m);
    }
    if (nearest_m < 6) edges.emplace_back(kEye + nearest_m * ray);
  }
  return edges;
}

/// An aisle with a branch to the left from `corner_m` on, 1.6 m wide.
std::vector<Segment2> branch_to_the_left(double corner_m) {
  return {{{0, 0.7}, {corner_m, 0.7}},
          {{corner_m, 0.7}, {corner_m, 4}},
          {{corner_m + 1.6, 0.7}, {corner_m + 1.6, 4}},
          {{corner_m + 1.6, 0.7}, {8, 0.7}},
          {{0, -0.7}, {8, -0.7}}};
}

std::vector<Segment2> mirrored(std::vector<Segment2> floor_edges) {
  for (Segment2& floor_edge : floor_edges)
    floor_edge = {{floor_edge.start.x(), -floor_edge.start.y()}, {floor_edge.end.x(), -floor_edge.end.y()}};
  return floor_edges;
}

TEST(RouteCorner, LiesWhereWhatStandsBesideTheRouteEnds) {
  for (const double corner_m : {2.2, 2.6, 3.0}) {
    const auto edges = edges_of(branch_to_the_left(corner_m));
    const auto corner = find_route_corner(edges, kEye, RouteSide::kLeft, {});
    ASSERT_TRUE(corner) << corner_m;
    EXPECT_NEAR(corner->x(), corner_m, 0.1);
    EXPECT_NEAR(corner->y(), 0.7, 0.01);
  }
}

TEST(RouteCorner, IsFoundOnEitherSideAndOnlyThere) {
  const auto left = edges_of(branch_to_the_left(2.5)), right = edges_of(mirrored(branch_to_the_left(2.5)));
  EXPECT_FALSE(find_route_corner(left, kEye, RouteSide::kRight, {}));
  EXPECT_FALSE(find_route_corner(right, kEye, RouteSide::kLeft, {}));
  const auto corner = find_route_corner(right, kEye, RouteSide::kRight, {});
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->x(), 2.5, 0.1);
  EXPECT_NEAR(corner->y(), -0.7, 0.01);
}

TEST(RouteCorner, IsNotSeenOnceTheViewIsPastIt) {
  EXPECT_FALSE(find_route_corner(edges_of(branch_to_the_left(1.5)), kEye, RouteSide::kLeft, {}));
}

TEST(RouteCorner, AnAisleWithoutBranchesHasNone) {
  const auto edges = edges_of({{{0, 0.7}, {4, 0.7}}, {{4, 0.7}, {4, -0.7}}, {{0, -0.7}, {4, -0.7}}});
  EXPECT_FALSE(find_route_corner(edges, kEye, RouteSide::kLeft, {}));
  EXPECT_FALSE(find_route_corner(edges, kEye, RouteSide::kRight, {}));
}

TEST(RouteCorner, ASideThatIsSeenSparselyFarAwayHasNone) {
  auto edges = edges_of({{{0, 0.7}, {8, 0.7}}, {{0, -0.7}, {8, -0.7}}});
  std::erase_if(edges, [](const Vec2& p) { return p.x() > 2.6 && p.x() < 3.6; });
  EXPECT_FALSE(find_route_corner(edges, kEye, RouteSide::kLeft, {}));
  EXPECT_FALSE(find_route_corner(edges, kEye, RouteSide::kRight, {}));
}

TEST(RouteCorner, WhatIsSeenOfASideMustBeLongEnough) {
  const std::vector<Segment2> post = {{{2.5, 0.7}, {2.6, 0.7}}, {{6, -3}, {6, 5}}};
  EXPECT_FALSE(find_route_corner(edges_of(post), kEye, RouteSide::kLeft, {}));
}

}  // namespace
}  // namespace aisle
