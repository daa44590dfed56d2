#include "aisle/guidance/rooms/edge_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace aisle {
namespace {

/// A camera that looks down ahead; no point in these tests lies in the route that it sees.
RouteView eye() {
  const CameraIntrinsics camera{.fx_px = 215, .fy_px = 215, .cx_px = 127.5, .cy_px = 121};
  return {{}, camera, {.p_vehicle_camera = {0.8, 0, 1.25}, .tilt_rad = 38 * kDegree}, 256, 243, 0.6};
}

RouteSight sight_of(std::vector<Vec2> edges, std::vector<Vec2> cut_off = {}) {
  RouteSight sight;
  sight.mask = Image(256, 243);
  sight.p_vehicle_edges = std::move(edges);
  sight.p_vehicle_cut_off = std::move(cut_off);
  return sight;
}

TEST(EdgeMemory, KeepsEdgesUntilTheyAreFar) {
  EdgeMemory memory(4);
  memory.take(eye(), sight_of({{2, 1}}), {}, 0);
  const auto beside = memory.seen_around({2, 0, 0});
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_NEAR((beside[0].p_vehicle - Vec2(0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR(beside[0].seen_from_m, Vec2(2, 1).norm(), 1e-12);
  memory.take(eye(), sight_of({}), {7, 0, 0}, 0);
  EXPECT_TRUE(memory.around({7, 0, 0}).empty());
}

TEST(EdgeMemory, APointSeenFromNearerReplacesOneSeenFromFar) {
  EdgeMemory memory(6);
  memory.take(eye(), sight_of({{4, 1}}), {}, 0);
  memory.take(eye(), sight_of({{2, 0.85}}), {2, 0, 0}, 0);
  const auto seen = memory.seen_around({});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0].p_vehicle.y(), 0.85, 1e-12);
  memory.take(eye(), sight_of({{4, 1}}), {}, 0);
  EXPECT_EQ(memory.seen_around({}).size(), 2U) << "a point seen from farther away replaces nothing";
}

/// The wheels have counted half the path since the second edge was seen.
TEST(EdgeMemory, WhatWasSeenWhileTheOdometryWasOffIsMoved) {
  OdometryHistory odometry({});
  EdgeMemory memory(6);
  const auto drive_on = [&](double stamp_s) {
    odometry.move({.stamp_s = stamp_s, .odometry = FrontSteeredMotion{1, 0}});
  };
  drive_on(1);
  memory.take(eye(), sight_of({{3, 1}}), odometry.T_odom_vehicle(), 1);
  drive_on(2);
  memory.take(eye(), sight_of({{3, -1}}), odometry.T_odom_vehicle(), 2);
  const OdometryHistory before = odometry;
  odometry.correct({.distance_factor = 2}, 1);
  memory.correct(before, odometry);
  const auto seen = memory.seen_around(odometry.T_odom_vehicle());
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_NEAR(seen[0].p_vehicle.x(), 1, 1e-9) << "seen 2 m ago";
  EXPECT_NEAR(seen[1].p_vehicle.x(), 3, 1e-9) << "seen just now";
}

TEST(EdgeMemory, AnObstacleCutOffByTheViewHasNoFloorPoint) {
  EdgeMemory memory(4);
  memory.take(eye(), sight_of({{3, 0.4}}, {{1.5, 0.4}}), {}, 0);
  EXPECT_EQ(memory.around({}).size(), 2U);
  ASSERT_EQ(memory.seen_around({}).size(), 1U);
  EXPECT_NEAR(memory.seen_around({})[0].p_vehicle.x(), 3, 1e-12);
}

/// Route all over the view, except for obstacles at some places.
RouteSight free_but_for(const std::vector<Vec2>& edges) {
  constexpr int kHalf_px = 8;
  RouteSight sight = sight_of(edges);
  std::fill(sight.mask.bytes.begin(), sight.mask.bytes.end(), std::uint8_t{255});
  for (const Vec2& p : edges) {
    const Vec2 pixel = eye().pixel_of(p).value();
    for (int v = std::max(0, static_cast<int>(pixel.y()) - kHalf_px); v <= pixel.y() + 1; ++v)
      for (int u = static_cast<int>(pixel.x()) - kHalf_px; u < pixel.x() + kHalf_px; ++u)
        if (u >= 0 && u < sight.mask.width_px) sight.mask.row(v)[u] = 0;
  }
  return sight;
}

constexpr double kImage_s = 0.2;
const Pose2 kLooksAway{0, 0, 2};

/// What is left in memory after the view has turned away for some time.
std::size_t remembered_after(EdgeMemory& memory, double stamp_s, double away_s) {
  memory.take(eye(), free_but_for({}), kLooksAway, stamp_s + away_s);
  return memory.around({}).size();
}

TEST(EdgeMemory, APersonWhoWalkedOutOfViewIsForgottenAfterAWhile) {
  EdgeMemory memory(4);
  double now_s = 0;
  for (; now_s < 2; now_s += kImage_s) memory.take(eye(), free_but_for({}), {}, now_s);
  for (double y = 0.6; y > -0.9; y -= 0.2, now_s += kImage_s)
    memory.take(eye(), free_but_for({{2, y}}), {}, now_s);
  EXPECT_EQ(remembered_after(memory, now_s, 2), 1U);
  EXPECT_EQ(remembered_after(memory, now_s, 10), 0U);
}

TEST(EdgeMemory, AStandingObstacleSeenLateIsNotForgotten) {
  EdgeMemory memory(4);
  double now_s = 0;
  for (; now_s < 2; now_s += kImage_s) memory.take(eye(), free_but_for({}), {}, now_s);
  for (; now_s < 3; now_s += kImage_s) memory.take(eye(), free_but_for({{2, -0.6}}), {}, now_s);
  EXPECT_EQ(remembered_after(memory, now_s, 30), 1U);
}

TEST(EdgeMemory, AStandingObstacleThatAPersonPassedIsNotForgotten) {
  EdgeMemory memory(4);
  const Vec2 standing(2, -0.8);
  double now_s = 0;
  for (; now_s < 2; now_s += kImage_s) memory.take(eye(), free_but_for({standing}), {}, now_s);
  for (double y = 0.6; y > -0.5; y -= 0.2, now_s += kImage_s)
    memory.take(eye(), free_but_for({{2, y}, standing}), {}, now_s);
  memory.take(eye(), free_but_for({standing}), {}, now_s);
  ASSERT_EQ(remembered_after(memory, now_s, 30), 1U);
  EXPECT_NEAR((memory.around({})[0] - standing).norm(), 0, 1e-9);
}

TEST(EdgeMemory, ClearsARectangle) {
  EdgeMemory memory(4);
  memory.take(eye(), sight_of({{2, 0.2}, {2, 1.5}}), {}, 0);
  memory.clear({2, 0, 0}, {1, 1});
  ASSERT_EQ(memory.around({}).size(), 1U);
  EXPECT_NEAR(memory.around({})[0].y(), 1.5, 1e-12);
}

}  // namespace
}  // namespace aisle
