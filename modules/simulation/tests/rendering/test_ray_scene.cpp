#include "rendering/ray_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace aisle {
namespace {

constexpr std::size_t kBlocked = 3, kFree = 5, kNotAsked = 7;

/// Ways along x from 1 m before a panel across x = 0, and one that nobody asks for and that is no number.
WayPacket ways_to_a_panel() {
  WayPacket ways;
  for (Floats* all : {&ways.from_x, &ways.from_y, &ways.from_z, &ways.x, &ways.y, &ways.z})
    std::fill(std::begin(all->at), std::end(all->at), std::numeric_limits<float>::quiet_NaN());
  std::fill(std::begin(ways.asked.at), std::end(ways.asked.at), 0);
  for (const std::size_t k : {kBlocked, kFree}) {
    ways.from_x.at[k] = -1;
    ways.from_y.at[k] = ways.y.at[k] = ways.z.at[k] = 0;
    ways.from_z.at[k] = 0.5f;
    ways.asked.at[k] = -1;
  }
  ways.x.at[kBlocked] = 4;
  ways.x.at[kFree] = 0.5f;
  return ways;
}

RayScene scene_with_a_panel() {
  const Panel panel{.corner = {0, -1, 0}, .along = {0, 2, 0}, .up = {0, 0, 1}};
  return {std::vector{panel}, SceneFrame{}};
}

TEST(RayScene, TellsWhichWaysAreBlockedAmongSuchAsAreNoNumber) {
  Flags blocked{};
  scene_with_a_panel().find_blocked(ways_to_a_panel(), blocked);
  EXPECT_EQ(blocked.at[kBlocked], -1);
  EXPECT_EQ(blocked.at[kFree], 0);
  EXPECT_EQ(blocked.at[kNotAsked], 0);
}

TEST(RayScene, TellsHowFarWaysAreFreeAmongSuchAsAreNoNumber) {
  Floats shares{};
  scene_with_a_panel().free_shares(ways_to_a_panel(), shares);
  EXPECT_FLOAT_EQ(shares.at[kBlocked], 0.25f);
  EXPECT_FLOAT_EQ(shares.at[kFree], 1);
  EXPECT_FLOAT_EQ(shares.at[kNotAsked], 1);
}

}  // namespace
}  // namespace aisle
