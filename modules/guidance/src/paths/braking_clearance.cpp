#include "aisle/guidance/paths/braking_clearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace aisle {
namespace {

constexpr double kReaction_s = 0.25;  // from a command to its effect
constexpr double kStopSlack_m = 0.03;
constexpr double kHitMatters_m = 1.5;  // from the vehicle's outline
constexpr double kHitMargin_m = 0.02;
constexpr double kHitOnTrail_m = 0.01;

/// Transforms points into the vehicle's later frame. There are many, so the rotation is computed once.
class FromLater {
 public:
  explicit FromLater(const Pose2& T_vehicle_later)
      : p_vehicle_later_(T_vehicle_later.position()), R_later_vehicle_(rotation(-T_vehicle_later.theta)) {}

  Vec2 operator()(const Vec2& p_vehicle) const { return R_later_vehicle_ * (p_vehicle - p_vehicle_later_); }

 private:
  Vec2 p_vehicle_later_;
  Mat2 R_later_vehicle_;
};

}  // namespace

BrakingClearance::BrakingClearance(const VehicleDescription& vehicle, double margin_m)
    : vehicle_(vehicle), footprint_clearance_(vehicle.footprint, margin_m) {}

void BrakingClearance::see(const LaserScanner& scanner, std::span<const float> ranges_m) {
  p_vehicle_hit_.clear();
  for (std::size_t beam = 0; beam < ranges_m.size(); ++beam) {
    const double range_m = ranges_m[beam];
    if (!(range_m > 0) || range_m >= scanner.range_max_m) continue;
    const Vec2 p_vehicle = scanner.T_vehicle_laser * Vec2(range_m * unit(scanner.beam_angle(beam)));
    if (off_footprint_m(vehicle_.footprint, p_vehicle) < kHitMatters_m) p_vehicle_hit_.push_back(p_vehicle);
  }
  hit_now_m_ = hit_m({});
}

bool BrakingClearance::is_off_hit(const Pose2& T_vehicle_later) const {
  return is_off_hit(T_vehicle_later, kHitMargin_m);
}

bool BrakingClearance::is_off_hit(const Pose2& T_vehicle_later, double margin_m) const {
  const double enough_m = std::min(margin_m, hit_now_m_ - kClearanceNoise_m);
  if (enough_m <= 0) return true;
  const FromLater from_later(T_vehicle_later);
  return std::all_of(p_vehicle_hit_.begin(), p_vehicle_hit_.end(), [&](const Vec2& p_vehicle) {
    return off_footprint_m(vehicle_.footprint, from_later(p_vehicle)) >= enough_m;
  });
}

bool BrakingClearance::is_free(const KnownFloor& floor, const Pose2& T_map_vehicle, const Command& command,
                               double steering_rad) const {
  return is_free_until_stopped(command, steering_rad, [&](const Pose2& T_vehicle_later) {
    return is_free_at(floor, T_map_vehicle, T_vehicle_later);
  });
}

bool BrakingClearance::is_free_on_trail(const KnownFloor& floor, const Pose2& T_map_vehicle,
                                        const Command& command, double steering_rad) const {
  return is_free_until_stopped(command, steering_rad, [&](const Pose2& T_vehicle_later) {
    return is_off_hit(T_vehicle_later, kHitOnTrail_m) &&
           footprint_clearance_.lies_off_occupied(floor, T_map_vehicle * T_vehicle_later);
  });
}

template <class IsFreeAt>
bool BrakingClearance::is_free_until_stopped(const Command& command, double steering_rad,
                                             IsFreeAt is_free_at) const {
  const double path_m = std::copysign(stopping_path_m(command.speed_mps), command.speed_mps);
  if (vehicle_.is_differential) {
    const double turn_rad = stopping_turn_rad(command.turn_rate_rad_s);
    return is_free_at(end_pose({path_m / 2, turn_rad / 2})) && is_free_at(end_pose({path_m, turn_rad}));
  }
  const std::array<double, 2> steerings_rad = {steering_rad, command.steering_rad};
  return std::all_of(steerings_rad.begin(), steerings_rad.end(), [&](double wheels_rad) {
    const Pose2 T_vehicle_half = drive(vehicle_.front_steered, FrontSteeredMotion{path_m / 2, wheels_rad});
    const Pose2 T_vehicle_stopped = drive(vehicle_.front_steered, FrontSteeredMotion{path_m, wheels_rad});
    return is_free_at(T_vehicle_half) && is_free_at(T_vehicle_stopped);
  });
}

double BrakingClearance::stopping_path_m(double speed_mps) const {
  const double speed = std::abs(speed_mps);
  return speed * kReaction_s + speed * speed / (2 * vehicle_.limits.deceleration_max_mps2) + kStopSlack_m;
}

double BrakingClearance::stopping_turn_rad(double rate_rad_s) const {
  const double braking_rad =
      rate_rad_s * std::abs(rate_rad_s) / (2 * vehicle_.limits.turn_acceleration_max_rad_s2);
  return rate_rad_s * kReaction_s + braking_rad;
}

bool BrakingClearance::is_free_at(const KnownFloor& floor, const Pose2& T_map_vehicle,
                                  const Pose2& T_vehicle_later) const {
  if (!is_off_hit(T_vehicle_later)) return false;
  const Pose2 T_map_later = T_map_vehicle * T_vehicle_later;
  if (footprint_clearance_.clearance_m(floor, T_map_later) >= 0) return true;
  return footprint_clearance_.fits_barely(floor, T_map_later,
                                          footprint_clearance_.relaxed_clearance(floor, T_map_vehicle));
}

/// From the footprint to the nearest laser return; 0 inside.
double BrakingClearance::hit_m(const Pose2& T_vehicle_later) const {
  const FromLater from_later(T_vehicle_later);
  double least_m = kHitMatters_m;
  for (const Vec2& p_vehicle : p_vehicle_hit_)
    least_m = std::min(least_m, off_footprint_m(vehicle_.footprint, from_later(p_vehicle)));
  return std::max(0.0, least_m);
}

}  // namespace aisle
