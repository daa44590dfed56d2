#pragma once
/// What another map says of a wall, from one end to the other.

#include <vector>

#include "aisle/maps/wall_map.hpp"
#include "aisle/merging/building_changes.hpp"
#include "aisle/merging/map_pattern.hpp"

namespace aisle {

/// Shorter than this, neighbouring walls keep a map from telling.
inline constexpr double kFateMin_m = 0.35;

/// The fate of each step of about 0.1 m along a wall: kept, not compared or `if_denied`. Runs shorter than
/// kFateMin_m take the fate of a neighbour.
/// @param wall  of some length
/// @param beyond_m  free floor of the other map this far from everything denies the wall
std::vector<WallChange> fates_along(const Wall& wall, const MapPattern& other, WallChange if_denied,
                                    double beyond_m = MapPattern::kBeyond_m);

/// Short runs take the fate of a neighbour: where the other map is silent, of one that has changed if there
/// is one, as what is not confirmed is not kept; else of the run before, and the first of the run behind.
void smooth_fates(std::vector<WallChange>& fates);

/// The number of those steps.
std::size_t fate_steps(const Wall& wall);

/// The middle of such a step.
Vec2 middle_of_step(const Segment2& segment, std::size_t step, std::size_t steps);

}  // namespace aisle
