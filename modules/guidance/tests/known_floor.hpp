#pragma once

#include <initializer_list>
#include <utility>

#include "aisle/maps/floor_clearance.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

inline VehicleDescription cart() {
  VehicleDescription vehicle;
  vehicle.front_steered.wheelbase_m = 0.75;
  vehicle.footprint = {.front_m = 0.95, .rear_m = 0.25, .width_m = 0.6, .height_m = 1.3};
  return vehicle;
}

/// Free rectangles in the unknown.
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
