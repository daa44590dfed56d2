#pragma once

#include <cstddef>
#include <vector>

#include "aisle/maps/floor_grid.hpp"

namespace aisle {

/// Distance from each cell of a floor to the nearest one not known to be free, over all known cells and a
/// border of one cell.
class ClearFloor {
 public:
  explicit ClearFloor(const FloorGrid& floor);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double cell_m() const { return cell_m_; }
  std::size_t size() const { return clearance_m_.size(); }

  /// From the cell's centre to the edge of the nearest cell that is not free [m]; 0 for such a cell itself.
  double clearance_m(std::size_t cell) const { return clearance_m_[cell]; }
  Vec2 centre(std::size_t cell) const;
  std::size_t cell_at(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  int column_of(std::size_t cell) const {
    return static_cast<int>(cell % static_cast<std::size_t>(columns_));
  }
  int row_of(std::size_t cell) const { return static_cast<int>(cell / static_cast<std::size_t>(columns_)); }

  /// The cells with at least this clearance that are connected to the one nearest to a point; none if that
  /// one is more than a metre away.
  std::vector<bool> reached_from(const Vec2& p_map, double clearance_min_m) const;

 private:
  FloorBox box_;
  int columns_;
  int rows_;
  double cell_m_;
  std::vector<float> clearance_m_;
};

}  // namespace aisle
