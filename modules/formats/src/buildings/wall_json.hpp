#pragma once
/// The part "walls" of a building.

#include <string>

#include "aisle/maps/wall_map.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string walls_json(const WallMap& map);

WallMap read_walls(const JsonValue& value);

}  // namespace aisle
