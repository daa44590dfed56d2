#include "corridor_search.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace aisle {

CorridorSearch::CorridorSearch(const CorridorGraph& graph, std::vector<double> lengths_m)
    : graph_(graph), lengths_m_(std::move(lengths_m)), at_node_(graph.nodes.size()) {
  for (std::size_t i = 0; i < graph.corridors.size(); ++i) {
    at_node_[graph.corridors[i].from].push_back(i);
    at_node_[graph.corridors[i].to].push_back(i);
  }
}

void CorridorSearch::run(const std::vector<double>& begin_m) {
  using Entry = std::pair<double, std::size_t>;  // distance, node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distance_m_ = begin_m;
  corridor_to_.assign(begin_m.size(), std::nullopt);
  for (std::size_t node = 0; node < begin_m.size(); ++node) open.emplace(begin_m[node], node);
  while (!open.empty()) {
    const auto [distance_m, node] = open.top();
    open.pop();
    if (distance_m > distance_m_[node]) continue;
    for (const std::size_t corridor : at_node_[node]) {
      const std::size_t next = across(corridor, node);
      const double next_m = distance_m + lengths_m_[corridor];
      if (next_m >= distance_m_[next]) continue;
      distance_m_[next] = next_m;
      corridor_to_[next] = corridor;
      open.emplace(next_m, next);
    }
  }
}

std::size_t CorridorSearch::across(std::size_t corridor, std::size_t node) const {
  const Corridor& c = graph_.corridors[corridor];
  return c.from == node ? c.to : c.from;
}

std::vector<std::size_t> CorridorSearch::corridors_to(std::size_t node) const {
  std::vector<std::size_t> corridors;
  while (const auto corridor = corridor_to(node)) {
    corridors.push_back(*corridor);
    node = across(*corridor, node);
  }
  std::reverse(corridors.begin(), corridors.end());
  return corridors;
}

}  // namespace aisle
