#pragma once
/// The part "wall_directions" of a building.

#include <string>
#include <vector>

#include "aisle/maps/wall_direction.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string wall_directions_json(const std::vector<WallDirection>& directions);

std::vector<WallDirection> read_wall_directions(const JsonValue& value);

}  // namespace aisle
