#include "paths/drivable_area.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "aisle/simulation/wall_grid.hpp"

namespace aisle {
namespace {

/// Connected areas with enough clearance, labelled from 1.
class ClearAreas {
 public:
  ClearAreas(const ClearanceGrid& grid, std::vector<Segment2> walls, double clearance_min_m)
      : grid_(grid), walls_(std::move(walls)), clearance_min_m_(clearance_min_m) {
    cv::Mat wide(grid.rows(), grid.columns(), CV_8U);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      wide.data[cell] = grid.clearance_m(cell) >= clearance_min_m;
    }
    const auto count = static_cast<std::size_t>(cv::connectedComponents(wide, labels_, 4, CV_32S));
    cells_.assign(count, 0);
    votes_m_.assign(count, 0);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) ++cells_[label(cell)];
  }

  std::size_t label(std::size_t cell) const {
    return static_cast<std::size_t>(reinterpret_cast<const int*>(labels_.data)[cell]);
  }
  std::size_t count() const { return cells_.size(); }
  std::size_t cells(std::size_t label) const { return cells_[label]; }

  /// A wall votes with its length for the area on its left and against that on its right.
  void count_votes_of(const Segment2& wall) {
    const Vec2 left = left_normal(wall.end - wall.start).normalized();
    for (const double sign : {1.0, -1.0}) {
      if (const auto area = area_beside(wall.midpoint(), sign * left))
        votes_m_[*area] += sign * wall.length();
    }
  }

  /// On the free side of most of its walls.
  bool is_inside(std::size_t area) const { return votes_m_[area] > 0; }

  std::size_t best() const {
    std::size_t best = 0;
    const auto rank = [&](std::size_t area) { return std::pair(votes_m_[area] > 0, cells_[area]); };
    for (std::size_t area = 1; area < count(); ++area) {
      if (best == 0 || rank(area) > rank(best)) best = area;
    }
    return best;
  }

 private:
  /// The area next to a wall, up to the next wall.
  std::optional<std::size_t> area_beside(const Vec2& p, const Vec2& direction) const {
    const double room_m = walls_.cast(p + kOffWall_m * direction, direction);
    for (int step = 0; step < 6 && clearance_min_m_ + step * grid_.cell_m() < room_m; ++step) {
      const Vec2 beside = p + (clearance_min_m_ + step * grid_.cell_m()) * direction;
      if (!grid_.contains(beside)) return std::nullopt;
      if (const std::size_t area = label(grid_.cell_at(beside)); area > 0) return area;
    }
    return std::nullopt;
  }

  const ClearanceGrid& grid_;
  WallGrid walls_;
  double clearance_min_m_;
  cv::Mat labels_;
  std::vector<std::size_t> cells_;
  std::vector<double> votes_m_;
};

void count_shut_off(const ClearAreas& areas, std::size_t chosen, const ClearanceGrid& grid,
                    DrivableArea& area) {
  std::size_t largest = 0;
  for (std::size_t other = 1; other < areas.count(); ++other) {
    if (other == chosen || !areas.is_inside(other)) continue;
    area.shut_off_cells += areas.cells(other);
    if (largest == 0 || areas.cells(other) > areas.cells(largest)) largest = other;
  }
  if (largest == 0) return;
  area.largest_shut_off_cells = areas.cells(largest);
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (areas.label(cell) != largest) continue;
    if (!area.shut_off_cell || grid.clearance_m(cell) > grid.clearance_m(*area.shut_off_cell))
      area.shut_off_cell = cell;
  }
}

}  // namespace

DrivableArea drivable_area(const World& world, const ClearanceGrid& grid, double clearance_min_m) {
  std::vector<Segment2> walls;
  for (const WallFace& wall : world.walls) walls.push_back(wall.floor_edge);
  ClearAreas areas(grid, walls, clearance_min_m);
  for (const Segment2& wall : walls) areas.count_votes_of(wall);
  std::size_t chosen = areas.best();
  if (world.start && grid.contains(world.start->position())) {
    const std::size_t at_start = areas.label(grid.cell_at(world.start->position()));
    if (at_start > 0) chosen = at_start;
  }
  DrivableArea area{std::vector<bool>(grid.size(), false), 0};
  if (chosen == 0) return area;
  area.cells = areas.cells(chosen);
  for (std::size_t cell = 0; cell < grid.size(); ++cell) area.contains[cell] = areas.label(cell) == chosen;
  count_shut_off(areas, chosen, grid, area);
  return area;
}

}  // namespace aisle
