#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "aisle/geometry/segment2.hpp"

namespace aisle {

/// Spatial index: a grid of square cells, each with the ids of what touches it.
/// Adding and querying cost O(cells touched), whatever the size of the building.
class CellIndex {
 public:
  explicit CellIndex(double cell_m = 3) : cell_m_(cell_m) {}

  /// Adds the id to every cell that the segment passes through. Adding it again to the same cells changes
  /// nothing.
  void add(const Segment2& segment, int id);

  /// Replaces `ids` by all in cells that touch the box of the two corners widened by `margin_m`; sorted, each
  /// once. A superset of what lies in the box.
  void query(const Vec2& corner, const Vec2& opposite, double margin_m, std::vector<int>& ids) const;

  void clear() { cells_.clear(); }

 private:
  template <class Visit>
  void for_each_cell(const Vec2& low, const Vec2& high, Visit visit) const;

  double cell_m_;
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
};

}  // namespace aisle
