#include "aisle/vision/route/route_view.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "seen_floor.hpp"

namespace aisle {
namespace {

constexpr double kVehicleWidth_m = 0.6;
constexpr double kMarkerHeight_m = 0.3;

RouteView eye() {
  return {{}, kFloorLens, floor_mount(), kFloorWidth_px, kFloorHeight_px, kVehicleWidth_m};
}

RouteView eye_by_markers() {
  return {{}, kFloorLens, floor_mount(), kFloorWidth_px, kFloorHeight_px, kVehicleWidth_m, kMarkerHeight_m};
}

/// A bright floor between dark sides, with a dark obstacle on it.
Image path(double right_m, double left_m, const Segment2& thing = {{20, 20}, {20, 20}}) {
  return seen_floor([&](const Vec2& p) {
    const bool is_route = p.y() > right_m && p.y() < left_m && p.x() < 6;
    const bool is_thing =
        p.x() > thing.start.x() && p.x() < thing.end.x() && p.y() > thing.start.y() && p.y() < thing.end.y();
    return is_route && !is_thing ? 165.0 : 60.0;
  });
}

TEST(RouteView, NeedsACameraThatSeesTheFloor) {
  const CameraMount ahead{.p_vehicle_camera = {0.8, 0, 1.25}, .tilt_rad = -30 * kDegree};
  EXPECT_TRUE(RouteView::sees_floor(kFloorLens, floor_mount(), kFloorWidth_px, kFloorHeight_px));
  EXPECT_FALSE(RouteView::sees_floor(kFloorLens, ahead, kFloorWidth_px, kFloorHeight_px));
  EXPECT_THROW(RouteView({}, kFloorLens, ahead, kFloorWidth_px, kFloorHeight_px, kVehicleWidth_m),
               std::invalid_argument);
}

TEST(RouteView, TheMiddleLiesBetweenTheSides) {
  RouteView view = eye();
  const auto middle = view.middle(view.look(path(-0.9, 0.5)), 0, 0);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(middle->y(), -0.2, 0.06);
  EXPECT_GT(middle->x(), 1.5);
}

TEST(RouteView, MaskingASideMovesTheMiddleToTheOther) {
  RouteView view = eye();
  const RouteSight sight = view.look(path(-0.8, 0.8));
  EXPECT_GT(view.middle(sight, 0, 0.5)->y(), 0.2);
  EXPECT_LT(view.middle(sight, 0.5, 0)->y(), -0.2);
}

TEST(RouteView, TheCheckRegionsTellWhereSomethingStands) {
  RouteView view = eye();
  const RouteChecks free = view.look(path(-1, 1)).checks;
  EXPECT_FALSE(free.ahead || free.left || free.right);
  const RouteChecks ahead = view.look(path(-1, 1, {{1.5, -0.25}, {2.2, 0.3}})).checks;
  EXPECT_TRUE(ahead.ahead);
  const RouteChecks left = view.look(path(-1, 0.3)).checks;
  EXPECT_TRUE(left.left);
  EXPECT_FALSE(left.right);
  EXPECT_GT(left.right_share, left.left_share);
}

TEST(RouteView, EdgesLieWhereTheRouteEnds) {
  RouteView view = eye();
  const RouteSight sight = view.look(path(-0.6, 0.6));
  ASSERT_THAT(sight.p_vehicle_edges, testing::SizeIs(testing::Gt(20U)));
  for (const Vec2& p : sight.p_vehicle_edges) {
    if (p.x() >= 3) continue;
    EXPECT_NEAR(std::abs(p.y()), 0.6, 0.1) << p.transpose();
  }
  EXPECT_TRUE(view.sees_route(sight, {2, 0}));
  EXPECT_FALSE(view.sees_route(sight, {2, 0.8}));
  EXPECT_FALSE(view.sees_route(sight, {0, 0})) << "below the view";
}

TEST(RouteView, WhatStandsOnThePatchOrBeforeItDarkensIt) {
  RouteView view = eye();
  const double free_grey = view.look(path(-1, 1)).patch_grey;
  for (const double ahead_m : {1.2, 1.4, 1.5, 1.7}) {
    for (const double lateral_m : {-0.3, 0.0, 0.3}) {
      const Vec2 p(ahead_m, lateral_m);
      const Image there = path(-1, 1, {p - Vec2(0.05, 0.05), p + Vec2(0.15, 0.05)});
      EXPECT_EQ(view.is_before_patch_end(p), view.look(there).patch_grey < free_grey - 1) << p.transpose();
    }
  }
}

TEST(RouteView, WhereTheViewEndsIsNoEdge) {
  RouteView view = eye();
  const double lowest_m = view.floor_point({kFloorWidth_px / 2.0, kFloorHeight_px - 1.0})->x();
  const RouteSight sight = view.look(path(-0.9, 0.3));
  ASSERT_FALSE(sight.p_vehicle_cut_off.empty()) << "the left side is nearer than the view's lower corner";
  for (const Vec2& p : sight.p_vehicle_cut_off) {
    EXPECT_NEAR(p.x(), lowest_m, 0.01);
    EXPECT_GT(p.y(), 0.25);
  }
  for (const Vec2& p : sight.p_vehicle_edges) EXPECT_GT(p.x(), lowest_m + 0.001);
}

/// An obstacle across the route, nearly as bright as the floor.
Image faint_front(double ahead_m, double right_m, double left_m) {
  return seen_floor(
      [&](const Vec2& p) { return p.x() > ahead_m && p.y() > right_m && p.y() < left_m ? 150.0 : 165.0; });
}

/// Laser light on a side of an obstacle whose floor edge is a line on the floor.
Image lit_side(const Vec2& p_vehicle_begin, const Vec2& p_vehicle_end, const Image& before) {
  constexpr int kSteps = 2000;
  constexpr int kHalfRows = 1;
  Image image = before;
  int last_u = -1;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec2 p = p_vehicle_begin + i / static_cast<double>(kSteps) * (p_vehicle_end - p_vehicle_begin);
    const auto pixel = floor_lens().project(floor_mount().to_camera({p.x(), p.y(), kMarkerHeight_m}));
    const int u = static_cast<int>(std::lround(pixel->x())), row = static_cast<int>(std::lround(pixel->y()));
    if (std::exchange(last_u, u) == u || row < kHalfRows || row + kHalfRows >= kFloorHeight_px) continue;
    for (int v = row - kHalfRows; v <= row + kHalfRows; ++v) image.row(v)[u] = v == row ? 250 : 200;
  }
  return image;
}

/// The same of an obstacle that stands across the route.
Image lit_front(double ahead_m, double right_m, double left_m, const Image& before) {
  return lit_side({ahead_m, left_m}, {ahead_m, right_m}, before);
}

TEST(RouteView, WhereTheLasersLightAnObstacleIsNoRouteHoweverMuchItLooksLikeIt) {
  constexpr double kAhead_m = 2.2, kHalfWidth_m = 0.4;
  const Image unlit = faint_front(kAhead_m, -kHalfWidth_m, kHalfWidth_m);
  const Image lit = lit_front(kAhead_m, -kHalfWidth_m, kHalfWidth_m, unlit);
  RouteView view = eye_by_markers();
  EXPECT_TRUE(view.sees_route(view.look(unlit), {kAhead_m + 0.1, 0})) << "nothing is lit";
  const RouteSight sight = view.look(lit);
  for (const double lateral_m : {-0.3, 0.0, 0.3}) {
    EXPECT_TRUE(view.sees_route(sight, {kAhead_m - 0.1, lateral_m})) << lateral_m;
    EXPECT_FALSE(view.sees_route(sight, {kAhead_m + 0.1, lateral_m})) << lateral_m;
  }
  EXPECT_TRUE(view.sees_route(sight, {kAhead_m + 0.1, kHalfWidth_m + 0.2})) << "beside it";
  const auto is_floor_edge = [&](const Vec2& p) {
    return std::abs(p.y()) < kHalfWidth_m - 0.1 && std::abs(p.x() - kAhead_m) < 0.04;
  };
  EXPECT_GE(std::count_if(sight.p_vehicle_edges.begin(), sight.p_vehicle_edges.end(), is_floor_edge), 10);
  RouteView by_brightness = eye();
  EXPECT_TRUE(by_brightness.sees_route(by_brightness.look(lit), {kAhead_m + 0.1, 0}));
}

TEST(RouteView, ALitObstacleIsNoRouteWhereItsFloorEdgeAndItsLightLeaveTheView) {
  constexpr double kLateral_m = -0.25;
  const Image faint = seen_floor([&](const Vec2& p) { return p.y() < kLateral_m ? 150.0 : 165.0; });
  const Image lit = lit_side({2, kLateral_m}, {0.9, kLateral_m}, faint);
  RouteView view = eye_by_markers();
  RouteView by_brightness = eye();
  for (const double lateral_m : {-0.5, -0.6, -0.7}) {
    EXPECT_TRUE(by_brightness.sees_route(by_brightness.look(lit), {1.5, lateral_m})) << lateral_m;
    EXPECT_FALSE(view.sees_route(view.look(lit), {1.5, lateral_m})) << lateral_m;
  }
  EXPECT_TRUE(view.sees_route(view.look(lit), {1.5, -0.1}));
}

TEST(RouteView, BesideACornerThatIsLitJustAboveTheViewsLowerEdgeTheFloorIsRoute) {
  double corner_m = 3;
  const auto lit_row = [](double ahead_m) {
    return floor_lens().project(floor_mount().to_camera({ahead_m, 0, kMarkerHeight_m}))->y();
  };
  while (lit_row(corner_m) < kFloorHeight_px - 10) corner_m -= 0.01;
  const Image faint =
      seen_floor([&](const Vec2& p) { return p.x() - corner_m > std::abs(p.y()) ? 150.0 : 165.0; });
  const Vec2 corner(corner_m, 0), to_left(1, 1), to_right(1, -1);
  for (const double length : {0.7, 0.75, 0.8, 0.85, 0.9}) {
    const Image right_lit = lit_side(corner, corner + length * to_right, faint);
    const Image lit = lit_side(corner, corner + length * to_left, right_lit);
    RouteView view = eye_by_markers();
    const RouteSight sight = view.look(lit);
    for (const double side : {-1, 1}) {
      EXPECT_FALSE(view.sees_route(sight, {corner_m + 0.6, side * 0.4})) << length << ' ' << side;
      EXPECT_TRUE(view.sees_route(sight, {corner_m + 0.4, side * 0.6})) << length << ' ' << side;
    }
  }
}

TEST(RouteView, ALineOnTheFloorThatLooksLikeLaserLightIsNoObstacle) {
  constexpr double kAhead_m = 2.2, kHalfWidth_m = 0.4;
  const Image line = lit_front(kAhead_m, -kHalfWidth_m, kHalfWidth_m, path(-20, 20));
  RouteView view = eye_by_markers();
  EXPECT_TRUE(view.sees_route(view.look(line), {kAhead_m + 0.1, 0}));
}

}  // namespace
}  // namespace aisle
