#include "rendering/exposure.hpp"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace aisle {
namespace {

/// Samples of a pixel lie on a lattice: each has a column and a row of its own.
struct Offset {
  float u = 0, v = 0;
};

Offset sample_offset(int sample, int count) {
  constexpr double kGoldenShare = 0.6180339887;
  int step = std::max(1, static_cast<int>(std::lround(kGoldenShare * count)));
  while (std::gcd(step, count) != 1) ++step;
  const auto centred = [&](int i) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(count) - 0.5f;
  };
  return {centred(sample), centred(sample * step % count)};
}

/// Calls `work(begin, end)` for stretches of all rows of blocks, in parallel.
template <class Work>
void for_all_blocks(int high, int wide, const Work& work) {
  constexpr std::size_t kRows = 4, kColumns = 16;
  using Range = tbb::blocked_range2d<int>;
  tbb::parallel_for(Range(0, high, kRows, 0, wide, kColumns), [&](const Range& range) {
    for (int row = range.rows().begin(); row < range.rows().end(); ++row) {
      for (int column = range.cols().begin(); column < range.cols().end(); ++column) work(row, column);
    }
  });
}

}  // namespace

RayPacket block_rays(const LensTable& lens, Block block, const Viewpoint& view, float offset_u,
                     float offset_v) {
  RayPacket packet;
  const Eigen::Matrix3f& R = view.R_scene_camera;
  for (int k = 0; k < kLanes; ++k) {
    const int u = std::min(block.u + k % kPacketSide, lens.width_px - 1),
              v = std::min(block.v + k / kPacketSide, lens.height_px - 1);
    const std::size_t pixel = lens.index(u, v);
    const LensTable::Slopes& s = lens.slopes[pixel];
    const float x = s.x + s.x_by_u * offset_u + s.x_by_v * offset_v,
                y = s.y + s.y_by_u * offset_u + s.y_by_v * offset_v;
    packet.x.at[k] = R(0, 0) * x + R(0, 1) * y + R(0, 2);
    packet.y.at[k] = R(1, 0) * x + R(1, 1) * y + R(1, 2);
    packet.z.at[k] = R(2, 0) * x + R(2, 1) * y + R(2, 2);
    packet.used.at[k] = lens.transmission[pixel] > 0 ? -1 : 0;
  }
  const LensTable::Slopes& s = lens.slopes[lens.index(block.u, block.v)];
  const Eigen::Vector3f by_column = R.col(0) * s.x_by_u + R.col(1) * s.y_by_u,
                        by_row = R.col(0) * s.x_by_v + R.col(1) * s.y_by_v;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    packet.origin[at] = view.p_scene_camera[i];
    packet.by_column[at] = by_column[i];
    packet.by_row[at] = by_row[i];
  }
  return packet;
}

Exposure::Exposure(const RenderedWorld::Scene& scene, const LensTable& lens, std::vector<Viewpoint> views,
                   const LightLevels& levels, const LaserPlane& laser, int rays_per_pixel)
    : scene_(scene),
      lens_(lens),
      views_(std::move(views)),
      levels_(levels),
      laser_(laser),
      samples_(std::max(rays_per_pixel, static_cast<int>(views_.size()))),
      seen_(static_cast<std::size_t>(blocks_wide()) * static_cast<std::size_t>(blocks_high())) {
  if (views_.size() == 1) find_surfaces();
}

void Exposure::find_surfaces() {
  for_all_blocks(blocks_high(), blocks_wide(), [&](int row, int column) {
    const RayPacket packet =
        block_rays(lens_, {column * kPacketSide, row * kPacketSide}, views_.front(), 0, 0);
    scene_.first_hits(packet, seen_[static_cast<std::size_t>(row * blocks_wide() + column)]);
  });
}

/// Whether all pixels of the block and around it see the same surface.
bool Exposure::has_one_surface(Block block) const {
  const auto seen = [&](int u, int v) {
    const auto packet = static_cast<std::size_t>(v / kPacketSide * blocks_wide() + u / kPacketSide);
    return seen_[packet].at[v % kPacketSide * kPacketSide + u % kPacketSide];
  };
  const int right = std::min(block.u + kPacketSide, lens_.width_px - 1),
            bottom = std::min(block.v + kPacketSide, lens_.height_px - 1);
  const std::uint32_t first = seen(block.u, block.v);
  for (int v = std::max(0, block.v - 1); v <= bottom; ++v) {
    for (int u = std::max(0, block.u - 1); u <= right; ++u) {
      if (seen(u, v) != first) return false;
    }
  }
  return true;
}

/// Shades surface by surface: mostly there is only one in a packet.
void Exposure::add_light(const RayPacket& rays, const Hits& hits, Floats& sum) const {
  const ShadingTables tables = scene_.tables();
  std::uint32_t left = 0xffff;
  for (int k = 0; k < kLanes; ++k) {
    if (hits.at[k] == kNothing) left &= ~(1u << k);
  }
  while (left != 0) {
    const std::uint32_t hit = hits.at[std::countr_zero(left)];
    Flags on_surface;
    for (int k = 0; k < kLanes; ++k) {
      on_surface.at[k] = hits.at[k] == hit ? -1 : 0;
      if (hits.at[k] == hit) left &= ~(1u << k);
    }
    Floats radiance;
    shade(scene_.surface(hit), tables, levels_, rays, on_surface, radiance);
    for (int k = 0; k < kLanes; ++k) sum.at[k] += on_surface.at[k] != 0 ? radiance.at[k] : 0;
  }
}

void Exposure::add_stripe(const RayPacket& rays, const Hits& hits, Floats& light) const {
  constexpr float kReach_m = 0.2f;  ///< above and below the light plane, for the widest profile
  Floats stripe{};
  WayPacket ways{};
  bool any = false;
  std::uint32_t last = kNothing;
  for (int first = 0; first < kLanes; ++first) {
    const std::uint32_t hit = hits.at[first];
    if (hit == kNothing || hit == last) continue;
    last = hit;
    if (std::find(hits.at, hits.at + first, hit) != hits.at + first) continue;
    const Surface& surface = scene_.surface(hit);
    if (surface.bottom > laser_.projector[2] + kReach_m || surface.top < laser_.projector[2]) continue;
    Flags on_surface;
    for (int k = 0; k < kLanes; ++k) on_surface.at[k] = hits.at[k] == hit ? -1 : 0;
    any |= shade_stripe(surface, laser_, rays, on_surface, stripe, ways);
  }
  if (!any) return;
  Flags blocked{};
  scene_.find_blocked(ways, blocked);
  for (int k = 0; k < kLanes; ++k) light.at[k] += blocked.at[k] != 0 ? 0 : stripe.at[k];
}

Floats Exposure::light_of(Block block) const {
  Floats sum{};
  const auto packet = static_cast<std::size_t>(block.v / kPacketSide * blocks_wide() + block.u / kPacketSide);
  const bool is_plain = views_.size() == 1 && has_one_surface(block);
  const int samples = is_plain ? 1 : samples_;
  for (int i = 0; i < samples; ++i) {
    const Offset offset = sample_offset(i, samples);
    const Viewpoint& view = views_[static_cast<std::size_t>(i) % views_.size()];
    const RayPacket packet_rays = block_rays(lens_, block, view, offset.u, offset.v);
    Hits hits;
    if (is_plain) {
      hits = seen_[packet];
    } else {
      scene_.first_hits(packet_rays, hits);
    }
    add_light(packet_rays, hits, sum);
    if (laser_.strength > 0) add_stripe(packet_rays, hits, sum);
  }
  for (float& light : sum.at) light /= static_cast<float>(samples);
  return sum;
}

Image Exposure::develop(const SensorResponse& response, double exposure) const {
  Image image(lens_.width_px, lens_.height_px);
  const auto gain = static_cast<float>(exposure);
  for_all_blocks(blocks_high(), blocks_wide(), [&](int row, int column) {
    const Block block{column * kPacketSide, row * kPacketSide};
    const Floats light = light_of(block);
    for (int k = 0; k < kLanes; ++k) {
      const int u = block.u + k % kPacketSide, v = block.v + k / kPacketSide;
      if (u >= lens_.width_px || v >= lens_.height_px) continue;
      const std::size_t pixel = lens_.index(u, v);
      image.bytes[pixel] =
          response.grey(gain * lens_.transmission[pixel] * light.at[k], static_cast<std::uint32_t>(pixel));
    }
  });
  return image;
}

}  // namespace aisle
