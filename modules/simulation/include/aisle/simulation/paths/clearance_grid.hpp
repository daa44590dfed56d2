#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// Distance to the nearest obstacle or to the grid's border, in square cells over the area that the obstacles
/// span.
class ClearanceGrid {
 public:
  /// @param obstacles  at least one
  /// @param cell_m     made larger if the grid would have more than 8 million cells
  ClearanceGrid(std::span<const Segment2> obstacles, double cell_m);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t size() const { return clearance_m_.size(); }
  double cell_m() const { return cell_m_; }

  /// From the middle of a cell to the nearest obstacle or border cell [m], never overestimated,
  /// underestimated by at most 1.5 cells.
  double clearance_m(std::size_t cell) const { return clearance_m_[cell]; }
  /// The same at any point; 0 outside the grid.
  double clearance_m(const Vec2& p) const;

  bool contains(const Vec2& p) const;
  std::size_t cell_at(const Vec2& p) const;  ///< `p` must be inside
  Vec2 centre(std::size_t cell) const;

 private:
  Vec2 corner_ = Vec2::Zero();
  double cell_m_;
  int columns_ = 1;
  int rows_ = 1;
  std::vector<float> clearance_m_;
};

}  // namespace aisle
