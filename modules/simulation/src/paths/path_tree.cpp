#include "paths/path_tree.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace aisle {
namespace {

constexpr double kAmpleClearance_m = 1;
constexpr double kNarrowCost = 3;        ///< extra cost of a metre where there is no clearance at all
constexpr double kCoverSpacing_m = 0.4;  ///< between the cells of a path around which the floor is covered
constexpr std::size_t kCellsAReport = 4096;

double cost_a_metre(double clearance_m) {
  return 1 + kNarrowCost * std::max(0.0, 1 - clearance_m / kAmpleClearance_m);
}

struct Visit {
  double cost = 0;
  std::size_t cell = 0;
  bool operator>(const Visit& other) const {
    return cost != other.cost ? cost > other.cost : cell > other.cell;
  }
};

using Queue = std::priority_queue<Visit, std::vector<Visit>, std::greater<>>;

}  // namespace

PathTree::PathTree(const ClearanceGrid& grid, const DrivableArea& area, std::size_t root, Progress& progress)
    : grid_(grid),
      area_(area),
      root_(root),
      parent_(grid.size(), kNone),
      chosen_(grid.size(), false),
      nearest_path_m_(grid.size(), std::numeric_limits<float>::infinity()) {
  find_cheapest_paths(progress);
}

/// Calls with every step to one of the eight neighbours; cells at the border of a grid have no clearance, so
/// an area never reaches it.
template <class Use>
void PathTree::for_steps_from(std::size_t cell, Use use) const {
  const auto columns = static_cast<std::size_t>(grid_.columns());
  for (const std::size_t row : {cell - columns, cell, cell + columns}) {
    for (const std::size_t next : {row - 1, row, row + 1}) {
      if (next == cell || !area_.contains[next]) continue;
      const bool is_diagonal = row != cell && next != row;
      use(Step{next, (is_diagonal ? std::sqrt(2.0) : 1.0) * grid_.cell_m()});
    }
  }
}

void PathTree::find_cheapest_paths(Progress& progress) {
  std::vector<double> cost(grid_.size(), std::numeric_limits<double>::infinity());
  Queue queue;
  cost[root_] = 0;
  queue.push({0, root_});
  while (!queue.empty()) {
    const Visit visit = queue.top();
    queue.pop();
    if (visit.cost > cost[visit.cell]) continue;
    by_cost_.push_back(visit.cell);
    if (by_cost_.size() % kCellsAReport == 0)
      progress.report("planning a tour", by_cost_.size(), area_.cells);
    for_steps_from(visit.cell, [&](const Step& step) {
      const double total = visit.cost + step.length_m * cost_a_metre(grid_.clearance_m(step.cell));
      if (total >= cost[step.cell]) return;
      cost[step.cell] = total;
      parent_[step.cell] = visit.cell;
      queue.push({total, step.cell});
    });
  }
}

void PathTree::choose_paths(double reach_m, Progress& progress) {
  chosen_[root_] = true;
  cover_around({root_}, reach_m);
  std::size_t done = 0;
  for (auto target = by_cost_.rbegin(); target != by_cost_.rend(); ++target) {
    if (++done % kCellsAReport == 0) progress.report("covering the floor", done, by_cost_.size());
    if (nearest_path_m_[*target] > reach_m) choose_path_towards(*target, reach_m);
  }
}

/// The path ends when its target is well within reach: the vehicle need not stand in every corner.
void PathTree::choose_path_towards(std::size_t target, double reach_m) {
  double short_of_m = 0;
  std::size_t cell = target;
  while (short_of_m < 0.7 * reach_m && cell != root_) {
    short_of_m += (grid_.centre(cell) - grid_.centre(parent_[cell])).norm();
    cell = parent_[cell];
  }
  double since_cover_m = kCoverSpacing_m;
  std::vector<std::size_t> middles;
  for (; !chosen_[cell]; cell = parent_[cell]) {
    chosen_[cell] = true;
    if (since_cover_m >= kCoverSpacing_m) {
      middles.push_back(cell);
      since_cover_m = 0;
    }
    since_cover_m += grid_.cell_m();
  }
  cover_around(middles, reach_m);
  nearest_path_m_[target] = 0;
}

/// From all cells of a path at once, so that each cell of the floor is reached about once for a path.
void PathTree::cover_around(const std::vector<std::size_t>& cells, double reach_m) {
  Queue queue;
  for (const std::size_t cell : cells) {
    nearest_path_m_[cell] = 0;
    queue.push({0, cell});
  }
  while (!queue.empty()) {
    const Visit visit = queue.top();
    queue.pop();
    if (visit.cost > static_cast<double>(nearest_path_m_[visit.cell])) continue;
    for_steps_from(visit.cell, [&](const Step& step) {
      const auto distance_m = static_cast<float>(visit.cost + step.length_m);
      if (distance_m > reach_m || distance_m >= nearest_path_m_[step.cell]) return;
      nearest_path_m_[step.cell] = distance_m;
      queue.push({static_cast<double>(distance_m), step.cell});
    });
  }
}

std::vector<std::size_t> PathTree::branches(std::size_t cell) const {
  std::vector<std::size_t> branches;
  for_steps_from(cell, [&](const Step& step) {
    if (chosen_[step.cell] && parent_[step.cell] == cell) branches.push_back(step.cell);
  });
  return branches;
}

}  // namespace aisle
