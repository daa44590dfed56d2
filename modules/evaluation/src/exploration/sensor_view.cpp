#include "aisle/evaluation/exploration/sensor_view.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/geometry/box2.hpp"

namespace aisle {
namespace {

constexpr double kViewCellsMax = 16e6;
constexpr double kRayStep_rad = 1 * kDegree;
constexpr double kMarksPerCell = 2;  ///< along a ray

}  // namespace

SensorView::SensorView(std::span<const Segment2> walls)
    : grid_(std::vector<Segment2>(walls.begin(), walls.end())) {
  const Box2 box = box_around(walls);
  const Vec2 size_m = box.sizes();
  cell_m_ = std::max(cell_m_, std::sqrt(size_m.x() * size_m.y() / kViewCellsMax));
  corner_ = box.min() - Vec2::Constant(2 * cell_m_);
  columns_ = static_cast<long>(std::ceil(size_m.x() / cell_m_)) + 4;
  rows_ = static_cast<long>(std::ceil(size_m.y() / cell_m_)) + 4;
  marks_.resize(static_cast<std::size_t>(columns_ * rows_));
}

void SensorView::look(const Pose2& T_world_sensor, double reach_m, double width_rad) {
  const Vec2 origin = T_world_sensor.position();
  const int rays = std::max(1, static_cast<int>(std::lround(width_rad / kRayStep_rad)));
  for (int i = 0; i <= rays; ++i) {
    const Vec2 direction = unit(T_world_sensor.theta + width_rad * (static_cast<double>(i) / rays - 0.5));
    const double wall_m = grid_.cast(origin, direction);
    const double free_m = std::min(reach_m, wall_m);
    const int marks = static_cast<int>(std::ceil(free_m * kMarksPerCell / cell_m_));
    for (int k = 0; k < marks; ++k) mark(origin + k * cell_m_ / kMarksPerCell * direction, kPassed);
    if (wall_m <= reach_m) mark(origin + wall_m * direction, kHit);
  }
}

void SensorView::mark(const Vec2& p_world, std::uint8_t mark) {
  const Vec2 at = (p_world - corner_) / cell_m_;
  const auto column = static_cast<long>(std::floor(at.x())), row = static_cast<long>(std::floor(at.y()));
  if (contains(column, row)) marks_[static_cast<std::size_t>(row * columns_ + column)] |= mark;
}

Vec2 SensorView::centre(std::size_t cell) const {
  const auto columns = static_cast<std::size_t>(columns_);
  const std::size_t column = cell % columns, row = cell / columns;
  return corner_ + cell_m_ * Vec2(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
}

bool SensorView::has_nearby(std::size_t cell, std::uint8_t mark) const {
  const auto column = static_cast<long>(cell) % columns_, row = static_cast<long>(cell) / columns_;
  for (long r = row - 1; r <= row + 1; ++r) {
    for (long c = column - 1; c <= column + 1; ++c) {
      if (contains(c, r) && (marks_[static_cast<std::size_t>(r * columns_ + c)] & mark) != 0) return true;
    }
  }
  return false;
}

bool SensorView::is_hit(const Vec2& p_world) const {
  const Vec2 at = (p_world - corner_) / cell_m_;
  const auto column = static_cast<long>(std::floor(at.x())), row = static_cast<long>(std::floor(at.y()));
  return contains(column, row) && has_nearby(static_cast<std::size_t>(row * columns_ + column), kHit);
}

}  // namespace aisle
