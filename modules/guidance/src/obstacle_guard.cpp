#include "aisle/guidance/obstacle_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "aisle/guidance/swept_strip.hpp"

namespace aisle {
namespace {

constexpr std::size_t kPlacesMax = 2048;
constexpr double kRightAhead_m = 1.2;
constexpr int kHiddenRaysMin = 4;
constexpr int kHiddenPicturesMin = 2;

const CameraDescription* camera_named(const VehicleDescription& vehicle, const std::string& name) {
  if (name.empty()) return vehicle.cameras.empty() ? nullptr : &vehicle.cameras.front();
  const auto found = std::find_if(vehicle.cameras.begin(), vehicle.cameras.end(),
                                  [&](const CameraDescription& camera) { return camera.name == name; });
  if (found == vehicle.cameras.end()) throw std::invalid_argument("the vehicle has no camera " + name);
  return &*found;
}

Pose2 moved(const VehicleDescription& vehicle, const OdometryReading& odometry) {
  if (const auto* motion = std::get_if<FrontSteeredMotion>(&odometry)) {
    return drive(vehicle.front_steered, *motion);
  }
  return drive(vehicle.differential, std::get<WheelSteps>(odometry));
}

}  // namespace

void ObstacleGuardParams::describe(FieldList& fields) {
  fields.group("things", things);
  fields.group("memory", memory);
  fields.group("pictures", pictures);
  fields.real("margin_m", margin_m, {0, 1}, "free floor wanted on either side of the vehicle");
  fields.real("gap_m", gap_m, {0.05, 3}, "left before an obstacle when the vehicle has stopped");
  fields.real("reach_m", reach_m, {0.5, 20}, "how far ahead of the front is looked at");
  fields.real("deceleration_share", deceleration_share, {0.05, 1},
              "of the greatest deceleration, to stop with");
  fields.real("reaction_s", reaction_s, {0, 2}, "from something's appearance to the first braking");
  fields.real("reverse_speed_mps", reverse_speed_mps, {0.01, 1}, "at most, as nothing sees behind");
  fields.real("free_again_s", free_again_s, {0, 10}, "the way must have been free so long to go on");
  fields.real("wait_max_s", wait_max_s, {0, 3600}, "then the way is reported as blocked");
}

ObstacleGuard::ObstacleGuard(const VehicleDescription& vehicle, const ObstacleGuardParams& params,
                             const std::string& camera)
    : vehicle_(vehicle), params_(params), memory_(params.memory) {
  if (const CameraDescription* found = camera_named(vehicle, camera)) {
    eye_.emplace(Eye{StandingThingDetector(params.things, found->intrinsics, found->mount, found->width_px,
                                           found->height_px),
                     PictureWatch(params.pictures, found->name)});
  }
  if (!eye_ && !vehicle.scanner) throw std::invalid_argument("the vehicle has neither camera nor scanner");
  p_vehicle_.reserve(kPlacesMax);
}

Guarded ObstacleGuard::guard(const Observation& observation, const Command& wished) {
  const double now_s = observation.stamp_s;
  move(observation);
  p_vehicle_.clear();
  if (eye_) look(observation);
  if (observation.scan && vehicle_.scanner) take_scan(*observation.scan);

  Guarded guarded{.command = limited(wished)};
  if (wished.speed_mps < 0) {
    waiting_from_s_.reset();
    guarded.command.speed_mps = std::max(guarded.command.speed_mps, -params_.reverse_speed_mps);
    return guarded;
  }
  if (observation.bumper_pressed) {
    return {.command = {.steering_rad = wished.steering_rad},
            .state = GuardState::kBlocked,
            .why = "the vehicle touches something"};
  }
  if (eye_) {
    if (auto trouble = eye_->watch.trouble(now_s)) return waiting(now_s, std::move(*trouble));
  }
  guarded.free_ahead_m = free_ahead_m(wished);
  const double speed_mps = speed_before(guarded.free_ahead_m);
  if (wished.speed_mps > 0 && speed_mps <= 0) {
    Guarded stopped = waiting(now_s, fmt::format("something stands {:.1f} m ahead", guarded.free_ahead_m));
    stopped.free_ahead_m = guarded.free_ahead_m;
    return stopped;
  }
  if (waiting_from_s_ && now_s - free_from_s_ < params_.free_again_s) {
    return {.command = {.steering_rad = guarded.command.steering_rad},
            .state = GuardState::kWaiting,
            .why = "the way has just become free",
            .free_ahead_m = guarded.free_ahead_m};
  }
  waiting_from_s_.reset();
  if (speed_mps < guarded.command.speed_mps) {
    guarded.why = fmt::format("something stands {:.1f} m ahead", guarded.free_ahead_m);
    guarded.command.speed_mps = speed_mps;
  }
  return guarded;
}

void ObstacleGuard::move(const Observation& observation) {
  T_odom_vehicle_ = T_odom_vehicle_ * moved(vehicle_, observation.odometry);
  poses_[moves_++ % poses_.size()] = {observation.stamp_s, T_odom_vehicle_};
}

/// The remembered pose nearest in time.
Pose2 ObstacleGuard::pose_at(double stamp_s) const {
  const std::size_t known = std::min(moves_, poses_.size());
  const auto nearer = [&](const StampedPose& a, const StampedPose& b) {
    return std::abs(a.stamp_s - stamp_s) < std::abs(b.stamp_s - stamp_s);
  };
  return std::min_element(poses_.begin(), poses_.begin() + static_cast<std::ptrdiff_t>(known), nearer)
      ->T_odom_vehicle;
}

void ObstacleGuard::look(const Observation& observation) {
  if (const CameraPicture* picture = eye_->watch.look(observation)) {
    const auto& things = eye_->detector.detect(*picture->image);
    if (eye_->watch.shows_something(*picture, eye_->detector.mean_level())) {
      memory_.see(things, eye_->detector, pose_at(picture->stamp_s), picture->stamp_s);
      hidden_pictures_ = is_hidden_right_ahead(things) ? hidden_pictures_ + 1 : 0;
    }
  }
  const auto& places = memory_.places(T_odom_vehicle_);
  p_vehicle_.insert(p_vehicle_.end(), places.begin(), places.end());
  if (hidden_pictures_ >= kHiddenPicturesMin && !is_remembered_right_ahead()) {
    p_vehicle_.push_back({vehicle_.footprint.front_m, 0});
  }
}

/// Nearer than the floor begins in the picture.
bool ObstacleGuard::is_remembered_right_ahead() const {
  return std::any_of(p_vehicle_.begin(), p_vehicle_.end(), [&](const Vec2& p) {
    const double ahead_m = p.x() - vehicle_.footprint.front_m;
    return ahead_m >= 0 && ahead_m < kRightAhead_m &&
           std::abs(p.y()) < vehicle_.footprint.width_m / 2 + params_.margin_m;
  });
}

/// Things straight ahead that begin below the picture: they may stand anywhere before the vehicle.
bool ObstacleGuard::is_hidden_right_ahead(const std::vector<StandingThing>& things) const {
  const auto rays = std::count_if(things.begin(), things.end(), [&](const StandingThing& thing) {
    return thing.foot_hidden && std::abs(thing.p_vehicle.y()) < vehicle_.footprint.width_m / 2;
  });
  return rays >= kHiddenRaysMin;
}

void ObstacleGuard::take_scan(const RangeScan& scan) {
  const LaserScanner& scanner = *vehicle_.scanner;
  for (std::size_t beam = 0; beam < scan.ranges_m.size() && p_vehicle_.size() < kPlacesMax; ++beam) {
    const double range_m = scan.ranges_m[beam];
    if (range_m <= 0 || range_m >= scanner.range_max_m) continue;
    p_vehicle_.push_back(scanner.T_vehicle_laser * (range_m * unit(scanner.beam_angle(beam))));
  }
}

double ObstacleGuard::free_ahead_m(const Command& wished) const {
  const SweptStrip strip{.footprint = vehicle_.footprint,
                         .margin_m = params_.margin_m,
                         .turn_rad_per_m = curvature_of(vehicle_, wished)};
  return strip.free_m(p_vehicle_, params_.reach_m);
}

/// The greatest speed from which the vehicle stops in time: v t + v^2 / (2 a) = way.
double ObstacleGuard::speed_before(double free_m) const {
  const double way_m = free_m - params_.gap_m;
  if (free_m >= params_.reach_m) return vehicle_.limits.speed_max_mps;
  if (way_m <= 0) return 0;
  const double a = params_.deceleration_share * vehicle_.limits.deceleration_max_mps2;
  const double at = a * params_.reaction_s;
  return std::sqrt(at * at + 2 * a * way_m) - at;
}

Command ObstacleGuard::limited(const Command& wished) const {
  const DriveLimits& limits = vehicle_.limits;
  return {std::clamp(wished.speed_mps, -limits.reverse_speed_max_mps, limits.speed_max_mps),
          std::clamp(wished.steering_rad, -limits.steering_max_rad, limits.steering_max_rad),
          std::clamp(wished.turn_rate_rad_s, -limits.turn_rate_max_rad_s, limits.turn_rate_max_rad_s)};
}

Guarded ObstacleGuard::waiting(double now_s, std::string why) {
  if (!waiting_from_s_) waiting_from_s_ = now_s;
  free_from_s_ = now_s;
  const bool too_long = now_s - *waiting_from_s_ > params_.wait_max_s;
  return {.state = too_long ? GuardState::kBlocked : GuardState::kWaiting, .why = std::move(why)};
}

}  // namespace aisle
