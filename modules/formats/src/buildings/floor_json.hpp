#pragma once
/// The part "floor" of a building: rows of cells from the bottom up, each as runs of equal cells.

#include <string>

#include "aisle/maps/floor_grid.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string floor_json(const FloorGrid& floor);

FloorGrid read_floor(const JsonValue& value);

}  // namespace aisle
