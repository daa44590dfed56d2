#include "aisle/simulation/wall_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "aisle/geometry/box2.hpp"

namespace aisle {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kCellSlack_m =
    1e-6;  ///< walls also count for cells that they miss by this much: rounding drops none
constexpr double kSeam_m = 1e-9;  ///< two walls that share an end leave no gap between them
constexpr double kCellMin_m = 0.5;
constexpr int kSideMax = 1024;  ///< cells along the longer side of the grid

}  // namespace

double ray_distance(const Vec2& origin, const Vec2& direction, const Segment2& wall) {
  const Vec2 along = wall.end - wall.start;
  const Vec2 to_start = wall.start - origin;
  const Vec2 normal = left_normal(direction);
  const double slope = normal.dot(along);
  const double length_m = along.norm();
  if (std::abs(slope) <= 1e-12 * length_m) return kNever;
  const double share = -normal.dot(to_start) / slope;
  if (share * length_m < -kSeam_m || (share - 1) * length_m > kSeam_m) return kNever;
  const double distance_m = direction.dot(to_start + share * along);
  return distance_m >= 0 ? distance_m : kNever;
}

WallGrid::WallGrid(std::vector<Segment2> walls) : walls_(std::move(walls)) {
  size_grid();
  std::vector<std::pair<std::size_t, std::uint32_t>> cell_and_wall;
  for (std::uint32_t wall = 0; wall < walls_.size(); ++wall) {
    for (const std::size_t cell : cells_touched(walls_[wall])) cell_and_wall.emplace_back(cell, wall);
  }
  std::sort(cell_and_wall.begin(), cell_and_wall.end());
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const auto& [cell, wall] : cell_and_wall) {
    ++first_[cell + 1];
    wall_of_.push_back(wall);
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

void WallGrid::size_grid() {
  if (walls_.empty()) return;
  const Box2 box = box_around(walls_);
  const Vec2 size = box.sizes() + Vec2::Constant(2 * kCellSlack_m);
  cell_m_ = std::max(kCellMin_m, size.maxCoeff() / kSideMax);
  corner_ = box.min() - Vec2::Constant(kCellSlack_m);
  columns_ = static_cast<int>(size.x() / cell_m_) + 1;
  rows_ = static_cast<int>(size.y() / cell_m_) + 1;
}

WallGrid::Cell WallGrid::cell_at(const Vec2& p) const {
  const Vec2 q = (p - corner_) / cell_m_;
  return {std::clamp(static_cast<int>(std::floor(q.x())), 0, columns_ - 1),
          std::clamp(static_cast<int>(std::floor(q.y())), 0, rows_ - 1)};
}

std::vector<std::size_t> WallGrid::cells_touched(const Segment2& wall) const {
  const Vec2 slack = Vec2::Constant(kCellSlack_m);
  const Vec2 left = wall.start.x() <= wall.end.x() ? wall.start : wall.end;
  const Vec2 right = wall.start.x() <= wall.end.x() ? wall.end : wall.start;
  const double width_m = right.x() - left.x();
  const auto height_at = [&](double x) {
    const double share = width_m > 0 ? std::clamp((x - left.x()) / width_m, 0.0, 1.0) : 0;
    return left.y() + share * (right.y() - left.y());
  };
  std::vector<std::size_t> touched;
  for (int column = cell_at(left - slack).column; column <= cell_at(right + slack).column; ++column) {
    const double x_min = corner_.x() + column * cell_m_ - kCellSlack_m;
    const bool is_vertical = width_m <= 2 * kCellSlack_m;
    const double y_in = is_vertical ? left.y() : height_at(x_min);
    const double y_out = is_vertical ? right.y() : height_at(x_min + cell_m_ + 2 * kCellSlack_m);
    const int row_min = cell_at({x_min, std::min(y_in, y_out) - kCellSlack_m}).row;
    const int row_max = cell_at({x_min, std::max(y_in, y_out) + kCellSlack_m}).row;
    for (int row = row_min; row <= row_max; ++row) touched.push_back(index({column, row}));
  }
  return touched;
}

std::span<const std::uint32_t> WallGrid::walls_in(Cell cell) const {
  const std::size_t i = index(cell);
  return {wall_of_.data() + first_[i], first_[i + 1] - first_[i]};
}

/// Where along the ray the grid begins and ends; max < min: the ray misses the grid.
Interval WallGrid::part_inside(const Vec2& origin, const Vec2& direction) const {
  const Vec2 high = corner_ + cell_m_ * Vec2(columns_, rows_);
  Interval part{0, kNever};
  for (int axis = 0; axis < 2; ++axis) {
    if (direction[axis] == 0) {
      if (origin[axis] < corner_[axis] || origin[axis] > high[axis]) return {0, -1};
      continue;
    }
    const double a = (corner_[axis] - origin[axis]) / direction[axis];
    const double b = (high[axis] - origin[axis]) / direction[axis];
    part.min = std::max(part.min, std::min(a, b));
    part.max = std::min(part.max, std::max(a, b));
  }
  return part;
}

double WallGrid::cast(const Vec2& origin, const Vec2& direction) const {
  const Interval part = part_inside(origin, direction);
  if (walls_.empty() || part.max < part.min) return kNever;

  Cell cell = cell_at(origin + part.min * direction);
  const std::array<int, 2> step = {direction.x() < 0 ? -1 : 1, direction.y() < 0 ? -1 : 1};
  const auto leaving_at = [&](int axis) {
    if (direction[axis] == 0) return kNever;
    const int border =
        (axis == 0 ? cell.column : cell.row) + (step[static_cast<std::size_t>(axis)] > 0 ? 1 : 0);
    return (corner_[axis] + border * cell_m_ - origin[axis]) / direction[axis];
  };

  double nearest_m = kNever;
  while (is_inside(cell)) {
    for (const std::uint32_t wall : walls_in(cell)) {
      nearest_m = std::min(nearest_m, ray_distance(origin, direction, walls_[wall]));
    }
    const double leaving_x_m = leaving_at(0), leaving_y_m = leaving_at(1);
    if (nearest_m <= std::min(leaving_x_m, leaving_y_m)) break;
    if (leaving_x_m < leaving_y_m) {
      cell.column += step[0];
    } else {
      cell.row += step[1];
    }
  }
  return nearest_m;
}

}  // namespace aisle
