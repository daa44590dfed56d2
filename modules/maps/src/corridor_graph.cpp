#include "aisle/maps/corridor_graph.hpp"

#include <algorithm>

#include "aisle/geometry/polyline.hpp"
#include "aisle/geometry/segment2.hpp"

namespace aisle {

std::string_view name_of(CorridorNode::Kind kind) {
  switch (kind) {
    case CorridorNode::Kind::kCrossing:
      return "crossing";
    case CorridorNode::Kind::kEnd:
      return "end";
    case CorridorNode::Kind::kRound:
      return "round";
  }
  return "";
}

double Corridor::length_m() const {
  return polyline_length_m(path);
}

Vec2 Corridor::at(double along_m) const {
  double left_m = std::max(along_m, 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step_m = (path[i] - path[i - 1]).norm();
    if (left_m < step_m) return path[i - 1] + left_m / step_m * (path[i] - path[i - 1]);
    left_m -= step_m;
  }
  return path.back();
}

double CorridorGraph::length_m() const {
  double sum_m = 0;
  for (const Corridor& corridor : corridors) sum_m += corridor.length_m();
  return sum_m;
}

std::size_t CorridorGraph::count(CorridorNode::Kind kind) const {
  return static_cast<std::size_t>(
      std::count_if(nodes.begin(), nodes.end(), [&](const CorridorNode& node) { return node.kind == kind; }));
}

std::size_t CorridorGraph::degree(std::size_t node) const {
  std::size_t ends = 0;
  for (const Corridor& corridor : corridors) {
    ends += (corridor.from == node ? 1U : 0U) + (corridor.to == node ? 1U : 0U);
  }
  return ends;
}

std::optional<CorridorPlace> CorridorGraph::nearest(const Vec2& p_map) const {
  std::optional<CorridorPlace> best;
  for (std::size_t i = 0; i < corridors.size(); ++i) {
    const std::vector<Vec2>& path = corridors[i].path;
    double along_m = 0;
    for (std::size_t j = 1; j < path.size(); ++j) {
      const Vec2 step = path[j] - path[j - 1];
      const double step_m = step.norm();
      const double share =
          step_m > 0 ? std::clamp((p_map - path[j - 1]).dot(step) / (step_m * step_m), 0.0, 1.0) : 0;
      const Vec2 p = path[j - 1] + share * step;
      const double lateral_m = (p_map - p).norm();
      if (!best || lateral_m < best->lateral_m)
        best = CorridorPlace{i, along_m + share * step_m, p, lateral_m};
      along_m += step_m;
    }
  }
  return best;
}

std::string CorridorGraph::name_of(std::size_t node) const {
  const auto is_alike = [&](const CorridorNode& other) { return other.kind == nodes[node].kind; };
  const auto number =
      1 + std::count_if(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(node), is_alike);
  return std::string(aisle::name_of(nodes[node].kind)) + " " + std::to_string(number);
}

std::optional<CorridorPlace> CorridorGraph::place_of(std::size_t node) const {
  for (std::size_t i = 0; i < corridors.size(); ++i) {
    if (corridors[i].from == node) return CorridorPlace{i, 0, nodes[node].p_map, 0};
    if (corridors[i].to == node) return CorridorPlace{i, corridors[i].length_m(), nodes[node].p_map, 0};
  }
  return std::nullopt;
}

}  // namespace aisle
