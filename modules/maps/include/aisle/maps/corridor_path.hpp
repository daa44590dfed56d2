#pragma once

#include <optional>
#include <vector>

#include "aisle/maps/corridor_graph.hpp"

namespace aisle {

/// A piece of one corridor.
struct CorridorLeg {
  std::size_t corridor = 0;
  double from_m = 0;  ///< along the corridor
  double to_m = 0;    ///< less than `from_m`: driven against the corridor's direction

  double length_m() const { return from_m < to_m ? to_m - from_m : from_m - to_m; }
};

/// Legs, each beginning where the previous one ends.
struct CorridorPath {
  std::vector<CorridorLeg> legs;

  double length_m() const;
  /// The points in `map` that the path leads through, in order.
  std::vector<Vec2> points(const CorridorGraph& graph) const;
};

/// The shortest path on the graph; deterministic.
/// @param closed  places that cannot be passed
/// @return nullopt if there is none
std::optional<CorridorPath> shortest_path(const CorridorGraph& graph, const CorridorPlace& from,
                                          const CorridorPlace& to,
                                          const std::vector<CorridorPlace>& closed = {});

/// A closed tour from a node that drives every corridor that can be reached at least once and is as short as
/// possible (the Chinese postman problem): a corridor is driven twice where it must be, none three times. It
/// is optimal if at most 16 nodes have an odd number of corridors, otherwise improved from a greedy choice;
/// never longer than twice all corridors.
CorridorPath patrol_path(const CorridorGraph& graph, std::size_t node);

}  // namespace aisle
