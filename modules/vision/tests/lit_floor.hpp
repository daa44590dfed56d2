#pragma once
/// Images of a floor, 1 m below the camera of a cart that looks along a corridor.

#include <cmath>

#include "aisle/core/random.hpp"
#include "aisle/geometry/back_projection.hpp"

namespace aisle {

inline constexpr int kWidth_px = 640, kHeight_px = 480;
inline constexpr double kLightHeight_m = 0.3;
inline constexpr double kFloorLevel = 120;
inline const CameraMount kMount{.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};

inline Image floor_with_noise() {
  Image image(kWidth_px, kHeight_px);
  Random random(3);
  for (auto& level : image.bytes)
    level = static_cast<std::uint8_t>(std::lround(kFloorLevel + random.normal(2)));
  return image;
}

/// A sheet on the floor, square to the vehicle or turned.
inline void lay_paper(Image& image, const CameraIntrinsics& lens, const Vec2& p_vehicle, double turned_rad) {
  const BackProjection floor(CameraModel(lens), kMount, 0);
  for (int v = 150; v < kHeight_px; ++v) {
    for (int u = 200; u < 440; ++u) {
      const auto p = floor.point({u, v});
      if (!p) continue;
      const Vec2 p_paper = rotate(-turned_rad, *p - p_vehicle);
      if (std::abs(p_paper.x()) < 0.105 && std::abs(p_paper.y()) < 0.149) image.row(v)[u] = 240;
    }
  }
}

}  // namespace aisle
