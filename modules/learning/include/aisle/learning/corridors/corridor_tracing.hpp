#pragma once

#include "aisle/core/parameters.hpp"
#include "aisle/maps/corridor_graph.hpp"
#include "aisle/maps/floor_grid.hpp"

namespace aisle {

struct CorridorTracingParams {
  double clearance_min_m =
      0.35;  ///< from a corridor's middle to what stands there; half a vehicle and its margin
  double branch_min_m = 0.8;
  double ridge_slope_max = 0.6;

  void describe(FieldList& fields);
};

/// The corridors of the floor that can be driven from a point: the lines that run in the middle between all
/// that is not known to be free. Where such lines meet is a crossing; a line that does not lead farther out
/// of the circle around a crossing that is free than `branch_min_m` is none, and crossings within each
/// other's circles are one. Nodes are in the order of their distance from the point.
/// @return no nodes if nothing within a metre of the point can be driven; one node without corridors if it is
/// a
///         place from which nothing leads on
CorridorGraph trace_corridors(const FloorGrid& floor, const Vec2& p_map_start,
                              const CorridorTracingParams& params);

}  // namespace aisle
