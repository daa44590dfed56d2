#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "aisle/maps/floor_clearance.hpp"
#include "aisle/maps/zone.hpp"

namespace aisle {

/// A floor, the clearance on it, which always belongs to the floor as it is now, and where it is driven one
/// way only.
class KnownFloor {
 public:
  /// @param clearance  not updated yet; has the legs and barriers that it is to take into account
  /// @param zones  of these, the one-way ones count: keep-out zones are barriers to the clearance
  explicit KnownFloor(FloorGrid grid = FloorGrid(), FloorClearance clearance = FloorClearance(),
                      std::span<const Zone> zones = {})
      : grid_(std::move(grid)), clearance_(std::move(clearance)) {
    clearance_.update(grid_, grid_.known());
    std::copy_if(zones.begin(), zones.end(), std::back_inserter(one_way_),
                 [](const Zone& zone) { return zone.kind == Zone::Kind::kOneWay; });
  }

  const FloorGrid& grid() const { return grid_; }
  const FloorClearance& clearance() const { return clearance_; }

  /// Seen to be free, and under no barrier.
  bool is_free(FloorCell cell) const { return grid_.at(cell) == Floor::kFree && !clearance_.is_barred(cell); }

  bool is_one_way_somewhere() const { return !one_way_.empty(); }
  /// Whether a path may lead over a pose in a gear, which a person's one-way zones may forbid.
  bool may_drive(const Pose2& T_map_vehicle, Gear gear) const {
    return one_way_against(one_way_, T_map_vehicle, gear) == nullptr;
  }

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
  std::vector<Zone> one_way_;
};

}  // namespace aisle
