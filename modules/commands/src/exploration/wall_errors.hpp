#pragma once
/// How far a learned wall map agrees with the walls of the world it was learned in.

#include <functional>
#include <span>

#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/wall_map.hpp"

namespace aisle {

struct WallErrors {
  double true_m = 0;     ///< of walls that could be seen
  double missed_m = 0;   ///< of them: nothing was learned there
  double learned_m = 0;  ///< of learned walls
  double false_m = 0;    ///< of them: nothing stands there
  double rmse_m = 0;     ///< of the learned walls' points that are not false, from what stands there

  double missed_share() const { return true_m > 0 ? missed_m / true_m : 0; }
  double false_share() const { return learned_m > 0 ? false_m / learned_m : 0; }
};

/// Compares points every 5 cm. A point of one is where the other is within 15 cm (of a true wall: and the
/// learned one runs as it does within 20 degrees).
/// @param standing   all that stands in the world at the sensor's height; pieces shorter than half a metre
/// (legs,
///                   reveals of doors) need not be learned as walls
/// @param is_seen    whether a point of what stands there could be seen; what could not is not missed
WallErrors wall_errors(const WallMap& learned, const Pose2& T_world_map, std::span<const Segment2> standing,
                       const std::function<bool(const Vec2&)>& is_seen);

}  // namespace aisle
