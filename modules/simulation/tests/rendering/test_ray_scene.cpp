#include "rendering/ray_scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace aisle {
namespace {

constexpr std::size_t kBlocked = 3, kFree = 5, kNotAsked = 7;

/// Paths along x from 1 m before a panel across x = 0, and one that nobody asks for and that is no number.
PathPacket paths_to_a_panel() {
  PathPacket paths;
  for (Floats* all : {&paths.from_x, &paths.from_y, &paths.from_z, &paths.x, &paths.y, &paths.z})
    std::fill(std::begin(all->at), std::end(all->at), std::numeric_limits<float>::quiet_NaN());
  std::fill(std::begin(paths.asked.at), std::end(paths.asked.at), 0);
  for (const std::size_t k : {kBlocked, kFree}) {
    paths.from_x.at[k] = -1;
    paths.from_y.at[k] = paths.y.at[k] = paths.z.at[k] = 0;
    paths.from_z.at[k] = 0.5f;
    paths.asked.at[k] = -1;
  }
  paths.x.at[kBlocked] = 4;
  paths.x.at[kFree] = 0.5f;
  return paths;
}

RayScene scene_with_a_panel() {
  const Panel panel{.corner = {0, -1, 0}, .along = {0, 2, 0}, .up = {0, 0, 1}};
  return {std::vector{panel}, SceneFrame{}};
}

TEST(RayScene, TellsWhichPathsAreBlockedAmongSuchAsAreNoNumber) {
  Flags blocked{};
  scene_with_a_panel().find_blocked(paths_to_a_panel(), blocked);
  EXPECT_EQ(blocked.at[kBlocked], -1);
  EXPECT_EQ(blocked.at[kFree], 0);
  EXPECT_EQ(blocked.at[kNotAsked], 0);
}

TEST(RayScene, TellsHowFarPathsAreFreeAmongSuchAsAreNoNumber) {
  Floats shares{};
  scene_with_a_panel().free_shares(paths_to_a_panel(), shares);
  EXPECT_FLOAT_EQ(shares.at[kBlocked], 0.25f);
  EXPECT_FLOAT_EQ(shares.at[kFree], 1);
  EXPECT_FLOAT_EQ(shares.at[kNotAsked], 1);
}

}  // namespace
}  // namespace aisle
