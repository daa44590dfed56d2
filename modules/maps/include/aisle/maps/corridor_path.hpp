#pragma once

#include <optional>
#include <vector>

#include "aisle/maps/corridor_graph.hpp"

namespace aisle {

/// A segment of one corridor.
struct CorridorLeg {
  std::size_t corridor = 0;
  double from_m = 0;  ///< along the corridor
  double to_m = 0;    ///< less than `from_m`: against the corridor's own direction

  double length_m() const { return from_m < to_m ? to_m - from_m : from_m - to_m; }
};

/// Legs, each beginning where the one before ends.
struct CorridorPath {
  std::vector<CorridorLeg> legs;

  double length_m() const;
  /// The points of the graph that the path leads through, in order.
  std::vector<Vec2> points(const CorridorGraph& graph) const;
};

/// The shortest path on the graph, the same for the same arguments.
/// @param closed  places that there is no getting past
/// @return nullopt if there is none
std::optional<CorridorPath> shortest_path(const CorridorGraph& graph, const CorridorPlace& from,
                                          const CorridorPlace& to,
                                          const std::vector<CorridorPlace>& closed = {});

/// Corridors to drive one after the other from a node and back to it, so that each corridor that can be
/// reached is driven at least once and the whole path is as short as may be (the Chinese postman's path): a
/// corridor is driven twice where it must be, none three times. Shortest of all if at most 16 nodes have an
/// odd number of corridors, else improved from a greedy choice; never longer than twice all corridors.
CorridorPath patrol_path(const CorridorGraph& graph, std::size_t node);

}  // namespace aisle
