#pragma once

#include <initializer_list>
#include <utility>

#include "aisle/maps/floor_clearance.hpp"
#include "cart.hpp"

namespace aisle {

/// Free rectangles in unknown floor.
struct KnownFloor {
  explicit KnownFloor(std::initializer_list<std::pair<Vec2, Vec2>> rectangles) {
    for (const auto& [low, high] : rectangles) {
      const FloorCell first = floor.cell_at(low.array() + floor.cell_m() / 2);
      const FloorCell last = floor.cell_at(high.array() - floor.cell_m() / 2);
      for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) floor.set({x, y}, Floor::kFree);
      }
    }
    clearance.update(floor, floor.known());
  }

  FloorGrid floor;
  FloorClearance clearance;
};

}  // namespace aisle
