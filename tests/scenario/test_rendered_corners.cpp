/// The corner of the route between two close turnings, in images of the simulated camera.

#include <gtest/gtest.h>

#include <optional>

#include "aisle/simulation/buildings/turning_course.hpp"
#include "aisle/simulation/vehicle/camera_sensor.hpp"
#include "aisle/vision/route/route_corner.hpp"
#include "aisle/vision/route/route_view.hpp"

namespace aisle {
namespace {

/// The third camera of a vehicle for rooms.
CameraDescription third_camera() {
  CameraDescription camera;
  camera.width_px = 512;
  camera.height_px = 486;
  camera.intrinsics = {.fx_px = 350, .fy_px = 350, .cx_px = 255.5, .cy_px = 242.5};
  camera.mount = {.p_vehicle_camera = {0.92, 0, 0.45}, .tilt_rad = 32 * kDegree};
  return camera;
}

std::optional<Vec2> corner_seen(int first, int second, const Pose2& T_world_vehicle, RouteSide side) {
  constexpr double kVehicleWidth_m = 0.6;
  Random random(3);
  const RenderedWorld world(close_turnings_course(first, second, random));
  const CameraDescription camera = third_camera();
  RouteView view({}, camera.intrinsics, camera.mount, camera.width_px, camera.height_px, kVehicleWidth_m);
  CameraMoment moment;
  moment.T_world_vehicle = T_world_vehicle;
  const RouteSight sight = view.look(CameraSensor(camera, {}, 1).take(world, moment));
  const auto corner =
      find_route_corner(sight.p_vehicle_edges, camera.mount.p_vehicle_camera.head<2>(), side, {});
  if (!corner) return std::nullopt;
  return T_world_vehicle * *corner;
}

/// The corner of the aisle into which the second turning leads, on the near side.
const Vec2 kCorner(0.7, -0.8);

TEST(RenderedCorners, TheCornerOfASecondTurningToTheRightIsFound) {
  for (const Pose2& T_world_vehicle :
       {Pose2{-1.6, 0, 0}, Pose2{-0.9, 0.2, -20 * kDegree}, Pose2{-0.45, 0.95, -39 * kDegree}}) {
    const auto corner = corner_seen(6, 5, T_world_vehicle, RouteSide::kRight);
    ASSERT_TRUE(corner) << T_world_vehicle.x;
    EXPECT_LT((*corner - kCorner).norm(), 0.2) << corner->transpose();
  }
}

TEST(RenderedCorners, TheCornerOfASecondTurningToTheLeftIsFound) {
  for (const Pose2& T_world_vehicle : {Pose2{1.6, 0, kPi}, Pose2{0.9, 0.2, kPi + 20 * kDegree}}) {
    const auto corner = corner_seen(8, 7, T_world_vehicle, RouteSide::kLeft);
    ASSERT_TRUE(corner) << T_world_vehicle.x;
    EXPECT_LT((*corner - Vec2(-kCorner.x(), kCorner.y())).norm(), 0.2) << corner->transpose();
  }
}

TEST(RenderedCorners, BesideTheSecondTurningItsCornerIsNotSeen) {
  EXPECT_FALSE(corner_seen(6, 5, {1.6, 0, 0}, RouteSide::kRight));
  EXPECT_FALSE(corner_seen(8, 7, {-1.6, 0, kPi}, RouteSide::kLeft));
}

}  // namespace
}  // namespace aisle
