#include "aisle/simulation/paths/round_trip.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/square.hpp"
#include "aisle/simulation/cross_section.hpp"
#include "aisle/simulation/paths/clearance_grid.hpp"
#include "paths/drivable_area.hpp"
#include "paths/path_tree.hpp"

namespace aisle {
namespace {

constexpr double kCell_m = 0.05;
constexpr double kWobble_m = 0.12;  ///< by which a path of cells may be straightened
constexpr double kComfortableClearance_m = 0.6;

/// The cell where the tour begins: the world's start, or one near the middle of the area with clearance.
std::size_t root_of(const World& world, const ClearanceGrid& grid, const DrivableArea& area) {
  if (world.start && grid.contains(world.start->position())) {
    const std::size_t cell = grid.cell_at(world.start->position());
    if (area.contains[cell]) return cell;
  }
  Vec2 sum = Vec2::Zero();
  double clearance_max_m = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (!area.contains[cell]) continue;
    sum += grid.centre(cell);
    clearance_max_m = std::max(clearance_max_m, grid.clearance_m(cell));
  }
  const Vec2 middle = sum / static_cast<double>(area.cells);
  const double clearance_min_m = std::min(clearance_max_m, kComfortableClearance_m);
  std::size_t best = PathTree::kNone;
  double best_m = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (!area.contains[cell] || grid.clearance_m(cell) < clearance_min_m) continue;
    const double distance_m = (grid.centre(cell) - middle).norm();
    if (best == PathTree::kNone || distance_m < best_m) {
      best = cell;
      best_m = distance_m;
    }
  }
  return best;
}

/// Turns paths of cells into straight legs.
class Straightener {
 public:
  Straightener(const ClearanceGrid& grid, double clearance_min_m)
      : grid_(grid), clearance_min_m_(clearance_min_m) {}

  /// Adds the points after the first one of a path.
  void add_legs(const std::vector<std::size_t>& path, std::vector<Vec2>& points) const {
    add_legs(path, 0, path.size() - 1, points);
  }

 private:
  void add_legs(const std::vector<std::size_t>& path, std::size_t first, std::size_t last,
                std::vector<Vec2>& points) const {
    if (last == first) return;
    const Vec2 start = grid_.centre(path[first]), end = grid_.centre(path[last]);
    const auto [farthest, off_m] = farthest_from(path, first, last);
    if (last == first + 1 ||
        (off_m <= kWobble_m && is_clear(start, end, clearance_kept_m(path, first, last)))) {
      points.push_back(end);
      return;
    }
    add_legs(path, first, farthest, points);
    add_legs(path, farthest, last, points);
  }

  /// The cell between the two that is farthest from the straight line; the middle one if all lie on it.
  std::pair<std::size_t, double> farthest_from(const std::vector<std::size_t>& path, std::size_t first,
                                               std::size_t last) const {
    const Vec2 start = grid_.centre(path[first]);
    const Vec2 normal = left_normal(grid_.centre(path[last]) - start).normalized();
    std::size_t farthest = (first + last) / 2;
    double off_m = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = std::abs(normal.dot(grid_.centre(path[i]) - start));
      if (off > off_m + 1e-9) {
        farthest = i;
        off_m = off;
      }
    }
    return {farthest, off_m};
  }

  /// The clearance that a straight leg must keep: the path's least, or a comfortable one if that is less.
  double clearance_kept_m(const std::vector<std::size_t>& path, std::size_t first, std::size_t last) const {
    double narrowest_m = kComfortableClearance_m;
    for (std::size_t i = first; i <= last; ++i)
      narrowest_m = std::min(narrowest_m, grid_.clearance_m(path[i]));
    return std::max(clearance_min_m_, narrowest_m - grid_.cell_m());
  }

  bool is_clear(const Vec2& start, const Vec2& end, double kept_m) const {
    const int steps = static_cast<int>((end - start).norm() / (grid_.cell_m() / 2)) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Vec2 p = start + (end - start) * i / steps;
      if (grid_.clearance_m(p) < kept_m) return false;
    }
    return true;
  }

  const ClearanceGrid& grid_;
  double clearance_min_m_;
};

/// Walks out along every branch of a tree and back.
class TreeWalk {
 public:
  TreeWalk(const PathTree& tree, const Straightener& straightener)
      : tree_(tree), straightener_(straightener) {}

  std::vector<Vec2> walk(const Vec2& start) {
    points_ = {start};
    struct Visit {
      std::vector<std::size_t> branches;  ///< not yet walked
      std::vector<Vec2> back;             ///< the points that lead to where the branch began
    };
    std::vector<Visit> open = {{tree_.branches(tree_.root()), {}}};
    std::vector<std::size_t> at = {tree_.root()};
    while (!open.empty()) {
      if (open.back().branches.empty()) {
        points_.insert(points_.end(), open.back().back.begin(), open.back().back.end());
        open.pop_back();
        at.pop_back();
        continue;
      }
      const std::size_t branch = open.back().branches.back();
      open.back().branches.pop_back();
      std::vector<std::size_t> path = {at.back(), branch};
      std::vector<std::size_t> next = tree_.branches(branch);
      while (next.size() == 1) {
        path.push_back(next.front());
        next = tree_.branches(path.back());
      }
      std::vector<Vec2> out = {points_.back()};
      straightener_.add_legs(path, out);
      points_.insert(points_.end(), out.begin() + 1, out.end());
      open.push_back({next, {out.rbegin() + 1, out.rend()}});
      at.push_back(path.back());
    }
    return points_;
  }

 private:
  const PathTree& tree_;
  const Straightener& straightener_;
  std::vector<Vec2> points_;
};

/// Without the points at which a vehicle goes straight on.
std::vector<Vec2> without_straight_points(const std::vector<Vec2>& points) {
  std::vector<Vec2> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && i + 1 < points.size()) {
      const Vec2 in = (points[i] - kept.back()).normalized(), out = (points[i + 1] - points[i]).normalized();
      if (in.dot(out) > 1 - 1e-9) continue;
    }
    kept.push_back(points[i]);
  }
  return kept;
}

}  // namespace

std::optional<RoundTrip> plan_round_trip(const World& world, const RoundTripParams& params,
                                         Progress& progress) {
  const std::vector<Segment2> obstacles = obstacles_below(world, params.height_m);
  if (obstacles.empty()) return std::nullopt;
  const double clearance_min_m = params.vehicle_width_m / 2 + params.margin_m;
  const ClearanceGrid grid(obstacles, kCell_m);
  const DrivableArea area = drivable_area(world, grid, clearance_min_m);
  if (area.cells == 0) return std::nullopt;

  PathTree tree(grid, area, root_of(world, grid, area), progress);
  tree.choose_paths(params.reach_m, progress);
  const Straightener straightener(grid, clearance_min_m);
  RoundTrip run;
  run.drivable_m2 = static_cast<double>(area.cells) * square(grid.cell_m());
  if (area.shut_off_cell) {
    const auto all_cells = static_cast<double>(area.cells + area.shut_off_cells);
    run.shut_off = {static_cast<double>(area.shut_off_cells) / all_cells,
                    static_cast<double>(area.largest_shut_off_cells) * square(grid.cell_m()),
                    grid.centre(*area.shut_off_cell)};
  }
  run.tour = without_straight_points(TreeWalk(tree, straightener).walk(grid.centre(tree.root())));
  run.T_world_start = {run.tour[0].x(), run.tour[0].y(), 0};
  if (run.tour.size() > 1) run.T_world_start.theta = Segment2{run.tour[0], run.tour[1]}.heading();
  return run;
}

}  // namespace aisle
