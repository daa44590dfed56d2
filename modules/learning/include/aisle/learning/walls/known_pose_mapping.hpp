#pragma once
/// A map from a log whose poses are known already, because the vehicle was localised in an older map.

#include <optional>
#include <span>

#include "aisle/learning/walls/map_building.hpp"
#include "aisle/maps/floor_grid.hpp"

namespace aisle {

struct KnownPoseMap {
  WallMap walls;    ///< in the frame of the poses
  FloorGrid floor;  ///< likewise
};

/// The walls and the floor that a log shows at poses that are not adjusted: whatever is wrong with them is in
/// the map. Costs as much as the last step of `build_map`.
/// @param T_map_vehicle  one per scan; none: the scan is not used
/// @param has_dominant_direction  of the building: else no wall lies on an axis
KnownPoseMap map_at_poses(const LaserLog& log, std::span<const std::optional<Pose2>> T_map_vehicle,
                          bool has_dominant_direction, const MapParams& params);

}  // namespace aisle
