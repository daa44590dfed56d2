#pragma once

#include <span>
#include <vector>

#include "aisle/guidance/paths/footprint_clearance.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Checks whether a vehicle may go on as commanded: until it could stop, its whole footprint must stay on
/// known free floor and off the present laser returns, whether the floor shows these already or not.
class BrakingClearance {
 public:
  /// @param margin_m  around the footprint; where the vehicle has less already, it must not become even less
  BrakingClearance(const VehicleDescription& vehicle, double margin_m);

  /// Takes in the present scan.
  void see(const LaserScanner& scanner, std::span<const float> ranges_m);

  /// Whether the vehicle would keep its distance from the present laser returns, or at least not lose any.
  bool is_off_hit(const Pose2& T_vehicle_later) const;

  /// @param steering_rad  present steering angle
  bool is_free(const KnownFloor& floor, const Pose2& T_map_vehicle, const Command& command,
               double steering_rad) const;

  /// The same on the vehicle's own trail: only what is known to stand under its footprint stops it. Obstacles
  /// beside it do not matter, as the floor may show them thicker than they are; laser returns may be nearer,
  /// as the vehicle has passed them before.
  bool is_free_on_trail(const KnownFloor& floor, const Pose2& T_map_vehicle, const Command& command,
                        double steering_rad) const;

 private:
  bool is_off_hit(const Pose2& T_vehicle_later, double margin_m) const;
  template <class IsFreeAt>
  bool is_free_until_stopped(const Command& command, double steering_rad, IsFreeAt is_free_at) const;
  bool is_free_at(const KnownFloor& floor, const Pose2& T_map_vehicle, const Pose2& T_vehicle_later) const;
  double stopping_path_m(double speed_mps) const;
  double stopping_turn_rad(double rate_rad_s) const;
  double hit_m(const Pose2& T_vehicle_later) const;

  VehicleDescription vehicle_;
  FootprintClearance footprint_clearance_;
  std::vector<Vec2> p_vehicle_hit_;  ///< laser returns that are near enough to matter
  double hit_now_m_ = 0;             ///< from the footprint to the nearest of them
};

}  // namespace aisle
