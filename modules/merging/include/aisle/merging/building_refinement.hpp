#pragma once
/// A building that was learned before, made better by what one more trip saw of it.

#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/maps/building.hpp"
#include "aisle/merging/map_pattern.hpp"

namespace aisle {

struct RefinementParams {
  double trip_sigma_m = 0.01;  ///< of a wall's position, as one trip shows it
  int trips_remembered = 10;   ///< a wall's position weighs no more than so many trips: old errors fade
  double denied_m = 0.15;      ///< the trip's free floor this far from everything denies a wall
  double common_min_m = 6;     ///< walls that the trip must have in common with the building
  double agreement_min = 0.6;  ///< share of the walls in sight of both that both must have

  void describe(FieldList& fields);
};

/// What became of a piece of a wall.
enum class WallRefinement {
  kAdded,    ///< seen for the first time: it is uncertain
  kAssured,  ///< was uncertain, and is certain now
  kDoubted,  ///< the trip saw through it, but not enough trips have
  kRemoved,  ///< enough trips have seen through it: it is gone
};

struct RefinedWall {
  Segment2 segment;  ///< in the building's frame
  WallRefinement what = WallRefinement::kAdded;
};

struct RefinedBuilding {
  MapOverlap overlap;  ///< of the building and the trip's map
  Building building;
  std::vector<RefinedWall> walls;  ///< that have become something else
  double moved_rms_m = 0;          ///< by which the positions of walls that the trip saw again were corrected

  double length_m(WallRefinement what) const;
};

/// Whether a trip's map fits a building well enough to refine it, both in one frame.
bool is_of_building(const MapOverlap& overlap, const RefinementParams& params);

/// Takes a trip's map into a building; both lie in the building's frame, and have a floor
/// (std::invalid_argument). A wall that the trip saw again is moved towards where the trip saw it, by the
/// trip's share of what is known of it, and its evidence grows; a wall that the trip saw through loses
/// evidence, piece by piece, and goes when none is left; a wall that is new begins with one trip's evidence.
/// What the trip did not see stays. Floor is as the trip saw it, but where both draw one surface a little
/// apart. Everything else of the building stays as it is. Walls that one trip alone saw go with the next, so
/// the size is bounded by what stands in the building.
RefinedBuilding refined_building(const Building& old, const Building& trip, const RefinementParams& params);

}  // namespace aisle
