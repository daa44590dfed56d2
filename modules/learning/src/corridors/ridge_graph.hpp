#pragma once

#include <cstddef>
#include <vector>

#include "corridors/clear_floor.hpp"

namespace aisle {

/// A skeleton's cells as a graph, before deciding which parts are corridors.
struct RidgeGraph {
  struct Node {
    Vec2 p_map = Vec2::Zero();
    double clearance_m = 0;
  };
  struct Edge {
    std::size_t from = 0;
    std::size_t to = 0;
    std::vector<Vec2> points;         ///< from node to node, both included
    std::vector<double> clearance_m;  ///< one a point

    double length_m() const;
  };
  std::vector<Node> nodes;
  std::vector<Edge> edges;

  std::size_t degree(std::size_t node) const;
  /// Joins the two edges that meet at a node of degree 2; a loop edge stays.
  void join_edges_at(std::size_t node);
  /// Moves the only node of a loop edge to where it is nearest to a point.
  void turn_round(Edge& edge, const Vec2& p_map);
};

/// The ends, the places where more than two lines meet, and the lines between. A loop without either has a
/// node somewhere.
RidgeGraph ridge_graph(const ClearFloor& floor, const std::vector<bool>& skeleton);

}  // namespace aisle
