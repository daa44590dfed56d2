#pragma once

#include "aisle/core/parameters.hpp"
#include "aisle/maps/corridor_graph.hpp"
#include "aisle/maps/floor_grid.hpp"

namespace aisle {

struct CorridorTracingParams {
  double clearance_min_m =
      0.35;  ///< from a corridor's centre line to obstacles; half a vehicle and its margin
  double branch_min_m = 0.8;
  double ridge_slope_max = 0.6;

  void describe(FieldList& fields);
};

/// The corridors of the floor that can be driven from a point: the lines midway between everything that is
/// not known to be free. Lines meet at crossings. A line that does not lead farther than `branch_min_m` out
/// of the free circle around its crossing is dropped, and crossings inside each other's circles are merged.
/// Nodes are ordered by their distance from the point.
/// @return no nodes if no floor within a metre of the point can be driven; one node without corridors if
///         nothing leads away from the place
CorridorGraph trace_corridors(const FloorGrid& floor, const Vec2& p_map_start,
                              const CorridorTracingParams& params);

}  // namespace aisle
