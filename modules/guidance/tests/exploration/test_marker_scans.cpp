#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "aisle/guidance/exploration/scan_source.hpp"

namespace aisle {
namespace {

VehicleDescription lit_cart() {
  VehicleDescription vehicle;
  CameraDescription camera{.name = "corridor"};
  camera.intrinsics = {.fx_px = 460, .fy_px = 460, .cx_px = 319.5, .cy_px = 239.5};
  camera.mount = {.p_vehicle_camera = {0.85, 0, 1}, .tilt_rad = 14 * kDegree};
  vehicle.cameras.push_back(camera);
  vehicle.laser_markers = LaserMarkers{.height_m = 0.3};
  return vehicle;
}

/// A grey floor, and laser light on an obstacle that stands across the path from `right_m` to `left_m`.
Observation sees_light(double ahead_m, double right_m, double left_m) {
  const CameraDescription camera = lit_cart().cameras.front();
  const CameraModel model(camera.intrinsics);
  auto image = std::make_shared<Image>(camera.width_px, camera.height_px);
  std::fill(image->bytes.begin(), image->bytes.end(), std::uint8_t{120});
  for (double y_m = right_m; y_m <= left_m; y_m += 0.002) {
    const auto pixel = model.project(camera.mount.to_camera({ahead_m, y_m, 0.3}));
    const int u = static_cast<int>(std::lround(pixel->x())), v = static_cast<int>(std::lround(pixel->y()));
    if (u < 0 || u >= camera.width_px) continue;
    image->row(v - 1)[u] = image->row(v + 1)[u] = 170;
    image->row(v)[u] = 220;
  }
  Observation observation{.stamp_s = 1};
  observation.images.push_back({.camera = camera.name, .stamp_s = 1, .pixels = image});
  return observation;
}

float range_at(const ScanSource& sensor, const ScanView& view, double angle_deg) {
  const double beam =
      (angle_deg * kDegree - sensor.scanner().first_angle_rad) / sensor.scanner().angle_step_rad;
  return view.ranges_m.at(static_cast<std::size_t>(std::lround(beam)));
}

TEST(MarkerScans, AreRangesAboutThePointBelowTheLens) {
  const auto sensor = marker_scans(lit_cart(), "corridor");
  ScanView view;
  ASSERT_TRUE(sensor->look(sees_light(2.85, -0.5, 0.5), view));
  EXPECT_NEAR(sensor->scanner().T_vehicle_laser.x, 0.85, 1e-9);
  EXPECT_NEAR(range_at(*sensor, view, 0), 2, 0.01);
  EXPECT_NEAR(range_at(*sensor, view, 10), 2 / std::cos(10 * kDegree), 0.01);
  EXPECT_EQ(view.near_m.size(), view.ranges_m.size());
}

TEST(MarkerScans, ABeamWithoutLightIsFreeAsFarAsLightWouldBeSeen) {
  const auto sensor = marker_scans(lit_cart(), "corridor");
  ScanView view;
  ASSERT_TRUE(sensor->look(sees_light(2.85, -0.5, 0.5), view));
  EXPECT_FLOAT_EQ(range_at(*sensor, view, 25), static_cast<float>(sensor->scanner().range_max_m));
}

TEST(MarkerScans, ShowNothingWithoutAnyLaserLight) {
  const auto sensor = marker_scans(lit_cart(), "corridor");
  ScanView view;
  ASSERT_TRUE(sensor->look(sees_light(2.85, 1, 0), view));
  EXPECT_THAT(view.ranges_m, testing::Each(0.0F));
}

TEST(MarkerScans, NeedAPresentImageOfACameraThatTheVehicleHas) {
  const auto sensor = marker_scans(lit_cart(), "corridor");
  ScanView view;
  EXPECT_FALSE(sensor->look({.stamp_s = 1}, view));
  EXPECT_THROW(marker_scans(lit_cart(), "rear"), std::invalid_argument);
  VehicleDescription dark = lit_cart();
  dark.laser_markers.reset();
  EXPECT_THROW(marker_scans(dark, "corridor"), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
