#include "aisle/guidance/paths/path_driver.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/control/reversing.hpp"
#include "aisle/guidance/paths/driving_care.hpp"

namespace aisle {
namespace {

constexpr double kWatchMargin_m = 0.02;           // around the footprint
constexpr double kCreeping_mps = 0.04;            // where it could not stop in time at the path's speed ...
constexpr double kCreeping_rad_s = 10 * kDegree;  // ... or, on the spot, as fast as it would turn
constexpr double kBendAhead_m = 0.05;
constexpr double kWheelsOff_rad = 25 * kDegree;
constexpr double kWheelsOffAtFirst_rad = 4 * kDegree;  // at the start of a leg
constexpr double kWheelsTurned_rad = 1 * kDegree;

SteeringParams turning_late(SteeringParams steering) {
  steering.bend_ahead_m = kLateBendAhead_m;
  steering.bend_ahead_s = 0;
  return steering;
}

/// The same bend, driven slowly.
Command creeping(const Command& command) {
  Command slow = command;
  slow.speed_mps = std::clamp(command.speed_mps, -kCreeping_mps, kCreeping_mps);
  slow.turn_rate_rad_s = command.speed_mps == 0
                             ? std::clamp(command.turn_rate_rad_s, -kCreeping_rad_s, kCreeping_rad_s)
                             : command.turn_rate_rad_s * (slow.speed_mps / command.speed_mps);
  return slow;
}

}  // namespace

PathDriver::PathDriver(const VehicleDescription& vehicle, const SteeringParams& steering,
                       const SpeedParams& speed)
    : vehicle_(vehicle),
      speed_(speed),
      kept_clearance_(vehicle.footprint, kWatchMargin_m),
      braking_(vehicle, kWatchMargin_m),
      follower_(vehicle, turning_late(steering)) {}

void PathDriver::take(const Path& path, double trail_m) {
  if (!has_path()) leg_begun_ = 0;
  path_ = path_.followed_by(path);
  trail_from_m_ = trail_m > 0 ? path_.length_m() - trail_m : kNoTrail_m;
  progress_ = has_path() ? PathProgress(path_, progress_->point()) : PathProgress(path_);
}

void PathDriver::take_trail(const Path& path) {
  drop();
  take(path, path.length_m());
}

void PathDriver::shorten(double ahead_m) {
  const PathPoint point = progress_->point();
  path_ = path_.up_to(std::min(point.along_m + ahead_m, path_.leg_end_m(point.piece)),
                      path_.leg_end(point.piece));
  progress_.emplace(path_, point);
}

void PathDriver::drop() {
  progress_.reset();
  path_ = {};
  trail_from_m_ = kNoTrail_m;
}

double PathDriver::free_m(const KnownFloor& floor, const Pose2& T_map_vehicle) const {
  if (!has_path()) return 0;
  if (is_on_trail()) return left_m();
  const double along_m = progress_->point().along_m;
  const double free_m = kept_clearance_.free_path_m(floor, path_, along_m,
                                                    kept_clearance_.relaxed_clearance(floor, T_map_vehicle));
  return along_m + free_m >= trail_from_m_ ? left_m() : free_m;
}

PathDriver::Step PathDriver::drive(const KnownFloor& floor, const FootprintClearance& footprint_clearance,
                                   const Pose2& T_map_vehicle, double steering_rad) {
  const Command standing{.steering_rad = steering_rad};
  if (!has_path()) return {State::kNoPath, standing};
  const PathPoint& point = progress_->advance(T_map_vehicle);
  if (progress_->has_arrived()) return {State::kArrived, standing};
  const double care = driving_care(vehicle_, footprint_clearance, floor, path_, point.along_m, steering_rad);
  const double speed_mps = speed_along(path_, point.along_m, care, vehicle_, speed_);
  const Command command = follower_.follow(path_, point, T_map_vehicle, speed_mps, steering_rad);
  if (const auto wheels_rad = wheels_to_turn_rad(point, command.steering_rad, steering_rad))
    return {State::kTurningWheels, {.steering_rad = *wheels_rad}};
  const LegDirection direction = direction_of(path_.pieces()[point.piece].arc);
  if (is_free(floor, T_map_vehicle, command, steering_rad)) return {State::kDriving, command, direction};
  const Command slow = creeping(command);
  if (is_free(floor, T_map_vehicle, slow, steering_rad)) return {State::kDriving, slow, direction};
  const bool is_for_wheels = std::abs(command.steering_rad - steering_rad) > kWheelsTurned_rad &&
                             is_free(floor, T_map_vehicle, command, command.steering_rad);
  if (is_for_wheels) return {State::kTurningWheels, {.steering_rad = command.steering_rad}, direction};
  return {State::kBlocked, standing, direction};
}

bool PathDriver::is_free(const KnownFloor& floor, const Pose2& T_map_vehicle, const Command& command,
                         double steering_rad) const {
  return is_on_trail() ? braking_.is_free_on_trail(floor, T_map_vehicle, command, steering_rad)
                       : braking_.is_free(floor, T_map_vehicle, command, steering_rad);
}

/// Where the path's curvature does not match the steering angle, the vehicle stops to turn its wheels; but
/// not while it is correcting its cross-track error.
std::optional<double> PathDriver::wheels_to_turn_rad(const PathPoint& point, double followed_rad,
                                                     double steering_rad) {
  if (vehicle_.is_differential) return std::nullopt;
  const std::size_t leg_end = path_.leg_end(point.piece);
  const PathPoint ahead =
      path_.at(std::min(point.along_m + kBendAhead_m, path_.leg_end_m(point.piece) - 1e-6));
  const double bent_rad = std::atan(ahead.curvature_per_m * vehicle_.front_steered.wheelbase_m);
  const double wanted_rad =
      std::clamp(bent_rad, -vehicle_.limits.steering_max_rad, vehicle_.limits.steering_max_rad);
  const bool is_under_path = leg_end == leg_begun_;
  const double off_rad = std::abs(wanted_rad - steering_rad);
  if (is_under_path) {
    const bool is_correcting = std::abs(followed_rad - steering_rad) < kWheelsOff_rad / 2;
    return off_rad >= kWheelsOff_rad && !is_correcting ? std::optional(wanted_rad) : std::nullopt;
  }
  if (off_rad >= kWheelsOffAtFirst_rad) return wanted_rad;
  leg_begun_ = leg_end;
  return std::nullopt;
}

}  // namespace aisle
