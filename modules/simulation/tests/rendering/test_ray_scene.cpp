#include "rendering/ray_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace aisle {
namespace {

constexpr std::size_t kBlocked = 3, kFree = 5, kNotAsked = 7;

/// Segments along x from 1 m before a panel across x = 0, and a lane that is not asked for and holds NaN.
SegmentPacket segments_to_a_panel() {
  SegmentPacket segments;
  for (Floats* all :
       {&segments.from_x, &segments.from_y, &segments.from_z, &segments.x, &segments.y, &segments.z})
    std::fill(std::begin(all->at), std::end(all->at), std::numeric_limits<float>::quiet_NaN());
  std::fill(std::begin(segments.asked.at), std::end(segments.asked.at), 0);
  for (const std::size_t k : {kBlocked, kFree}) {
    segments.from_x.at[k] = -1;
    segments.from_y.at[k] = segments.y.at[k] = segments.z.at[k] = 0;
    segments.from_z.at[k] = 0.5f;
    segments.asked.at[k] = -1;
  }
  segments.x.at[kBlocked] = 4;
  segments.x.at[kFree] = 0.5f;
  return segments;
}

RayScene scene_with_a_panel() {
  const Panel panel{.corner = {0, -1, 0}, .along = {0, 2, 0}, .up = {0, 0, 1}};
  return {std::vector{panel}, SceneFrame{}};
}

TEST(RayScene, FindsWhichSegmentsAreBlockedAmongSomeThatAreNaN) {
  Flags blocked{};
  scene_with_a_panel().find_blocked(segments_to_a_panel(), blocked);
  EXPECT_EQ(blocked.at[kBlocked], -1);
  EXPECT_EQ(blocked.at[kFree], 0);
  EXPECT_EQ(blocked.at[kNotAsked], 0);
}

TEST(RayScene, FindsHowFarSegmentsAreFreeAmongSomeThatAreNaN) {
  Floats shares{};
  scene_with_a_panel().free_shares(segments_to_a_panel(), shares);
  EXPECT_FLOAT_EQ(shares.at[kBlocked], 0.25f);
  EXPECT_FLOAT_EQ(shares.at[kFree], 1);
  EXPECT_FLOAT_EQ(shares.at[kNotAsked], 1);
}

}  // namespace
}  // namespace aisle
