#include "aisle/simulation/paths/free_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "aisle/geometry/box2.hpp"

namespace aisle {
namespace {

constexpr double kFloorCellsMax = 4e6;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool do_cross(const Segment2& a, const Segment2& b) {
  const auto side = [](const Segment2& line, const Vec2& p) {
    return (line.end - line.start).dot(left_normal(p - line.start));
  };
  return side(a, b.start) * side(a, b.end) < 0 && side(b, a.start) * side(b, a.end) < 0;
}

double distance_m(const Segment2& a, const Segment2& b) {
  if (do_cross(a, b)) return 0;
  return std::min({a.distance(b.start), a.distance(b.end), b.distance(a.start), b.distance(a.end)});
}

}  // namespace

FreeFloor::FreeFloor(std::span<const Segment2> obstacles, const Vec2& start, double radius_m) {
  const Box2 box = box_around(obstacles).extend(start);
  const Vec2 margin = Vec2::Constant(radius_m + cell_m_);
  corner_ = box.min() - margin;
  const Vec2 size_m = box.max() + margin - corner_;
  cell_m_ = std::max(cell_m_, std::sqrt(size_m.x() * size_m.y() / kFloorCellsMax));
  columns_ = static_cast<long>(std::ceil(size_m.x() / cell_m_));
  rows_ = static_cast<long>(std::ceil(size_m.y() / cell_m_));
  cells_.resize(static_cast<std::size_t>(columns_ * rows_), Cell::kFree);
  block_around(obstacles, radius_m);
  flood(start);
}

long FreeFloor::column_of(const Vec2& p) const {
  return static_cast<long>(std::floor((p.x() - corner_.x()) / cell_m_));
}

long FreeFloor::row_of(const Vec2& p) const {
  return static_cast<long>(std::floor((p.y() - corner_.y()) / cell_m_));
}

/// Cells whose centre is nearer than the radius to a point of an obstacle, points half a cell apart.
void FreeFloor::block_around(std::span<const Segment2> obstacles, double radius_m) {
  const long reach = static_cast<long>(std::ceil(radius_m / cell_m_));
  const auto block_disc = [&](const Vec2& p) {
    const long column = column_of(p), row = row_of(p);
    for (long r = row - reach; r <= row + reach; ++r) {
      for (long c = column - reach; c <= column + reach; ++c) {
        const Vec2 centre =
            corner_ + cell_m_ * Vec2(static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5);
        if (is_inside(c, r) && (centre - p).norm() < radius_m) cell(c, r) = Cell::kBlocked;
      }
    }
    if (is_inside(column, row)) cell(column, row) = Cell::kBlocked;
  };
  for (const Segment2& s : obstacles) {
    const auto steps = std::max(1L, static_cast<long>(std::ceil(2 * s.length() / cell_m_)));
    for (long i = 0; i <= steps; ++i) {
      block_disc(s.start + static_cast<double>(i) / static_cast<double>(steps) * (s.end - s.start));
    }
  }
}

void FreeFloor::flood(const Vec2& start) {
  std::vector<std::pair<long, long>> open = {{column_of(start), row_of(start)}};
  while (!open.empty()) {
    const auto [column, row] = open.back();
    open.pop_back();
    if (!is_inside(column, row)) {
      leads_outside_ = true;
      continue;
    }
    if (cell(column, row) != Cell::kFree) continue;
    cell(column, row) = Cell::kReached;
    open.insert(open.end(), {{column + 1, row}, {column - 1, row}, {column, row + 1}, {column, row - 1}});
  }
}

bool FreeFloor::reaches(const Vec2& p) const {
  const long column = column_of(p), row = row_of(p);
  for (long r = row - 1; r <= row + 1; ++r) {
    for (long c = column - 1; c <= column + 1; ++c) {
      if (is_inside(c, r) && cells_[static_cast<std::size_t>(r * columns_ + c)] == Cell::kReached)
        return true;
    }
  }
  return false;
}

double FreeFloor::area_m2() const {
  if (leads_outside_) return kInfinity;
  return cell_m_ * cell_m_ * static_cast<double>(std::count(cells_.begin(), cells_.end(), Cell::kReached));
}

double clearance_m(std::span<const Vec2> path, std::span<const Segment2> obstacles) {
  double least_m = kInfinity;
  for (std::size_t i = 1; i < path.size(); ++i) {
    for (const Segment2& obstacle : obstacles) {
      least_m = std::min(least_m, distance_m({path[i - 1], path[i]}, obstacle));
    }
  }
  return least_m;
}

}  // namespace aisle
