#include "rendering/viewpoints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"

namespace aisle {
namespace {

constexpr int kViewpointsMax = 16;
constexpr double kSmear_px = 1.5;  ///< between one viewpoint and the next

CameraMount shaken(CameraMount mount, const CameraSensorParams& params, const CameraMoment& moment,
                   std::uint64_t seed) {
  Random random(seed ^ ~(moment.image * 0x9e3779b97f4a7c15u));
  const double speed = std::abs(moment.speed_mps);
  mount.tilt_rad += random.normal(params.shake_pitch_rad * speed);
  mount.roll_rad += random.normal(params.shake_roll_rad * speed);
  return mount;
}

/// How far the image of the floor or of a nearby wall moves during the exposure [px].
double smear_px(const CameraDescription& camera, const CameraSensorParams& params,
                const CameraMoment& moment) {
  constexpr double kWall_m = 2;
  const double turn_px = std::abs(moment.turn_rate_rad_s) * camera.intrinsics.fx_px;
  const double near_m = std::min(kWall_m, 2 * camera.mount.p_vehicle_camera.z());
  const double shift_px = std::abs(moment.speed_mps) * camera.intrinsics.fy_px / (2 * near_m);
  return (turn_px + shift_px) * params.exposure_time_s;
}

}  // namespace

Viewpoint mirrored_in_floor(const Viewpoint& view) {
  const Eigen::DiagonalMatrix<float, 3> upside_down(1, 1, -1);
  return {upside_down * view.p_scene_camera, upside_down * view.R_scene_camera};
}

std::vector<Viewpoint> viewpoints(const CameraDescription& camera, const CameraSensorParams& params,
                                  const CameraMoment& moment, std::uint64_t seed, const SceneFrame& frame) {
  const CameraMount mount = shaken(camera.mount, params, moment, seed);
  const Mat3 R_vehicle_camera = mount.R_vehicle_camera();
  const int count = std::clamp(static_cast<int>(std::ceil(smear_px(camera, params, moment) / kSmear_px)), 1,
                               kViewpointsMax);
  std::vector<Viewpoint> views;
  for (int i = 0; i < count; ++i) {
    const double time_s = ((i + 0.5) / count - 0.5) * params.exposure_time_s;
    const Pose2 T_world_vehicle =
        moment.T_world_vehicle * Pose2{moment.speed_mps * time_s, 0, moment.turn_rate_rad_s * time_s};
    const Mat3 R_world_vehicle = Eigen::AngleAxisd(T_world_vehicle.theta, Vec3::UnitZ()).toRotationMatrix();
    const Vec3 p_world_camera =
        R_world_vehicle * mount.p_vehicle_camera + Vec3(T_world_vehicle.x, T_world_vehicle.y, 0);
    views.push_back(
        {frame(p_world_camera).cast<float>(), (R_world_vehicle * R_vehicle_camera).cast<float>()});
  }
  return views;
}

}  // namespace aisle
