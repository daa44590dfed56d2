#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// How far off a wall's face rays away from it start.
inline constexpr double kOffWall_m = 0.01;

/// Distance along a ray to one wall [m]; infinity: the ray misses it. A ray along the wall misses.
/// @param direction  of length 1
double ray_distance(const Vec2& origin, const Vec2& direction, const Segment2& wall);

/// Walls sorted into the cells of a uniform grid, so that a ray is tested only against the walls near it: its
/// cost depends on its length, not on the size of the building.
class WallGrid {
 public:
  explicit WallGrid(std::vector<Segment2> walls);

  /// Distance from `origin` along `direction` (of length 1) to the first wall [m]; infinity if there is none.
  double cast(const Vec2& origin, const Vec2& direction) const;

 private:
  struct Cell {
    int column = 0;
    int row = 0;
  };

  bool is_inside(Cell cell) const {
    return cell.column >= 0 && cell.column < columns_ && cell.row >= 0 && cell.row < rows_;
  }
  std::size_t index(Cell cell) const {
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cell.column);
  }
  Cell cell_at(const Vec2& p) const;
  void size_grid();
  std::vector<std::size_t> cells_touched(const Segment2& wall) const;
  std::span<const std::uint32_t> walls_in(Cell cell) const;
  Interval part_inside(const Vec2& origin, const Vec2& direction) const;

  std::vector<Segment2> walls_;
  Vec2 corner_ = Vec2::Zero();  ///< lower left corner of cell (0, 0)
  double cell_m_ = 1;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<std::uint32_t> first_;  ///< the walls of cell i are wall_of_[first_[i] .. first_[i + 1])
  std::vector<std::uint32_t> wall_of_;
};

}  // namespace aisle
