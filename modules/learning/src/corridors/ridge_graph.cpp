#include "corridors/ridge_graph.hpp"

#include <algorithm>
#include <utility>

#include "aisle/geometry/polyline.hpp"
#include "corridors/skeleton.hpp"

namespace aisle {
namespace {

constexpr std::size_t kNoNode = static_cast<std::size_t>(-1);

class LineTracer {
 public:
  LineTracer(const ClearFloor& floor, const std::vector<bool>& skeleton)
      : floor_(floor), skeleton_(skeleton), node_of_(skeleton.size(), kNoNode), is_traced_(skeleton.size()) {
    for (std::size_t cell = 0; cell < skeleton_.size(); ++cell) {
      if (skeleton_[cell]) cells_.push_back(cell);
    }
  }

  RidgeGraph trace() {
    for (const std::size_t cell : cells_) {
      if (node_of_[cell] == kNoNode && neighbours(cell).size() != 2) add_node(cell);
    }
    for (const std::size_t cell : cells_) {
      if (node_of_[cell] != kNoNode) trace_from(cell);
    }
    for (const std::size_t cell : cells_) {
      if (node_of_[cell] != kNoNode || is_traced_[cell]) continue;
      add_node(cell);
      trace_from(cell);
    }
    return std::move(graph_);
  }

 private:
  std::vector<std::size_t> neighbours(std::size_t cell) const {
    std::vector<std::size_t> cells;
    for (const std::size_t next : cells_around(floor_, cell)) {
      if (skeleton_[next]) cells.push_back(next);
    }
    return cells;
  }

  /// Adjacent cells at which lines meet are one node, placed at the greatest clearance.
  void add_node(std::size_t cell) {
    const std::size_t node = graph_.nodes.size();
    std::vector<std::size_t> open = {cell};
    std::size_t middle = cell;
    node_of_[cell] = node;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (floor_.clearance_m(at) > floor_.clearance_m(middle)) middle = at;
      if (neighbours(at).size() < 3) continue;
      for (const std::size_t next : neighbours(at)) {
        if (node_of_[next] != kNoNode || neighbours(next).size() < 3) continue;
        node_of_[next] = node;
        open.push_back(next);
      }
    }
    graph_.nodes.push_back({floor_.centre(middle), floor_.clearance_m(middle)});
  }

  /// Traces the lines that leave a node's cell and were not traced from their other end.
  void trace_from(std::size_t cell) {
    for (const std::size_t next : neighbours(cell)) {
      if (node_of_[next] == node_of_[cell] || is_traced_[next]) continue;
      if (node_of_[next] != kNoNode && node_of_[next] < node_of_[cell]) continue;
      trace_line(cell, next);
    }
  }

  void trace_line(std::size_t before, std::size_t cell) {
    RidgeGraph::Edge edge{node_of_[before], kNoNode, {}, {}};
    const auto add = [&](const Vec2& p, double clearance_m) {
      edge.points.push_back(p);
      edge.clearance_m.push_back(clearance_m);
    };
    add(graph_.nodes[edge.from].p_map, graph_.nodes[edge.from].clearance_m);
    while (node_of_[cell] == kNoNode) {
      is_traced_[cell] = true;
      add(floor_.centre(cell), floor_.clearance_m(cell));
      const auto beside = neighbours(cell);  // exactly two
      const std::size_t next = beside[0] == before ? beside[1] : beside[0];
      before = std::exchange(cell, next);
    }
    edge.to = node_of_[cell];
    add(graph_.nodes[edge.to].p_map, graph_.nodes[edge.to].clearance_m);
    graph_.edges.push_back(std::move(edge));
  }

  const ClearFloor& floor_;
  const std::vector<bool>& skeleton_;
  std::vector<std::size_t> cells_;
  std::vector<std::size_t> node_of_;
  std::vector<bool> is_traced_;
  RidgeGraph graph_;
};

}  // namespace

double RidgeGraph::Edge::length_m() const {
  return polyline_length_m(points);
}

std::size_t RidgeGraph::degree(std::size_t node) const {
  std::size_t ends = 0;
  for (const Edge& edge : edges) ends += (edge.from == node ? 1U : 0U) + (edge.to == node ? 1U : 0U);
  return ends;
}

void RidgeGraph::join_edges_at(std::size_t node) {
  const auto ends_at_node = [&](const Edge& edge) { return edge.from == node || edge.to == node; };
  const auto first = std::find_if(edges.begin(), edges.end(), ends_at_node);
  const auto second = first == edges.end() ? first : std::find_if(first + 1, edges.end(), ends_at_node);
  if (second == edges.end()) return;
  const auto turn = [](Edge& edge) {
    std::swap(edge.from, edge.to);
    std::reverse(edge.points.begin(), edge.points.end());
    std::reverse(edge.clearance_m.begin(), edge.clearance_m.end());
  };
  if (first->to != node) turn(*first);
  if (second->from != node) turn(*second);
  first->to = second->to;
  first->points.insert(first->points.end(), second->points.begin() + 1, second->points.end());
  first->clearance_m.insert(first->clearance_m.end(), second->clearance_m.begin() + 1,
                            second->clearance_m.end());
  edges.erase(second);
}

void RidgeGraph::turn_round(Edge& edge, const Vec2& p_map) {
  const auto nearer = [&](const Vec2& a, const Vec2& b) { return (a - p_map).norm() < (b - p_map).norm(); };
  const auto first = std::min_element(edge.points.begin(), edge.points.end(), nearer) - edge.points.begin();
  edge.points.pop_back();
  edge.clearance_m.pop_back();
  std::rotate(edge.points.begin(), edge.points.begin() + first, edge.points.end());
  std::rotate(edge.clearance_m.begin(), edge.clearance_m.begin() + first, edge.clearance_m.end());
  edge.points.push_back(edge.points.front());
  edge.clearance_m.push_back(edge.clearance_m.front());
  nodes[edge.from] = {edge.points.front(), edge.clearance_m.front()};
}

RidgeGraph ridge_graph(const ClearFloor& floor, const std::vector<bool>& skeleton) {
  return LineTracer(floor, skeleton).trace();
}

}  // namespace aisle
