#include "aisle/maps/corridor_path.hpp"

#include <algorithm>
#include <limits>

#include "corridor_search.hpp"

namespace aisle {
namespace {

constexpr double kNoPath = std::numeric_limits<double>::infinity();

class PathSearch {
 public:
  PathSearch(const CorridorGraph& graph, const CorridorPlace& from, const CorridorPlace& to,
             const std::vector<CorridorPlace>& closed)
      : graph_(graph), from_(from), to_(to), closed_(closed), search_(graph, free_lengths()) {}

  std::optional<CorridorPath> shortest() {
    std::vector<double> begin_m(graph_.nodes.size(), kNoPath);
    const Corridor& first = graph_.corridors[from_.corridor];
    begin_m[first.from] = free_m({from_.corridor, from_.along_m, 0});
    begin_m[first.to] =
        std::min(begin_m[first.to], free_m({from_.corridor, from_.along_m, first.length_m()}));
    search_.run(begin_m);

    const double direct_m = from_.corridor == to_.corridor ? free_m(direct()) : kNoPath;
    const CorridorLeg last = last_leg();
    const double round_m = distance_to(last) + free_m(last);
    if (direct_m == kNoPath && round_m == kNoPath) return std::nullopt;
    if (direct_m <= round_m) return CorridorPath{{direct()}};
    return path_by_nodes(last);
  }

 private:
  /// The leg's length; infinity if a closed place lies on it.
  double free_m(const CorridorLeg& leg) const {
    const double low_m = std::min(leg.from_m, leg.to_m), high_m = std::max(leg.from_m, leg.to_m);
    const bool is_closed = std::any_of(closed_.begin(), closed_.end(), [&](const CorridorPlace& place) {
      return place.corridor == leg.corridor && low_m <= place.along_m && place.along_m <= high_m;
    });
    return is_closed ? kNoPath : high_m - low_m;
  }

  std::vector<double> free_lengths() const {
    std::vector<double> lengths_m;
    for (std::size_t i = 0; i < graph_.corridors.size(); ++i)
      lengths_m.push_back(free_m({i, 0, graph_.corridors[i].length_m()}));
    return lengths_m;
  }

  CorridorLeg direct() const { return {from_.corridor, from_.along_m, to_.along_m}; }

  double distance_to(const CorridorLeg& leg) const {
    const Corridor& corridor = graph_.corridors[leg.corridor];
    return search_.distance_m(leg.from_m == 0 ? corridor.from : corridor.to);
  }

  /// The shorter way to the destination from one of its corridor's ends.
  CorridorLeg last_leg() const {
    const CorridorLeg from_start{to_.corridor, 0, to_.along_m};
    const CorridorLeg from_end{to_.corridor, graph_.corridors[to_.corridor].length_m(), to_.along_m};
    return distance_to(from_end) + free_m(from_end) < distance_to(from_start) + free_m(from_start)
               ? from_end
               : from_start;
  }

  CorridorPath path_by_nodes(const CorridorLeg& last) const {
    const Corridor& corridor = graph_.corridors[last.corridor];
    const std::size_t end = last.from_m == 0 ? corridor.from : corridor.to;
    const std::vector<std::size_t> corridors = search_.corridors_to(end);
    std::size_t node = end;
    for (auto it = corridors.rbegin(); it != corridors.rend(); ++it) node = search_.across(*it, node);
    CorridorPath path{{first_leg(node)}};
    for (const std::size_t i : corridors) {
      const double length_m = graph_.corridors[i].length_m();
      const bool forwards = graph_.corridors[i].from == node;
      path.legs.push_back({i, forwards ? 0 : length_m, forwards ? length_m : 0});
      node = search_.across(i, node);
    }
    path.legs.push_back(last);
    std::erase_if(path.legs, [](const CorridorLeg& leg) { return leg.length_m() == 0; });
    if (path.legs.empty()) path.legs.push_back(last);
    return path;
  }

  /// From the start to the node where the path leaves its corridor.
  CorridorLeg first_leg(std::size_t node) const {
    const Corridor& corridor = graph_.corridors[from_.corridor];
    const CorridorLeg back{from_.corridor, from_.along_m, 0};
    const CorridorLeg on{from_.corridor, from_.along_m, corridor.length_m()};
    if (corridor.from != node) return on;
    if (corridor.to != node) return back;
    return free_m(on) < free_m(back) ? on : back;
  }

  const CorridorGraph& graph_;
  const CorridorPlace& from_;
  const CorridorPlace& to_;
  const std::vector<CorridorPlace>& closed_;
  CorridorSearch search_;
};

}  // namespace

double CorridorPath::length_m() const {
  double sum_m = 0;
  for (const CorridorLeg& leg : legs) sum_m += leg.length_m();
  return sum_m;
}

std::vector<Vec2> CorridorPath::points(const CorridorGraph& graph) const {
  std::vector<Vec2> points;
  const auto add = [&](const Vec2& p) {
    if (points.empty() || points.back() != p) points.push_back(p);
  };
  for (const CorridorLeg& leg : legs) {
    const Corridor& corridor = graph.corridors[leg.corridor];
    const auto [low_m, high_m] = std::minmax(leg.from_m, leg.to_m);
    std::vector<Vec2> inner;
    double along_m = 0;
    for (std::size_t i = 0; i < corridor.path.size(); ++i) {
      if (i > 0) along_m += (corridor.path[i] - corridor.path[i - 1]).norm();
      if (low_m < along_m && along_m < high_m) inner.push_back(corridor.path[i]);
    }
    if (leg.to_m < leg.from_m) std::reverse(inner.begin(), inner.end());
    add(corridor.at(leg.from_m));
    for (const Vec2& p : inner) add(p);
    add(corridor.at(leg.to_m));
  }
  return points;
}

std::optional<CorridorPath> shortest_path(const CorridorGraph& graph, const CorridorPlace& from,
                                          const CorridorPlace& to, const std::vector<CorridorPlace>& closed) {
  return PathSearch(graph, from, to, closed).shortest();
}

}  // namespace aisle
