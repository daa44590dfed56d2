#pragma once

#include <span>
#include <vector>

#include "aisle/guidance/paths/footprint_clearance.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/laser_log.hpp"

namespace aisle {

/// Whether a vehicle may go on as commanded: until it could stand still again, its whole footprint stays on
/// known free floor and off what its sensor strikes just now, whether the floor shows that already or not.
class BrakingClearance {
 public:
  /// @param margin_m  around the footprint; where the vehicle has less already, it must not become less still
  BrakingClearance(const VehicleDescription& vehicle, double margin_m);

  /// What the sensor shows now.
  void see(const LaserScanner& fan, std::span<const float> ranges_m);

  /// Whether the vehicle would stand off what the sensor strikes now, or at least not nearer to it.
  bool is_off_hit(const Pose2& T_vehicle_later) const;

  /// @param steering_rad  as the wheels stand now
  bool is_free(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
               const Command& command, double steering_rad) const;

  /// The same on the vehicle's own trail: what is under its footprint must be free; what the floor shows
  /// beside it does not matter, as that may have come out thicker than it is, and what the sensor strikes may
  /// be nearer, as it was passed before.
  bool is_free_on_trail(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                        const Command& command, double steering_rad) const;

 private:
  bool is_off_hit(const Pose2& T_vehicle_later, double margin_m) const;
  template <class IsFreeAt>
  bool is_free_until_stopped(const Command& command, double steering_rad, IsFreeAt is_free_at) const;
  bool is_free_at(const FloorGrid& floor, const FloorClearance& clearance, const Pose2& T_map_vehicle,
                  const Pose2& T_vehicle_later) const;
  double stopping_path_m(double speed_mps) const;
  double hit_m(const Pose2& T_vehicle_later) const;

  VehicleDescription vehicle_;
  FootprintClearance footprint_clearance_;
  std::vector<Vec2> p_vehicle_hit_;  ///< near enough to matter
  double hit_now_m_ = 0;             ///< from the footprint to the nearest of them
};

}  // namespace aisle
