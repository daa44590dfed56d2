#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// The floor that the centre of a round vehicle can reach from its start, on a grid of 5 cm, coarser in
/// buildings of more than four million such cells.
class FreeFloor {
 public:
  /// @param obstacles  to keep at least `radius_m` away from
  FreeFloor(std::span<const Segment2> obstacles, const Vec2& start, double radius_m);

  /// Whether a vehicle can get from the start to a point, give or take a cell.
  bool reaches(const Vec2& p) const;
  /// The reachable floor between the obstacles' edges [m^2]; infinity: it leads out of the building.
  double area_m2() const;

 private:
  enum class Cell : std::uint8_t { kFree, kBlocked, kReached };

  bool is_inside(long column, long row) const {
    return column >= 0 && column < columns_ && row >= 0 && row < rows_;
  }
  Cell& cell(long column, long row) { return cells_[static_cast<std::size_t>(row * columns_ + column)]; }
  long column_of(const Vec2& p) const;
  long row_of(const Vec2& p) const;
  void block_around(std::span<const Segment2> obstacles, double radius_m);
  void flood(const Vec2& start);

  Vec2 corner_ = Vec2::Zero();  ///< lower left corner of cell (0, 0)
  double cell_m_ = 0.05;
  long columns_ = 0;
  long rows_ = 0;
  bool leads_outside_ = false;
  std::vector<Cell> cells_;
};

/// The least distance of a path, straight from point to point, to obstacles [m]; infinity: there are none.
double clearance_m(std::span<const Vec2> path, std::span<const Segment2> obstacles);

}  // namespace aisle
