#include "aisle/learning/corridors/corridor_tracing.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

#include "aisle/geometry/segment2.hpp"
#include "corridors/ridge_graph.hpp"
#include "corridors/skeleton.hpp"

namespace aisle {
namespace {

/// How far an end's free circle extends beyond that of its crossing.
double reach_out_m(const RidgeGraph::Node& crossing, const RidgeGraph::Node& end) {
  return (end.p_map - crossing.p_map).norm() + end.clearance_m - crossing.clearance_m;
}

/// Removes lines that end near their crossing, the shortest first: each removal may turn its crossing into a
/// bend of one corridor.
void prune(RidgeGraph& graph, double branch_min_m) {
  for (;;) {
    std::optional<std::size_t> least;
    double least_m = branch_min_m;
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      const RidgeGraph::Edge& edge = graph.edges[i];
      for (const auto& [end, crossing] : {std::pair(edge.from, edge.to), std::pair(edge.to, edge.from)}) {
        if (graph.degree(end) != 1 || graph.degree(crossing) < 3) continue;
        const double reach_m = reach_out_m(graph.nodes[crossing], graph.nodes[end]);
        if (reach_m >= least_m) continue;
        least = i;
        least_m = reach_m;
      }
    }
    if (!least) return;
    const RidgeGraph::Edge gone = graph.edges[*least];
    graph.edges.erase(graph.edges.begin() + static_cast<std::ptrdiff_t>(*least));
    for (const std::size_t node : {gone.from, gone.to}) {
      if (graph.degree(node) == 2) graph.join_edges_at(node);
    }
  }
}

/// Merges two crossings if one lies inside the other's free circle: the one with more clearance stays, and
/// the other's lines lead on to it.
bool unite_two_crossings(RidgeGraph& graph) {
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const RidgeGraph::Edge link = graph.edges[i];
    if (link.from == link.to || graph.degree(link.from) < 3 || graph.degree(link.to) < 3) continue;
    const RidgeGraph::Node &a = graph.nodes[link.from], &b = graph.nodes[link.to];
    if (link.length_m() > std::max(a.clearance_m, b.clearance_m)) continue;
    const bool a_stays = a.clearance_m >= b.clearance_m;
    const std::size_t stays = a_stays ? link.from : link.to, goes = a_stays ? link.to : link.from;
    graph.edges.erase(graph.edges.begin() + static_cast<std::ptrdiff_t>(i));
    for (RidgeGraph::Edge& edge : graph.edges) {
      if (edge.from == goes) {
        edge.from = stays;
        edge.points.insert(edge.points.begin(), graph.nodes[stays].p_map);
        edge.clearance_m.insert(edge.clearance_m.begin(), graph.nodes[stays].clearance_m);
      }
      if (edge.to == goes) {
        edge.to = stays;
        edge.points.push_back(graph.nodes[stays].p_map);
        edge.clearance_m.push_back(graph.nodes[stays].clearance_m);
      }
    }
    return true;
  }
  return false;
}

/// Leaves out points within a tolerance of the straight line past them (Douglas and Peucker).
void simplify(const std::vector<Vec2>& points, std::size_t first, std::size_t last, double tolerance_m,
              std::vector<Vec2>& kept) {
  const Segment2 straight{points[first], points[last]};
  std::size_t farthest = first;
  double farthest_m = tolerance_m;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance_m = straight.distance(points[i]);
    if (distance_m <= farthest_m) continue;
    farthest = i;
    farthest_m = distance_m;
  }
  if (farthest == first) {
    kept.push_back(points[last]);
    return;
  }
  simplify(points, first, farthest, tolerance_m, kept);
  simplify(points, farthest, last, tolerance_m, kept);
}

std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance_m) {
  std::vector<Vec2> kept = {points.front()};
  simplify(points, 0, points.size() - 1, tolerance_m, kept);
  return kept;
}

/// Twice the median clearance, measured away from both crossings where possible.
double width_of(const RidgeGraph::Edge& edge, const RidgeGraph& graph) {
  std::vector<double> clearances_m;
  for (std::size_t i = 0; i < edge.points.size(); ++i) {
    const auto is_apart = [&](const RidgeGraph::Node& node) {
      return (edge.points[i] - node.p_map).norm() > node.clearance_m;
    };
    if (is_apart(graph.nodes[edge.from]) && is_apart(graph.nodes[edge.to]))
      clearances_m.push_back(edge.clearance_m[i]);
  }
  if (clearances_m.empty()) clearances_m = edge.clearance_m;
  const auto middle = clearances_m.begin() + static_cast<std::ptrdiff_t>(clearances_m.size() / 2);
  std::nth_element(clearances_m.begin(), middle, clearances_m.end());
  return 2 * *middle;
}

CorridorNode::Kind kind_of(std::size_t degree) {
  if (degree < 2) return CorridorNode::Kind::kEnd;
  return degree == 2 ? CorridorNode::Kind::kRound : CorridorNode::Kind::kCrossing;
}

/// The remaining nodes, those near the start first, and the corridors between them.
CorridorGraph corridors_of(const RidgeGraph& ridges, const Vec2& p_map_start, double tolerance_m) {
  std::vector<std::size_t> order;
  for (std::size_t node = 0; node < ridges.nodes.size(); ++node) {
    if (ridges.degree(node) > 0 || ridges.edges.empty()) order.push_back(node);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return (ridges.nodes[a].p_map - p_map_start).norm() < (ridges.nodes[b].p_map - p_map_start).norm();
  });
  CorridorGraph graph;
  std::vector<std::size_t> new_index(ridges.nodes.size());
  for (const std::size_t node : order) {
    new_index[node] = graph.nodes.size();
    graph.nodes.push_back({kind_of(ridges.degree(node)), ridges.nodes[node].p_map});
  }
  for (const RidgeGraph::Edge& edge : ridges.edges) {
    graph.corridors.push_back({new_index[edge.from], new_index[edge.to], simplified(edge.points, tolerance_m),
                               width_of(edge, ridges)});
  }
  return graph;
}

}  // namespace

void CorridorTracingParams::describe(FieldList& fields) {
  fields.real("clearance_min_m", clearance_min_m, {0.05, 2},
              "from a corridor's centre line to obstacles, for a vehicle to get through");
  fields.real("branch_min_m", branch_min_m, {0, 10},
              "a branch that leads less far out of its crossing is an alcove");
  fields.real("ridge_slope_max", ridge_slope_max, {0.1, 0.95},
              "an end leads into a corner where the clearance falls faster than this");
}

CorridorGraph trace_corridors(const FloorGrid& floor, const Vec2& p_map_start,
                              const CorridorTracingParams& params) {
  if (floor.known().empty()) return {};
  const ClearFloor clear(floor);
  RidgeGraph ridges = ridge_graph(
      clear,
      skeleton(clear, clear.reached_from(p_map_start, params.clearance_min_m), params.ridge_slope_max));
  prune(ridges, params.branch_min_m);
  while (unite_two_crossings(ridges)) prune(ridges, params.branch_min_m);
  for (RidgeGraph::Edge& edge : ridges.edges) {
    if (edge.from == edge.to && ridges.degree(edge.from) == 2) ridges.turn_round(edge, p_map_start);
  }
  return corridors_of(ridges, p_map_start, floor.cell_m());
}

}  // namespace aisle
