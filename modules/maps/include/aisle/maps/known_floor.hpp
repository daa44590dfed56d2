#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "aisle/core/angle.hpp"
#include "aisle/maps/floor_clearance.hpp"
#include "aisle/maps/zone.hpp"

namespace aisle {

/// A floor, the clearance on it, which always belongs to the floor as it is now, and where it is driven one
/// way only.
class KnownFloor {
 public:
  /// @param clearance  not updated yet; has the legs and barriers that it is to take into account
  explicit KnownFloor(FloorGrid grid = FloorGrid(), FloorClearance clearance = FloorClearance())
      : grid_(std::move(grid)), clearance_(std::move(clearance)) {
    clearance_.update(grid_, grid_.known());
  }

  /// Of these zones, the one-way ones count; keep-out zones are barriers to the clearance.
  void zone(std::span<const Zone> zones) {
    std::copy_if(zones.begin(), zones.end(), std::back_inserter(one_way_),
                 [](const Zone& zone) { return zone.kind == Zone::Kind::kOneWay; });
  }

  const FloorGrid& grid() const { return grid_; }
  const FloorClearance& clearance() const { return clearance_; }

  /// Seen to be free, and under no barrier.
  bool is_free(FloorCell cell) const { return grid_.at(cell) == Floor::kFree && !clearance_.is_barred(cell); }

  bool is_one_way_somewhere() const { return !one_way_.empty(); }
  /// Whether a path may lead over a point in a direction, which a person's one-way zones may forbid.
  bool may_drive(const Vec2& p_map, double direction_rad) const {
    return one_way_against(one_way_, p_map, direction_rad, kOffOneWayMax_rad) == nullptr;
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
  static constexpr double kOffOneWayMax_rad = 100 * kDegree;  ///< crossing a one-way zone is not against it

  FloorGrid grid_;
  FloorClearance clearance_;
  std::vector<Zone> one_way_;
};

}  // namespace aisle
