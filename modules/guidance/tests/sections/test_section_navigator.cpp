#include "aisle/guidance/sections/section_navigator.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "aisle/core/angle.hpp"
#include "drawn_corridor.hpp"

namespace aisle {
namespace {

constexpr double kYawError_rad = 2.5 * kDegree, kBeside_m = 0.04;
constexpr double kBlind_m = 0.8;  // on its path home the vehicle sees no wall from here on
const Vec3 kLeastCorner{-0.5, -0.6, 0}, kGreatestCorner{4, 0.6, 2.5};  // of a corridor along x

/// The wall where the path begins is as bright as the floor, so that its floor edge is invisible.
/// @return brightness of the surface that a ray from inside the corridor meets
double brightness_seen(const Vec3& eye, const Vec3& ray) {
  const std::array kEndsSidesFloor = {ray.x() < 0 ? 120.0 : 170.0, 200.0, 120.0};
  double nearest = 1e9, seen = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double side = ray[axis] < 0 ? kLeastCorner[axis] : kGreatestCorner[axis];
    const double share = ray[axis] == 0 ? nearest : (side - eye[axis]) / ray[axis];
    if (share >= nearest) continue;
    nearest = share;
    seen = kEndsSidesFloor[static_cast<std::size_t>(axis)];
  }
  return seen;
}

VehicleDescription two_wheels_and_a_camera() {
  VehicleDescription vehicle;
  vehicle.is_differential = true;
  vehicle.footprint = {.front_m = 0.11, .rear_m = 0.11, .width_m = 0.21, .height_m = 0.25};
  vehicle.limits.turn_rate_max_rad_s = 45 * kDegree;
  vehicle.cameras.push_back({.width_px = 160,
                             .height_px = 120,
                             .intrinsics = {.fx_px = 135, .fy_px = 135, .cx_px = 79.5, .cy_px = 59.5},
                             .mount = {.p_vehicle_camera = {0.09, 0, 0.19}, .tilt_rad = 18 * kDegree}});
  return vehicle;
}

/// A vehicle in the corridor with perfect actuators, camera and odometry, except that its wheels slip where
/// it sees no wall.
class CorridorDrive {
 public:
  CorridorDrive(const VehicleDescription& vehicle, const Pose2& T_world_start, double slip_rad_per_m)
      : vehicle_(vehicle), T_world_vehicle_(T_world_start), slip_rad_per_m_(slip_rad_per_m) {}

  /// @return whether the navigator was done within a minute
  bool drive(SectionNavigator& navigator) {
    WheelSteps steps;
    for (cycle_ = 1; cycle_ < 600; ++cycle_) {
      const Decision decision = navigator.step(observation(steps));
      if (decision.status != NavigatorStatus::kGoing) return decision.status == NavigatorStatus::kDone;
      steps = steps_of(decision.command);
      const Pose2 moved = aisle::drive(vehicle_.differential, steps);
      const bool is_blind = T_world_vehicle_.x < kBlind_m && std::abs(T_world_vehicle_.theta) > kPi / 2;
      x_m_.push_back(T_world_vehicle_.x);
      T_world_vehicle_ = T_world_vehicle_ * moved * Pose2{0, 0, is_blind ? slip_rad_per_m_ * moved.x : 0};
    }
    return false;
  }

  const Pose2& T_world_vehicle() const { return T_world_vehicle_; }
  /// Along the corridor, over a second, where it was there.
  double fastest_mps(double from_m, double to_m) const {
    const auto cycles = static_cast<std::size_t>(std::lround(1 / vehicle_.cycle_s));
    double fastest = 0;
    for (std::size_t i = cycles; i < x_m_.size(); ++i) {
      if (x_m_[i - cycles] >= from_m && x_m_[i] <= to_m)
        fastest = std::max(fastest, x_m_[i] - x_m_[i - cycles]);
    }
    return fastest;
  }

 private:
  Observation observation(const WheelSteps& steps) const {
    const double stamp_s = cycle_ * vehicle_.cycle_s;
    return {.stamp_s = stamp_s,
            .images = {{vehicle_.cameras.front().name, stamp_s, std::make_shared<Image>(image())}},
            .odometry = steps};
  }

  /// The brightness flickers, as the camera would otherwise count as frozen.
  Image image() const {
    const CameraDescription& camera = vehicle_.cameras.front();
    const CameraIntrinsics& lens = camera.intrinsics;
    const Vec2 p_camera = T_world_vehicle_ * Vec2(camera.mount.p_vehicle_camera.head<2>());
    const Vec3 eye{p_camera.x(), p_camera.y(), camera.mount.p_vehicle_camera.z()};
    const Mat3 R_world_camera =
        Eigen::AngleAxisd(T_world_vehicle_.theta, Vec3::UnitZ()) * camera.mount.R_vehicle_camera();
    return drawn(camera.width_px, camera.height_px, 1, [&](const Vec2& p_px) {
      const Vec3 ray{(p_px.x() - lens.cx_px) / lens.fx_px, (p_px.y() - lens.cy_px) / lens.fy_px, 1};
      return brightness_seen(eye, R_world_camera * ray) + cycle_ % 2;
    });
  }

  /// Carries fractions of a step over to the next cycle.
  WheelSteps steps_of(const Command& command) {
    const double turn_mps = command.turn_rate_rad_s * vehicle_.differential.wheel_separation_m / 2;
    const double per_mps = vehicle_.cycle_s / vehicle_.differential.step_length_m();
    left_steps_ += (command.speed_mps - turn_mps) * per_mps;
    right_steps_ += (command.speed_mps + turn_mps) * per_mps;
    const WheelSteps steps{static_cast<int>(std::lround(left_steps_)),
                           static_cast<int>(std::lround(right_steps_))};
    left_steps_ -= steps.left;
    right_steps_ -= steps.right;
    return steps;
  }

  VehicleDescription vehicle_;
  Pose2 T_world_vehicle_;
  double slip_rad_per_m_;
  double left_steps_ = 0, right_steps_ = 0;
  int cycle_ = 0;
  std::vector<double> x_m_;  ///< one per cycle
};

/// The final pose of a vehicle that starts beside the beginning of its path, with a yaw error.
std::optional<Pose2> end_of(SectionRun run, double slip_rad_per_m = 0) {
  const SectionList sections = {
      {.kind = Section::Kind::kFollow, .length_m = 2, .right_m = 0.6, .left_m = 0.6}};
  const VehicleDescription vehicle = two_wheels_and_a_camera();
  SectionNavigator navigator({.speed = {.speed_mps = 0.3}}, vehicle, "front", sections,
                             guided_path(sections, {}, run));
  CorridorDrive drive(vehicle, {0, kBeside_m, kYawError_rad}, slip_rad_per_m);
  if (!drive.drive(navigator)) return std::nullopt;
  return drive.T_world_vehicle();
}

TEST(SectionNavigator, ComesHomeToItsStartPose) {
  const auto end = end_of(SectionRun::kThereAndBack);
  ASSERT_TRUE(end);
  EXPECT_NEAR((end->theta - kYawError_rad) / kDegree, 0, 1);
  EXPECT_NEAR(end->y, kBeside_m, 0.015);
}

TEST(SectionNavigator, CorrectsWheelSlipAfterItsLastTurnAtHome) {
  const auto end = end_of(SectionRun::kThereAndBack, 4 * kDegree);
  ASSERT_TRUE(end);
  EXPECT_NEAR((end->theta - kYawError_rad) / kDegree, 0, 1);
}

TEST(SectionNavigator, EndsAtThePathsEnd) {
  const auto end = end_of(SectionRun::kThere);
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->theta / kDegree, 0, 1);
  EXPECT_NEAR(end->y, 0, 0.015);
}

/// From x = 0.8 m to 1.2 m, across the corridor.
Zone zone_across(Zone::Kind kind) {
  return {.kind = kind, .outline = {{0.8, -1}, {1.2, -1}, {1.2, 1}, {0.8, 1}}, .speed_max_mps = 0.06};
}

struct ZonedDrive {
  explicit ZonedDrive(Zone::Kind kind) {
    Building building;
    building.zones = {zone_across(kind)};
    const VehicleDescription vehicle = two_wheels_and_a_camera();
    SectionNavigator navigator({.speed = {.speed_mps = 0.3}}, vehicle, "front", sections,
                               guided_path(sections, {}, SectionRun::kThere), FloorRules(building, vehicle));
    is_done = drive.drive(navigator);
  }

  SectionList sections = {{.kind = Section::Kind::kFollow, .length_m = 2, .right_m = 0.6, .left_m = 0.6}};
  CorridorDrive drive{two_wheels_and_a_camera(), {}, 0};
  bool is_done = false;
};

TEST(SectionNavigator, StopsBeforeAKeepOutZone) {
  const ZonedDrive zoned(Zone::Kind::kKeepOut);
  EXPECT_FALSE(zoned.is_done);
  const double front_m = zoned.drive.T_world_vehicle().x + two_wheels_and_a_camera().footprint.front_m;
  EXPECT_LT(front_m, 0.8);
  EXPECT_GT(front_m, 0.6);
}

TEST(SectionNavigator, IsSlowInASlowZone) {
  const ZonedDrive zoned(Zone::Kind::kSlow);
  EXPECT_TRUE(zoned.is_done);
  EXPECT_LT(zoned.drive.fastest_mps(0.8, 1.2), 0.09);
  EXPECT_GT(zoned.drive.fastest_mps(0, 0.5), 0.2);
}

}  // namespace
}  // namespace aisle
