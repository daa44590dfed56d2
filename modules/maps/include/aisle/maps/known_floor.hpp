#pragma once

#include <utility>

#include "aisle/maps/floor_clearance.hpp"

namespace aisle {

/// A floor and the clearance on it, which always belongs to the floor as it is now.
class KnownFloor {
 public:
  /// @param clearance  not updated yet; has the legs and barriers that it is to take into account
  explicit KnownFloor(FloorGrid grid = FloorGrid(), FloorClearance clearance = FloorClearance())
      : grid_(std::move(grid)), clearance_(std::move(clearance)) {
    clearance_.update(grid_, grid_.known());
  }

  const FloorGrid& grid() const { return grid_; }
  const FloorClearance& clearance() const { return clearance_; }

  /// Seen to be free, and under no barrier.
  bool is_free(FloorCell cell) const { return grid_.at(cell) == Floor::kFree && !clearance_.is_barred(cell); }

  /// Changes the grid and then, once, the clearance.
  /// @param change_grid  takes the grid; returns a box around all cells that it changed
  /// @return that box
  template <class ChangeGrid>
  FloorBox change(ChangeGrid change_grid) {
    const FloorBox changed = change_grid(grid_);
    clearance_.update(grid_, changed);
    return changed;
  }

 private:
  FloorGrid grid_;
  FloorClearance clearance_;
};

}  // namespace aisle
