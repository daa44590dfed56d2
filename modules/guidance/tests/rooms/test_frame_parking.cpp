#include "aisle/guidance/rooms/frame_parking.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "aisle/geometry/back_projection.hpp"
#include "aisle/guidance/rooms/room_cameras.hpp"

namespace aisle {
namespace {

const Vec2 kFrame_m(1.64, 1.14);
const Pose2 kFrameAhead{2.2, 0, 0};

VehicleDescription frame_cart() {
  VehicleDescription vehicle;
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6};
  CameraDescription camera;
  camera.name = kFirstCamera;
  camera.width_px = 512;
  camera.height_px = 486;
  camera.intrinsics = {.fx_px = 430, .fy_px = 430, .cx_px = 255.5, .cy_px = 242.5};
  camera.mount = {.p_vehicle_camera = {0.8, 0, 1.25}, .tilt_rad = 38 * kDegree};
  vehicle.cameras = {camera};
  return vehicle;
}

/// A painted frame on a plain floor, as the first camera sees it.
Observation sight_of_frame(const CameraDescription& camera) {
  constexpr double kHalfLine_m = 0.025;
  const BackProjection floor(CameraModel(camera.intrinsics), camera.mount, 0);
  auto image = std::make_shared<Image>(camera.width_px, camera.height_px);
  for (int v = 0; v < camera.height_px; ++v) {
    for (int u = 0; u < camera.width_px; ++u) {
      const auto p = floor.point(Vec2(u, v));
      const Vec2 off_m = p ? (kFrameAhead.inverse() * *p).cwiseAbs() - kFrame_m / 2 : Vec2(9, 9);
      image->row(v)[u] = std::abs(off_m.maxCoeff()) < kHalfLine_m ? 230 : 140;
    }
  }
  Observation observation;
  observation.stamp_s = 0.1;
  observation.images.push_back({camera.name, observation.stamp_s, image});
  return observation;
}

bool sees_frame_expected_at(const Pose2& T_odom_expected) {
  constexpr double kAstray_m = 0.5;
  const VehicleDescription vehicle = frame_cart();
  FrameParking parking({}, vehicle, kFrame_m);
  parking.look(sight_of_frame(vehicle.cameras.front()), {}, T_odom_expected, kAstray_m);
  return parking.sees_frame();
}

TEST(FrameParking, AcceptsAFrameOnlyNearTheTaughtOne) {
  EXPECT_TRUE(sees_frame_expected_at({2.5, 0.2, 0}));
  EXPECT_FALSE(sees_frame_expected_at({2.9, 0, 0}));
}

TEST(FrameParking, DoesNotTrackALookalikeAwayFromTheFrame) {
  const VehicleDescription vehicle = frame_cart();
  const double tracked_m = FrameParkingParams{}.tracked_m;
  const Observation sight = sight_of_frame(vehicle.cameras.front());
  FrameParking parking({}, vehicle, kFrame_m);
  // It moves on with the vehicle, 5 cm per image, as a pattern or a lamp's light would.
  for (int i = 0; i < 40; ++i) parking.look(sight, {0.05 * i, 0, 0}, kFrameAhead, 1);
  ASSERT_TRUE(parking.sees_frame());
  EXPECT_LT(between(kFrameAhead, *parking.frame()).position().norm(), tracked_m + 0.05);
}

/// The decision at the end of its last try, with this lateral error.
Decision end_of_last_try(double lateral_m) {
  const VehicleDescription vehicle = frame_cart();
  FrameParkingParams params;
  params.tries_max = 1;
  params.unseen_max_m = 5;
  FrameParking parking(params, vehicle, kFrame_m);
  parking.look(sight_of_frame(vehicle.cameras.front()), {}, kFrameAhead, 1);
  const double ahead_m = (vehicle.footprint.front_m - vehicle.footprint.rear_m) / 2;
  parking.look({}, {kFrameAhead.x - ahead_m, lateral_m, 0}, kFrameAhead, 1);
  return parking.step();
}

TEST(FrameParking, HasNotParkedIfMisalignedAfterTheLastTry) {
  EXPECT_EQ(end_of_last_try(0.03).status, NavigatorStatus::kDone);
  EXPECT_EQ(end_of_last_try(0.08).status, NavigatorStatus::kFailed);
  EXPECT_EQ(end_of_last_try(0.08).state, "misaligned");
}

}  // namespace
}  // namespace aisle
