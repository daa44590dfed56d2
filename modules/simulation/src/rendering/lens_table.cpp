#include "rendering/lens_table.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

namespace aisle {
namespace {

/// Grows around points.
struct Bounds {
  static constexpr float kFar = std::numeric_limits<float>::max();
  float left = kFar, right = -kFar, top = kFar, bottom = -kFar;

  void add(float x, float y, float half_x, float half_y) {
    left = std::min(left, x - half_x);
    right = std::max(right, x + half_x);
    top = std::min(top, y - half_y);
    bottom = std::max(bottom, y + half_y);
  }

  void add(const SlopeBox& box) {
    if (!box.is_empty()) add(box.x, box.y, box.half_x, box.half_y);
  }

  SlopeBox box() const {
    if (left > right) return {};
    constexpr float kRounding = 1e-6f;
    return {(left + right) / 2, (top + bottom) / 2, (right - left) / 2 + kRounding,
            (bottom - top) / 2 + kRounding};
  }
};

int half(int count) {
  return (count + 1) / 2;
}

}  // namespace

LensTable::LensTable(const CameraDescription& camera, double vignetting)
    : width_px(camera.width_px),
      height_px(camera.height_px),
      blocks_wide((width_px + kPacketSide - 1) / kPacketSide),
      blocks_high((height_px + kPacketSide - 1) / kPacketSide),
      blocks(block(0, blocks_high), Block{}) {
  const CameraModel model(camera.intrinsics);
  levels_.push_back({blocks_wide, blocks_high, std::vector<SlopeBox>(blocks.size())});
  tbb::parallel_for(0, blocks_high, [&](int row) {
    for (int column = 0; column < blocks_wide; ++column) fill_block(model, vignetting, column, row);
  });
  while (levels_.back().beams.size() > 1) levels_.push_back(twice_as_wide(levels_.back()));
}

void LensTable::fill_block(const CameraModel& model, double vignetting, int column, int row) {
  const Vec2 middle{(width_px - 1) / 2.0, (height_px - 1) / 2.0};
  Block& filled = blocks[block(column, row)];
  Bounds bounds;
  for (int k = kLanes - 1; k >= 0; --k) {
    const int u = std::min(column * kPacketSide + k % kPacketSide, width_px - 1),
              v = std::min(row * kPacketSide + k / kPacketSide, height_px - 1);
    const Vec2 place{u, v};
    const auto ray = model.ray(place);
    if (!ray) continue;
    filled.x.at[k] = static_cast<float>(ray->direction.x());
    filled.y.at[k] = static_cast<float>(ray->direction.y());
    filled.x_by_u = static_cast<float>(ray->by_pixel(0, 0));
    filled.x_by_v = static_cast<float>(ray->by_pixel(0, 1));
    filled.y_by_u = static_cast<float>(ray->by_pixel(1, 0));
    filled.y_by_v = static_cast<float>(ray->by_pixel(1, 1));
    bounds.add(filled.x.at[k], filled.y.at[k], (std::abs(filled.x_by_u) + std::abs(filled.x_by_v)) / 2,
               (std::abs(filled.y_by_u) + std::abs(filled.y_by_v)) / 2);
    const double from_middle = (place - middle).squaredNorm() / middle.squaredNorm();
    filled.transmission.at[k] = static_cast<float>(1 - vignetting * from_middle);
  }
  levels_.front().beams[block(column, row)] = bounds.box();
}

LensTable::Level LensTable::twice_as_wide(const Level& finer) const {
  Level level{half(finer.wide), half(finer.high), {}};
  for (int row = 0; row < level.high; ++row) {
    for (int column = 0; column < level.wide; ++column) {
      Bounds bounds;
      for (int y = 2 * row; y < std::min(2 * row + 2, finer.high); ++y) {
        for (int x = 2 * column; x < std::min(2 * column + 2, finer.wide); ++x) {
          bounds.add(finer.beams[static_cast<std::size_t>(y * finer.wide + x)]);
        }
      }
      level.beams.push_back(bounds.box());
    }
  }
  return level;
}

}  // namespace aisle
