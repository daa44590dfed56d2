#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "aisle/maps/corridor_graph.hpp"

namespace aisle {

/// Dijkstra's search along whole corridors.
class CorridorSearch {
 public:
  /// @param lengths_m  of the corridors; infinity: impassable
  CorridorSearch(const CorridorGraph& graph, std::vector<double> lengths_m);

  /// Recomputes all distances, given start distances of the nodes (infinity: not a start).
  void run(const std::vector<double>& begin_m);

  double distance_m(std::size_t node) const { return distance_m_[node]; }
  /// The corridor by which the shortest path reaches the node; nullopt: the path starts there.
  std::optional<std::size_t> corridor_to(std::size_t node) const { return corridor_to_[node]; }
  /// The other end of a corridor.
  std::size_t across(std::size_t corridor, std::size_t node) const;

  /// The corridors of the shortest path to a reachable node, in order.
  std::vector<std::size_t> corridors_to(std::size_t node) const;

 private:
  const CorridorGraph& graph_;
  std::vector<double> lengths_m_;
  std::vector<std::vector<std::size_t>> at_node_;  ///< corridors
  std::vector<double> distance_m_;
  std::vector<std::optional<std::size_t>> corridor_to_;
};

}  // namespace aisle
