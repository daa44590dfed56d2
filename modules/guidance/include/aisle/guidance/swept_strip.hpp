#pragma once

#include <span>

#include "aisle/vehicle/arc.hpp"
#include "aisle/vehicle/command.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// The floor that a vehicle sweeps on one arc: its footprint, wider by a margin on either side.
struct SweptStrip {
  Footprint footprint;
  double margin_m = 0.1;
  double turn_rad_per_m = 0;  ///< of base_link's way

  /// How far the front can go along the strip before it meets the first of some points.
  /// @return at most `reach_m`; 0 if a point is within the footprint
  double free_m(std::span<const Vec2> p_vehicle, double reach_m) const;
};

/// How much base_link turns on a metre of its way forwards; straight on if it stands.
double curvature_of(const VehicleDescription& vehicle, const Command& command);

}  // namespace aisle
