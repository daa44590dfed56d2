#pragma once
/// A route's part "room" in a building.

#include <string>

#include "aisle/maps/room_route.hpp"
#include "buildings/json_value.hpp"

namespace aisle {

std::string room_json(const RoomRoute& room);

/// What is wrong is a problem; then the room is not whole.
RoomRoute read_room(const JsonValue& value);

}  // namespace aisle
