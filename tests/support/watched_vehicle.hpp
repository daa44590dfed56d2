#pragma once
/// A vehicle that only matters for its images: for benchmarks of viewers.

#include <memory>

#include "aisle/core/image.hpp"
#include "aisle/core/random.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

constexpr int kWatchedWidth_px = 640, kWatchedHeight_px = 480;

/// A vehicle with one camera, "front".
inline VehicleDescription watched_vehicle() {
  VehicleDescription vehicle;
  vehicle.name = "watched";
  CameraDescription camera;
  camera.name = "front";
  camera.width_px = kWatchedWidth_px;
  camera.height_px = kWatchedHeight_px;
  vehicle.cameras.push_back(camera);
  return vehicle;
}

/// Texture that gives a JPEG of typical size.
inline std::shared_ptr<const Image> watched_image() {
  auto image = std::make_shared<Image>(kWatchedWidth_px, kWatchedHeight_px);
  Random random(1);
  for (int v = 0; v < kWatchedHeight_px; ++v) {
    for (int u = 0; u < kWatchedWidth_px; ++u)
      image->row(v)[u] = static_cast<std::uint8_t>(100 + 60 * ((u / 40 + v / 60) % 2) + random.bits() % 8);
  }
  return image;
}

}  // namespace aisle
