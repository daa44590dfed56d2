#pragma once

#include <string>
#include <vector>

#include "aisle/guidance/navigator.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What a person has drawn on a building's floor for vehicles to obey: barriers and zones.
class FloorRules {
 public:
  FloorRules() = default;
  FloorRules(const Building& building, const VehicleDescription& vehicle);

  bool empty() const { return lines_.empty() && zones_.empty(); }

  /// The decision as far as the rules allow it: slowed, and failed where the vehicle, if it executed the
  /// command and then braked, would meet a line or drive against a one-way zone, or where it is in a keep-out
  /// zone.
  Decision obey(Decision decision, const Pose2& T_map_vehicle) const;

  /// The command along the same path, no faster than allowed where the vehicle is or could still brake.
  Command slowed(Command command, const Pose2& T_map_vehicle) const;

 private:
  std::string why_forbidden(const Pose2& T_map_vehicle, double speed_mps) const;

  std::vector<Barrier> lines_;
  std::vector<Zone> zones_;
  VehicleDescription vehicle_;
};

}  // namespace aisle
