#include "rendering/exposure.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace aisle {
namespace {

constexpr int kSamplesMax = 64;

constexpr Coverage whole_pixels() {
  Coverage whole{};
  for (int k = 0; k < kLanes; ++k) {
    whole.any.at[k] = -1;
    whole.share.at[k] = 1;
  }
  return whole;
}

/// Samples of a pixel lie on a lattice: each has a column and a row of its own.
std::vector<PixelOffset> sample_offsets(int count) {
  constexpr double kGoldenShare = 0.6180339887;
  int step = std::max(1, static_cast<int>(std::lround(kGoldenShare * count)));
  while (std::gcd(step, count) != 1) ++step;
  const auto centred = [&](int i) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f;
  };
  std::vector<PixelOffset> offsets;
  offsets.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) offsets.push_back({centred(i), centred(i * step % count)});
  return offsets;
}

/// What the samples of a block's pixels see: sample by sample, each for all pixels.
void find_seen(std::span<const Candidate> candidates, const LensTable::Block& block,
               std::span<const PixelOffset> samples, std::span<Hits> seen) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float off_x = block.x_by_u * samples[i].u + block.x_by_v * samples[i].v,
                off_y = block.y_by_u * samples[i].u + block.y_by_v * samples[i].v;
    Floats x, y;
    for (int k = 0; k < kLanes; ++k) {
      x.at[k] = block.x.at[k] + off_x;
      y.at[k] = block.y.at[k] + off_y;
    }
    find_seen(candidates, x, y, seen[i]);
  }
}

Square quarter(const Square& square, int which) {
  return {square.level - 1, 2 * square.column + which % 2, 2 * square.row + which / 2};
}

}  // namespace

RayPacket block_rays(const LensTable::Block& block, const Viewpoint& view, const Floats& offset_u,
                     const Floats& offset_v) {
  RayPacket rays;
  const Eigen::Matrix3f R_scene_camera = view.R_scene_camera;
  for (int k = 0; k < kLanes; ++k) {
    const float u = offset_u.at[k], v = offset_v.at[k];
    const float x = block.x.at[k] + block.x_by_u * u + block.x_by_v * v,
                y = block.y.at[k] + block.y_by_u * u + block.y_by_v * v;
    rays.x.at[k] = R_scene_camera(0, 0) * x + R_scene_camera(0, 1) * y + R_scene_camera(0, 2);
    rays.y.at[k] = R_scene_camera(1, 0) * x + R_scene_camera(1, 1) * y + R_scene_camera(1, 2);
    rays.z.at[k] = R_scene_camera(2, 0) * x + R_scene_camera(2, 1) * y + R_scene_camera(2, 2);
  }
  const Eigen::Vector3f by_column =
                            R_scene_camera.col(0) * block.x_by_u + R_scene_camera.col(1) * block.y_by_u,
                        by_row = R_scene_camera.col(0) * block.x_by_v + R_scene_camera.col(1) * block.y_by_v;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    rays.origin[at] = view.p_scene_camera[i];
    rays.by_column[at] = by_column[i];
    rays.by_row[at] = by_row[i];
  }
  return rays;
}

struct Exposure::View {
  const Viewpoint& from;
  std::vector<PixelOffset> samples;
  float share;
  bool is_in_floor = false;  ///< what the floor mirrors
};

Exposure::Exposure(const RenderedWorld::Scene& scene, const LensTable& lens, const LightLevels& levels,
                   const LaserPlane& laser, CollectedLight& light)
    : scene_(scene), lens_(lens), levels_(levels), laser_(laser), light_(light) {
  light_.all.assign(lens.blocks.size(), Floats{});
  light_.mirrored.resize(scene.has_polished_floor() ? lens.blocks.size() : 0);
}

void Exposure::add(const Viewpoint& view, int samples, float share) {
  const std::vector<PixelOffset> offsets = sample_offsets(std::clamp(samples, 1, kSamplesMax));
  std::fill(light_.mirrored.begin(), light_.mirrored.end(), Floats{});
  look_from({view, offsets, share});
  if (!light_.mirrored.empty()) look_from({mirrored_in_floor(view), offsets, share, true});
}

void Exposure::look_from(const View& view) {
  const std::vector<SeenPanel> panels = scene_.seen_panels(view.from);
  std::vector<Candidate> candidates;
  candidates.reserve(panels.size());
  for (const SeenPanel& panel : panels) {
    if (!view.is_in_floor || scene_.is_above_floor(panel.number))
      candidates.push_back({&panel, panel.nearest, false});
  }
  look(view, lens_.whole(), candidates, 0);
}

/// @param candidates  those from `begin` on may be seen; the same when done
void Exposure::look(const View& view, const Square& square, std::vector<Candidate>& candidates,
                    std::size_t begin) {
  constexpr int kTaskLevel = 3;  ///< squares of this level are worth a task of their own
  if (!lens_.holds(square)) return;
  const std::size_t end = candidates.size();
  narrow(candidates, begin, end, lens_.beam(square));
  if (candidates.size() > end && square.level == 0) {
    add_block(view, lens_.block(square.column, square.row), std::span(candidates).subspan(end));
  } else if (candidates.size() > end && square.level <= kTaskLevel) {
    for (int i = 0; i < 4; ++i) look(view, quarter(square, i), candidates, end);
  } else if (candidates.size() > end) {
    tbb::parallel_for(0, 4, [&](int i) {
      std::vector<Candidate> own(candidates.begin() + static_cast<std::ptrdiff_t>(end), candidates.end());
      look(view, quarter(square, i), own, 0);
    });
  }
  candidates.resize(end);
}

void Exposure::add_block(const View& view, std::size_t block, std::span<const Candidate> candidates) {
  static constexpr Coverage kWhole = whole_pixels();
  if (candidates.size() == 1 && candidates.front().covers) {
    add_panel(view, block, *candidates.front().panel, kWhole);
    return;
  }
  std::array<Hits, kSamplesMax> all;
  const std::span<Hits> seen(all.data(), view.samples.size());
  find_seen(candidates, lens_.blocks[block], view.samples, seen);
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    Coverage coverage;
    if (find_coverage(i, seen, view.samples, coverage)) {
      add_panel(view, block, *candidates[i].panel, coverage);
    }
  }
}

void Exposure::add_panel(const View& view, std::size_t block, const SeenPanel& panel,
                         const Coverage& coverage) {
  const ShadedSurface& surface = scene_.surface(panel.number);
  const RayPacket rays = block_rays(lens_.blocks[block], view.from, coverage.u, coverage.v);
  Floats radiance;
  shade(surface, scene_.tables(), levels_, rays, coverage.any, radiance);
  if (laser_.strength > 0) add_stripe(surface, rays, coverage.any, radiance);
  if (!light_.mirrored.empty() && !view.is_in_floor) mirror(surface, view, block, rays, coverage, radiance);
  for (int k = 0; k < kLanes; ++k) {
    const float share = view.is_in_floor ? light_.mirrored[block].at[k] : view.share;
    light_.all[block].at[k] += coverage.any.at[k] != 0 ? share * coverage.share.at[k] * radiance.at[k] : 0;
  }
}

/// Notes what the floor mirrors of other light, and takes that from its own.
void Exposure::mirror(const ShadedSurface& surface, const View& view, std::size_t block,
                      const RayPacket& rays, const Coverage& coverage, Floats& radiance) {
  const float gloss = scene_.tables().materials[static_cast<std::size_t>(surface.material)].gloss;
  if (gloss == 0) return;
  Floats shares;
  find_mirrored(gloss, rays, shares);
  for (int k = 0; k < kLanes; ++k) {
    radiance.at[k] *= 1 - shares.at[k];
    light_.mirrored[block].at[k] +=
        coverage.any.at[k] != 0 ? view.share * coverage.share.at[k] * shares.at[k] : 0;
  }
}

void Exposure::add_stripe(const ShadedSurface& surface, const RayPacket& rays, const Flags& on_surface,
                          Floats& radiance) const {
  constexpr float kReach_m = 0.2f;  ///< above and below the light plane, for the widest profile
  if (surface.bottom > laser_.projector[2] + kReach_m || surface.top < laser_.projector[2]) return;
  Floats stripe;
  SegmentPacket segments;
  if (!shade_stripe(surface, laser_, rays, on_surface, stripe, segments)) return;
  Flags blocked{};
  scene_.find_blocked(segments, blocked);
  for (int k = 0; k < kLanes; ++k) radiance.at[k] += blocked.at[k] != 0 ? 0 : stripe.at[k];
}

Image Exposure::develop(const SensorResponse& response, double exposure) const {
  Image image(lens_.width_px, lens_.height_px);
  const auto gain = static_cast<float>(exposure);
  tbb::parallel_for(0, lens_.blocks_high, [&](int row) {
    for (int column = 0; column < lens_.blocks_wide; ++column) {
      const std::size_t block = lens_.block(column, row);
      Floats light;
      for (int k = 0; k < kLanes; ++k) {
        light.at[k] = gain * lens_.blocks[block].transmission.at[k] * light_.all[block].at[k];
      }
      const Greys greys = response.greys(light, static_cast<std::uint32_t>(block));
      const int first_u = column * kPacketSide, first_v = row * kPacketSide;
      const int wide = std::min(kPacketSide, lens_.width_px - first_u),
                high = std::min(kPacketSide, lens_.height_px - first_v);
      for (int v = 0; v < high; ++v) {
        std::copy_n(greys.data() + std::ptrdiff_t{v} * kPacketSide, wide, image.row(first_v + v) + first_u);
      }
    }
  });
  return image;
}

}  // namespace aisle
