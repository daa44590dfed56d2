#pragma once
/// Clean walls from a plan of cells: a straight wall becomes one straight piece, though its border in the
/// plan is a flight of steps.

#include <optional>
#include <vector>

#include "aisle/core/progress.hpp"
#include "aisle/geometry/segment2.hpp"
#include "aisle/simulation/plans/floor_plan.hpp"

namespace aisle {

struct PlanTracingParams {
  double tolerance_cells =
      1;  ///< of a straight wall against the middles of the cells' sides that it stands for
};

struct PlanCleaningParams {
  double speck_m = 0;  ///< solid areas that fit into a square of this side become free; pillars look the same
  double slit_m = 0.1;  ///< free areas that no larger square fits into become solid
};

/// Removes specks, slits, and the outside of the building: free areas that reach the plan's border become
/// solid if they take more than half of that border, or if an enclosed free area is larger than they are
/// together.
/// @return how many specks there were
int clean_plan(FloorPlan& plan, const PlanCleaningParams& params);

/// The borders between free and solid cells as closed polygons, free on the left, in the frame `world`. Every
/// polygon has as few corners as the tolerance allows; pieces that may be parallel to the axes of the plan,
/// or to the direction that most of its walls have, are exactly so. Solid cells that touch at a corner are
/// connected.
/// @return pieces of each polygon in order, each starting where the one before ends; no value if the borders
///         have more than a million corners, which no world holds
std::optional<std::vector<Segment2>> trace_plan(const FloorPlan& plan, const PlanTracingParams& params,
                                                Progress& progress);

}  // namespace aisle
