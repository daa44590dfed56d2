#include "aisle/guidance/edge_memory.hpp"

#include <gtest/gtest.h>

namespace aisle {
namespace {

/// Looks down ahead; nothing that is asked about lies in its view's route.
RouteView eye() {
  const CameraModel camera({.fx_px = 215, .fy_px = 215, .cx_px = 127.5, .cy_px = 121});
  return {{}, camera, {.p_vehicle_camera = {0.8, 0, 1.25}, .tilt_rad = 38 * kDegree}, 256, 243, 0.6};
}

RouteSight sight_of(std::vector<Vec2> edges, std::vector<Vec2> cut_off = {}) {
  RouteSight sight;
  sight.mask = Image(256, 243);
  sight.p_vehicle_edges = std::move(edges);
  sight.p_vehicle_cut_off = std::move(cut_off);
  return sight;
}

TEST(EdgeMemory, WhatWasSeenIsCarriedOnUntilItIsFar) {
  EdgeMemory memory(4);
  memory.take(eye(), sight_of({{2, 1}}), {});
  const auto beside = memory.seen_around({2, 0, 0});
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_NEAR((beside[0].p_vehicle - Vec2(0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR(beside[0].seen_from_m, Vec2(2, 1).norm(), 1e-12);
  memory.take(eye(), sight_of({}), {7, 0, 0});
  EXPECT_TRUE(memory.around({7, 0, 0}).empty());
}

TEST(EdgeMemory, WhatIsSeenFromNearerTakesThePlaceOfWhatWasSeenFromFar) {
  EdgeMemory memory(6);
  memory.take(eye(), sight_of({{4, 1}}), {});
  memory.take(eye(), sight_of({{2, 0.85}}), {2, 0, 0});
  const auto seen = memory.seen_around({});
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_NEAR(seen[0].p_vehicle.y(), 0.85, 1e-12);
  memory.take(eye(), sight_of({{4, 1}}), {});
  EXPECT_EQ(memory.seen_around({}).size(), 2U) << "what is seen from farther takes no place";
}

TEST(EdgeMemory, WhatTheViewCutsOffStandsThereButIsNoFoot) {
  EdgeMemory memory(4);
  memory.take(eye(), sight_of({{3, 0.4}}, {{1.5, 0.4}}), {});
  EXPECT_EQ(memory.around({}).size(), 2U);
  ASSERT_EQ(memory.seen_around({}).size(), 1U);
  EXPECT_NEAR(memory.seen_around({})[0].p_vehicle.x(), 3, 1e-12);
}

TEST(EdgeMemory, WhatIsKnownNotToStandThereGoes) {
  EdgeMemory memory(4);
  memory.take(eye(), sight_of({{2, 0.2}, {2, 1.5}}), {});
  memory.clear({2, 0, 0}, {1, 1});
  ASSERT_EQ(memory.around({}).size(), 1U);
  EXPECT_NEAR(memory.around({})[0].y(), 1.5, 1e-12);
}

}  // namespace
}  // namespace aisle
