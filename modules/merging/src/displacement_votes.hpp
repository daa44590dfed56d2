#pragma once
/// All placements at which two maps may have walls in common: turns by the directions of their walls
/// (Carpin 2008), displacements by a vote of every pair of wall pieces.

#include <span>
#include <vector>

#include "aisle/merging/map_pattern.hpp"

namespace aisle {

/// A square of displacements, at one turn.
struct PlacementGuess {
  Pose2 T_fixed_moved;  ///< at the middle of the square
  double most_m = 0;    ///< no placement in the square has more of the moved map's walls in common
};

/// Turns of the moved map at which walls run the same way in both; the best first.
/// @cite Carpin2008
std::vector<double> likely_turns(std::span<const WallSample> fixed, std::span<const WallSample> moved);

/// Every square in which `least_m` of the moved map's walls or more may lie on walls of the fixed one.
std::vector<PlacementGuess> likely_displacements(std::span<const WallSample> fixed,
                                                 std::span<const WallSample> moved, double turn_rad,
                                                 double least_m);

}  // namespace aisle
