#pragma once

#include <cstdint>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/exploration/floor_distances.hpp"
#include "aisle/maps/floor_clearance.hpp"

namespace aisle {

struct FrontierParams {
  double room_m = 0.32;       ///< from the vehicle's middle line to anything that is not free floor
  double uncertain_m = 0.05;  ///< where so much more is free of things, there may be floor
  double area_min_m2 = 0.05;  ///< behind a frontier; less is no path
  double cluster_gap_m = 0.15;

  void describe(FieldList& fields);
};

/// Where floor on which the vehicle can go for sure meets floor on which it may be able to: a path that leads
/// on (C99 section 4.2: "a navigation path is said to be available").
struct Frontier {
  static constexpr double kPocketDepth_m = 0.4;  ///< of the unknown that lies before a pocket's rim, at most

  std::vector<FloorCell> frontier_cells;  ///< cells of sure floor that border on the other
  std::vector<Vec2> rim;      ///< on the edge of the free floor there: what must be seen to know more [m]
  FloorBox box;               ///< about the frontier cells
  Vec2 p_map = Vec2::Zero();  ///< the middle of the frontier cells: one of its cells
  double behind_m2 = 0;       ///< of floor that may be there, as far as it was counted
  double path_m = 0;          ///< from the vehicle to the nearest cell of the frontier cells
  bool is_pocket = false;     ///< only to be looked into, see find_pockets() ...
  FloorCell stand;            ///< ... the nearest place from which that may be; `path_m` leads there
};

/// The same frontier on floor of cells half as wide.
Frontier with_cells_halved(Frontier frontier);

/// What a search notes of each cell of a room; kept for the next one, as its memory is costly to get again.
using CellMarks = std::vector<std::uint8_t>;

/// All frontiers that can be reached.
/// @param reached  measured with `params.room_m`
/// @param marks  to work with
std::vector<Frontier> find_frontiers(const FloorGrid& floor, const FloorClearance& clearance,
                                     const FloorDistances& reached, const FrontierParams& params,
                                     CellMarks& marks);

}  // namespace aisle
