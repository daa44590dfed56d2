#include "aisle/guidance/rooms/frame_parking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "aisle/guidance/rooms/room_cameras.hpp"
#include "aisle/vehicle/odometry_step.hpp"

namespace aisle {

void FrameParkingParams::describe(FieldList& fields) {
  fields.group("lines", frame);
  fields.group("steering", steering);
  fields.real("speed_mps", speed_mps, {0.02, 1}, "into the frame");
  fields.real("speed_min_mps", speed_min_mps, {0.005, 0.5}, "at the end of the approach");
  fields.real("deceleration_mps2", deceleration_mps2, {0.005, 2}, "towards the end of the approach");
  fields.real("reverse_speed_mps", reverse_speed_mps, {0.02, 1}, "out of the frame, for another try");
  fields.real("gain", gain, {0.01, 1}, "how much one image corrects the frame's pose");
  fields.real("lateral_max_m", lateral_max_m, {0.001, 1}, "lateral error above which it tries again");
  fields.angle("turned_max_deg", turned_max_rad, {0.1, 45}, "yaw error above which it tries again");
  fields.real("misaligned_m", misaligned_m, {0.001, 1},
              "lateral error after the last try above which it has not parked");
  fields.angle("yaw_error_deg", yaw_error_rad, {0.1, 45},
               "yaw error after the last try above which it has not parked");
  fields.real("judged_m", judged_m, {0, 5}, "distance to the end at which a hopeless approach is given up");
  fields.real("hopeless_m", hopeless_m, {0.001, 1}, "lateral error at that distance that makes it hopeless");
  fields.real("back_off_m", back_off_m, {0.2, 10}, "path back before it tries again");
  fields.count("tries_max", tries_max, {1, 100}, "attempts; after the last one it stays where it is");
  fields.real("unseen_max_m", unseen_max_m, {0.1, 10}, "path without seeing the frame, then it gives up");
  fields.real("tracked_m", tracked_m, {0.05, 5},
              "a frame farther than this from where it was first seen is ignored");
}

FrameParking::FrameParking(const FrameParkingParams& params, const VehicleDescription& vehicle,
                           const Vec2& size_m)
    : params_(params), vehicle_(vehicle), size_m_(size_m), follower_(vehicle, params.steering) {}

void FrameParking::look(const Observation& observation, const Pose2& T_odom_vehicle,
                        const Pose2& T_odom_expected, double astray_m) {
  unseen_m_ += (T_odom_vehicle.position() - T_odom_vehicle_.position()).norm();
  T_odom_vehicle_ = T_odom_vehicle;
  steering_rad_ = steering_rad_of(observation.odometry);
  for (const char* name : {kFirstCamera, kThirdCamera, kSecondCamera}) {
    const CameraDescription* camera = vehicle_.camera(name);
    if (camera == nullptr) continue;
    const CameraImage* image = present_image(observation, name, vehicle_.cycle_s);
    if (image == nullptr) continue;
    const auto points =
        painted_line_points(*image->pixels, CameraModel(camera->intrinsics), camera->mount, params_.frame);
    const auto fit =
        T_odom_frame_ ? track_frame(points, size_m_, between(T_odom_vehicle, *T_odom_frame_), params_.frame)
                      : find_frame(points, size_m_, wrap_angle(T_odom_expected.theta - T_odom_vehicle.theta),
                                   params_.frame);
    if (!fit) continue;
    const Pose2 T_odom_seen = T_odom_vehicle * fit->T_vehicle_frame;
    const auto off_m = [&](const Pose2& T_odom) { return between(T_odom, T_odom_seen).position().norm(); };
    if (T_odom_frame_ ? off_m(T_odom_found_) > params_.tracked_m : off_m(T_odom_expected) > astray_m)
      continue;
    take(T_odom_seen);
    return;
  }
}

void FrameParking::take(const Pose2& T_odom_seen) {
  if (!T_odom_frame_) T_odom_found_ = T_odom_seen;
  T_odom_frame_ = T_odom_frame_ ? interpolate(*T_odom_frame_, T_odom_seen, params_.gain) : T_odom_seen;
  unseen_m_ = 0;
}

/// Pose of the parked vehicle: its footprint's centre on the frame's.
Pose2 FrameParking::T_odom_parked() const {
  const Footprint& footprint = vehicle_.footprint;
  return *T_odom_frame_ * Pose2{(footprint.rear_m - footprint.front_m) / 2, 0, 0};
}

Pose2 FrameParking::off() const {
  return between(T_odom_parked(), T_odom_vehicle_);
}

Decision FrameParking::step() {
  if (unseen_m_ > params_.unseen_max_m)
    return {.status = NavigatorStatus::kFailed, .state = "no frame", .why = "the frame is not seen any more"};
  return is_backing_ ? back_off() : approach();
}

Decision FrameParking::approach() {
  const Pose2 off = FrameParking::off();
  const double left_m = -off.x;
  const bool is_hopeless = left_m < params_.judged_m && std::abs(off.y) > params_.hopeless_m;
  if (left_m < vehicle_.cycle_s * params_.speed_min_mps || (is_hopeless && tries_ < params_.tries_max))
    return settle();
  constexpr double kRunUp_m = 8;
  const Pose2 T_odom_begin = T_odom_parked() * Pose2{-kRunUp_m, 0, 0};
  const Path path({{T_odom_begin, {kRunUp_m, 0}}});
  const double speed_mps =
      std::clamp(std::sqrt(2 * params_.deceleration_mps2 * left_m), params_.speed_min_mps, params_.speed_mps);
  const PathPoint point = path.nearest(T_odom_vehicle_.position(), 0, kRunUp_m);
  return {.command = follower_.follow(path, point, T_odom_vehicle_, speed_mps, steering_rad_),
          .state = "parking",
          .why = fmt::format("{:.2f} m to go, {:.3f} m to the side", left_m, off.y)};
}

/// Ends parking, or backs off for another try.
Decision FrameParking::settle() {
  const Pose2 off = FrameParking::off();
  const auto is_within = [&](double lateral_m, double turned_rad) {
    return std::abs(off.y) <= lateral_m && std::abs(off.theta) <= turned_rad;
  };
  const bool is_good = is_within(params_.lateral_max_m, params_.turned_max_rad);
  if (!is_good && tries_ < params_.tries_max) {
    ++tries_;
    is_backing_ = true;
    return {.state = "backing off"};
  }
  const std::string why =
      fmt::format("{:.3f} m to the side, {:.2f} degrees turned", off.y, to_degrees(off.theta));
  if (is_good || is_within(params_.misaligned_m, params_.yaw_error_rad))
    return {.status = NavigatorStatus::kDone, .state = "parked", .why = why};
  return {.status = NavigatorStatus::kFailed, .state = "misaligned", .why = "not parked: it stands " + why};
}

Decision FrameParking::back_off() {
  if (-off().x > params_.back_off_m) {
    is_backing_ = false;
    return {.state = "parking"};
  }
  const double path_m = params_.back_off_m + 1;
  const Path path({{T_odom_parked(), {-path_m, 0}}});
  const PathPoint point = path.nearest(T_odom_vehicle_.position(), 0, path_m);
  return {.command = follower_.follow(path, point, T_odom_vehicle_, params_.reverse_speed_mps, steering_rad_),
          .state = "backing off"};
}

}  // namespace aisle
