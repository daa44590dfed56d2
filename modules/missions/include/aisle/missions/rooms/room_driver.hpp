#pragma once
/// Makes the navigator of taught paths through rooms for missions and for their replays, both from the origin
/// that the session records.

#include <memory>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/rooms/room_navigator.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

inline constexpr const char* kRoomNavigator = "route";  ///< name of the navigator in a session

struct RoomDriverParams {
  RoomNavigatorParams navigator;
  double from_m = 0;

  void describe(FieldList& fields) {
    navigator.describe(fields);
    fields.real("from_m", from_m, {0, 100'000}, "initial position of the vehicle along the route");
  }
};

/// Finds a route by name; an empty name means the first route. A route that was not taught in a room is a
/// problem.
Result<Route> find_room_route(const Building& building, const std::string& name);

/// Removes all other cameras.
void keep_cameras(VehicleDescription& vehicle, const std::vector<std::string>& names);

/// Problems: parameters and building that cannot be read, an unknown route, one that was not taught in a
/// room, a vehicle that is not front-steered or lacks a camera.
Result<std::unique_ptr<RoomNavigator>> make_room_navigator(const SessionOrigin& origin,
                                                           const VehicleDescription& vehicle);

/// Why a vehicle cannot drive through rooms with these cameras; empty: it can.
Problems unfit_for_rooms(const VehicleDescription& vehicle, const std::vector<std::string>& cameras);

}  // namespace aisle
