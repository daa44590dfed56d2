#include "aisle/exploration/walk_bound.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace aisle {
namespace {

/// Finds the blocks (biconnected components) by depth-first search and adds up their costs. J. Hopcroft, R.
/// Tarjan, "Algorithm 447: efficient algorithms for graph manipulation", CACM 16(6), 1973.
class BlockWalk {
 public:
  explicit BlockWalk(const GridWorld& world)
      : world_(world), depth_(world.size(), 0), low_(world.size(), 0) {}

  std::size_t moves(std::size_t start) {
    enter(start);
    while (!path_.empty()) {
      Visit& visit = path_.back();
      if (visit.next_side == 4) {
        leave();
        continue;
      }
      const Side side = kAllSides[visit.next_side++];
      if (!contains(world_.open(visit.cell), side)) continue;
      const std::size_t beyond = world_.neighbour(visit.cell, side);
      if (depth_[beyond] == 0) {
        enter(beyond);
      } else {
        low_[visit.cell] = std::min(low_[visit.cell], depth_[beyond]);
      }
    }
    return moves_;
  }

 private:
  struct Visit {
    std::uint32_t cell;
    std::uint8_t next_side;
  };

  void enter(std::size_t cell) {
    path_.push_back({static_cast<std::uint32_t>(cell), 0});
    depth_[cell] = low_[cell] = static_cast<std::uint32_t>(path_.size());
    block_.push_back(static_cast<std::uint32_t>(cell));
  }

  void leave() {
    const std::uint32_t child = path_.back().cell;
    path_.pop_back();
    if (path_.empty()) return;
    const std::uint32_t parent = path_.back().cell;
    low_[parent] = std::min(low_[parent], low_[child]);
    if (low_[child] >= depth_[parent]) close_block(parent, child);
  }

  /// `parent` and everything entered since `child` are one block.
  void close_block(std::size_t parent, std::size_t child) {
    std::array<std::size_t, 2> of_color{};
    ++of_color[color(parent)];
    std::uint32_t cell = 0;
    do {
      cell = block_.back();
      block_.pop_back();
      ++of_color[color(cell)];
    } while (cell != child);
    moves_ += 2 * std::max(of_color[0], of_color[1]);
  }

  std::size_t color(std::size_t index) const {
    const Cell cell = world_.cell(index);
    return static_cast<std::size_t>(cell.x + cell.y) % 2;
  }

  const GridWorld& world_;
  std::vector<std::uint32_t> depth_;  ///< 1 for the start; 0: not entered yet
  std::vector<std::uint32_t> low_;
  std::vector<Visit> path_;
  std::vector<std::uint32_t> block_;
  std::size_t moves_ = 0;
};

}  // namespace

std::size_t walk_lower_bound(const GridWorld& world, Cell start) {
  return BlockWalk(world).moves(world.index(start));
}

/// Breadth-first search over (cells visited so far, current cell).
std::optional<std::size_t> shortest_walk(const GridWorld& world, Cell start) {
  const std::vector<bool> reachable = reachable_cells(world, start);
  const auto count = static_cast<std::size_t>(std::count(reachable.begin(), reachable.end(), true));
  if (count > kMaxExactCells) return std::nullopt;
  std::vector<std::uint32_t> number(world.size(), 0);
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < world.size(); ++cell) {
    if (!reachable[cell]) continue;
    number[cell] = static_cast<std::uint32_t>(cells.size());
    cells.push_back(cell);
  }
  const auto state_of = [&](std::uint32_t visited, std::size_t cell) {
    return (visited | 1U << number[cell]) * kMaxExactCells + number[cell];
  };
  const std::size_t home = world.index(start);
  const std::size_t goal = state_of((1U << count) - 1, home);
  std::vector<bool> seen((std::size_t{1} << count) * kMaxExactCells, false);
  std::vector<std::size_t> front{state_of(0, home)};
  seen[front.front()] = true;
  for (std::size_t moves = 0;; ++moves) {
    std::vector<std::size_t> next_front;
    for (const std::size_t state : front) {
      if (state == goal) return moves;
      const std::size_t cell = cells[state % kMaxExactCells];
      for (const Side side : kAllSides) {
        if (!contains(world.open(cell), side)) continue;
        const auto visited = static_cast<std::uint32_t>(state / kMaxExactCells);
        const std::size_t next = state_of(visited, world.neighbour(cell, side));
        if (seen[next]) continue;
        seen[next] = true;
        next_front.push_back(next);
      }
    }
    front = std::move(next_front);
  }
}

}  // namespace aisle
