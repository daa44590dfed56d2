#pragma once

#include <cstdint>
#include <vector>

#include "aisle/core/parameters.hpp"
#include "aisle/exploration/floor_distances.hpp"
#include "aisle/maps/known_floor.hpp"

namespace aisle {

struct FrontierParams {
  double clearance_m = 0.32;  ///< clearance from the vehicle's centre line to anything that is not free floor
  double uncertain_m = 0.05;  ///< beyond this extra clearance from obstacles there may be floor
  double area_min_m2 = 0.05;  ///< least floor behind a frontier
  double cluster_gap_m = 0.15;
  double length_max_m = 8;  ///< longer ones are cut, so that one look shows a good part of each

  void describe(FieldList& fields);
};

/// Where floor that the vehicle can surely drive on meets floor that it may be able to drive on: a path that
/// leads on (C99 section 4.2: "a navigation path is said to be available").
struct Frontier {
  static constexpr double kPocketDepth_m = 0.4;  ///< depth of the unknown before a pocket's edge, at most

  std::vector<FloorCell> cells;  ///< drivable cells that border on uncertain floor
  std::vector<Vec2> edge;        ///< in `map` [m], on the edge of the free floor: to be seen to know more
  FloorBox box;                  ///< bounding box of the frontier cells
  Vec2 p_map = Vec2::Zero();     ///< the centre of the middle one of the frontier cells
  double behind_m2 = 0;          ///< area that may be floor, as far as it was counted
  double path_m = 0;             ///< path from the vehicle to the nearest frontier cell
  bool is_pocket = false;        ///< only to be looked into, see find_pockets() ...
  FloorCell viewpoint;           ///< ... from this nearest viewpoint; `path_m` leads there
};

/// The same frontier on floor of cells half as wide.
Frontier with_cells_halved(Frontier frontier);

/// Marks that a search leaves on each cell; kept from search to search to save allocations.
using CellMarks = std::vector<std::uint8_t>;

/// All frontiers that can be reached.
/// @param reached  measured with `params.clearance_m`
/// @param marks  scratch memory
std::vector<Frontier> find_frontiers(const KnownFloor& floor, const FloorDistances& reached,
                                     const FrontierParams& params, CellMarks& marks);

}  // namespace aisle
