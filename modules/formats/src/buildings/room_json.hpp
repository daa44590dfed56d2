#pragma once
/// A route's part "room" in a building.

#include <string>

#include "aisle/maps/room_route.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string room_json(const RoomRoute& room);

/// Errors become problems of `value`; the result is then incomplete.
RoomRoute read_room(const JsonValue& value);

}  // namespace aisle
