#pragma once
/// Graphs of corridors to test with.

#include <utility>
#include <vector>

#include "aisle/core/random.hpp"
#include "aisle/maps/corridor_graph.hpp"

namespace aisle {

inline CorridorGraph straight_graph(const std::vector<Vec2>& nodes,
                                    const std::vector<std::pair<std::size_t, std::size_t>>& corridors) {
  CorridorGraph graph;
  for (const Vec2& p : nodes) graph.nodes.push_back({CorridorNode::Kind::kCrossing, p});
  for (const auto& [from, to] : corridors) graph.corridors.push_back({from, to, {nodes[from], nodes[to]}, 2});
  return graph;
}

/// Connected; corridors bend, form loops, and lie beside each other now and then.
inline CorridorGraph any_graph(Random& random, std::size_t nodes, std::size_t more_corridors) {
  CorridorGraph graph;
  const auto any_point = [&] { return Vec2(random.uniform(-30, 30), random.uniform(-30, 30)); };
  for (std::size_t i = 0; i < nodes; ++i) graph.nodes.push_back({CorridorNode::Kind::kCrossing, any_point()});
  const auto join = [&](std::size_t from, std::size_t to) {
    graph.corridors.push_back({from, to, {graph.nodes[from].p_map, any_point(), graph.nodes[to].p_map}, 2});
  };
  for (std::size_t i = 1; i < nodes; ++i) join(i, random.index(i));
  for (std::size_t i = 0; i < more_corridors; ++i) join(random.index(nodes), random.index(nodes));
  return graph;
}

}  // namespace aisle
