#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "aisle/maps/barrier.hpp"
#include "aisle/maps/floor_grid.hpp"
#include "aisle/maps/leg_barriers.hpp"

namespace aisle {

/// The clearance on a floor, updated while the floor is learned: from the centre of each cell to the nearest
/// edge of a cell that is not known to be free, and to the nearest occupied one. With legs given, cells
/// between them count as occupied; cells under a barrier always do.
class FloorClearance {
 public:
  /// @param far_m  clearances are capped at this
  explicit FloorClearance(double far_m = 1) : far_m_(far_m) {}
  explicit FloorClearance(const LegParams& legs, double far_m = 1) : far_m_(far_m), legs_(legs) {}

  /// To be called before the first update.
  /// @param cell_m  cell size of the floor to come
  void bar(std::span<const Barrier> barriers, double cell_m);

  /// Call this when cells of the box may have changed. O(box widened by the far distance); where the known
  /// floor outgrows the stored box, it is copied.
  void update(const FloorGrid& floor, const FloorBox& changed);

  double far_m() const { return far_m_; }
  /// Whether a barrier lies over the cell.
  bool is_barred(FloorCell cell) const;
  /// 0 in a cell that is not free, and outside the stored box.
  double to_doubtful_m(FloorCell cell) const {
    return stored_.contains(cell) ? to_doubtful_m_[index(cell)] : 0;
  }
  /// 0 in an occupied cell, `far_m` outside the stored box.
  double to_occupied_m(FloorCell cell) const {
    return stored_.contains(cell) ? to_occupied_m_[index(cell)] : static_cast<float>(far_m_);
  }
  /// The same by cell index. No cell at the border of the stored box is free.
  double to_doubtful_m(std::size_t index) const { return to_doubtful_m_[index]; }
  double to_occupied_m(std::size_t index) const { return to_occupied_m_[index]; }
  /// The stored box: the floor's known box and a margin; all is unknown outside.
  const FloorBox& room() const { return stored_; }
  /// The index of a cell in the stored box, 0 .. size() - 1: row by row.
  std::size_t index(FloorCell cell) const {
    return static_cast<std::size_t>(cell.y - stored_.low.y) * columns() +
           static_cast<std::size_t>(cell.x - stored_.low.x);
  }
  /// Visits the cells of a box that are in the stored box, each with its index, row by row.
  template <class Visit>
  void for_cells(const FloorBox& box, Visit visit) const {
    const FloorBox within = box.common_with(stored_);
    for (int y = within.low.y; y < within.end.y; ++y) {
      std::size_t number = index({within.low.x, y});
      for (int x = within.low.x; x < within.end.x; ++x) visit(FloorCell{x, y}, number++);
    }
  }
  std::size_t columns() const { return static_cast<std::size_t>(stored_.end.x - stored_.low.x); }
  std::size_t size() const { return to_doubtful_m_.size(); }

 private:
  void widen_stored(const FloorBox& wider);

  double far_m_;
  std::optional<LegBarriers> legs_;
  std::vector<FloorCell> barred_;  ///< row by row
  FloorBox stored_;
  std::vector<float> to_doubtful_m_;
  std::vector<float> to_occupied_m_;
  std::vector<int> in_column_;  ///< scratch memory
};

}  // namespace aisle
