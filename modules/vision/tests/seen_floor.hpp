#pragma once
/// Images of a flat floor on which nothing stands, drawn by its brightness at each point.

#include <cmath>

#include "aisle/core/angle.hpp"
#include "aisle/core/image.hpp"
#include "aisle/geometry/back_projection.hpp"

namespace aisle {

inline constexpr int kFloorWidth_px = 256, kFloorHeight_px = 243;

inline constexpr CameraIntrinsics kFloorLens{.fx_px = 215, .fy_px = 215, .cx_px = 127.5, .cy_px = 121};
inline CameraModel floor_lens() {
  return CameraModel(kFloorLens);
}
inline CameraMount floor_mount() {
  return {.p_vehicle_camera = {0.8, 0, 1.25}, .tilt_rad = 38 * kDegree};
}

/// @param grey  of a floor point in base_link; sampled four times a pixel
template <class Grey>
Image seen_floor(const Grey& grey) {
  const BackProjection floor(floor_lens(), floor_mount(), 0);
  Image image(kFloorWidth_px, kFloorHeight_px);
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) {
      double sum = 0;
      for (const double du : {-0.25, 0.25}) {
        for (const double dv : {-0.25, 0.25}) {
          const auto p = floor.point({u + du, v + dv});
          sum += p ? grey(*p) : 0;
        }
      }
      image.row(v)[u] = static_cast<std::uint8_t>(std::lround(sum / 4));
    }
  }
  return image;
}

}  // namespace aisle
