#include "aisle/guidance/obstacles/obstacle_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace aisle {
namespace {

constexpr double kFloorStep_m = 0.05;  // between the points of an edge that are checked
constexpr double kNoPath_m = 0.005;    // a shorter path is none: the vehicle stands

}  // namespace

void ObstacleGuardParams::describe(FieldList& fields) {
  fields.group("stripes", stripes);
  fields.group("memory", memory);
  fields.group("images", images);
  fields.real("margin_m", margin_m, {0, 1}, "free floor wanted on either side of the vehicle");
  fields.real("gap_m", gap_m, {0.05, 3}, "left before an obstacle when the vehicle has stopped");
  fields.real("reach_m", reach_m, {0.5, 20}, "how far ahead of the front it looks");
  fields.real("deceleration_share", deceleration_share, {0.05, 1},
              "share of the maximum deceleration with which it brakes");
  fields.real("reaction_s", reaction_s, {0, 2}, "from the appearance of an obstacle to the first braking");
  fields.real("reverse_speed_mps", reverse_speed_mps, {0.01, 1}, "at most, as nothing looks behind");
  fields.real("unlit_s", unlit_s, {0.1, 60},
              "after this time without laser light the markers may have failed");
  fields.real("unlit_speed_mps", unlit_speed_mps, {0.01, 5}, "at most, while the markers may have failed");
  fields.real("free_again_s", free_again_s, {0, 10},
              "the path must be free for this long before it drives on");
  fields.real("wait_max_s", wait_max_s, {0, 3600}, "after waiting for this long the path counts as blocked");
}

ObstacleGuard::ObstacleGuard(const VehicleDescription& vehicle, const ObstacleGuardParams& params,
                             const CameraDescription* camera)
    : vehicle_(vehicle), params_(params), odometry_(vehicle), memory_(params.memory) {
  if (camera == nullptr) return;
  monitor_.emplace(params.images, *camera);
  if (vehicle.laser_markers) {
    stripe_.emplace(params.stripes, camera->intrinsics, camera->mount, camera->width_px, camera->height_px,
                    vehicle.laser_markers->height_m);
  }
}

const CameraImage* ObstacleGuard::look(const Observation& observation) {
  odometry_.move(observation);
  p_vehicle_scanned_.clear();
  if (observation.scan && vehicle_.scanner) take_scan(*observation.scan);
  const CameraImage* image = monitor_ ? monitor_->look(observation, odometry_) : nullptr;
  if (image != nullptr && stripe_) read_stripe(*image);
  return image;
}

void ObstacleGuard::read_stripe(const CameraImage& image) {
  sight_.stamp_s = image.stamp_s;
  sight_.T_odom_taken = odometry_.T_odom_at(image.stamp_s);
  stripe_->find(as_grey(*image.pixels, grey_));
  sight_.p_vehicle_returns.clear();
  stripe_->append_lit(sight_.p_vehicle_returns);
  sight_.is_new = true;
  if (!lit_s_ || stripe_->sees_light()) lit_s_ = image.stamp_s;
}

void ObstacleGuard::take_scan(const RangeScan& scan) {
  const LaserScanner& scanner = *vehicle_.scanner;
  for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
    const double range_m = scan.ranges_m[beam];
    if (range_m <= 0 || range_m >= scanner.range_max_m) continue;
    p_vehicle_scanned_.push_back(scanner.T_vehicle_laser * (range_m * unit(scanner.beam_angle(beam))));
  }
}

Guarded ObstacleGuard::allow(const Command& requested, const PathAhead& path) {
  remember_what_is_on(path);
  judge_floor(path);
  Guarded guarded{.command = limited(requested)};
  if (requested.speed_mps < 0) {
    waiting_from_s_.reset();
    guarded.command.speed_mps = std::max(guarded.command.speed_mps, -params_.reverse_speed_mps);
    return guarded;
  }
  if (monitor_) {
    if (const auto trouble = monitor_->trouble(odometry_.stamp_s())) return waiting(guarded, *trouble);
  }
  guarded.free_ahead_m = free_ahead_m(path);
  const double speed_mps = speed_before(guarded.free_ahead_m);
  if (requested.speed_mps > 0 && speed_mps <= 0)
    return waiting(guarded, fmt::format("obstacle ahead, {:.1f} m away", guarded.free_ahead_m));
  if (waiting_from_s_ && odometry_.stamp_s() - free_from_s_ < params_.free_again_s) {
    guarded.command.speed_mps = 0;
    guarded.state = GuardState::kWaiting;
    guarded.why = "the path has just become free";
    return guarded;
  }
  waiting_from_s_.reset();
  if (speed_mps < guarded.command.speed_mps) {
    guarded.command.speed_mps = speed_mps;
    if (guarded.free_ahead_m < params_.reach_m) guarded.why = "slower: something is ahead";
  }
  if (lit_s_ && odometry_.stamp_s() - *lit_s_ > params_.unlit_s)
    guarded.command.speed_mps = std::min(guarded.command.speed_mps, params_.unlit_speed_mps);
  return guarded;
}

void ObstacleGuard::remember_what_is_on(const PathAhead& path) {
  if (!std::exchange(sight_.is_new, false)) return;
  const Pose2 T_now_taken = between(odometry_.T_odom_vehicle(), sight_.T_odom_taken);
  p_vehicle_returns_on_path_ = sight_.p_vehicle_returns;
  std::erase_if(p_vehicle_returns_on_path_, [&](const Vec2& p_vehicle) {
    return !path_to(T_now_taken * p_vehicle, path, vehicle_.footprint, params_.margin_m);
  });
  memory_.see(p_vehicle_returns_on_path_, *stripe_, sight_.T_odom_taken, sight_.stamp_s);
}

void ObstacleGuard::see_floor(std::span<const SensedSegment> edges, double stamp_s) {
  floor_.is_used = floor_.is_new = true;
  floor_.T_odom_taken = odometry_.T_odom_at(stamp_s);
  floor_.p_vehicle_end.clear();
  for (const SensedSegment& edge : edges) {
    const int steps = std::max(1, static_cast<int>(edge.segment.length() / kFloorStep_m));
    for (int i = 0; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      floor_.p_vehicle_end.emplace_back((1 - share) * edge.segment.start + share * edge.segment.end);
    }
  }
}

/// Keeps those ends of the floor that are in the path and within reach.
void ObstacleGuard::judge_floor(const PathAhead& path) {
  if (!std::exchange(floor_.is_new, false)) return;
  const Pose2 T_now_taken = between(odometry_.T_odom_vehicle(), floor_.T_odom_taken);
  std::erase_if(floor_.p_vehicle_end, [&](const Vec2& p_vehicle) {
    const auto path_m = path_to(T_now_taken * p_vehicle, path, vehicle_.footprint, params_.margin_m);
    return !path_m || *path_m > params_.reach_m;
  });
  floor_.sightings = floor_.p_vehicle_end.empty() ? 0 : floor_.sightings + 1;
}

double ObstacleGuard::free_ahead_m(const PathAhead& path) {
  double free_m = params_.reach_m;
  const auto shorten = [&](const Vec2& p_vehicle) {
    free_m =
        std::min(free_m, path_to(p_vehicle, path, vehicle_.footprint, params_.margin_m).value_or(free_m));
  };
  for (const Vec2& p_vehicle : memory_.places(odometry_.T_odom_vehicle())) shorten(p_vehicle);
  for (const Vec2& p_vehicle : p_vehicle_scanned_) shorten(p_vehicle);
  if (floor_.sightings >= params_.memory.sightings_min) {
    const Pose2 T_now_taken = between(odometry_.T_odom_vehicle(), floor_.T_odom_taken);
    for (const Vec2& p_vehicle : floor_.p_vehicle_end) shorten(T_now_taken * p_vehicle);
  }
  return free_m;
}

/// The greatest speed from which the vehicle stops in time: v t + v^2 / (2 a) = path.
double ObstacleGuard::speed_before(double free_m) const {
  if (!stripe_ && !vehicle_.scanner && !floor_.is_used) return vehicle_.limits.speed_max_mps;
  const double path_m = free_m - params_.gap_m;
  if (path_m < kNoPath_m) return 0;
  const double a = params_.deceleration_share * vehicle_.limits.deceleration_max_mps2;
  const double at = a * params_.reaction_s;
  return std::sqrt(at * at + 2 * a * path_m) - at;
}

Command ObstacleGuard::limited(const Command& requested) const {
  const DriveLimits& limits = vehicle_.limits;
  return {std::clamp(requested.speed_mps, -limits.reverse_speed_max_mps, limits.speed_max_mps),
          std::clamp(requested.steering_rad, -limits.steering_max_rad, limits.steering_max_rad),
          std::clamp(requested.turn_rate_rad_s, -limits.turn_rate_max_rad_s, limits.turn_rate_max_rad_s)};
}

Guarded ObstacleGuard::waiting(Guarded guarded, const std::string& why) {
  if (!waiting_from_s_) waiting_from_s_ = odometry_.stamp_s();
  free_from_s_ = odometry_.stamp_s();
  const bool too_long = odometry_.stamp_s() - *waiting_from_s_ > params_.wait_max_s;
  guarded.command = {.steering_rad = guarded.command.steering_rad};
  guarded.state = too_long ? GuardState::kBlocked : GuardState::kWaiting;
  guarded.why = why;
  return guarded;
}

}  // namespace aisle
