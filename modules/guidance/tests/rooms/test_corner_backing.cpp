#include "aisle/guidance/rooms/corner_backing.hpp"

#include <gmock/gmock.h>

#include <memory>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"

namespace aisle {
namespace {

constexpr double kCornerCycle_s = 0.1, kTaught_m = 1;

VehicleDescription cart_with_third_camera() {
  VehicleDescription vehicle;
  CameraDescription camera;
  camera.name = kThirdCamera;
  camera.width_px = 256;
  camera.height_px = 243;
  camera.intrinsics = {.fx_px = 175, .fy_px = 175, .cx_px = 127.5, .cy_px = 121};
  camera.mount = {.p_vehicle_camera = {0.92, 0, 0.45}, .tilt_rad = 32 * kDegree};
  vehicle.cameras = {camera};
  return vehicle;
}

/// A bright floor strip along x between dark sides, with a branch to the left from x = 2.2 m on.
Observation seen_from(const VehicleDescription& vehicle, const Pose2& T_world_vehicle, double stamp_s) {
  const CameraDescription& camera = vehicle.cameras.front();
  const BackProjection floor(CameraModel(camera.intrinsics), camera.mount, 0);
  auto image = std::make_shared<Image>(camera.width_px, camera.height_px);
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      const auto p_vehicle = floor.point(Vec2(u, v));
      const Vec2 p = p_vehicle ? Vec2(T_world_vehicle * *p_vehicle) : Vec2(1e6, 1e6);
      const bool in_aisle = std::abs(p.y()) < 0.7 && p.x() < 5;
      const bool in_branch = p.x() > 2.2 && p.x() < 3.8 && p.y() > 0 && p.y() < 3;
      image->row(v)[u] = in_aisle || in_branch ? 165 : 60;
    }
  }
  Observation observation;
  observation.stamp_s = stamp_s;
  observation.images = {{camera.name, stamp_s, image}};
  return observation;
}

/// Reverses straight from x = 1.5 m.
struct DrivenBack {
  double end_x_m = 0;
  bool has_seen_corner = false;
};

DrivenBack back_until_done(TurningClass next) {
  constexpr double kBackingStep_m = 0.02, kBegin_m = 1.5;
  const VehicleDescription vehicle = cart_with_third_camera();
  CornerBacking backing({}, {}, vehicle);
  backing.begin(next, kTaught_m, {kBegin_m, 0, 0});
  for (int i = 0; i < 1000; ++i) {
    const Pose2 T_odom_vehicle{kBegin_m - i * kBackingStep_m, 0, 0};
    backing.look(seen_from(vehicle, T_odom_vehicle, (i + 1) * kCornerCycle_s), T_odom_vehicle);
    if (backing.is_done(T_odom_vehicle)) return {T_odom_vehicle.x, backing.has_seen_corner()};
  }
  return {};
}

TEST(CornerBacking, EndsWhenTheCornerComesIntoView) {
  const DrivenBack left = back_until_done(TurningClass::kLeft);
  EXPECT_TRUE(left.has_seen_corner);
  EXPECT_NEAR(left.end_x_m, 0.35, 0.15) << "0.7 m to the side, it is in view from 1 m before it";
}

TEST(CornerBacking, ReversesHardlyFartherThanTaughtWithoutACorner) {
  const DrivenBack right = back_until_done(TurningClass::kRight);
  EXPECT_FALSE(right.has_seen_corner);
  EXPECT_NEAR(right.end_x_m, 1.5 - CornerBackingParams().most_share * kTaught_m, 0.03);
}

TEST(CornerBacking, TurnsTheWheelsAwayFromTheSecondTurning) {
  CornerBacking backing({}, {}, cart_with_third_camera());
  backing.begin(TurningClass::kLeft, kTaught_m, {});
  EXPECT_DOUBLE_EQ(backing.requested_steering_rad(), -10 * kDegree);
  backing.begin(TurningClass::kRight, kTaught_m, {});
  EXPECT_DOUBLE_EQ(backing.requested_steering_rad(), 10 * kDegree);
}

TEST(CornerBacking, NeedsTheThirdCamera) {
  EXPECT_THROW(CornerBacking({}, {}, VehicleDescription()), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
