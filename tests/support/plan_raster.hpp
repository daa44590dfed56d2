#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "aisle/simulation/plans/floor_plan.hpp"
#include "aisle/simulation/world.hpp"

namespace aisle {

/// The cells of `frame` whose centres lie in the floor that closed walls enclose (even-odd rule). The content
/// of `frame` does not matter.
inline FloorPlan drawn_plan(std::span<const Segment2> walls, const FloorPlan& frame) {
  FloorPlan plan = frame;
  std::fill(plan.solid.begin(), plan.solid.end(), 1);
  const Pose2 T_plan_world = frame.T_world_plan.inverse();
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(plan.height));
  for (const Segment2& wall : walls) {
    const Vec2 a = (T_plan_world * wall.start) / plan.cell_m, b = (T_plan_world * wall.end) / plan.cell_m;
    const int low = static_cast<int>(std::ceil(std::min(a.y(), b.y()) - 0.5));
    const int high = static_cast<int>(std::ceil(std::max(a.y(), b.y()) - 0.5));
    for (int row = std::max(low, 0); row < std::min(high, plan.height); ++row) {
      crossings[static_cast<std::size_t>(row)].push_back(a.x() + (row + 0.5 - a.y()) / (b.y() - a.y()) *
                                                                     (b.x() - a.x()));
    }
  }
  for (int row = 0; row < plan.height; ++row) {
    std::vector<double>& xs = crossings[static_cast<std::size_t>(row)];
    std::sort(xs.begin(), xs.end());
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
      const int first = std::max(0, static_cast<int>(std::ceil(xs[i] - 0.5)));
      const int last = std::min(plan.width, static_cast<int>(std::ceil(xs[i + 1] - 0.5)));
      for (int column = first; column < last; ++column) plan.solid[plan.index(column, row)] = 0;
    }
  }
  return plan;
}

/// Whether a cell has neighbours of both kinds, or of the other kind, within so many cells.
inline bool is_near_border(const FloorPlan& plan, int x, int y, int cells) {
  const bool solid = plan.is_solid(x, y);
  for (int v = y - cells; v <= y + cells; ++v) {
    for (int u = x - cells; u <= x + cells; ++u) {
      if (plan.is_solid(u, v) != solid) return true;
    }
  }
  return false;
}

/// How well walls reproduce the plan from which they were traced.
struct Agreement {
  double all = 1;                ///< share of all cells
  double away_from_borders = 1;  ///< share of the cells at least two cells from a border
};

inline Agreement agreement(const FloorPlan& plan, std::span<const Segment2> walls) {
  const FloorPlan drawn = drawn_plan(walls, plan);
  double cells = 0, equal = 0, inner = 0, inner_equal = 0;
  for (int y = 0; y < plan.height; ++y) {
    for (int x = 0; x < plan.width; ++x) {
      const bool same = plan.is_solid(x, y) == drawn.is_solid(x, y);
      ++cells;
      equal += same;
      if (is_near_border(plan, x, y, 1)) continue;
      ++inner;
      inner_equal += same;
    }
  }
  return {equal / cells, inner > 0 ? inner_equal / inner : 1};
}

inline std::vector<Segment2> wall_floor_edges(const World& world) {
  std::vector<Segment2> floor_edges;
  for (const WallFace& wall : world.walls) floor_edges.push_back(wall.floor_edge);
  return floor_edges;
}

}  // namespace aisle
