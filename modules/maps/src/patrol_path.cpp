#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "aisle/maps/corridor_path.hpp"
#include "corridor_search.hpp"

namespace aisle {
namespace {

constexpr std::size_t kExactNodesMax = 16;
constexpr double kFar = std::numeric_limits<double>::infinity();

using Pair = std::pair<std::size_t, std::size_t>;
using Distances = std::vector<std::vector<double>>;

/// The pairing with the least total distance. The best way to pair a set of nodes pairs its first node with
/// some other one and the rest in the best way (dynamic programming over subsets).
std::vector<Pair> pair_exactly(const Distances& distances) {
  const std::size_t count = distances.size();
  std::vector<double> cost(std::size_t{1} << count, kFar);
  std::vector<std::uint8_t> partner(cost.size());
  cost[0] = 0;
  for (std::uint32_t set = 1; set < cost.size(); ++set) {
    if (std::popcount(set) % 2 != 0) continue;
    const auto first = static_cast<std::size_t>(std::countr_zero(set));
    for (std::size_t other = first + 1; other < count; ++other) {
      if ((set >> other & 1U) == 0) continue;
      const double with_other = cost[set & ~(1U << first) & ~(1U << other)] + distances[first][other];
      if (with_other >= cost[set]) continue;
      cost[set] = with_other;
      partner[set] = static_cast<std::uint8_t>(other);
    }
  }
  std::vector<Pair> pairs;
  for (auto set = static_cast<std::uint32_t>(cost.size() - 1); set != 0;) {
    const auto first = static_cast<std::size_t>(std::countr_zero(set));
    pairs.emplace_back(first, partner[set]);
    set &= ~(1U << first) & ~(1U << partner[set]);
  }
  return pairs;
}

std::vector<Pair> pair_nearest_first(const Distances& distances) {
  std::vector<Pair> candidates, pairs;
  for (std::size_t a = 0; a < distances.size(); ++a) {
    for (std::size_t b = a + 1; b < distances.size(); ++b) candidates.emplace_back(a, b);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [&](const Pair& a, const Pair& b) {
    return distances[a.first][a.second] < distances[b.first][b.second];
  });
  std::vector<bool> is_paired(distances.size(), false);
  for (const Pair& pair : candidates) {
    if (is_paired[pair.first] || is_paired[pair.second]) continue;
    is_paired[pair.first] = is_paired[pair.second] = true;
    pairs.push_back(pair);
  }
  return pairs;
}

/// Exchanges partners between two pairs as long as that gets shorter (2-opt).
void exchange_partners(std::vector<Pair>& pairs, const Distances& distances) {
  const auto length = [&](const Pair& pair) { return distances[pair.first][pair.second]; };
  const auto try_pairs = [&](Pair& a, Pair& b, const Pair& new_a, const Pair& new_b) {
    if (length(new_a) + length(new_b) > length(a) + length(b) - 1e-9) return false;
    a = new_a;
    b = new_b;
    return true;
  };
  for (bool is_better = true; is_better;) {
    is_better = false;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      for (std::size_t j = i + 1; j < pairs.size(); ++j) {
        Pair &a = pairs[i], &b = pairs[j];
        is_better |= try_pairs(a, b, {a.first, b.first}, {a.second, b.second});
        is_better |= try_pairs(a, b, {a.first, b.second}, {a.second, b.first});
      }
    }
  }
}

std::vector<Pair> pairs_of(const Distances& distances) {
  if (distances.size() <= kExactNodesMax) return pair_exactly(distances);
  std::vector<Pair> pairs = pair_nearest_first(distances);
  exchange_partners(pairs, distances);
  return pairs;
}

class Postman {
 public:
  Postman(const CorridorGraph& graph, std::size_t start)
      : graph_(graph), start_(start), search_(graph, lengths(graph)) {}

  CorridorPath path() {
    run_from(start_);
    for (std::size_t i = 0; i < graph_.corridors.size(); ++i)
      times_.push_back(search_.distance_m(graph_.corridors[i].from) < kFar ? 1 : 0);
    double_between(odd_nodes());
    return round_trip();
  }

 private:
  static std::vector<double> lengths(const CorridorGraph& graph) {
    std::vector<double> lengths_m;
    for (const Corridor& corridor : graph.corridors) lengths_m.push_back(corridor.length_m());
    return lengths_m;
  }

  void run_from(std::size_t node) {
    std::vector<double> begin_m(graph_.nodes.size(), kFar);
    begin_m[node] = 0;
    search_.run(begin_m);
  }

  std::vector<std::size_t> odd_nodes() const {
    std::vector<std::size_t> odd;
    for (std::size_t node = 0; node < graph_.nodes.size(); ++node) {
      if (search_.distance_m(node) < kFar && graph_.degree(node) % 2 != 0) odd.push_back(node);
    }
    return odd;
  }

  /// Drives the corridors between paired nodes once more. Where two pairs share a corridor, the extra passes
  /// cancel out.
  void double_between(const std::vector<std::size_t>& odd) {
    Distances distances_m(odd.size());
    std::vector<std::vector<std::vector<std::size_t>>> corridors(odd.size());
    for (std::size_t a = 0; a < odd.size(); ++a) {
      run_from(odd[a]);
      for (const std::size_t b : odd) {
        distances_m[a].push_back(search_.distance_m(b));
        corridors[a].push_back(search_.corridors_to(b));
      }
    }
    for (const auto& [a, b] : pairs_of(distances_m)) {
      for (const std::size_t i : corridors[a][b]) times_[i] = times_[i] == 1 ? 2 : 1;
    }
  }

  /// Hierholzer's algorithm: walks on while it can, and inserts what was left out on the way back.
  CorridorPath round_trip() {
    std::vector<std::vector<std::size_t>> at_node(graph_.nodes.size());
    for (std::size_t i = 0; i < graph_.corridors.size(); ++i) {
      at_node[graph_.corridors[i].from].push_back(i);
      at_node[graph_.corridors[i].to].push_back(i);
    }
    struct Stand {
      std::size_t node;
      std::optional<std::size_t> by;  // the corridor that led here
    };
    std::vector<Stand> walked = {{start_, std::nullopt}};
    CorridorPath path;
    while (!walked.empty()) {
      const Stand stand = walked.back();
      std::vector<std::size_t>& open = at_node[stand.node];
      std::erase_if(open, [&](std::size_t corridor) { return times_[corridor] == 0; });
      if (!open.empty()) {
        // Turns straight back only where there is no other way on.
        const bool is_back = stand.by == open.front() && open.size() > 1;
        const std::size_t corridor = open[is_back ? 1 : 0];
        --times_[corridor];
        walked.push_back({search_.across(corridor, stand.node), corridor});
        continue;
      }
      walked.pop_back();
      if (stand.by) path.legs.push_back(leg_from(stand.node, *stand.by));
    }
    return path;
  }

  /// The path is built backwards: from where the corridor led to.
  CorridorLeg leg_from(std::size_t node, std::size_t corridor) const {
    const double length_m = graph_.corridors[corridor].length_m();
    return graph_.corridors[corridor].from == node ? CorridorLeg{corridor, 0, length_m}
                                                   : CorridorLeg{corridor, length_m, 0};
  }

  const CorridorGraph& graph_;
  std::size_t start_;
  CorridorSearch search_;
  std::vector<int> times_;  ///< each corridor is still to be driven
};

}  // namespace

CorridorPath patrol_path(const CorridorGraph& graph, std::size_t node) {
  return Postman(graph, node).path();
}

}  // namespace aisle
