#include "aisle/exploration/known_paths.hpp"

#include <algorithm>

namespace aisle {

void KnownPaths::begin(std::size_t cells, std::size_t from) {
  if (stamps_.size() != cells || stamp_ == UINT32_MAX) {
    stamps_.assign(cells, 0);
    entered_by_.resize(cells);
    distances_.resize(cells);
    stamp_ = 0;
  }
  stamps_[from] = ++stamp_;
  distances_[from] = 0;
  from_ = from;
  queue_.assign(1, static_cast<std::uint32_t>(from));
}

void KnownPaths::take_path(const LearnedGrid& map, std::size_t goal, std::vector<Side>& path) const {
  path.clear();
  while (goal != from_) {
    path.push_back(entered_by_[goal]);
    goal = map.neighbour(goal, opposite(entered_by_[goal]));
  }
}

}  // namespace aisle
