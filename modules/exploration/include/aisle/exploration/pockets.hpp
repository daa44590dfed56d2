#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "aisle/exploration/frontiers.hpp"

namespace aisle {

struct PocketParams {
  double edge_min_m = 0.3;  ///< shorter edges of the known floor are ignored
  double reach_m = 4.5;     ///< a pocket is looked into from at most this far
  double path_max_m = 3;    ///< a pocket farther away waits until the vehicle comes by; 0: all are ignored
  double path_max_m_per_m2 = 60;  ///< the same per area hidden along its edge; the greater limit counts
  double again_m2 = 0.3;          ///< a pocket that hides this much along its edge is looked into twice

  /// Not worth a detour.
  bool is_far(const Frontier& frontier) const {
    return frontier.is_pocket &&
           frontier.path_m > std::max(path_max_m, path_max_m_per_m2 * frontier.behind_m2);
  }
  /// Whether to look again after a look into it has shown nothing.
  bool is_worth_another_look(const Frontier& frontier) const {
    return !frontier.is_pocket || (frontier.behind_m2 >= again_m2 && !is_far(frontier));
  }

  void describe(FieldList& fields);
};

/// Pockets: hidden floor that no frontier leads to but that can be seen from where the vehicle gets: behind a
/// cupboard, or in a room whose door is hardly open. Each is given as a frontier that is not driven through:
/// its frontier cells are the edge of the free floor, its edge lies right behind them in the unknown.
/// @param reached  measured with `frontier_params.clearance_m`
/// @param frontiers  of the same floor
/// @param marks  scratch memory
std::vector<Frontier> find_pockets(const KnownFloor& floor, const FloorDistances& reached,
                                   std::span<const Frontier> frontiers, const FrontierParams& frontier_params,
                                   const PocketParams& params, CellMarks& marks);

}  // namespace aisle
