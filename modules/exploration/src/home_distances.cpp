#include "aisle/exploration/home_distances.hpp"

namespace aisle {
namespace {

constexpr std::size_t kMostUpdates = 1024;

}  // namespace

HomeDistances::HomeDistances(std::size_t cells, std::size_t start) : distances_(cells, UINT32_MAX) {
  distances_[start] = 0;
}

void HomeDistances::add(const LearnedGrid& map, std::size_t cell) {
  const auto for_each_known_neighbour = [&map](std::size_t of, auto visit) {
    for (const Side side : kAllSides) {
      if (contains(map.open(of), side) && map.visited(map.neighbour(of, side)))
        visit(map.neighbour(of, side));
    }
  };
  for_each_known_neighbour(cell, [&](std::size_t next) {
    if (distances_[next] != UINT32_MAX && distances_[next] + 1 < distances_[cell]) {
      distances_[cell] = distances_[next] + 1;
    }
  });
  changed_.assign(1, static_cast<std::uint32_t>(cell));
  for (std::size_t i = 0; i < changed_.size() && i < kMostUpdates; ++i) {
    const std::uint32_t reached = distances_[changed_[i]] + 1;
    for_each_known_neighbour(changed_[i], [&](std::size_t next) {
      if (distances_[next] <= reached) return;
      distances_[next] = reached;
      changed_.push_back(static_cast<std::uint32_t>(next));
    });
  }
}

}  // namespace aisle
