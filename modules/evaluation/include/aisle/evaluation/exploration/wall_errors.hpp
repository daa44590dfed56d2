#pragma once
/// How well a learned wall map agrees with the walls of the world it was learned in.

#include <functional>
#include <span>

#include "aisle/geometry/segment2.hpp"
#include "aisle/maps/wall_map.hpp"

namespace aisle {

struct WallErrors {
  double true_m = 0;     ///< length of the true walls that could be seen
  double missed_m = 0;   ///< of these: no wall was learned there
  double learned_m = 0;  ///< length of the learned walls
  double false_m = 0;    ///< of these: there is no true wall
  double rmse_m = 0;     ///< distance of the learned walls' other points from the true walls

  double missed_share() const { return true_m > 0 ? missed_m / true_m : 0; }
  double false_share() const { return learned_m > 0 ? false_m / learned_m : 0; }
};

/// Compares points every 5 cm. A point of one map agrees if the other map has a wall within 15 cm (for a
/// point of a true wall, the learned wall's direction must also agree within 20 degrees).
/// @param standing  all obstacles of the world at the sensor's height; pieces shorter than half a metre
/// (legs,
///                  door reveals) need not be learned as walls
/// @param is_seen   whether a point of an obstacle could be seen; one that could not is not missed
WallErrors wall_errors(const WallMap& learned, const Pose2& T_world_map, std::span<const Segment2> standing,
                       const std::function<bool(const Vec2&)>& is_seen);

}  // namespace aisle
