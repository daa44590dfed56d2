#include "aisle/maps/occupied_near.hpp"

namespace aisle {

bool is_occupied_near(const FloorGrid& floor, FloorCell cell, int cells) {
  for (int y = cell.y - cells; y <= cell.y + cells; ++y) {
    for (int x = cell.x - cells; x <= cell.x + cells; ++x) {
      if (floor.at(FloorCell{x, y}) == Floor::kOccupied) return true;
    }
  }
  return false;
}

}  // namespace aisle
