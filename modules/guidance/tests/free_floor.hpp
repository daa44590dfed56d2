#pragma once

#include <initializer_list>
#include <utility>

#include "aisle/maps/known_floor.hpp"
#include "cart.hpp"

namespace aisle {

/// Free rectangles in unknown floor, each from its low to its high corner.
inline KnownFloor free_floor(std::initializer_list<std::pair<Vec2, Vec2>> rectangles) {
  FloorGrid grid;
  for (const auto& [low, high] : rectangles) {
    const FloorCell first = grid.cell_at(low.array() + grid.cell_m() / 2);
    const FloorCell last = grid.cell_at(high.array() - grid.cell_m() / 2);
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) grid.set({x, y}, Floor::kFree);
    }
  }
  return KnownFloor(std::move(grid));
}

inline void set(KnownFloor& floor, FloorCell cell, Floor kind) {
  floor.change([&](FloorGrid& grid) {
    grid.set(cell, kind);
    FloorBox changed;
    changed.include(cell);
    return changed;
  });
}

/// Puts an obstacle there.
inline void occupy(KnownFloor& floor, FloorCell cell) {
  set(floor, cell, Floor::kOccupied);
}

}  // namespace aisle
