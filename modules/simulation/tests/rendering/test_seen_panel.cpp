#include "rendering/seen_panel.hpp"

#include <gtest/gtest.h>

#include "office_corridor.hpp"
#include "rendering/exposure.hpp"

using namespace aisle;

namespace {

CameraDescription bent_lens() {
  CameraDescription camera;
  camera.width_px = 162;  // no multiple of a block's side
  camera.height_px = 121;
  camera.intrinsics = {110, 110, 80, 60, -0.18, 0.03, 0, 0, 0};
  camera.mount = {.p_vehicle_camera = {0.5, 0, 1}, .tilt_rad = 12 * kDegree, .roll_rad = 3 * kDegree};
  return camera;
}

std::vector<Viewpoint> places(const RenderedWorld::Scene& scene) {
  std::vector<Viewpoint> views;
  for (int i = 0; i < 8; ++i) {
    const CameraMoment moment{.T_world_vehicle = {1 + 2.3 * i, 0.1 * (i - 4), 0.8 * i}};
    views.push_back(viewpoints(bent_lens(), {}, moment, 1, scene.frame).front());
  }
  return views;
}

std::vector<Candidate> all_of(const std::vector<SeenPanel>& panels) {
  std::vector<Candidate> candidates;
  candidates.reserve(panels.size());
  for (const SeenPanel& panel : panels) candidates.push_back({&panel, panel.nearest, false});
  return candidates;
}

std::vector<Candidate> narrowed(std::vector<Candidate> candidates, const SlopeBox& beam) {
  const std::size_t count = candidates.size();
  narrow(candidates, 0, count, beam);
  candidates.erase(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count));
  return candidates;
}

/// Numbers of the panels that a block's pixels see.
std::vector<std::uint32_t> seen_by(const LensTable::Block& block, const std::vector<Candidate>& candidates) {
  Hits seen;
  find_seen(candidates, block.x, block.y, seen);
  std::vector<std::uint32_t> numbers;
  for (const std::uint32_t at : seen.at) {
    numbers.push_back(at == kNoSurface ? kNoSurface : candidates[at].panel->number);
  }
  return numbers;
}

TEST(SeenPanel, PixelsSeeThePanelsThatARayTracerHits) {
  const RenderedWorld::Scene scene(office_corridor());
  const LensTable lens(bent_lens(), 0);
  int rays = 0, others = 0;
  for (const Viewpoint& view : places(scene)) {
    const std::vector<SeenPanel> panels = scene.seen_panels(view);
    for (const LensTable::Block& block : lens.blocks) {
      Hits hits;
      scene.what_stands().first_hits(block_rays(block, view, {}, {}), hits);
      const auto seen = seen_by(block, all_of(panels));
      for (std::size_t k = 0; k < kLanes; ++k, ++rays) others += seen[k] != hits.at[k] ? 1 : 0;
    }
  }
  // Rays that meet an edge, or two panels in one place, may be decided either way.
  EXPECT_LT(others, rays / 5000);
}

TEST(SeenPanel, NarrowingABeamLosesNothingThatItsRaysSee) {
  const RenderedWorld::Scene scene(office_corridor());
  const LensTable lens(bent_lens(), 0);
  for (const Viewpoint& view : places(scene)) {
    const std::vector<SeenPanel> panels = scene.seen_panels(view);
    const std::vector<Candidate> all = all_of(panels);
    for (int row = 0; row < lens.blocks_high; ++row) {
      for (int column = 0; column < lens.blocks_wide; ++column) {
        const LensTable::Block& block = lens.blocks[lens.block(column, row)];
        const std::vector<Candidate> left = narrowed(all, lens.beam({0, column, row}));
        ASSERT_EQ(seen_by(block, left), seen_by(block, all)) << column << ", " << row;
      }
    }
  }
}

/// A panel before a camera that looks along x; y is on its left.
SeenPanel wall_ahead(double left_m, double right_m, double distance_m = 2, std::uint32_t number = 0) {
  Viewpoint view{Eigen::Vector3f::Zero(), Eigen::Matrix3f::Zero()};
  view.R_scene_camera << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Corners corners{Vec3(distance_m, left_m, -9), Vec3(distance_m, right_m, -9),
                        Vec3(distance_m, right_m, 9), Vec3(distance_m, left_m, 9)};
  return seen_panel(corners, view, number).value();
}

TEST(SeenPanel, ABeamThatAWallFillsSeesNothingBehindIt) {
  const SlopeBox beam{0, 0, 0.1f, 0.1f};
  const std::vector<SeenPanel> panels = {wall_ahead(0.1, -9, 5), wall_ahead(1, -1), wall_ahead(9, -9, 3)};
  const std::vector<Candidate> left = narrowed(all_of(panels), beam);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left.front().panel, &panels[1]);
  EXPECT_TRUE(left.front().covers);
}

TEST(SeenPanel, ABeamThatAWallFillsInPartSeesWhatIsBehindItToo) {
  const SlopeBox beam{0, 0, 0.1f, 0.1f};
  const std::vector<SeenPanel> panels = {wall_ahead(0.1, -9, 2), wall_ahead(9, -9, 3), wall_ahead(9, -9, 4)};
  const std::vector<Candidate> left = narrowed(all_of(panels), beam);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_FALSE(left[0].covers);
  EXPECT_TRUE(left[1].covers);
  Floats x{}, y{};
  x.at[0] = -0.06f;  // left of the edge at 0.1 m / 2 m
  x.at[1] = -0.04f;
  Hits seen;
  find_seen(left, x, y, seen);
  EXPECT_EQ(seen.at[0], 1u);
  EXPECT_EQ(seen.at[1], 0u);
}

TEST(SeenPanel, WhatIsBehindTheCameraIsNotSeen) {
  Viewpoint view{Eigen::Vector3f::Zero(), Eigen::Matrix3f::Identity()};
  const Corners behind{Vec3(-1, -1, -2), Vec3(1, -1, -2), Vec3(1, 1, -2), Vec3(-1, 1, -2)};
  EXPECT_FALSE(seen_panel(behind, view, 0));
}

TEST(SeenPanel, CoverageIsTheShareOfSamplesAndTheirMiddle) {
  const std::vector<PixelOffset> samples = {{-0.4f, 0.1f}, {-0.2f, 0.3f}, {0.2f, -0.3f}, {0.4f, -0.1f}};
  std::vector<Hits> seen(samples.size(), Hits{});
  for (Hits& hits : seen) std::fill(std::begin(hits.at), std::end(hits.at), 7u);
  seen[0].at[5] = seen[1].at[5] = 3;
  Coverage coverage;
  ASSERT_TRUE(find_coverage(3, seen, samples, coverage));
  EXPECT_EQ(coverage.any.at[4], 0);
  EXPECT_EQ(coverage.any.at[5], -1);
  EXPECT_FLOAT_EQ(coverage.share.at[5], 0.5f);
  EXPECT_FLOAT_EQ(coverage.u.at[5], -0.3f);
  EXPECT_FLOAT_EQ(coverage.v.at[5], 0.2f);
  EXPECT_FALSE(find_coverage(4, seen, samples, coverage));
}

}  // namespace
