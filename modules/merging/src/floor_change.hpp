#pragma once

#include "aisle/merging/building_changes.hpp"
#include "same_surface.hpp"

namespace aisle {

/// What has become of a cell. Both floors have cells of one size; floor beside an equal cell of the other is
/// no change.
inline FloorChange change_of_cell(const FloorGrid& old_floor, const FloorGrid& new_floor, FloorCell cell) {
  const Floor before = old_floor.at(cell), now = new_floor.at(cell);
  if (before == now) return before == Floor::kUnknown ? FloorChange::kNotSeen : FloorChange::kSame;
  if (before == Floor::kUnknown) return FloorChange::kOnlyNew;
  if (now == Floor::kUnknown) return FloorChange::kOnlyOld;
  if (now == Floor::kOccupied)
    return has_surface_at(old_floor, cell) ? FloorChange::kSame : FloorChange::kLost;
  return has_surface_at(new_floor, cell) ? FloorChange::kSame : FloorChange::kWon;
}

}  // namespace aisle
